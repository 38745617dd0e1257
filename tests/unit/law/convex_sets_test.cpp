// Convex sets: both tables of proximal points, limits, and the properties that define a proximal
// point.
#include <gtest/gtest.h>

#include <array>

#include "convex_sets_random.hpp"

namespace dynamy::convex {
namespace {

// ---- the table of sets
// ---------------------------------------------------------------------------

TEST(ConvexSets, BilateralConstraintKeepsTheArgument) {
  EXPECT_EQ(prox(Interval{-kInfinity, kInfinity}, -3.5), -3.5);
  EXPECT_EQ(proxDerivative(Interval{-kInfinity, kInfinity}, -3.5), 1.0);
}

TEST(ConvexSets, NoForceIsTheSetOfZero) {
  EXPECT_EQ(prox(Interval{0.0, 0.0}, 7.0), 0.0);
  EXPECT_EQ(prox(Interval{0.0, 0.0}, -7.0), 0.0);
}

TEST(ConvexSets, HalfLinesClampAtZero) {
  EXPECT_EQ(prox(Interval{}, 2.0), 2.0);
  EXPECT_EQ(prox(Interval{}, -2.0), 0.0);
  EXPECT_EQ(prox(Interval{-kInfinity, 0.0}, 2.0), 0.0);
  EXPECT_EQ(prox(Interval{-kInfinity, 0.0}, -2.0), -2.0);
}

TEST(ConvexSets, IntervalClampsAtBothEnds) {
  const Interval C{-1.0, 3.0};
  EXPECT_EQ(prox(C, -2.0), -1.0);
  EXPECT_EQ(prox(C, 0.5), 0.5);
  EXPECT_EQ(prox(C, 4.0), 3.0);
  EXPECT_EQ(proxDerivative(C, 0.5), 1.0);
  EXPECT_EQ(proxDerivative(C, 4.0), 0.0);
}

TEST(ConvexSets, BoxActsComponentwise) {
  const Box<3> C{P3(-1, -2, 0), P3(1, 2, kInfinity)};
  EXPECT_EQ(prox(C, P3(5, -1, -1)), P3(1, -1, 0));
  EXPECT_EQ(proxDerivative(C, P3(5, -1, 3)), Matrix<3>(P3(0, 1, 1).asDiagonal()));
}

TEST(ConvexSets, DiscScalesPointsOutside) {
  const Disc C{2.5};
  EXPECT_EQ(prox(C, P2(1.5, 2.0)), P2(1.5, 2.0));  // on the rim: |x| = 2.5
  EXPECT_LE((prox(C, P2(3.0, -4.0)) - P2(1.5, -2.0)).norm(), 4 * kEps * 2.5);
}

TEST(ConvexSets, BallScalesPointsOutside) {
  // |(1, 2, 2)| = 3.
  EXPECT_LE((prox(Ball<3>{1.0}, P3(1, 2, 2)) - P3(1, 2, 2) / 3.0).norm(), 4 * kEps);
}

TEST(ConvexSets, HalfSpaceMovesAlongItsNormal) {
  const HalfSpace<3> C{P3(0.6, 0.0, 0.8), 1.0};
  EXPECT_EQ(prox(C, P3(0, 5, 0)), P3(0, 5, 0));
  // n·x = 6 exceeds d = 1 by 5: x − 5 n.
  EXPECT_LE((prox(C, P3(10, 1, 0)) - P3(7, 1, -4)).norm(), 100 * kEps);
}

TEST(ConvexSets, AConeWithoutFrictionIsTheHalfLine) {
  // Both sides of |x_T| <= mu x_N are zero here: the sign of x_N decides.
  const FrictionCone<3> K{0.0};
  EXPECT_EQ(prox(K, Point<3>(-1.0, 0.0, 0.0)), Point<3>::Zero());
  EXPECT_EQ(prox(K, Point<3>(2.0, 0.0, 0.0)), Point<3>(2.0, 0.0, 0.0));
  EXPECT_EQ(prox(K, Point<3>(2.0, 1.0, 0.0)), Point<3>(2.0, 0.0, 0.0));
  EXPECT_EQ(proxDerivative(K, Point<3>(-1.0, 0.0, 0.0)), Matrix<3>::Zero());
}

TEST(ConvexSets, FrictionConeFollowsItsThreeCases) {
  const FrictionCone<3> K{0.5};
  EXPECT_EQ(prox(K, P3(2, 0.6, 0.8)), P3(2, 0.6, 0.8));  // on its mantle
  EXPECT_EQ(prox(K, P3(-0.5, 0.6, 0.8)), P3(0, 0, 0));   // on the polar cone's mantle
  // s = (0.5·5 + 0)/(1.25) = 2, result (2, 2·0.5·(0.6, 0.8)).
  EXPECT_LE((prox(K, P3(0, 3, 4)) - P3(2, 0.6, 0.8)).norm(), 10 * kEps);
}

TEST(ConvexSets, SegmentAndPolygonGiveTheNearestPointOfTheirEdges) {
  EXPECT_EQ(prox(Segment<2>{P2(0, 0), P2(2, 0)}, P2(1, 3)), P2(1, 0));
  EXPECT_EQ(prox(Segment<2>{P2(0, 0), P2(2, 0)}, P2(3, 3)), P2(2, 0));
  EXPECT_EQ(prox(Segment<2>{P2(1, 1), P2(1, 1)}, P2(3, 3)), P2(1, 1));
  const std::array<P2, 4> square{P2(0, 0), P2(1, 0), P2(1, 1), P2(0, 1)};
  const ConvexPolygon C{square.data(), 4};
  EXPECT_EQ(prox(C, P2(0.25, 0.75)), P2(0.25, 0.75));
  EXPECT_EQ(prox(C, P2(0.25, 2.0)), P2(0.25, 1.0));
  EXPECT_EQ(prox(C, P2(3, -2)), P2(1, 0));
  EXPECT_EQ(prox(ConvexPolygon{square.data(), 1}, P2(3, -2)), P2(0, 0));
}

// ---- the table of ellipses and ellipsoids
// ----------------------------------------------------------

// 15 printed digits: half a unit of the last one is 5e-15 relative; the prox itself rounds by
// 2e-15.
constexpr double kTable = 1e-14;
template <int n>
void expectRow(const Point<n>& axes, const Point<n>& p, const Point<n>& x, double t) {
  const Ellipsoid<n> C{axes};
  const Point<n> y = prox(C, p);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(y[i], x[i], kTable * std::abs(x[i])) << "component " << i;
  // t near 0 is the root of a difference of numbers of size 1: relative error ε |p|²/t at most.
  const double tolerance = t == 0.0 ? 0.0 : kTable * t + 4 * kEps * p.squaredNorm();
  EXPECT_NEAR(multiplier(C, p), t, tolerance);
}

TEST(ConvexSets, EllipseReproducesTheTable) {
  expectRow<2>(P2(2, 1), P2(3, 2), P2(1.72541125485598, 0.505706436981055), 2.95486363974229);
  expectRow<2>(P2(2, 1), P2(0.5, 0.5), P2(0.5, 0.5), 0.0);
  expectRow<2>(P2(2, 1), P2(0, 3), P2(0, 1), 2.0);
  expectRow<2>(P2(2, 1), P2(3, 0), P2(2, 0), 2.0);
  expectRow<2>(P2(2, 1), P2(2, -0.1), P2(1.99035347660389, -0.0980982137589805),
               0.0193865532117848);
}

TEST(ConvexSets, EllipsoidReproducesTheTable) {
  expectRow<3>(P3(3, 2, 1), P3(4, 3, 2), P3(2.32539709517618, 1.14490413627334, 0.267335830603586),
               6.48122687289778);
  expectRow<3>(P3(3, 2, 1), P3(0, 0, 5), P3(0, 0, 1), 4.0);
  expectRow<3>(P3(1, 1, 1), P3(1, 2, 2), P3(1, 2, 2) / 3.0, 2.0);
  expectRow<3>(P3(0.3, 0.3, 2e-4), P3(0.5, -0.4, 0.001),
               P3(0.23426064283246, -0.187408514265968, 3.91796689720248e-10), 0.102093727123354);
}

// ---- limits
// ----------------------------------------------------------------------------------------

TEST(ConvexSets, RadiusZeroOrBelowGivesZero) {
  for (const double radius : {0.0, -1.0}) {
    EXPECT_EQ(prox(Disc{radius}, P2(3, 4)), P2(0, 0));
    EXPECT_EQ(proxDerivative(Disc{radius}, P2(3, 4)), Matrix<2>(Matrix<2>::Zero()));
    EXPECT_EQ(prox(symmetricInterval(radius), 3.0), 0.0);
    EXPECT_EQ(prox(Ellipsoid<3>{P3::Constant(radius)}, P3(1, 2, 3)), P3(0, 0, 0));
    EXPECT_EQ(proxDerivative(Ellipse{P2::Constant(radius)}, P2(1, 2)),
              Matrix<2>(Matrix<2>::Zero()));
    EXPECT_EQ(prox(Disc{radius}, Matrix<2>(Matrix<2>::Identity()), P2(3, 4)), P2(0, 0));
  }
}

TEST(ConvexSets, FlatEllipseIsASegment) {
  for (const double thin : {0.0, 1e-9}) {
    const Ellipse C{P2(2, thin)};
    EXPECT_EQ(prox(C, P2(1, 5)), P2(1, 0));
    EXPECT_LE((prox(C, P2(3, 5)) - P2(2, 0)).norm(), 4 * kEps);
    EXPECT_EQ(proxDerivative(C, P2(1, 5)), Matrix<2>(P2(1, 0).asDiagonal()));
    EXPECT_LE(proxDerivative(C, P2(3, 5)).norm(), 4 * kEps);
  }
}

TEST(ConvexSets, FlatEllipsoidIsAnEllipse) {
  const P3 x = prox(Ellipsoid<3>{P3(2, 1, 0)}, P3(3, 2, 9));
  EXPECT_LE((x - P3(1.72541125485598, 0.505706436981055, 0)).norm(), kTable * 2);
}

TEST(ConvexSets, SlenderEllipsoidsOfAnySizeAreOptimal) {
  Random random(11);
  for (const double size : {1e-12, 1.0, 1e12}) {
    for (const double thin : {1e-2, 1e-4, 1e-6, 1e-7}) {
      for (int trial = 0; trial < 50; ++trial) {
        const Ellipsoid<3> C{size * P3(1, 0.5, thin)};
        const P3 p = random.point<3>(2 * size);
        const P3 x = prox(C, p);
        const P3 nu = p - x;
        // Fenchel's equality in units of the lengths' product.
        EXPECT_NEAR(support(C, nu), nu.dot(x), 1e-14 * size * p.norm());
      }
    }
  }
}

TEST(ConvexSets, NaNIsPassedOn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(prox(Interval{-1, 1}, nan)));
  EXPECT_TRUE(prox(Disc{1.0}, P2(nan, 0)).hasNaN());
  EXPECT_TRUE(prox(Disc{0.0}, P2(nan, 0)).hasNaN());
  EXPECT_TRUE(prox(Ellipse{P2(2, 1)}, P2(nan, 0)).hasNaN());
  EXPECT_TRUE(prox(FrictionCone<3>{0.5}, P3(nan, 0, 0)).hasNaN());
  EXPECT_FALSE(contains(Disc{1.0}, P2(nan, 0), 1e9));
}

TEST(ConvexSets, SupportOfInfiniteSetsIsNotNaN) {
  EXPECT_EQ(support(Interval{}, 0.0), 0.0);
  EXPECT_EQ(support(Interval{}, -2.0), 0.0);
  EXPECT_EQ(support(Interval{}, 2.0), kInfinity);
  EXPECT_EQ(support(HalfSpace<2>{P2(0, 1), 3.0}, P2(0, 2)), 6.0);
  EXPECT_EQ(support(HalfSpace<2>{P2(0, 1), 3.0}, P2(1, 2)), kInfinity);
  EXPECT_EQ(support(FrictionCone<2>{0.5}, P2(-1, 2)), 0.0);
  EXPECT_EQ(support(FrictionCone<2>{0.5}, P2(1, 0)), kInfinity);
}

// ---- properties of every proximal point
// ------------------------------------------------------------

// In C, idempotent, non-expansive, and (z − x)ᵀ(y − x) ≤ 0 for all y ∈ C.
template <class Set, int n>
void expectProximal(const Set& C, Random& random) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const Point<n> z = random.point<n>(3.0), other = random.point<n>(3.0);
    const Point<n> x = prox(C, z), y = prox(C, other);
    const double rounding = 100 * kEps * (1 + z.norm() + other.norm());  // a dozen operations
    EXPECT_TRUE(contains(C, x, rounding));
    EXPECT_LE((prox(C, x) - x).norm(), rounding);
    EXPECT_LE((x - y).norm(), (z - other).norm() + rounding);
    EXPECT_LE((z - x).dot(y - x), rounding * (1 + z.norm() + other.norm()));
  }
}

