/// C = (A + aB)⁻¹ B and f = (A + aB)⁻¹ F of one contact: what a Newton step of the contact law
/// leaves between percussion and relative velocity,  ΔΛ = −f − C Δγ.                 (theory 7.8)
///
///   stick  C = I/a;   open  C = 0, f = F;   slip  C_NN = 1/a, C_TN = μ d/a, C_ee across the slip
///
/// A + aB = I − (I − aR) P is regular for every law. The closed forms of single laws were rejected:
/// elimination of 3 × 3 costs little more and serves every law that has a derivative.
#pragma once
#include <dynamy/solver/elimination.hpp>

namespace dynamy {

/// C (n × n) and f (n) of one contact from its A, B (n × n, row after row), F and a; n ≤ 8. False:
/// singular. `open` tells C = 0.
template <int n>
bool contactCompliance(const double* A, const double* B, const double* F, double a, int dim,
                       double* C, double* f, bool& open) {
  constexpr int kMax = n > 0 ? n : 8;
  const int d = n > 0 ? n : dim, m = d + 1;
  open = true;
  for (int k = 0; k < d * d; ++k) open = open && B[k] == 0.0;
  double S[kMax * kMax], Y[kMax * (kMax + 1)];
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < d; ++j) {
      S[i * d + j] = A[i * d + j] + a * B[i * d + j];
      Y[i * m + j] = B[i * d + j];
    }
    Y[i * m + d] = F[i];
  }
  if (!eliminate(S, Y, d, m)) return false;
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < d; ++j) C[i * d + j] = Y[i * m + j];
    f[i] = Y[i * m + d];
  }
  return true;
}

}  // namespace dynamy
