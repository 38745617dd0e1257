/// C = (A + aB)⁻¹ B and f = (A + aB)⁻¹ F of one contact. In a Newton step of the contact law they
/// relate percussion and relative velocity by  ΔΛ = −f − C Δγ.                       (theory 7.8)
///
///   stick  C = I/a;   open  C = 0, f = F;   slip  C_NN = 1/a, C_TN = μ d/a, C_ee across the slip
///
/// A + aB = I − (I − aR) P is regular for every law. Stick, the state of all contacts in a resting
/// scene, is the same for every law and is computed in closed form. Closed forms for slip were
/// rejected: a 3 × 3 elimination serves every law that has a derivative.
#pragma once
#include <algorithm>
#include <dynamy/solver/newton/elimination.hpp>

namespace dynamy {

/// True if A = 0 and B is diagonal and regular: the projection changes nothing, whatever the law.
inline bool sticks(const double* A, const double* B, int d) {
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j)
      if (A[i * d + j] != 0.0 || (B[i * d + j] != 0.0) != (i == j)) return false;
  return true;
}

/// C (n × n) and f (n) of one contact from its A, B (n × n, row after row), F and a; n ≤ 8. False:
/// singular. `open`: true if C = 0.
template <int n>
bool contactCompliance(const double* A, const double* B, const double* F, double a, int dim,
                       double* C, double* f, bool& open) {
  constexpr int kMax = n > 0 ? n : 8;
  const int d = n > 0 ? n : dim, m = d + 1;
  if (sticks(A, B, d)) {
    open = false;
    std::fill(C, C + d * d, 0.0);
    for (int i = 0; i < d; ++i) C[i * d + i] = 1.0 / a, f[i] = F[i] / (a * B[i * d + i]);
    return true;
  }
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
