// Convex sets of force laws and their proximal points, the only non-smooth operation of the
// framework:
//   prox_C(z) = argmin |z − x|,   prox_C^R(z) = argmin (z − x)ᵀ R⁻¹ (z − x),   x ∈ C,
//   −ξ ∈ N_C(Λ)  ⇔  Λ = prox_C^R(Λ − R ξ)          for every symmetric positive definite R.
// A set is a small aggregate and every operation a free function, so that prox(Disc{mu * N}, z)
// reads as the formula. A class hierarchy of sets was rejected: the sets sit in the innermost loop
// of a solver and their dimensions are known at compile time. Interval, ball and cone are inline
// for that reason.
//
// Mind the metric: rows of one coupled set with unequal r need the prox in the metric R = diag(r).
// An iteration with the Euclidean prox of Λ − R ξ converges as well, but to another law
// (−R ξ ∈ N_C(Λ)).
//
// A radius below zero counts as zero: it occurs while a solver iterates normal forces. NaN is
// passed on.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <limits>
#include <type_traits>

namespace dynamy::convex {

template <int n>
using Point = Eigen::Matrix<double, n, 1>;
/// Argument whose n comes from the set alone, so that maps and expressions may be passed.
template <int n>
using In = std::type_identity_t<Point<n>>;
/// R of the metric R⁻¹, also the derivative of a prox: n × n.
template <int n>
using Matrix = Eigen::Matrix<double, n, n>;

// ---- interval and box --------------------------------------------------------------------------

/// C = [lower, upper], lower ≤ upper, ends may be infinite: contact [0, ∞), planar friction [−μN,
/// μN], joint (−∞, ∞). Any metric gives the same prox.
struct Interval {
  double lower = 0.0;
  double upper = kInfinity;
};

/// [−radius, radius], a negative radius counting as zero.
inline Interval symmetricInterval(double radius) {
  const double a = std::max(radius, 0.0);
  return {-a, a};
}
inline double prox(const Interval& C, double x) {
  return std::min(std::max(x, C.lower), C.upper);  // this order of arguments keeps NaN
}
/// Element of the generalised Jacobian; 0 on the ends themselves, unless the interval is all of R.
inline double proxDerivative(const Interval& C, double x) {
  return C.lower < x && x < C.upper ? 1.0 : 0.0;
}
/// S_C(y) = sup { y x : x ∈ C }.
inline double support(const Interval& C, double y) {
  if (y == 0.0) return 0.0;  // 0 · ∞ = 0 here
  return y * (y > 0.0 ? C.upper : C.lower);
}

/// C = [lower₁, upper₁] × … × [lowerₙ, upperₙ]. The prox holds in every diagonal metric.
template <int n>
struct Box {
  Point<n> lower, upper;
  Interval side(int i) const { return {lower[i], upper[i]}; }
};
template <int n>
Point<n> prox(const Box<n>& C, const In<n>& x) {
  Point<n> y;
  for (int i = 0; i < n; ++i) y[i] = prox(C.side(i), x[i]);
  return y;
}
template <int n>
Matrix<n> proxDerivative(const Box<n>& C, const In<n>& x) {
  Matrix<n> J = Matrix<n>::Zero();
  for (int i = 0; i < n; ++i) J(i, i) = proxDerivative(C.side(i), x[i]);
  return J;
}
template <int n>
double support(const Box<n>& C, const In<n>& y) {
  double S = 0.0;
  for (int i = 0; i < n; ++i) S += support(C.side(i), y[i]);
  return S;
}

// ---- ball --------------------------------------------------------------------------------------

/// C = { |x| ≤ radius }. Isotropic Coulomb friction: Disc{mu * N}. The prox holds for R = r I; for
/// other metrics see MetricEllipsoid.
template <int n>
struct Ball {
  double radius = 0.0;
};
using Disc = Ball<2>;

template <int n>
Point<n> prox(const Ball<n>& C, const In<n>& x) {
  if (C.radius <= 0.0) return x * 0.0;
  const double square = x.squaredNorm();
  if (square <= C.radius * C.radius) return x;
  return x * (C.radius / std::sqrt(square));
}
/// dprox/dx: I inside, (a/|x|)(I − e eᵀ) outside, e = x/|x|.
template <int n>
Matrix<n> proxDerivative(const Ball<n>& C, const In<n>& x) {
  if (C.radius <= 0.0) return Matrix<n>::Zero();
  const double length = x.norm();
  if (length <= C.radius) return Matrix<n>::Identity();
  const Point<n> e = x / length;
  return (C.radius / length) * (Matrix<n>::Identity() - e * e.transpose());
}
template <int n>
double support(const Ball<n>& C, const In<n>& y) {
  return std::max(C.radius, 0.0) * y.norm();
}

// ---- ellipsoid ---------------------------------------------------------------------------------

/// C = { Σ (xᵢ/aᵢ)² ≤ 1 } in its principal frame, semi-axes aᵢ ≥ 0. An axis shorter than kFlat
/// times the largest one counts as zero, because t + aᵢ² (see multiplier) would lose its digits.
/// The error is at most that axis.
template <int n>
struct Ellipsoid {
  Point<n> axes;
};
using Ellipse = Ellipsoid<2>;
inline constexpr double kFlat = 1e-8;

/// Root t ≥ 0 of the secular equation Σ (aᵢ pᵢ/(t + aᵢ²))² = 1, unit of aᵢ²; 0 for p inside.
template <int n>
double multiplier(const Ellipsoid<n>& C, const In<n>& p);
/// xᵢ = aᵢ² pᵢ/(t + aᵢ²), multiplied by a factor 1 + O(ε) that puts x on the contour.
template <int n>
Point<n> prox(const Ellipsoid<n>& C, const In<n>& p);
/// J = D − g gᵀ/(nᵀg) with D = diag(aᵢ²/(t + aᵢ²)), normal nᵢ = pᵢ/(t + aᵢ²), g = D n.
template <int n>
Matrix<n> proxDerivative(const Ellipsoid<n>& C, const In<n>& p);
/// d prox_{sC}(p)/ds at s = 1: 0 inside, g/(nᵀg) outside.
template <int n>
Point<n> scaleDerivative(const Ellipsoid<n>& C, const In<n>& p);
template <int n>
double support(const Ellipsoid<n>& C, const In<n>& y) {
  return C.axes.cwiseProduct(y).norm();
}

/// An ellipsoid (or ball) seen in a metric R⁻¹: with R = L Lᵀ and L⁻¹ diag(a) = Q diag(b) Vᵀ the
/// map x = L Q y turns prox_C^R into the Euclidean prox onto the ellipsoid with semi-axes b. Built
/// once while R and the shape stay; `scale` lets the set grow with the normal force.
template <int n>
struct MetricEllipsoid {
  Matrix<n> fromPrincipal;  ///< L Q
  Matrix<n> toPrincipal;    ///< Qᵀ L⁻¹
  Point<n> axes;            ///< b
  Ellipsoid<n> scaled(double scale) const { return {axes * std::max(scale, 0.0)}; }
};
/// @pre R symmetric positive definite. The ellipsoid has its principal frame along the rows of R.
template <int n>
MetricEllipsoid<n> inMetric(const Ellipsoid<n>& C, const Matrix<n>& R);
/// The ellipsoid C = { H y : |y| ≤ 1 } in the metric R⁻¹: any orientation, H may be singular.
template <int n>
MetricEllipsoid<n> inMetric(const Matrix<n>& H, const Matrix<n>& R);
template <int n>
Point<n> prox(const MetricEllipsoid<n>& C, const In<n>& z, double scale = 1.0) {
  return C.fromPrincipal * prox(C.scaled(scale), Point<n>(C.toPrincipal * z));
}
template <int n>
Matrix<n> proxDerivative(const MetricEllipsoid<n>& C, const In<n>& z, double scale = 1.0) {
  return C.fromPrincipal * proxDerivative(C.scaled(scale), Point<n>(C.toPrincipal * z)) *
         C.toPrincipal;
}
/// d prox/dscale; zero for scale ≤ 0, where the set is a point.
template <int n>
Point<n> scaleDerivative(const MetricEllipsoid<n>& C, const In<n>& z, double scale = 1.0) {
  if (scale <= 0.0) return Point<n>::Zero();
  return C.fromPrincipal * scaleDerivative(C.scaled(scale), Point<n>(C.toPrincipal * z)) / scale;
}
/// One-shot forms; R symmetric positive definite. For repeated use keep the MetricEllipsoid.
template <int n>
Point<n> prox(const Ball<n>& C, const Matrix<n>& R, const In<n>& z) {
  return prox(inMetric(Ellipsoid<n>{Point<n>::Ones()}, R), z, C.radius);
}
template <int n>
Point<n> prox(const Ellipsoid<n>& C, const Matrix<n>& R, const In<n>& z) {
  return prox(inMetric(C, R), z);
}

// ---- second-order cone -------------------------------------------------------------------------

/// K = { |x_T| ≤ μ x_N }, x = (x_N, x_T), μ ≥ 0; its polar cone is { μ |x_T| ≤ −x_N }.
template <int n>
struct FrictionCone {
  double mu = 0.0;
};
template <int n>
Point<n> prox(const FrictionCone<n>& K, const In<n>& x) {
  const double xT = x.template tail<n - 1>().norm();
  if (x[0] >= 0.0 && xT <= K.mu * x[0]) return x;  // the sign for μ = 0, where both sides may be 0
  if (K.mu * xT <= -x[0]) return Point<n>::Zero();
  const double s = (K.mu * xT + x[0]) / (1.0 + K.mu * K.mu);
  Point<n> y;
  y[0] = s;
  y.template tail<n - 1>() = x.template tail<n - 1>() * (K.mu * s / xT);
  return y;
}
template <int n>
Matrix<n> proxDerivative(const FrictionCone<n>& K, const In<n>& x) {
  const double xT = x.template tail<n - 1>().norm();
  if (x[0] >= 0.0 && xT <= K.mu * x[0]) return Matrix<n>::Identity();
  if (K.mu * xT <= -x[0]) return Matrix<n>::Zero();
  // Projection onto the generator (1, μ e), plus the turning of e.
  const double s = (K.mu * xT + x[0]) / (1.0 + K.mu * K.mu);
  Point<n> generator, e;
  e << 0.0, x.template tail<n - 1>() / xT;
  generator = K.mu * e;
  generator[0] = 1.0;
  Matrix<n> J = generator * generator.transpose() / (1.0 + K.mu * K.mu);
  Matrix<n> turning = Matrix<n>::Identity() - e * e.transpose();
  turning(0, 0) = 0.0;
  return J + (K.mu * s / xT) * turning;
}
/// prox in the metric R = diag(rN, rT, …): the cone of √(rN/rT) μ in rows divided by √r.
template <int n>
Point<n> prox(const FrictionCone<n>& K, double rN, double rT, const In<n>& x) {
  Point<n> root = Point<n>::Constant(std::sqrt(rT));
  root[0] = std::sqrt(rN);
  const FrictionCone<n> scaled{K.mu * root[0] / root[n - 1]};
  return root.cwiseProduct(prox(scaled, Point<n>(x.cwiseQuotient(root))));
}
template <int n>
Matrix<n> proxDerivative(const FrictionCone<n>& K, double rN, double rT, const In<n>& x) {
  Point<n> root = Point<n>::Constant(std::sqrt(rT));
  root[0] = std::sqrt(rN);
  const FrictionCone<n> scaled{K.mu * root[0] / root[n - 1]};
  return root.asDiagonal() * proxDerivative(scaled, Point<n>(x.cwiseQuotient(root))) *
         root.cwiseInverse().asDiagonal();
}
/// 0 on the polar cone, else ∞.
template <int n>
double support(const FrictionCone<n>& K, const In<n>& y) {
  return K.mu * y.template tail<n - 1>().norm() <= -y[0] ? 0.0 : kInfinity;
}

// ---- half space, segment, polygon --------------------------------------------------------------

/// C = { normalᵀx ≤ offset }, |normal| = 1.
template <int n>
struct HalfSpace {
  Point<n> normal;
  double offset = 0.0;
};
template <int n>
Point<n> prox(const HalfSpace<n>& C, const In<n>& x) {
  return x - std::max(C.normal.dot(x) - C.offset, 0.0) * C.normal;
}
template <int n>
Point<n> prox(const HalfSpace<n>& C, const Matrix<n>& R, const In<n>& x) {
  const Point<n> Rn = R * C.normal;
  return x - (std::max(C.normal.dot(x) - C.offset, 0.0) / C.normal.dot(Rn)) * Rn;
}
/// s offset for y = s normal with s ≥ 0, else ∞; the direction is judged to 1e-14 |y|, its
/// rounding.
template <int n>
double support(const HalfSpace<n>& C, const In<n>& y) {
  const double s = C.normal.dot(y);
  const bool along = s >= 0.0 && (y - s * C.normal).norm() <= 1e-14 * y.norm();
  return along ? s * C.offset : kInfinity;
}

/// C = { from + s (to − from), 0 ≤ s ≤ 1 }; both ends may coincide.
template <int n>
struct Segment {
  Point<n> from, to;
};
/// prox in the metric R⁻¹, where the argument is R⁻¹ and not R; the identity makes it Euclidean.
template <int n>
Point<n> proxInverse(const Segment<n>& C, const Matrix<n>& Rinverse, const In<n>& x) {
  const Point<n> edge = C.to - C.from, dual = Rinverse * edge;
  const double square = edge.dot(dual);
  if (square <= 0.0) return C.from;
  return C.from + prox(Interval{0.0, 1.0}, dual.dot(x - C.from) / square) * edge;
}
template <int n>
Point<n> prox(const Segment<n>& C, const In<n>& x) {
  return proxInverse(C, Matrix<n>(Matrix<n>::Identity()), x);
}
template <int n>
double support(const Segment<n>& C, const In<n>& y) {
  return std::max(C.from.dot(y), C.to.dot(y));
}

/// Convex hull of `count` ≥ 1 corners given counter-clockwise; two corners are a segment. The
/// corners are borrowed.
struct ConvexPolygon {
  const Point<2>* corners = nullptr;
  int count = 0;
};
Point<2> prox(const ConvexPolygon& C, const Point<2>& x);
/// prox in the metric R⁻¹, R symmetric positive definite.
Point<2> prox(const ConvexPolygon& C, const Matrix<2>& R, const Point<2>& x);
double support(const ConvexPolygon& C, const Point<2>& y);

// ---- for every set -----------------------------------------------------------------------------

/// x − prox_C(x): the gradient of ½ dist_C², an element of N_C(prox_C(x)).
template <class Set, class X>
X vectorDistance(const Set& C, const X& x) {
  return x - prox(C, x);
}
template <class Set>
double dist(const Set& C, double x) {
  return std::abs(vectorDistance(C, x));
}
template <class Set, int n>
double dist(const Set& C, const Eigen::Matrix<double, n, 1>& x) {
  return vectorDistance(C, x).norm();
}
/// x lies in C or at most `tolerance` ≥ 0 (unit of x) outside; false for NaN.
template <class Set, class X>
bool contains(const Set& C, const X& x, double tolerance = 0.0) {
  return dist(C, x) <= tolerance;
}

}  // namespace dynamy::convex
