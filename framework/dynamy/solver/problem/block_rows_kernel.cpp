#include <algorithm>
#include <cmath>
#include <dynamy/solver/problem/block_rows.hpp>

namespace dynamy {
namespace {

/// out += G x for blocks of one size, unrolled.
template <int n>
void multiplyAdd(const double* G, const double* x, double* out) {
  for (int r = 0; r < n; ++r) {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) sum += G[r * n + k] * x[k];
    out[r] += sum;
  }
}

/// Multiplies a row whose blocks all have n × n numbers, one after the other; false: it has other
/// blocks.
template <int n>
bool multiplyEqual(const BlockRows& G, int i, const int* row0, const double* x, double* out) {
  const int a = G.first[i], b = G.first[i + 1];
  if (a == b || G.value0[b - 1] != G.value0[a] + static_cast<std::ptrdiff_t>(n) * n * (b - 1 - a))
    return false;
  const double* value = G.value.data() + G.value0[a];
  double sum[n] = {};
  for (int k = a; k < b; ++k, value += n * n) {
    const int j = G.column[k];
    if (row0[j + 1] - row0[j] != n) return false;
    multiplyAdd<n>(value, x + row0[j], sum);
  }
  std::copy(sum, sum + n, out);
  return true;
}

}  // namespace

int BlockRows::find(int i, int j) const {
  const auto begin = column.begin() + first[i], end = column.begin() + first[i + 1];
  const auto at = std::lower_bound(begin, end, j);
  return at != end && *at == j ? static_cast<int>(at - column.begin()) : -1;
}

void BlockRows::multiplyRow(int i, const int* row0, const double* x, double* out) const {
  const int dim = row0[i + 1] - row0[i];
  if (dim == 3 && multiplyEqual<3>(*this, i, row0, x, out)) return;
  if (dim == 2 && multiplyEqual<2>(*this, i, row0, x, out)) return;
  std::fill(out, out + dim, 0.0);
  for (int k = first[i]; k < first[i + 1]; ++k) {
    const int j = column[k], dj = row0[j + 1] - row0[j];
    const double *G = value.data() + value0[k], *xj = x + row0[j];
    for (int r = 0; r < dim; ++r)
      for (int m = 0; m < dj; ++m) out[r] += G[r * dj + m] * xj[m];
  }
}

void BlockRows::multiplyRowAbsolute(int i, const int* row0, const double* x, double* out) const {
  const int dim = row0[i + 1] - row0[i];
  std::fill(out, out + dim, 0.0);
  for (int k = first[i]; k < first[i + 1]; ++k) {
    const int j = column[k], dj = row0[j + 1] - row0[j];
    const double *G = value.data() + value0[k], *xj = x + row0[j];
    for (int r = 0; r < dim; ++r)
      for (int m = 0; m < dj; ++m) out[r] += std::abs(G[r * dj + m] * xj[m]);
  }
}

}  // namespace dynamy
