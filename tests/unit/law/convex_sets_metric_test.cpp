// Convex sets in other metrics, and derivatives of the prox. Optimality is judged without the code
// that found it: x = prox_C^R(z) ⇔ x ∈ C and S_C(ν) = νᵀx with ν = R⁻¹(z − x).
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

#include "convex_sets_random.hpp"

namespace dynamy::convex {
namespace {

// x ∈ C and S_C(ν) = νᵀx prove x optimal; both tolerances are a few roundings of the lengths
// involved.
template <class Set, int n>
void expectOptimal(const Set& C, const Matrix<n>& R, const Point<n>& z, const Point<n>& x) {
  const Point<n> nu = R.inverse() * (z - x);
  const double size = 1.0 + z.norm() + x.norm();
  EXPECT_TRUE(contains(C, x, 100 * kEps * size));
  const double tolerance = 1e3 * kEps * size * R.inverse().norm() * size;  // cond(R) ≲ 100
  EXPECT_NEAR(support(C, nu), nu.dot(x), tolerance) << "z = " << z.transpose();
}

// ---- other metrics
// ---------------------------------------------------------------------------------

template <int n>
void expectMetricProx(unsigned seed) {
  Random random(seed);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Matrix<n> R = random.metric<n>();
    const Point<n> z = random.point<n>(3.0), other = random.point<n>(3.0);
    const Ball<n> ball{random.positive()};
    const Ellipsoid<n> ellipsoid{random.positives<n>()};
    const HalfSpace<n> half{random.point<n>().normalized(), 0.3};
    expectOptimal<Ball<n>, n>(ball, R, z, prox(ball, R, z));
    expectOptimal<Ellipsoid<n>, n>(ellipsoid, R, z, prox(ellipsoid, R, z));
    // The half space's support is infinite off its normal: compare the multiplier form instead.
    const Point<n> x = prox(half, R, z), nu = R.inverse() * (z - x);
    EXPECT_LE((nu - half.normal.dot(nu) * half.normal).norm(),
              1e-12 * R.inverse().norm() * (1 + z.norm()));
    // Non-expansive in its own metric.
    const Point<n> dx = prox(ball, R, z) - prox(ball, R, other), dz = z - other;
    EXPECT_LE(dx.dot(R.inverse() * dx), dz.dot(R.inverse() * dz) * (1 + 1e-12) + 1e-12);
  }
}
TEST(ConvexSetsInMetrics, MetricProxInThePlaneIsOptimal) { expectMetricProx<2>(41); }
TEST(ConvexSetsInMetrics, MetricProxInSpaceIsOptimal) { expectMetricProx<3>(42); }

TEST(ConvexSetsInMetrics, MetricDiscAgreesWithAMinimumOverItsRim) {
  Random random(43);
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix<2> R = random.metric<2>(), inverse = R.inverse();
    const P2 z = 4.0 * random.point<2>().normalized();
    double best = kInfinity, angle = 0.0;
    constexpr int kSamples = 20000;
    for (int i = 0; i < kSamples; ++i) {
      const double a = 2 * std::numbers::pi * i / kSamples;
      const P2 d = z - 1.5 * P2(std::cos(a), std::sin(a));
      if (d.dot(inverse * d) < best) best = d.dot(inverse * d), angle = a;
    }
    // Resolution of the samples: half a step 1.5·2π/20000/2 = 2.4e-4.
    const P2 x = prox(Disc{1.5}, R, z);
    EXPECT_LE((x - 1.5 * P2(std::cos(angle), std::sin(angle))).norm(), 2.5e-4);
  }
}

TEST(ConvexSetsInMetrics, MetricPolygonAndSegmentAreOptimal) {
  Random random(44);
  const std::vector<P2> corners = pentagon();
  const ConvexPolygon C{corners.data(), 5};
  for (int trial = 0; trial < kTrials; ++trial) {
    const Matrix<2> R = random.metric<2>();
    const P2 z = random.point<2>(3.0);
    expectOptimal<ConvexPolygon, 2>(C, R, z, prox(C, R, z));
    const Segment<2> edge{corners[0], corners[2]};
    expectOptimal<Segment<2>, 2>(edge, R, z, proxInverse(edge, Matrix<2>(R.inverse()), z));
  }
}

