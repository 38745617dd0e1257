/// ReturnMap: where a motion from a state meets the section again, and the derivative of this map:
///
///   x₁ = P(x₀) = φ(T(x₀), x₀),  s(x₁) = c        DP = ∂φ/∂x₀ − ẋ₁ (∂s/∂x₀)/ṡ        (theory 54.1)
///
/// All derivatives at fixed T are differences of runs that take the steps of the run from x₀, each
/// with its own instants of the same switches (theory 53.2). P does not change if x₀ moves along
/// the motion, so that x₀ need not be on the section: a fixed point is.
#pragma once
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/orbit/orbit_section.hpp>

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
  /// Passes within `least` [s] after the start do not count. `rate`: as in Return, if known. Throws
  /// ModelError.
  Return from(const State& x, double least, const Eigen::VectorXd& rate = {});
  /// The same with steps and switches of another return. False: they differ.
  bool like(const Return& other, const State& x, Return& out);
  /// Throws ModelError where runs close by have other switches, however small their difference is.
  ReturnDerivative derivative(const Return& r, const MapDifferences& how = {});
  /// ∂P/∂p, from the map of the same model at another value of a parameter p, `apart` from this one.
  /// Throws ModelError where it has other switches.
  Eigen::VectorXd byParameter(const Return& r, const ReturnDerivative& d, ReturnMap& other,
                              double apart);
  /// The state where the motion from x passes the section next, as a start; x may be on the section.
  State next(const State& x);
  /// The state one period after the end of r, without a new start.
  State after(const Return& r);
  const StateVariation& variation() const { return variation_; }
  const OrbitSection& section() const { return section_; }
  double tolerance() const { return tolerance_; }
  /// Runs over one period so far.
  long cycles() const { return cycles_; }

 private:
  struct Pass;
  Pass pass(const State& from, double least, int count);
  ModelError noPass() const;
  FollowedRun run(const State& from, double T, const MotionSequence* steps);
  bool locate(const MotionSequence* steps, Return& r);
  Eigen::VectorXd change(const Return& r, const Eigen::VectorXd& z, double dT, bool& same);
  Eigen::VectorXd central(const Return& r, const Eigen::VectorXd& z, double dT, double delta,
                          const MapDifferences& how);
  Eigen::VectorXd difference(const Return& r, const Eigen::VectorXd& z, double dT,
                             const MapDifferences& how, const std::string& of);
  [[noreturn]] void refuse(const MotionSequence::Difference& d, const std::string& of) const;
  Model& model_;
  OrbitSection section_;
  double tolerance_, until_;
  StateVariation variation_;
  MotionSequence::Difference difference_;
  long cycles_ = 0;
};

}  // namespace dynamy
