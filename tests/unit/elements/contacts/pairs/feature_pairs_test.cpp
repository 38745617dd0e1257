// Pairs of features one by one against brute force: the distance of two bodies by alternating
// projections, rates by differences along a motion.
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <random>
#include <unit/elements/contacts/faceted_bodies.hpp>
#include <vector>

namespace dynamy {
namespace {

using testing::turned;

/// A box about the origin of its frame.
struct FacetedBox {
  Frame frame;
  Vec3 half;
  Polyhedron of;
  PlacedPolyhedron placed;
  FacetedBox(const Vec3& c, const Mat3& R, const Vec3& h, const Vec3& v = Vec3::Zero(),
             const Vec3& Omega = Vec3::Zero())
      : half(h), of(boxTriangles(h)) {
    frame.r_OS_I = c, frame.A_IK = R, frame.v_S_I = v, frame.Omega_I = Omega;
    placed = {&frame, &of, c, R};
  }
  FacetedBox(const FacetedBox&) = delete;
  FacetedBox& operator=(const FacetedBox&) = delete;
  Vec3 nearest(const Vec3& p) const {
    const Vec3 local = placed.R.transpose() * (p - placed.c);
    return placed.c + placed.R * local.cwiseMax(-half).cwiseMin(half);
  }
  int faces(const Vec3& p) const {
    const Vec3 local = (placed.R.transpose() * (p - placed.c)).cwiseAbs();
    return static_cast<int>(((half - local).array() < 1e-6).count());
  }
};

struct Draw {
  std::mt19937 random;
  double operator()() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); }
  Vec3 vec() { return {(*this)(), (*this)(), (*this)()}; }
};

constexpr unsigned kFeatureSeed = 21;

TEST(FeaturePairs, NearestOneThatIsPresentHasTheDistanceOfTheBodies) {
  Draw draw{std::mt19937(kFeatureSeed)};
  int met = 0, edges = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const FacetedBox A(Vec3::Zero(), turned(2.0 * draw.vec()),
                       Vec3::Constant(0.6) + 0.3 * draw.vec());
    const FacetedBox B(draw.vec().normalized() * (1.6 + 0.4 * draw()), turned(2.0 * draw.vec()),
                       Vec3::Constant(0.6) + 0.3 * draw.vec());
    Vec3 a = A.placed.c, b = B.placed.c;
    for (int i = 0; i < 20000; ++i) b = B.nearest(a), a = A.nearest(b);
    const double distance = (b - a).norm();
    if (distance < 1e-2 || distance > 0.5) continue;
    // Both points of a pair that is present belong to the bodies, but for kSameFeature of them.
    const int all = featurePairs(A.of, B.of);
    EXPECT_EQ(all, 8 * 6 + 8 * 6 + 12 * 12);
    for (int f = 0; f < all; ++f) {
      double presence = 0.0;
      const ContactPoint at = featurePair(A.placed, B.placed, f, true, presence);
      EXPECT_TRUE(presence <= 0.0 || std::abs(at.g) > distance - 1e-5) << trial << ": " << f;
    }
    // Where corner and face or two edges are nearest, that pair is noted and tells the distance.
    const int fa = A.faces(a), fb = B.faces(b);
    const bool crossing = fa == 2 && fb == 2;
    if (!(fa == 3 && fb == 1) && !(fa == 1 && fb == 3) && !crossing) continue;
    std::vector<int> near;
    nearFeatures(A.placed, B.placed, {distance + 1e-6, 0.0}, near);
    double smallest = 1e300;
    for (const int f : near) {
      double presence = 0.0;
      const ContactPoint at = featurePair(A.placed, B.placed, f, true, presence);
      if (presence > 0.0) smallest = std::min(smallest, at.g);
    }
    ++met, edges += crossing;
    EXPECT_NEAR(smallest, distance, 1e-6) << "trial " << trial << ": " << fa << ' ' << fb;
  }
  EXPECT_GT(met, 60) << "seed " << kFeatureSeed;
  EXPECT_GT(edges, 5) << "seed " << kFeatureSeed;
}

