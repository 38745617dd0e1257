/// Derivative at s = 0 by the 4-point difference, with a bound of its error.
///
///   D(d) = [f(−2d) − 8 f(−d) + 8 f(d) − f(2d)] / 12d,     error −d⁴f⁽⁵⁾/30 + rounding ≤ 1.5 ε|f|/d
///
/// |D(d) − D(d/2)| bounds the first part of the error of D(d/2) 15 times over; of several d the one
/// with the least bound is taken. Dual numbers were rejected: user code is written for double.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <limits>

namespace dynamy::testing {

struct Difference {
  Eigen::VectorXd value;
  double error = std::numeric_limits<double>::infinity();  ///< bound, largest entry
};

/// `f`: double → Eigen::VectorXd of fixed size; `scale` stretches the steps 1e-2 … 1e-5;
/// `noise`: absolute rounding of f beyond that of its own size.
template <class F>
Difference differentiate(const F& f, double scale = 1.0, double noise = 0.0) {
  Difference best;
  for (const double step : {1e-2, 1e-3, 1e-4, 1e-5}) {
    Eigen::VectorXd D[2];
    double size = 0.0, d = step * scale;
    for (int half = 0; half < 2; ++half) {
      const double s = half == 0 ? d : 0.5 * d;
      const Eigen::VectorXd a = f(-2.0 * s), b = f(-s), c = f(s), e = f(2.0 * s);
      D[half] = (a - e + 8.0 * (c - b)) / (12.0 * s);
      for (const Eigen::VectorXd* x : {&a, &b, &c, &e})
        if (x->size() > 0) size = std::max(size, x->lpNorm<Eigen::Infinity>());
    }
    // f itself is accurate to some 10 ε of its largest entry, after a few operations per value.
    const double rounding = 30.0 * (kEpsilon * size + noise) / d;
    double truncation = D[0].size() > 0 ? (D[0] - D[1]).lpNorm<Eigen::Infinity>() : 0.0;
    if (!(truncation >= 0.0)) truncation = std::numeric_limits<double>::infinity();
    if (truncation + rounding < best.error || best.value.size() == 0) {
      best.value = D[1];
      best.error = truncation + rounding;
    }
  }
  return best;
}

/// Derivatives of many entries, each with a bound of its error; infinite: the entry is not a number
/// at some point of every step length.
struct Differences {
  Eigen::VectorXd value, error;
};

/// As differentiate(), for entries that are NaN where they do not exist: each is compared at the
/// step lengths at which it exists, and does not spoil the bounds of the others. `noise`: absolute
/// rounding of f beyond that of its own size.
template <class F>
Differences differentiateEach(const F& f, double noise = 0.0) {
  Differences best;
  for (const double d : {1e-2, 1e-3, 1e-4, 1e-5}) {
    Eigen::VectorXd D[2], size;
    for (int half = 0; half < 2; ++half) {
      const double s = half == 0 ? d : 0.5 * d;
      const Eigen::VectorXd a = f(-2.0 * s), b = f(-s), c = f(s), e = f(2.0 * s);
      D[half] = (a - e + 8.0 * (c - b)) / (12.0 * s);
      const Eigen::VectorXd most =
          a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs()).cwiseMax(e.cwiseAbs());
      size = half == 0 ? most : Eigen::VectorXd(size.cwiseMax(most));
    }
    if (best.value.size() == 0) {
      best.value = D[1];
      best.error = Eigen::VectorXd::Constant(D[1].size(), std::numeric_limits<double>::infinity());
    }
    const auto exists = [&](Eigen::Index i) { return std::isfinite(D[0][i] - D[1][i]); };
    double truncation = 0.0, largest = 0.0;
    for (Eigen::Index i = 0; i < size.size(); ++i)
      if (exists(i))
        truncation = std::max(truncation, std::abs(D[0][i] - D[1][i])),
        largest = std::max(largest, size[i]);
    const double bound = truncation + 30.0 * (kEpsilon * largest + noise) / d;
    for (Eigen::Index i = 0; i < size.size(); ++i)
      if (exists(i) && bound < best.error[i]) best.value[i] = D[1][i], best.error[i] = bound;
  }
  return best;
}

/// True: the derivative of entry i of f is not `stated`, which is off from a central difference by
/// `off`. A central difference across a kink nearby is a mean of two slopes, so derivatives from both
/// sides are taken: the shortest step at which they agree decides; at a kink they never do.
template <class F>
bool contradicts(const F& f, Eigen::Index i, double stated, double off) {
  for (const double s : {1e-6, 1e-5, 1e-4, 1e-3}) {
    const auto at = [&](double x) { return f(x)[i]; };
    const double zero = at(0.0), right = (4.0 * at(s) - at(2.0 * s) - 3.0 * zero) / (2.0 * s),
                 left = (3.0 * zero - 4.0 * at(-s) + at(-2.0 * s)) / (2.0 * s);
    if (std::abs(right - left) < 0.25 * off)
      return std::abs(stated - 0.5 * (right + left)) >= 0.5 * off;
  }
  return false;
}

}  // namespace dynamy::testing
