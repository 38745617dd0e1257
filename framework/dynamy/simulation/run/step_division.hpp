/// StepDivision: into how many equal parts a step of given length is divided because it is too long
/// for the motion: bodies turn too far in it, or forces swing too fast. Only steps of the scheme
/// that the program chose are divided; whoever names a scheme gets its steps (theory 37.6).
#pragma once
#include <dynamy/core/archive.hpp>
#include <dynamy/stages/implicit_forces.hpp>

namespace dynamy {

/// How coarse an attempted step is, as numbers of equal parts that would not be; up to 1: fine.
struct Coarseness {
  double turn = 0.0;     ///< parts in which no body turns by more than kMostTurn
  double swing = 0.0;    ///< parts that resolve the forces, ωΔt ≤ kMostSwing in each
  bool coarse = false;   ///< the step does not resolve its forces well
  double overlap = 0.0;  ///< parts after which bodies that meet in the step do not overlap much
  double ahead = 0.0;    ///< the same of the overlap at the place of the next step
  double gain = 0.0;     ///< parts in which forces that are damped bring in little energy
  double curve = 0.0;    ///< parts of a full step whose errors of the energy are small
  /// Turn of a body in a part [rad]; the run warns of more.
  static constexpr double kMostTurn = 1.0;
  /// ωΔt in a part of forces that the step does not resolve. Parts take them by the implicit
  /// midpoint rule, which keeps the energy of an oscillation and delays it by (ωΔt)²/12, here 1 %.
  static constexpr double kMostSwing = 0.35;
  /// Overlap that a part brings about, over the length of the scene; the run warns of 1 %. Where
  /// contacts rebound, two parts in a row add to one overlap: before the bodies meet and before
  /// they separate.
  static constexpr double kMostOverlap = 0.004;
  /// Overlap to which a part leads, over the size of the smallest body. Its parts are no shorter
  /// than 1/kMostAhead of a full step: thin bodies among many are not to multiply the cost.
  static constexpr double kMostForeseen = 0.005, kMostAhead = 8.0;
  /// Energy that unresolved forces may bring into a part, over T; the run warns of 1 % in all. The
  /// tangent with which they are damped leaves errors of order 2, and at most so many parts are
  /// tried at once.
  static constexpr double kMostGain = 0.002, kMostAtOnce = 8.0;
  /// Error of T that the parts of a full step may correct in all, over T. That of a part is of
  /// order 3. More than kMostCurveParts do not follow a motion without order any better.
  static constexpr double kMostCurve = 3e-3;
  static constexpr double kMostCurveParts = 32.0;
  /// Coarseness of a step: largest turn of a body in it [rad], how well it resolves the forces, and
  /// overlap that it brought about, over the scene's length, to which it leads, over the size
  /// of the smallest body, energy that it brought in, and its error of the energy where masses
  /// vary, over T.
  static Coarseness of(double turn, const ForceResolution& forces, double overlap = 0.0,
                       double foreseen = 0.0, double gain = 0.0, double curve = 0.0);
};

/// The number of parts is a power of two and changes seldom, because explicit rules keep the energy
/// of an oscillation only while their steps are equal.
class StepDivision {
 public:
  /// `divides`: false: every step has one part.
  explicit StepDivision(bool divides) : divides_(divides) {}
  bool divides() const { return divides_; }
  /// Begins a full step; returns the number of its parts, as the last step needed them or saw
  /// ahead.
  int begin();
  /// Number of parts, a power of two, into which the attempted part of `share` of the full step is
  /// to be divided; 1: it is fine, or so many parts would be more than `most` in the full step, `against`
  /// where they are to keep forces that are damped from bringing in energy.
  int parts(const Coarseness& c, double share, long most, long against);
  /// Times more parts than otherwise that a full step may have against such gains, which are seldom and feed
  /// on themselves.
  static constexpr long kAgainstGains = 8;
  /// Number of parts that the present step has, if all were as short as its shortest; 1: it was not
  /// divided.
  int finest() const { return static_cast<int>(finest_); }
  /// Throws ModelError on numbers that no run produces.
  void archive(Archive& a);

 private:
  bool divides_;
  bool swings_ = false;              // steps are divided for the sake of forces
  double parts_ = 1.0, need_ = 1.0;  // equal parts of a full step; parts that it needed
  double ahead_ = 1.0;               // parts of the next step alone, which leads to an overlap
  double finest_ = 1.0;
};

}  // namespace dynamy