template <int n>
void expectProximalInDimension(unsigned seed) {
  Random random(seed);
  expectProximal<Box<n>, n>({-random.positives<n>(), random.positives<n>()}, random);
  expectProximal<Ball<n>, n>({1.3}, random);
  expectProximal<Ellipsoid<n>, n>({random.positives<n>()}, random);
  expectProximal<HalfSpace<n>, n>({random.point<n>().normalized(), 0.4}, random);
  expectProximal<Segment<n>, n>({random.point<n>(), random.point<n>()}, random);
  expectProximal<FrictionCone<n>, n>({0.7}, random);
  expectProximal<FrictionCone<n>, n>({0.0}, random);
}
TEST(ConvexSets, ProximalPointsOfThePlaneObeyTheirInequalities) {
  expectProximalInDimension<2>(21);
}
TEST(ConvexSets, ProximalPointsOfSpaceObeyTheirInequalities) { expectProximalInDimension<3>(22); }

TEST(ConvexSets, ProximalPointsOfAPolygonObeyTheirInequalities) {
  Random random(23);
  const std::vector<P2> corners = pentagon();
  expectProximal<ConvexPolygon, 2>({corners.data(), 5}, random);
  expectProximal<ConvexPolygon, 2>({corners.data(), 2}, random);
}

