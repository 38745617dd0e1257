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
  MotionSequence sequence;  ///< of its steps
};

struct ReturnDerivative {
  Eigen::MatrixXd P;       ///< DP
  Eigen::VectorXd period;  ///< ∂T/∂x₀
};

class ReturnMap {
 public:
  /// `model` has a section signal and outlives the map.
  ReturnMap(Model& model, OrbitSection section, double tolerance);
  /// The state at the first pass of the section, from the initial state of the model; with a period
  /// that state itself. Throws ModelError if there is none until the end of the run.
  State start();
  /// Passes within `least` [s] after the start do not count. Throws ModelError.
  Return from(const State& x, double least);
  /// The same with steps and switches of another return. False: they differ.
  bool like(const Return& other, const State& x, Return& out);
  /// `fine`: 0, or the factor on the differences of fourth order, which take four runs a direction
  /// in place of two. Throws ModelError where runs close by have other switches, however small
  /// their difference is.
  ReturnDerivative derivative(const Return& r, double fine = 0.0);
  /// The state one period after the end of r, without a new start.
  State after(const Return& r);
  const StateVariation& variation() const { return variation_; }
  const OrbitSection& section() const { return section_; }
  double tolerance() const { return tolerance_; }

 private:
  struct Pass;
  Pass pass(const State& from, double least, int count);
  FollowedRun run(const State& from, double T, const MotionSequence* steps);
  bool locate(const MotionSequence* steps, Return& r);
  Eigen::VectorXd change(const Return& r, const Eigen::VectorXd& z, double dT, bool& same);
  Eigen::VectorXd central(const Return& r, const Eigen::VectorXd& z, double dT, double delta,
                          bool fine);
  Eigen::VectorXd difference(const Return& r, const Eigen::VectorXd& z, double dT, double fine,
                             const std::string& of);
  Model& model_;
  OrbitSection section_;
  double tolerance_, until_;
  StateVariation variation_;
  MotionSequence::Difference difference_;
};

}  // namespace dynamy
