/// Anderson acceleration of a fixed-point iteration x ← g(x) [anderson1965, walker_ni2011]:
///
///   f_k = g_k − x_k,   γ = argmin |f_k − ΔF γ|_w,   x_{k+1} = g_k − ΔG γ
///
/// ΔF, ΔG: the last m differences of f and g; |·|_w weighs rows. Safeguard: if |f| has grown by
/// more than kTolerableGrowth, the memory is dropped and x_{k+1} = g of the better iterate. The
/// normal equations (m ≤ 20) were preferred to an updated QR factorisation: a projected iteration,
/// whose pieces change, would not use the digits they lose.
#pragma once
#include <vector>

namespace dynamy {

class Anderson {
 public:
  static constexpr int kMaxMemory = 20;
  /// Forgets all; weights: `rows` positive numbers.
  void begin(int memory, const double* weights, int rows);
  /// In: x and g = g(x). Out: the next x in `next`, which may be x or g.
  void next(const double* x, const double* g, double* next);
  int restarts() const { return restarts_; }

 private:
  void drop() { count_ = 0; }
  double dot(const double* a, const double* b) const;
  bool solve(double* gamma) const;

  int memory_ = 0, rows_ = 0, count_ = 0, newest_ = 0, restarts_ = 0;
  bool first_ = true;
  double best_ = 0.0;  ///< |f|² of the iterate that `f_`, `g_` belong to
  std::vector<double> root_, f_, g_, dF_, dG_, fNew_;  // f scaled by the roots of the weights
  double gram_[kMaxMemory * kMaxMemory] = {}, right_[kMaxMemory] = {};
};

}  // namespace dynamy
