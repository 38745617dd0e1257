/// RunDifferences: a run and its derivatives by parameters, by runs that follow it (53.3):
///
///   d = (v(p + δ) − v(p − δ)) / 2δ
#pragma once
#include <dynamy/core/constants.hpp>
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <functional>
#include <utility>

namespace dynamy {

/// A parameter and its value, in SI units.
using Varied = std::pair<std::string, double>;
/// Makes the model with some parameters changed.
using ModelMaker = std::function<Model(const std::vector<Varied>& changed)>;

class RunDifferences {
 public:
  /// δ of a parameter, as a part of its size. Central differences of smooth runs have errors of
  /// about δ² and 1e-16/δ.
  static constexpr double kDelta = 5e-6;
  static constexpr double kWideDelta = 1e-4;  ///< the same for differences of order 4
  /// Rounding of a value at the end of a run, in units of its size; divided by δ.
  static constexpr double kRounding = 32.0 * kEpsilon;
  /// Runs with some parameters changed; `like`: with the steps of that run.
  using Run =
      std::function<FollowedRun(const std::vector<Varied>& changed, const MotionSequence* like)>;
  /// `wide`: factor on δ. Throws what `run` throws.
  explicit RunDifferences(Run run, double wide = 1.0);
  const FollowedRun& nominal() const { return run_; }
  /// From when on switches are so dense that the run steps in time and has no derivatives [s]; NaN:
  /// it has.
  double steppedFrom() const;

  /// Derivatives of all values by a parameter; `size`: what δ is a part of; `tries`: with ever
  /// smaller δ. Empty: the switches differ, see difference().
  std::vector<double> by(const Varied& parameter, double size, int tries);
  /// The same by four runs with a larger δ, for values that bend much within it:
  ///
  ///   d = (8 (v(p + δ) − v(p − δ)) − (v(p + 2δ) − v(p − 2δ))) / 12δ,   with an error of order δ⁴   (53.4)
  ///
  /// Empty: the switches differ. Their rounding is kRounding/kWideDelta of the size of a value.
  std::vector<double> byFour(const Varied& parameter, double size) const;
  /// Where there is no derivative: differences to runs that choose their own steps, on both sides,
  /// of each value the smaller one. A value that jumps on one side changes slowly on the other. A
  /// side that ends early is left out. Throws ModelError if both do.
  std::vector<double> across(const Varied& parameter, double size) const;

  /// Derivatives of all values towards one side of a parameter, `sign` 1 or −1, from a run that
  /// chooses its steps beside the parameter's value and two that follow it:
  ///
  ///   d = ∓(5 v(p ± δ) − 8 v(p ± 2δ) + 3 v(p ± 3δ)) / 2δ
  ///
  /// the errors, by a smaller δ, and the limits of the values, which are others than those at the
  /// parameter's value where the values jump. NaN: a derivative grows without bound as δ shrinks, or
  /// runs on that side switch differently for every δ.
  struct Side {
    std::vector<double> d, error, limit;
  };
  Side side(const Varied& parameter, double size, double sign) const;

  double delta() const { return delta_; }  ///< of the last derivatives
  const MotionSequence::Difference& difference() const { return difference_; }
  /// The switches differed for a larger value of the parameter, else for a smaller one.
  bool grows() const { return grows_; }

 private:
  Side sideOnce(const Varied& parameter, double delta) const;
  Run make_;
  double wide_, delta_ = 0.0;
  FollowedRun run_;
  MotionSequence::Difference difference_;
  bool grows_ = false;
};

}  // namespace dynamy
