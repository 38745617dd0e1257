/// Truncated Taylor numbers for exact first and second directional derivatives.
///
/// Jet<N> carries a value and its derivatives along two directions v and w:
///   N = 0: f      N = 1: f, f′v      N = 2: f, f′v, f′w, vᵀf″w
/// Chain rule for y = φ(a, b), subscripts of φ partial derivatives:
///   (1) y_v  = φ_a a_v + φ_b b_v
///   (2) y_vw = φ_a a_vw + φ_b b_vw + φ_aa a_v a_w + φ_ab (a_v b_w + a_w b_v) + φ_bb b_v b_w
/// Rejected: difference quotients, which lose half of the digits and need a step to be tuned; and
/// one type with a template parameter for the scalar, which would spread templates over every
/// element.
///
/// At points without a derivative the derivative of one side is taken, see each function. Where φ′
/// is infinite and the inner derivative is exactly zero (√(x²) at 0), the product is taken as zero.
#pragma once

#include <cmath>

namespace dynamy {

template <int N>
struct Jet;

template <>
struct Jet<0> {
  double v = 0.0;
};

template <>
struct Jet<1> {
  double v = 0.0;   ///< f
  double d1 = 0.0;  ///< f′v
};

template <>
struct Jet<2> {
  double v = 0.0;    ///< f
  double d1 = 0.0;   ///< f′v
  double d2 = 0.0;   ///< f′w
  double d12 = 0.0;  ///< vᵀf″w
};

/// f·d with ∞·0 = 0 for a zero inner derivative d.
inline double timesInner(double f, double d) { return d == 0.0 ? 0.0 : f * d; }

/// Equations (1), (2) for one argument: f, f′, f″ at x.v.
template <int N>
Jet<N> chain(const Jet<N>& x, double f, double fx, double fxx) {
  if constexpr (N == 0) {
    return {f};
  } else if constexpr (N == 1) {
    return {f, fx * x.d1};
  } else {
    return {f, fx * x.d1, fx * x.d2, fx * x.d12 + fxx * x.d1 * x.d2};
  }
}

/// Like chain, for functions whose derivative can be infinite inside their domain.
template <int N>
Jet<N> chainGuarded(const Jet<N>& x, double f, double fx, double fxx) {
  if constexpr (N == 0) {
    return {f};
  } else if constexpr (N == 1) {
    return {f, timesInner(fx, x.d1)};
  } else {
    return {f, timesInner(fx, x.d1), timesInner(fx, x.d2),
            timesInner(fx, x.d12) + timesInner(fxx, x.d1 * x.d2)};
  }
}

/// Partial derivatives of a function of two arguments.
struct Partials {
  double a, b, aa, ab, bb;
};

/// Equations (1), (2) for two arguments, guarded.
template <int N>
Jet<N> chain(const Jet<N>& a, const Jet<N>& b, double f, const Partials& p) {
  if constexpr (N == 0) {
    return {f};
  } else if constexpr (N == 1) {
    return {f, timesInner(p.a, a.d1) + timesInner(p.b, b.d1)};
  } else {
    return {f, timesInner(p.a, a.d1) + timesInner(p.b, b.d1),
            timesInner(p.a, a.d2) + timesInner(p.b, b.d2),
            timesInner(p.a, a.d12) + timesInner(p.b, b.d12) + timesInner(p.aa, a.d1 * a.d2) +
                timesInner(p.ab, a.d1 * b.d2 + a.d2 * b.d1) + timesInner(p.bb, b.d1 * b.d2)};
  }
}

/// A number without derivatives.
template <int N>
Jet<N> constantJet(double value) {
  Jet<N> y;
  y.v = value;
  return y;
}

template <int N>
Jet<N> operator-(const Jet<N>& x) {
  return chain(x, -x.v, -1.0, 0.0);
}

template <int N>
Jet<N> operator+(const Jet<N>& a, const Jet<N>& b) {
  if constexpr (N == 0) return {a.v + b.v};
  if constexpr (N == 1) return {a.v + b.v, a.d1 + b.d1};
  if constexpr (N == 2) return {a.v + b.v, a.d1 + b.d1, a.d2 + b.d2, a.d12 + b.d12};
}

template <int N>
Jet<N> operator-(const Jet<N>& a, const Jet<N>& b) {
  if constexpr (N == 0) return {a.v - b.v};
  if constexpr (N == 1) return {a.v - b.v, a.d1 - b.d1};
  if constexpr (N == 2) return {a.v - b.v, a.d1 - b.d1, a.d2 - b.d2, a.d12 - b.d12};
}

template <int N>
Jet<N> operator*(const Jet<N>& a, const Jet<N>& b) {
  if constexpr (N == 0) return {a.v * b.v};
  if constexpr (N == 1) return {a.v * b.v, a.d1 * b.v + a.v * b.d1};
  if constexpr (N == 2) {
    return {a.v * b.v, a.d1 * b.v + a.v * b.d1, a.d2 * b.v + a.v * b.d2,
            a.d12 * b.v + a.v * b.d12 + a.d1 * b.d2 + a.d2 * b.d1};
  }
}

template <int N>
Jet<N> operator/(const Jet<N>& a, const Jet<N>& b) {
  const double y = a.v / b.v;
  if constexpr (N == 0) {
    return {y};
  } else if constexpr (N == 1) {
    return {y, (a.d1 - y * b.d1) / b.v};
  } else {
    // From a = y b: a_vw = y_vw b + y_v b_w + y_w b_v + y b_vw.
    const double y1 = (a.d1 - y * b.d1) / b.v;
    const double y2 = (a.d2 - y * b.d2) / b.v;
    return {y, y1, y2, (a.d12 - y * b.d12 - y1 * b.d2 - y2 * b.d1) / b.v};
  }
}

template <int N>
Jet<N> sin(const Jet<N>& x) {
  const double s = std::sin(x.v);
  if constexpr (N == 0) return {s};
  return chain(x, s, std::cos(x.v), -s);
}

template <int N>
Jet<N> cos(const Jet<N>& x) {
  const double c = std::cos(x.v);
  if constexpr (N == 0) return {c};
  return chain(x, c, -std::sin(x.v), -c);
}

template <int N>
Jet<N> tan(const Jet<N>& x) {
  const double t = std::tan(x.v);
  return chain(x, t, 1.0 + t * t, 2.0 * t * (1.0 + t * t));
}

template <int N>
Jet<N> asin(const Jet<N>& x) {
  if constexpr (N == 0) return {std::asin(x.v)};
  const double c2 = (1.0 - x.v) * (1.0 + x.v);
  const double f1 = 1.0 / std::sqrt(c2);
  return chainGuarded(x, std::asin(x.v), f1, x.v * f1 / c2);
}

template <int N>
Jet<N> acos(const Jet<N>& x) {
  if constexpr (N == 0) return {std::acos(x.v)};
  const double c2 = (1.0 - x.v) * (1.0 + x.v);
  const double f1 = -1.0 / std::sqrt(c2);
  return chainGuarded(x, std::acos(x.v), f1, x.v * f1 / c2);
}

template <int N>
Jet<N> atan(const Jet<N>& x) {
  const double f1 = 1.0 / (1.0 + x.v * x.v);
  return chain(x, std::atan(x.v), f1, -2.0 * x.v * f1 * f1);
}

template <int N>
Jet<N> sinh(const Jet<N>& x) {
  const double s = std::sinh(x.v);
  if constexpr (N == 0) return {s};
  return chain(x, s, std::cosh(x.v), s);
}

template <int N>
Jet<N> cosh(const Jet<N>& x) {
  const double c = std::cosh(x.v);
  if constexpr (N == 0) return {c};
  return chain(x, c, std::sinh(x.v), c);
}

template <int N>
Jet<N> tanh(const Jet<N>& x) {
  const double t = std::tanh(x.v);
  const double f1 = (1.0 - t) * (1.0 + t);
  return chain(x, t, f1, -2.0 * t * f1);
}

template <int N>
Jet<N> exp(const Jet<N>& x) {
  const double e = std::exp(x.v);
  return chain(x, e, e, e);
}

template <int N>
Jet<N> log(const Jet<N>& x) {
  const double f1 = 1.0 / x.v;
  return chainGuarded(x, std::log(x.v), f1, -f1 * f1);
}

template <int N>
Jet<N> log10(const Jet<N>& x) {
  constexpr double kLog10OfE = 0.43429448190325182765;
  const double f1 = kLog10OfE / x.v;
  return chainGuarded(x, std::log10(x.v), f1, -f1 / x.v);
}

template <int N>
Jet<N> sqrt(const Jet<N>& x) {
  const double s = std::sqrt(x.v);
  if constexpr (N == 0) return {s};
  return chainGuarded(x, s, 0.5 / s, -0.25 / (s * x.v));
}

/// |x|; at 0 the derivative of the right-hand branch, +1.
template <int N>
Jet<N> abs(const Jet<N>& x) {
  return chain(x, std::abs(x.v), x.v < 0.0 ? -1.0 : 1.0, 0.0);
}

/// x^c for an exponent without derivatives; also defined for x < 0 and integer c.
template <int N>
Jet<N> powConstant(const Jet<N>& x, double c) {
  const double f = std::pow(x.v, c);
  if constexpr (N == 0) return {f};
  const double f1 = c * std::pow(x.v, c - 1.0);
  const double f2 = N == 1 ? 0.0 : c * (c - 1.0) * std::pow(x.v, c - 2.0);
  return chainGuarded(x, f, f1, f2);
}

/// a^b, both variable; derivatives along b need a > 0.
template <int N>
Jet<N> pow(const Jet<N>& a, const Jet<N>& b) {
  const double f = std::pow(a.v, b.v);
  if constexpr (N == 0) return {f};
  const double l = std::log(a.v);
  const double g = std::pow(a.v, b.v - 1.0);
  return chain(a, b, f,
               {b.v * g, f * l, b.v * (b.v - 1.0) * std::pow(a.v, b.v - 2.0), g * (1.0 + b.v * l),
                f * l * l});
}

/// √(a² + b²); at the origin all derivatives are taken as 0.
template <int N>
Jet<N> hypot(const Jet<N>& a, const Jet<N>& b) {
  const double r = std::hypot(a.v, b.v);
  if constexpr (N == 0) return {r};
  if (r == 0.0) return constantJet<N>(r);
  const double ca = a.v / r;
  const double cb = b.v / r;
  return chain(a, b, r, {ca, cb, cb * cb / r, -ca * cb / r, ca * ca / r});
}

/// Angle of the point (x, y); at the origin all derivatives are taken as 0.
template <int N>
Jet<N> atan2(const Jet<N>& y, const Jet<N>& x) {
  const double angle = std::atan2(y.v, x.v);
  if constexpr (N == 0) return {angle};
  const double r2 = y.v * y.v + x.v * x.v;
  if (r2 == 0.0) return constantJet<N>(angle);
  const double fy = x.v / r2;
  const double fx = -y.v / r2;
  return chain(y, x, angle, {fy, fx, 2.0 * fy * fx, fx * fx - fy * fy, -2.0 * fy * fx});
}

/// The smaller one; the first if both are equal; NaN if one is NaN.
template <int N>
Jet<N> min(const Jet<N>& a, const Jet<N>& b) {
  return a.v <= b.v || std::isnan(a.v) ? a : b;
}

/// The larger one; the first if both are equal; NaN if one is NaN.
template <int N>
Jet<N> max(const Jet<N>& a, const Jet<N>& b) {
  return a.v >= b.v || std::isnan(a.v) ? a : b;
}

/// a − b ⌊a/b⌋, in [0, b) for b > 0; at a jump the branch to the right.
template <int N>
Jet<N> mod(const Jet<N>& a, const Jet<N>& b) {
  const double k = std::floor(a.v / b.v);
  return chain(a, b, a.v - b.v * k, {1.0, -k, 0.0, 0.0, 0.0});
}

}  // namespace dynamy
