// Contact of two boxes against brute force: distance by alternating projections, the polygon of two
// faces by clipping, rates by differences.
#include <dynamy_elements/contacts/box_contact.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/core/rotation.hpp>
#include <random>
#include <vector>

namespace dynamy {
namespace {

using Contacts = std::array<BoxContact, kMostBoxContacts>;

Mat3 turned(const Vec3& theta) {
  double p[4] = {1, 0, 0, 0};
  rotate(p, theta);
  return rotationMatrix(p);
}

/// Box with its frame in the middle.
struct Body {
  Frame frame;
  PlacedBox box;
  Body(const Vec3& c, const Mat3& R, const Vec3& half, const Vec3& v = Vec3::Zero(),
       const Vec3& Omega = Vec3::Zero()) {
    frame.r_OS_I = c, frame.A_IK = R, frame.v_S_I = v, frame.Omega_I = Omega;
    box = {&frame, c, R, half};
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
};

Vec3 nearest(const PlacedBox& box, const Vec3& p) {
  const Vec3 local = box.R.transpose() * (p - box.c);
  return box.c + box.R * local.cwiseMax(-box.half).cwiseMin(box.half);
}
/// Closest points of two boxes that do not overlap; alternating projections converge to them.
std::pair<Vec3, Vec3> closest(const PlacedBox& A, const PlacedBox& B) {
  Vec3 a = A.c, b = B.c;
  for (int i = 0; i < 20000; ++i) b = nearest(B, a), a = nearest(A, b);
  return {a, b};
}
/// How many faces of the box p lies on: 1 face, 2 edge, 3 vertex.
int faces(const PlacedBox& box, const Vec3& p) {
  const Vec3 local = (box.R.transpose() * (p - box.c)).cwiseAbs();
  return static_cast<int>(((box.half - local).array() < 1e-6).count());
}

TEST(BoxContact, SmallestGapIsTheDistanceWhereFeaturesMeet) {
  constexpr unsigned kSeed = 20;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  int met = 0, edges = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Vec3 hA = Vec3::Constant(0.6) + 0.3 * vec(), hB = Vec3::Constant(0.6) + 0.3 * vec();
    const Body A(Vec3::Zero(), turned(2.0 * vec()), hA);
    const Body B(vec().normalized() * (1.6 + 0.4 * uniform(random)), turned(2.0 * vec()), hB);
    const auto [a, b] = closest(A.box, B.box);
    const double distance = (b - a).norm();
    if (distance < 1e-2 || distance > 0.5) continue;
    Contacts out;
    const int n = betweenBoxes(A.box, B.box, true, out);
    double smallest = 1e300;
    for (int i = 0; i < n; ++i) {
      // Both points of a contact belong to their boxes, as far as features nearer than 1e-6 are
      // one: no gap is smaller than the distance.
      EXPECT_GT(out[static_cast<std::size_t>(i)].at.g, distance - 1e-5) << "trial " << trial;
      smallest = std::min(smallest, out[static_cast<std::size_t>(i)].at.g);
    }
    // Vertex or edge before the inside of a face, edge crossing edge.
    const int fa = faces(A.box, a), fb = faces(B.box, b);
    const bool crossing = fa == 2 && fb == 2;
    if (!(fa == 1 || fb == 1 || crossing)) continue;
    ++met, edges += crossing;
    EXPECT_NEAR(smallest, distance, 1e-6) << "trial " << trial << ": " << fa << ' ' << fb;
  }
  EXPECT_GT(met, 60) << "seed " << kSeed;
  EXPECT_GT(edges, 5) << "seed " << kSeed;
}

using Polygon = std::vector<Eigen::Vector2d>;
/// Sutherland–Hodgman: the part of `p` with n·x ≤ d.
Polygon clipped(const Polygon& p, const Eigen::Vector2d& n, double d) {
  Polygon out;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Eigen::Vector2d a = p[i], b = p[(i + 1) % p.size()];
    const double ga = n.dot(a) - d, gb = n.dot(b) - d;
    if (ga <= 0.0) out.push_back(a);
    if (ga * gb < 0.0) out.push_back(a + ga / (ga - gb) * (b - a));
  }
  return out;
}

TEST(BoxContact, OfTwoFacesIsThePolygonTheyShare) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const double turn = 0.2 + 0.3 * (1.0 + uniform(random)), gap = 1e-3 * uniform(random);
    const Vec3 hA(0.5, 0.7, 0.3), hB(0.6, 0.4, 0.2);
    const Body A(Vec3::Zero(), Mat3::Identity(), hA);
    const Body B(Vec3(0.4 * uniform(random), 0.4 * uniform(random), 0.5 + gap),
                 turned({0.0, 0.0, turn}), hB);
    Contacts out;
    const int n = betweenBoxes(A.box, B.box, true, out);
    Polygon expected;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      expected.emplace_back((B.box.c + B.box.R * Vec3(x * hB.x(), y * hB.y(), 0.0)).head<2>());
    for (int axis = 0; axis < 2; ++axis)
      for (const double sign : {-1.0, 1.0})
        expected = clipped(expected, sign * Eigen::Vector2d::Unit(axis), hA[axis]);
    ASSERT_EQ(n, static_cast<int>(expected.size())) << "trial " << trial << ", seed " << kSeed;
    for (int i = 0; i < n; ++i) {
      const BoxContact& c = out[static_cast<std::size_t>(i)];
      EXPECT_NEAR(c.at.g, gap, 1e-14);
      EXPECT_NEAR(c.at.d[0].z(), 1.0, 1e-14);
      double nearestCorner = 1e300;
      for (const Eigen::Vector2d& p : expected)
        nearestCorner = std::min(nearestCorner, (p - c.at.P.head<2>()).norm());
      EXPECT_LT(nearestCorner, 1e-12) << "trial " << trial;
    }
  }
}

