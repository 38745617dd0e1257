#include <algorithm>
#include <cmath>
#include <dynamy/solver/prox/anderson.hpp>

namespace dynamy {
namespace {

constexpr double kTolerableGrowth = 2.0;  ///< growth of |f| that is tolerated in one step
constexpr double kRidge = 1e-14;  ///< of the diagonal: keeps the Gram matrix positive definite

}  // namespace

void Anderson::begin(int memory, const double* weights, int rows) {
  memory_ = std::min(memory, kMaxMemory), rows_ = rows;
  count_ = newest_ = restarts_ = 0, first_ = true;
  const auto n = static_cast<std::size_t>(rows), m = static_cast<std::size_t>(memory_);
  root_.resize(n);
  // Relative to a power of two: other units of mass give the same digits.
  int exponent = 0;
  std::frexp(n > 0 ? *std::max_element(weights, weights + n) : 1.0, &exponent);
  for (std::size_t k = 0; k < n; ++k) root_[k] = std::sqrt(std::ldexp(weights[k], -exponent));
  f_.resize(n), g_.resize(n), fNew_.resize(n), dF_.resize(n * m), dG_.resize(n * m);
}

double Anderson::dot(const double* a, const double* b) const {
  // Four sums side by side: a single sum would wait for each addition.
  double s[4] = {};
  int k = 0;
  for (; k + 4 <= rows_; k += 4)
    for (int i = 0; i < 4; ++i) s[i] += a[k + i] * b[k + i];
  for (; k < rows_; ++k) s[0] += a[k] * b[k];
  return (s[0] + s[1]) + (s[2] + s[3]);
}

void Anderson::next(const double* x, const double* g, double* next) {
  const auto n = static_cast<std::size_t>(rows_);
  for (std::size_t k = 0; k < n; ++k) fNew_[k] = root_[k] * (g[k] - x[k]);
  const double square = dot(fNew_.data(), fNew_.data());
  if (!first_ && !(square <= kTolerableGrowth * kTolerableGrowth * best_) && count_ > 0) {
    // The step increased |f| too much: back to the plain iteration from the last good point.
    drop(), ++restarts_, first_ = true;
    std::copy(g_.begin(), g_.end(), next);
    return;
  }
  if (!first_) {
    newest_ = count_ == 0 ? 0 : (newest_ + 1) % memory_;
    count_ = std::min(count_ + 1, memory_);
    double *dF = dF_.data() + static_cast<std::size_t>(newest_) * n,
           *dG = dG_.data() + static_cast<std::size_t>(newest_) * n;
    for (std::size_t k = 0; k < n; ++k) dF[k] = fNew_[k] - f_[k], dG[k] = g[k] - g_[k];
    for (int j = 0; j < count_; ++j)
      gram_[newest_ * kMaxMemory + j] = gram_[j * kMaxMemory + newest_] =
          dot(dF, dF_.data() + static_cast<std::size_t>(j) * n);
  }
  f_.swap(fNew_);
  std::copy(g, g + n, g_.begin());
  best_ = square, first_ = false;
  std::copy(g_.begin(), g_.end(), next);
  if (count_ == 0) return;
  double gamma[kMaxMemory];
  for (int j = 0; j < count_; ++j)
    right_[j] = dot(dF_.data() + static_cast<std::size_t>(j) * n, f_.data());
  if (!solve(gamma)) {
    drop();
    return;
  }
  for (int j = 0; j < count_; ++j) {
    const double* dG = dG_.data() + static_cast<std::size_t>(j) * n;
    for (std::size_t k = 0; k < n; ++k) next[k] -= gamma[j] * dG[k];
  }
}

bool Anderson::solve(double* gamma) const {
  // Cholesky's factor of the Gram matrix, scaled to a unit diagonal.
  double L[kMaxMemory][kMaxMemory], scale[kMaxMemory];
  for (int i = 0; i < count_; ++i) {
    const double d = gram_[i * kMaxMemory + i];
    if (!(d > 0.0)) return false;
    scale[i] = 1.0 / std::sqrt(d);
  }
  for (int i = 0; i < count_; ++i) {
    for (int j = 0; j <= i; ++j) {
      double s = gram_[i * kMaxMemory + j] * scale[i] * scale[j];
      if (i == j) s += kRidge;
      for (int k = 0; k < j; ++k) s -= L[i][k] * L[j][k];
      if (i == j && !(s > 0.0)) return false;
      L[i][j] = i == j ? std::sqrt(s) : s / L[j][j];
    }
  }
  for (int i = 0; i < count_; ++i) {
    double s = right_[i] * scale[i];
    for (int k = 0; k < i; ++k) s -= L[i][k] * gamma[k];
    gamma[i] = s / L[i][i];
  }
  for (int i = count_ - 1; i >= 0; --i) {
    double s = gamma[i];
    for (int k = i + 1; k < count_; ++k) s -= L[k][i] * gamma[k];
    gamma[i] = s / L[i][i];
  }
  for (int i = 0; i < count_; ++i) {
    gamma[i] *= scale[i];
    if (!std::isfinite(gamma[i])) return false;
  }
  return true;
}

}  // namespace dynamy