TEST(ConvexSetsInMetrics, MetricEllipsoidOfAnyOrientationIsOptimal) {
  Random random(45);
  for (int trial = 0; trial < kTrials; ++trial) {
    Matrix<3> H = random.metric<3>();
    const Matrix<3> R = random.metric<3>();
    const P3 z = random.point<3>(8.0);
    const double scale = random.positive();
    const P3 x = prox(inMetric(H, R), z, scale), nu = R.inverse() * (z - x);
    // S_C(ν) = scale |Hᵀν|, and x = H y with |y| ≤ scale; conditions of H and R ≲ 100.
    EXPECT_NEAR(scale * (H.transpose() * nu).norm(), nu.dot(x), 1e-11 * (1 + nu.norm() * x.norm()));
    EXPECT_LE((H.inverse() * x).norm(), scale * (1 + 1e-12));
  }
}

TEST(ConvexSetsInMetrics, MetricConeIsOptimal) {
  Random random(46);
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrictionCone<3> K{random.positive()};
    const double rN = random.positive(), rT = random.positive();
    const P3 z = random.point<3>(), x = prox(K, rN, rT, z);
    const P3 nu = P3(rN, rT, rT).cwiseInverse().cwiseProduct(z - x);
    // x ∈ K, ν ∈ K°, xᵀν = 0; sizes exp(±3) at most, a dozen roundings.
    const double tolerance = 1e-12;
    EXPECT_LE(x.tail<2>().norm(), K.mu * x[0] + tolerance * (1 + K.mu));
    EXPECT_LE(K.mu * nu.tail<2>().norm(), -nu[0] + tolerance * (1 + K.mu) * (1 + nu.norm()));
    EXPECT_NEAR(x.dot(nu), 0.0, tolerance * (1 + nu.norm()));
  }
}

TEST(ConvexSetsInMetrics, UnequalStepsWithAEuclideanProxSolveAnotherLaw) {
  // λ = prox(λ − Rξ) on the disc: with R = diag(1, 9) the metric prox answers slip with a force
  // opposite to ξ, the Euclidean one with a force opposite to Rξ.
  const Matrix<2> R = P2(1, 9).asDiagonal();
  const P2 xi(1, 1), lambda = -xi.normalized();
  EXPECT_LE((prox(Disc{1.0}, R, P2(lambda - R * xi)) - lambda).norm(), 20 * kEps);
  EXPECT_GT((prox(Disc{1.0}, P2(lambda - R * xi)) - lambda).norm(), 0.5);
}

// Central differences: error h²/6 |x'''| + ε|x|/h, at h = 1e-5 and third derivatives ≲ 1e3: < 1e-7.
constexpr double kStep = 1e-5, kDifferenceTolerance = 1e-6;
template <class Prox>
double gap(const Matrix<3>& J, Prox f, const P3& z) {
  Matrix<3> differences;
  for (int k = 0; k < 3; ++k) {
    const P3 h = kStep * P3::Unit(k);
    differences.col(k) = (f(P3(z + h)) - f(P3(z - h))) / (2 * kStep);
  }
  return (J - differences).norm();
}
bool awayFromKinks(double mu, const P3& z) {
  const double zT = z.tail<2>().norm();
  return zT > 0.1 && std::abs(zT - mu * z[0]) > 1e-2 && std::abs(mu * zT + z[0]) > 1e-2;
}

// ---- derivatives
// -------------------------------------------------------------------------------------

TEST(ConvexSetDerivatives, EllipsoidDerivativeSolvesTheKktSystem) {
  // Second formulation: [I + tA, Ax; xᵀA, 0] [dx; dt] = [dp; 0], A = diag(1/a²).
  Random random(51);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Ellipsoid<3> C{random.positives<3>()};
    const P3 p = random.point<3>(6.0), x = prox(C, p);
    const double t = multiplier(C, p);
    if (t <= 1e-6) continue;
    const P3 A = C.axes.cwiseProduct(C.axes).cwiseInverse();
    Eigen::Matrix4d kkt = Eigen::Matrix4d::Zero();
    kkt.topLeftCorner<3, 3>() = Matrix<3>((P3::Ones() + t * A).asDiagonal());
    kkt.topRightCorner<3, 1>() = A.cwiseProduct(x);
    kkt.bottomLeftCorner<1, 3>() = A.cwiseProduct(x).transpose();
    const Matrix<3> J = kkt.fullPivLu().inverse().topLeftCorner<3, 3>();
    EXPECT_LE((proxDerivative(C, p) - J).norm(), 1e-11);  // condition of the system ≲ 1e4
  }
}

