// Ellipsoids and polygons: the proximal points that need an iteration or a loop.
//   p outside: xᵢ = aᵢ² pᵢ/(t + aᵢ²),  t > 0 the root of |w(t)| = 1,  wᵢ = aᵢ pᵢ/(t + aᵢ²).
// Newton runs on 1 − 1/|w(t)|, which is convex and decreasing like |w|² − 1 itself, but nearly
// linear: it climbs monotonically from the left, needs no safeguard, and is exact in one step for a
// sphere. The polynomial of degree 4 or 6 was rejected: its coefficients overflow and cancel for
// slender sets.
#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <cassert>
#include <dynamy/law/convex_sets.hpp>

namespace dynamy::convex {
namespace {

// Data of the secular equation, lengths divided by the largest axis.
template <int n>
struct Secular {
  double scale;    // largest axis; 0: the set is the origin
  Point<n> a, p;   // axes (flat ones exactly 0) and point
  Point<n> d;      // t + aᵢ²
  Point<n> w;      // aᵢ pᵢ/(t + aᵢ²)
  double t = 0.0;  // 0: inside
  bool outside = false;
};

// wᵢ at the present t; flat axes carry no force.
template <int n>
double evaluate(Secular<n>& s) {
  for (int i = 0; i < n; ++i) {
    s.d[i] = s.t + s.a[i] * s.a[i];
    s.w[i] = s.a[i] > 0.0 ? s.a[i] * s.p[i] / s.d[i] : 0.0;
  }
  return s.w.norm();
}

template <int n>
Secular<n> solveSecular(const Ellipsoid<n>& C, const In<n>& point) {
  Secular<n> s;
  s.scale = C.axes.maxCoeff();
  if (!(s.scale > 0.0)) {
    s.scale = 0.0;
    return s;
  }
  s.a = C.axes / s.scale;
  s.p = point / s.scale;
  for (int i = 0; i < n; ++i) {
    if (s.a[i] < kFlat) s.a[i] = 0.0;
  }
  double length = evaluate(s);
  if (length <= 1.0) return s;

  // Start at the t where one term alone reaches 1. There 1 ≤ |w| ≤ √n, left of the root.
  s.outside = true;
  for (int i = 0; i < n; ++i) s.t = std::max(s.t, s.a[i] * (std::abs(s.p[i]) - s.a[i]));
  constexpr int kMostSteps = 30;  // 2 to 5 steps are usual, 10 the most in 2e5 random cases
  for (int k = 0; k < kMostSteps; ++k) {
    length = evaluate(s);
    double slope = 0.0;  // −½ d|w|²/dt
    for (int i = 0; i < n; ++i) {
      if (s.a[i] > 0.0) slope += s.w[i] * s.w[i] / s.d[i];
    }
    const double step = (length - 1.0) * length * length / slope;
    s.t += std::max(step, 0.0);
    // Quadratic convergence on the scale t: the error left is about (1e-9)². Also ends NaN.
    if (!(step > 1e-9 * s.t)) break;
  }
  evaluate(s);
  return s;
}

// Direction g = D n of steepest motion of the contact point and nᵀg, in scaled lengths.
template <int n>
double contourDirection(const Secular<n>& s, Point<n>& g) {
  double ng = 0.0;
  for (int i = 0; i < n; ++i) {
    g[i] = s.a[i] > 0.0 ? s.a[i] * s.w[i] / s.d[i] : 0.0;
    ng += s.a[i] > 0.0 ? s.w[i] * s.w[i] / s.d[i] : 0.0;
  }
  return ng;
}

double cross(const Point<2>& a, const Point<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

Point<2> proxInverse(const ConvexPolygon& C, const Matrix<2>& Rinverse, const Point<2>& x) {
  // Inside: on the left of every edge; a polygon without area has no inside.
  bool inside = C.count > 2;
  for (int i = 0; i < C.count && inside; ++i) {
    const Point<2>& from = C.corners[i];
    const Point<2>& to = C.corners[(i + 1) % C.count];
    inside = cross(to - from, x - from) >= 0.0;
  }
  if (inside) return x;

  // Outside: each edge has a nearest point; take the nearest of these.
  Point<2> best = C.corners[0];
  double nearest = kInfinity;
  for (int i = 0; i < C.count; ++i) {
    const Segment<2> edge{C.corners[i], C.corners[(i + 1) % C.count]};
    const Point<2> y = convex::proxInverse(edge, Rinverse, x);
    const double square = (x - y).dot(Rinverse * (x - y));
    if (square < nearest || std::isnan(square)) {
      best = y;
      nearest = square;
    }
  }
  return best;
}

}  // namespace

template <int n>
double multiplier(const Ellipsoid<n>& C, const In<n>& p) {
  const Secular<n> s = solveSecular(C, p);
  return s.t * s.scale * s.scale;
}

template <int n>
Point<n> prox(const Ellipsoid<n>& C, const In<n>& p) {
  const Secular<n> s = solveSecular(C, p);
  if (s.scale == 0.0) return p * 0.0;
  if (!s.outside) {
    Point<n> x;
    for (int i = 0; i < n; ++i) x[i] = s.a[i] > 0.0 ? p[i] : 0.0;
    return x;
  }
  return (s.scale / s.w.norm()) * s.a.cwiseProduct(s.w);
}

template <int n>
Matrix<n> proxDerivative(const Ellipsoid<n>& C, const In<n>& p) {
  const Secular<n> s = solveSecular(C, p);
  Matrix<n> J = Matrix<n>::Zero();
  if (s.scale == 0.0) return J;
  for (int i = 0; i < n; ++i) {
    if (s.a[i] > 0.0) J(i, i) = s.outside ? s.a[i] * s.a[i] / s.d[i] : 1.0;
  }
  if (!s.outside) return J;
  Point<n> g;
  const double ng = contourDirection(s, g);
  return J - g * g.transpose() / ng;
}

template <int n>
Point<n> scaleDerivative(const Ellipsoid<n>& C, const In<n>& p) {
  const Secular<n> s = solveSecular(C, p);
  Point<n> g = Point<n>::Zero();
  if (!s.outside) return g;
  const double ng = contourDirection(s, g);
  return g * (s.scale / ng);
}

template <int n>
MetricEllipsoid<n> inMetric(const Matrix<n>& H, const Matrix<n>& R) {
  const Eigen::LLT<Matrix<n>> llt(R);
  assert(llt.info() == Eigen::Success && "the metric must be positive definite");
  const Matrix<n> L = llt.matrixL();
  // Singular values of L⁻¹H rather than eigenvalues of its square: small axes keep their digits.
  const Matrix<n> Linverse =
      L.template triangularView<Eigen::Lower>().solve(Matrix<n>(Matrix<n>::Identity()));
  const Eigen::JacobiSVD<Matrix<n>> svd(Linverse * H, Eigen::ComputeFullU);
  return {L * svd.matrixU(), svd.matrixU().transpose() * Linverse, svd.singularValues()};
}

template <int n>
MetricEllipsoid<n> inMetric(const Ellipsoid<n>& C, const Matrix<n>& R) {
  return inMetric(Matrix<n>(C.axes.asDiagonal()), R);
}

Point<2> prox(const ConvexPolygon& C, const Point<2>& x) {
  return proxInverse(C, Matrix<2>::Identity(), x);
}

Point<2> prox(const ConvexPolygon& C, const Matrix<2>& R, const Point<2>& x) {
  // Only the direction of R⁻¹ matters: adj(R) = det(R) R⁻¹ spares the division.
  Matrix<2> adjugate;
  adjugate << R(1, 1), -R(0, 1), -R(1, 0), R(0, 0);
  return proxInverse(C, adjugate, x);
}

double support(const ConvexPolygon& C, const Point<2>& y) {
  double S = -kInfinity;
  for (int i = 0; i < C.count; ++i) S = std::max(S, C.corners[i].dot(y));
  return S;
}

template double multiplier<2>(const Ellipsoid<2>&, const Point<2>&);
template double multiplier<3>(const Ellipsoid<3>&, const Point<3>&);
template Point<2> prox<2>(const Ellipsoid<2>&, const Point<2>&);
template Point<3> prox<3>(const Ellipsoid<3>&, const Point<3>&);
template Matrix<2> proxDerivative<2>(const Ellipsoid<2>&, const Point<2>&);
template Matrix<3> proxDerivative<3>(const Ellipsoid<3>&, const Point<3>&);
template Point<2> scaleDerivative<2>(const Ellipsoid<2>&, const Point<2>&);
template Point<3> scaleDerivative<3>(const Ellipsoid<3>&, const Point<3>&);
template MetricEllipsoid<2> inMetric<2>(const Matrix<2>&, const Matrix<2>&);
template MetricEllipsoid<3> inMetric<3>(const Matrix<3>&, const Matrix<3>&);
template MetricEllipsoid<2> inMetric<2>(const Ellipsoid<2>&, const Matrix<2>&);
template MetricEllipsoid<3> inMetric<3>(const Ellipsoid<3>&, const Matrix<3>&);

}  // namespace dynamy::convex
