/// StateVariation: small changes z = (δ, w) of a state, one number a velocity each:
///
///   x ⊕ z:  q + F(q) δ, back on its manifold;  u + w          x₁ ⊖ x₀ = z:  F(q₀) δ = q₁ − q₀
///
/// Rotations are rotation vectors. δ is in units of the time integral of a velocity.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

class StateVariation {
 public:
  explicit StateVariation(const Model& model) : model_(model) {}
  Eigen::Index size() const { return 2 * static_cast<Eigen::Index>(model_.topology().nu()); }
  State added(const State& x, const Eigen::VectorXd& z) const;
  /// x₁ ⊖ x₀, exact where q̇ = u, else to second order of a difference.
  Eigen::VectorXd between(const State& x1, const State& x0) const;
  /// Names of the changes: signals where they have one.
  std::vector<std::string> names() const;

 private:
  Eigen::MatrixXd F(const State& x, int system) const;
  const Model& model_;
};

/// Coordinates and velocities of a state by the names of their signals, system by system.
std::vector<std::pair<std::string, double>> coordinatesOf(const Model& model, const State& x,
                                                          bool velocities = true);

}  // namespace dynamy
