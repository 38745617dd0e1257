/// SteadySearch: a steady motion near a state, with the contacts that are held there: u constant,
/// at rest zero,
///
///   u̇(q, u) = 0,  γ = 0 and g = 0 of the held rows
///
/// by Newton's method with corrections of least norm, so that coordinates on which nothing depends
/// stay where they are.
#pragma once
#include <dynamy/simulation/linear/held_motion.hpp>

namespace dynamy {

/// max |aᵢ|, 0 of nothing.
inline double maxAbs(const Eigen::VectorXd& a) {
  return a.size() > 0 ? a.lpNorm<Eigen::Infinity>() : 0.0;
}

class SteadySearch {
 public:
  /// Largest steps of differences of angles and velocities, and of lengths in units of the scene's.
  static constexpr double kStep = 0.1;
  /// A constraint is redundant if its pivot is below this share of the largest one.
  static constexpr double kRankOfStates = 1e-9;

  SteadySearch(Model& model, HeldMotion& motion);
  /// Moves x to a steady motion if one is near; at rest it changes positions alone. Returns the
  /// length of all corrections |(δ, w)|. Throws ModelError as HeldMotion::at().
  double seek(State& x);
  /// Largest accelerations of a steady motion [m/s², rad/s²]: rounding of those by the forces alone,
  /// and what stiff forces make of the rounding of places.
  double allowed() const;
  /// The accelerations later in the motion from x are zero, too, but for its rounding.
  bool staysSteady(const State& x);
  /// max |u̇| may grow by this factor later in the motion.
  static constexpr double kDrift = 1e3;
  /// Instants after x [s] at which a motion has to be steady: after some turn or way. Empty at rest.
  static std::vector<double> laterTimes(const State& x);
  /// Steps of the differences, one a velocity.
  const Eigen::VectorXd& steps() const { return step_; }

 private:
  double correct(State& x, const std::vector<double>& later);
  Eigen::VectorXd residual(const State& x, const std::vector<double>& later);
  /// `rows`: of the residual at x itself.
  void noteRounding(const State& x, const Eigen::MatrixXd& tangent, Eigen::Index rows);
  Eigen::MatrixXd tangent(const State& x, const std::vector<double>& later, Eigen::Index free);
  HeldMotion& motion_;
  Eigen::Index nu_;
  Eigen::VectorXd step_;
  double rounding_ = 0.0;  // of accelerations, by the rounding of places
};

}  // namespace dynamy
