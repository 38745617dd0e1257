/// RadauMethod: coefficients of the Radau IIA method of order 5 with three stages
/// [hairer_wanner1996, IV.5], and the transformation that separates its stages [IV.8]:
///
///   A⁻¹ = T Λ T⁻¹,   Λ = diag(γ, [α −β; β α])
#pragma once
#include <Eigen/Core>
#include <array>

namespace dynamy {

struct RadauMethod {
  static constexpr int kStages = 3;
  std::array<double, kStages> nodes{};    ///< c
  std::array<double, kStages> weights{};  ///< b, of a stage in an integral over the step, over h
  std::array<double, kStages> error{};    ///< of z in an embedded rule of order 3, times h
  Eigen::Matrix3d T, TInverse;
  double gamma = 0.0, alpha = 0.0, beta = 0.0;
};

const RadauMethod& radauMethod();

}  // namespace dynamy