// Moreau: x = a + b with a in K, b in K°, a·b = 0, and no other a and b.
TEST(ConvexSets, ConeAndPolarConeDecomposeEveryPoint) {
  Random random(31);
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrictionCone<3> K{trial == 0 ? 0.0 : random.positive()};
    const P3 x = random.point<3>(), a = prox(K, x), b = x - a;
    const double rounding = 20 * kEps * (1 + x.norm());
    EXPECT_LE(a.tail<2>().norm(), K.mu * a[0] + rounding);
    EXPECT_LE(K.mu * b.tail<2>().norm(), -b[0] + (1 + K.mu) * rounding);
    EXPECT_NEAR(a.dot(b), 0.0, 20 * kEps * (1 + x.squaredNorm()));
  }
}

TEST(ConvexSets, GradientOfHalfSquaredDistanceIsTheVectorDistance) {
  Random random(32);
  const Ellipse C{P2(2, 0.5)};
  for (int trial = 0; trial < 50; ++trial) {
    const P2 z = random.point<2>(3.0);
    for (int k = 0; k < 2; ++k) {
      const P2 h = 1e-5 * P2::Unit(k);
      const double up = dist(C, P2(z + h)), down = dist(C, P2(z - h));
      // Difference error: ε|z|²/h = 2e-10 beside h² of a function with Lipschitz gradient 1 at the
      // rim: h.
      EXPECT_NEAR((up * up - down * down) / 4e-5, vectorDistance(C, z)[k], 1e-5);
    }
  }
}

}  // namespace
}  // namespace dynamy::convex