TEST(BoxContact, OfAlignedCubesIsTheirFourCorners) {
  // Every corner is a vertex of both and a crossing of edges at once: one contact each, and the
  // same ones after a shift by rounding.
  for (const double shift : {0.0, 1e-16, -1e-12, 1e-9}) {
    const Body A(Vec3::Zero(), Mat3::Identity(), Vec3::Constant(0.5));
    const Body B(Vec3(shift, -shift, 1.0), Mat3::Identity(), Vec3::Constant(0.5));
    Contacts out;
    ASSERT_EQ(betweenBoxes(A.box, B.box, true, out), 4) << shift;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(out[static_cast<std::size_t>(i)].id, i) << shift;
  }
}

TEST(BoxContact, OfAWideBoxOnANarrowOneStandsOnTheNarrowOne) {
  const Body A(Vec3::Zero(), Mat3::Identity(), Vec3::Constant(0.5));
  const Body B(Vec3(0, 0, 0.6), Mat3::Identity(), Vec3(2.0, 0.5, 0.1));
  Contacts out;
  ASSERT_EQ(betweenBoxes(A.box, B.box, true, out), 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_GE(out[static_cast<std::size_t>(i)].id, 8);
    EXPECT_NEAR(out[static_cast<std::size_t>(i)].at.g, 0.0, 1e-15);
  }
}

/// The contacts of two boxes moved on by s with their velocities.
void movedOn(const Body& A, const Body& B, double s, Contacts& out, int& n) {
  const auto moved = [s](const Body& x) {
    return std::pair<Vec3, Mat3>(x.frame.r_OS_I + s * x.frame.v_S_I,
                                 turned(s * x.frame.Omega_I) * x.frame.A_IK);
  };
  const auto [cA, RA] = moved(A);
  const auto [cB, RB] = moved(B);
  const Body a(cA, RA, A.box.half, A.frame.v_S_I, A.frame.Omega_I),
      b(cB, RB, B.box.half, B.frame.v_S_I, B.frame.Omega_I);
  n = betweenBoxes(a.box, b.box, true, out);
}

TEST(BoxContact, RatesAreThoseOfTheMotion) {
  constexpr unsigned kSeed = 3;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  constexpr double s = 1e-5;
  // Central differences: s² times third derivatives of about (speed/size)³, and rounding over s.
  constexpr double kTolerance = 1e-7;
  int compared = 0, edges = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Body A(Vec3::Zero(), turned(2.0 * vec()), Vec3(0.5, 0.7, 0.3), vec(), vec());
    const Body B(1.3 * vec().normalized(), turned(2.0 * vec()), Vec3(0.6, 0.4, 0.5), vec(), vec());
    Contacts here, before, after;
    int n = betweenBoxes(A.box, B.box, true, here), nBefore = 0, nAfter = 0;
    movedOn(A, B, -s, before, nBefore);
    movedOn(A, B, s, after, nAfter);
    for (int i = 0; i < n; ++i) {
      const BoxContact& c = here[static_cast<std::size_t>(i)];
      const auto same = [&](const BoxContact& o) { return o.id == c.id; };
      const auto b = std::find_if(before.begin(), before.begin() + nBefore, same);
      const auto a = std::find_if(after.begin(), after.begin() + nAfter, same);
      if (b == before.begin() + nBefore || a == after.begin() + nAfter) continue;
      ++compared, edges += c.id >= 16;
      const Vec3 v =
          B.frame.velocity(c.at.P - B.frame.r_OS_I) - A.frame.velocity(c.at.P - A.frame.r_OS_I);
      EXPECT_NEAR(c.at.d[0].dot(v), (a->at.g - b->at.g) / (2.0 * s), kTolerance) << c.id;
      EXPECT_LT((c.at.Pdot - (a->at.P - b->at.P) / (2.0 * s)).norm(), 30.0 * kTolerance) << c.id;
      for (int k = 0; k < 3; ++k)
        EXPECT_LT((c.at.ddot[k] - (a->at.d[k] - b->at.d[k]) / (2.0 * s)).norm(), 30.0 * kTolerance)
            << c.id << ", direction " << k;
    }
  }
  EXPECT_GT(compared, 200) << "seed " << kSeed;
  EXPECT_GT(edges, 30) << "seed " << kSeed;
}

}  // namespace
}  // namespace dynamy
