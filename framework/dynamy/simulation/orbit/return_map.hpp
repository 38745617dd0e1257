/// ReturnMap: where a motion from a state meets the section again, and the derivative of this map:
///
///   x₁ = P(x₀) = φ(T(x₀), x₀),  s(x₁) = c        DP = ∂φ/∂x₀ − ẋ₁ (∂s/∂x₀)/ṡ        (theory 54.1)
///
/// All derivatives at fixed T are differences of runs that take the steps of the run from x₀, each
/// with its own instants of the same switches (theory 53.2). P does not change if x₀ moves along
/// the motion, so that x₀ need not be on the section: a fixed point is.
///
/// With a mirror S the return is half an orbit: P(x₀) = S φ(T(x₀), x₀), where T is the time to the
/// mirrored section.
#pragma once
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/orbit/orbit_mirror.hpp>

namespace dynamy {

/// A motion from the section back to it.
struct Return {
  State start, end;
  double period = 0.0;      ///< [s]
  double slope = 0.0;       ///< of the signal there [1/s]
  Eigen::VectorXd range;    ///< of each change of the state on the way; 1 where nothing changes
  Eigen::VectorXd rate;     ///< ẋ and ṡ at the end, about; empty: not known
  MotionSequence sequence;  ///< of its steps
};

/// How derivatives of a return are taken: forward by one run a direction, central of second order by
/// two, fine of fourth order by four at each of three distances.
struct MapDifferences {
  bool forward = false;
  double fine = 0.0;  ///< factor on the distances; 0: not fine
};

struct ReturnDerivative {
  Eigen::MatrixXd P;       ///< DP
  Eigen::VectorXd period;  ///< ∂T/∂x₀
  Eigen::VectorXd rate;    ///< ẋ₁ and ṡ; empty without a section
};

class ReturnMap {
 public:
  /// `model` has a section signal and outlives the map.
  ReturnMap(Model& model, OrbitSection section, double tolerance);
  /// The state at the first pass of the section, from the initial state of the model; with a period
  /// that state itself. Throws ModelError if there is none until the end of the run.
  State start();
  /// `last`: a return nearby, which bounds time and work of this one: passes before half of its period
  /// do not count. Throws ModelError.
  Return from(const State& x, const Return* last = nullptr);
  /// The same with steps and switches of another return. False: they differ.
  bool like(const Return& other, const State& x, Return& out);
  /// Throws ModelError where runs close by have other switches, however small their difference is.
  ReturnDerivative derivative(const Return& r, const MapDifferences& how = {});
  /// ∂P/∂p, from the map of the same model at another value of a parameter p, `apart` from this one.
  /// Throws ModelError where it has other switches.
  Eigen::VectorXd byParameter(const Return& r, const ReturnDerivative& d, ReturnMap& other,
                              double apart);
  /// The state one return after the end of r, without a new start; as seen from there, if mirrored.
  State after(const Return& r);
  /// Returns in an orbit: 2 if it is mirrored after half a period.
  int halves() const { return mirror_.any() ? 2 : 1; }
  const StateVariation& variation() const { return variation_; }
  const OrbitSection& section() const { return section_; }
  double tolerance() const { return tolerance_; }
  /// Runs over one period so far.
  long cycles() const { return cycles_; }

 private:
  struct Pass;
  /// Of a run to the section: passes in the first `least` [s] do not count.
  struct Limits {
    double least, until;
    long steps;
    bool located = true;  // steps in time have no derivatives
  };
  Pass pass(const State& from, const Limits& limits, int count);
  ModelError noPass(double until) const;
  FollowedRun run(const State& from, double T, const MotionSequence* steps, bool located = true);
  bool locate(const MotionSequence* steps, Return& r, bool located = true);
  Eigen::VectorXd change(const Return& r, const Eigen::VectorXd& z, double dT, bool& same);
  Eigen::VectorXd central(const Return& r, const Eigen::VectorXd& z, double dT, double delta,
                          const MapDifferences& how);
  Eigen::VectorXd difference(const Return& r, const Eigen::VectorXd& z, double dT,
                             const MapDifferences& how, const std::string& of);
  [[noreturn]] void refuse(const MotionSequence::Difference& d, const std::string& of) const;
  Model& model_;
  OrbitSection section_;
  OrbitMirror mirror_;
  OrbitSection end_;  ///< section at which returns end
  double tolerance_, until_;
  double forced_ = 0.0;  ///< duration of a return of a motion with forcing [s]
  StateVariation variation_;
  MotionSequence::Difference difference_;
  long cycles_ = 0;
};

}  // namespace dynamy