TEST(ConvexSetDerivatives, DiscDerivativeIsThatOfACircularEllipse) {
  const P2 p(3, -1);
  EXPECT_LE((proxDerivative(Disc{1.7}, p) - proxDerivative(Ellipse{P2(1.7, 1.7)}, p)).norm(),
            20 * kEps);
  EXPECT_LE((1.7 * p.normalized() - scaleDerivative(Ellipse{P2(1.7, 1.7)}, p)).norm(),  // |p| > 1.7
            20 * kEps);
}

TEST(ConvexSetDerivatives, DerivativesAgreeWithDifferences) {
  Random random(52);
  for (int trial = 0; trial < kTrials; ++trial) {
    const P3 z = random.point<3>(2.0);
    const Ball<3> ball{1.0};
    const FrictionCone<3> K{0.6};
    const MetricEllipsoid<3> metric = inMetric(Ellipsoid<3>{P3(1, 0.7, 0.5)}, random.metric<3>());
    const auto onBall = [&](const P3& x) { return prox(ball, x); };
    const auto onCone = [&](const P3& x) { return prox(K, x); };
    const auto onMetricCone = [&](const P3& x) { return prox(K, 2.0, 0.5, x); };
    const auto onMetric = [&](const P3& x) { return prox(metric, x, 1.2); };
    // Away from the kinks, where one-sided derivatives differ.
    if (std::abs(z.norm() - 1.0) > 1e-2) {
      EXPECT_LE(gap(proxDerivative(ball, z), onBall, z), kDifferenceTolerance);
    }
    if (awayFromKinks(0.6, z)) {
      EXPECT_LE(gap(proxDerivative(K, z), onCone, z), kDifferenceTolerance);
    }
    const P3 rows(std::sqrt(2.0), std::sqrt(0.5), std::sqrt(0.5));
    if (awayFromKinks(0.6 * rows[0] / rows[1], z.cwiseQuotient(rows))) {
      EXPECT_LE(gap(proxDerivative(K, 2.0, 0.5, z), onMetricCone, z), kDifferenceTolerance);
    }
    const double depth = (metric.toPrincipal * z).cwiseQuotient(1.2 * metric.axes).norm();
    if (std::abs(depth - 1.0) > 5e-2) {
      EXPECT_LE(gap(proxDerivative(metric, z, 1.2), onMetric, z), kDifferenceTolerance);
    }
  }
}

TEST(ConvexSetDerivatives, ScaleDerivativeFollowsFromHomogeneity) {
  // prox_{sC}(z) = s prox_C(z/s), hence s d/ds = x − J z.
  Random random(53);
  for (int trial = 0; trial < kTrials; ++trial) {
    const MetricEllipsoid<3> C = inMetric(Ellipsoid<3>{random.positives<3>()}, random.metric<3>());
    const P3 z = random.point<3>(4.0);
    const double s = random.positive();
    const P3 expected = (prox(C, z, s) - proxDerivative(C, z, s) * z) / s;
    EXPECT_LE((scaleDerivative(C, z, s) - expected).norm(), 1e-11 * (1 + z.norm() / s));
  }
}

TEST(ConvexSetDerivatives, DerivativesAreSymmetricWithEigenvaluesBetweenZeroAndOne) {
  // A prox is the gradient of a convex function and non-expansive.
  Random random(54);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Ellipsoid<3> C{random.positives<3>()};
    const Matrix<3> J = proxDerivative(C, random.point<3>(3.0));
    EXPECT_LE((J - J.transpose()).norm(), 10 * kEps);
    const P3 y = random.point<3>();
    EXPECT_GE(y.dot(J * y), -10 * kEps * y.squaredNorm());
    EXPECT_LE(y.dot(J * y), (1 + 10 * kEps) * y.squaredNorm());
  }
}

}  // namespace
}  // namespace dynamy::convex