TEST(FeaturePairs, GapsGoOnSmoothlyWithTheVelocityAlongTheNormal) {
  Draw draw{std::mt19937(kFeatureSeed)};
  int looked = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 hA = Vec3::Constant(0.6) + 0.3 * draw.vec(),
               hB = Vec3::Constant(0.6) + 0.3 * draw.vec();
    const Vec3 cB = 2.0 * draw.vec(), vA = draw.vec(), vB = draw.vec(), wA = draw.vec(),
               wB = draw.vec();
    const Mat3 RA = turned(2.0 * draw.vec()), RB = turned(2.0 * draw.vec());
    const auto at = [&](double t, int f, ContactPoint& out, double& presence, double* rate) {
      const FacetedBox A(t * vA, turned(t * wA) * RA, hA, vA, wA);
      const FacetedBox B(cB + t * vB, turned(t * wB) * RB, hB, vB, wB);
      out = featurePair(A.placed, B.placed, f, true, presence);
      if (rate)
        *rate = out.d[0].dot(B.frame.velocity(out.P - B.frame.r_OS_I) -
                             A.frame.velocity(out.P - A.frame.r_OS_I));
    };
    for (int f = 0; f < 240; ++f) {
      ContactPoint before, now, after;
      double presence = 0.0, rate = 0.0;
      constexpr double d = 1e-5;
      at(-d, f, before, presence, nullptr), at(d, f, after, presence, nullptr);
      at(0.0, f, now, presence, &rate);
      // Parallel edges, and those whose normal is about to turn round, have no gap to follow.
      if (presence < -2.0 || now.d[0].dot(before.d[0]) < 0.9) continue;
      if (f >= 96 && presence <= 0.0) continue;
      ++looked;
      // Central differences: d² times a third derivative of some hundred, near-parallel edges.
      EXPECT_NEAR((after.g - before.g) / (2.0 * d), rate, 1e-6 * (1.0 + std::abs(rate))) << f;
      EXPECT_LT(((after.d[0] - before.d[0]) / (2.0 * d) - now.ddot[0]).norm(),
                1e-5 * (1.0 + now.ddot[0].norm()))
          << f;
      EXPECT_LT(((after.P - before.P) / (2.0 * d) - now.Pdot).norm(),
                1e-5 * (1.0 + now.Pdot.norm()))
          << f;
    }
  }
  EXPECT_GT(looked, 3000) << "seed " << kFeatureSeed;
}

TEST(FeaturePairs, OfPolygonsAreTheirCornersOverSides) {
  // A unit square, and one turned by 45° whose lowest corner is 0.1 above the middle of its top.
  const Vec3 plane = -Vec3::UnitY();
  const std::vector<Vec3> square = {{-0.5, 0, -0.5}, {0.5, 0, -0.5}, {0.5, 0, 0.5}, {-0.5, 0, 0.5}};
  Frame a, b;
  a.A_IK = Mat3::Identity();
  b.A_IK = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitY()).toRotationMatrix();
  b.r_OS_I = Vec3(0, 0, 0.6 + std::sqrt(0.5));
  const PlacedPolygon A{&a, &square, plane}, B{&b, &square, plane};
  std::vector<int> near;
  nearFeatures(A, B, {0.11, 0.0}, near);
  ASSERT_EQ(near.size(), 1u);
  double presence = 0.0;
  const ContactPoint at = featurePair(A, B, near[0], true, presence);
  EXPECT_NEAR(at.g, 0.1, 1e-14);
  EXPECT_NEAR(presence, 0.5 + 1e-6, 1e-12);
  EXPECT_LT((at.d[0] - Vec3::UnitZ()).norm(), 1e-15);
  nearFeatures(A, B, {0.09, 0.0}, near);
  EXPECT_EQ(near.size(), 1u);
}

}  // namespace
}  // namespace dynamy
