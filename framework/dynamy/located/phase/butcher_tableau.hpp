/// ButcherTableau: coefficients of the explicit Runge–Kutta methods of Dormand and Prince,
///
///   Y_i = y + h Σ_{j<i} a_ij f(Y_j),   y⁺ = y + h Σ b_j f(Y_j),   f(y⁺) the next step's first stage
///
/// with error estimates and dense output [hairer_norsett_wanner1993, II.5, II.6, II.10]: order 5(4)
/// with 6 evaluations per step, and order 8(5,3) with 12 evaluations per step.
#pragma once

namespace dynamy {

struct ButcherTableau {
  int order;             ///< of the result
  int stages;            ///< stages without the one at the end of the step
  int denseStages;       ///< further stages for the dense output
  int denseRows;         ///< rows of `dense`
  int stride;            ///< numbers in a row of `a`
  const double* nodes;   ///< c_i; nodes[stages] is that of the end
  const double* a;       ///< row i: stage i; row `stages`: the weights b
  const double* error;   ///< weights of the error; the end counts as a stage where order is 5
  const double* error3;  ///< weights of the second estimate, or null
  const double* dense;   ///< denseRows × (stages + 1 + denseStages)

  double weight(int stage, int j) const { return a[stage * stride + j]; }
};

/// Order 5(4), of [dormand_prince1980].
const ButcherTableau& dormandPrince5();
/// Order 8(5,3), of [prince_dormand1981] with the estimates of [hairer_norsett_wanner1993].
const ButcherTableau& dormandPrince8();

}  // namespace dynamy
