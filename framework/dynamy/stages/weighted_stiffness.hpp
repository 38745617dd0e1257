/// WeightedStiffness: entries of K = ∂h/∂q F and D = ∂h/∂u, and the weights with which a step takes
/// them implicitly,
///
///   h + Δt K (s u^A + a (u^E − u^A)) + b D (u^E − u^A)
///
/// Forces that the model declares stiff, forces that a step damps since it does not resolve them, and
/// forces that it resolves and whose energy it keeps have weights of their own.
#pragma once
#include <dynamy/system/stiffness_sink.hpp>
#include <vector>

namespace dynamy {

/// Weights of the place between beginning and end of a step at which the linear part of h is taken:
/// h + Δt K (s u^A + a (u^E − u^A)) + b D (u^E − u^A).
struct ImplicitWeights {
  double s = 0.0, a = 0.0, b = 0.0;
};
/// Weights of the implicit midpoint rule, which is neither damped nor unstable: h is given at
/// q^A + Δt/2 u^A and required at the mean of the step.
inline constexpr ImplicitWeights kImplicitMidpoint{0.0, 0.25, 0.5};
/// Weights of the implicit Euler rule, which damps stiff motions: h is given at q and required at
/// q + Δt u^E and u^E.
inline constexpr ImplicitWeights kImplicitEnd{1.0, 1.0, 1.0};

struct WeightedStiffness {
  std::vector<StiffEntry> entries;
  std::size_t declared = 0;  ///< number of entries of stiff elements; those of damped ones follow
  std::size_t kept = 0;  ///< the first entry of a force whose energy is kept, behind damped ones
  ImplicitWeights ofDeclared;

  const ImplicitWeights& weights(std::size_t entry) const {
    return entry < declared ? ofDeclared : entry < kept ? kImplicitEnd : kImplicitMidpoint;
  }
  /// out += Δt² s K v.
  void addStart(double dt, const Eigen::VectorXd& v, Eigen::VectorXd& out) const;
  /// h += Δt K (s u^A + a (u^E − u^A)) + b D (u^E − u^A), the last term also to hNonPotential.
  void addUsedForce(double dt, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE,
                    Eigen::VectorXd& h, Eigen::VectorXd& hNonPotential) const;
  /// Work of Δt K (s u^A + a (u^E − u^A)) of damped forces in a step [J].
  double workOfDamped(double dt, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE) const;
};

}  // namespace dynamy
