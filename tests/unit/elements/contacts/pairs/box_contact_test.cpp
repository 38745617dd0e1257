// Contact of two boxes against brute force: distance by alternating projections, the polygon of two
// faces by clipping, rates by differences.
#include <dynamy_elements/contacts/pairs/box_contact.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/core/rotation.hpp>
#include <random>
#include <unit/elements/contacts/faceted_bodies.hpp>
#include <vector>

namespace dynamy {
namespace {

using Contacts = std::array<BoxContact, kMostBoxContacts>;

using testing::turned;

/// Box with its frame in the middle.
struct FramedBox {
  Frame frame;
  PlacedBox box;
  FramedBox(const Vec3& c, const Mat3& R, const Vec3& half, const Vec3& v = Vec3::Zero(),
            const Vec3& Omega = Vec3::Zero()) {
    frame.r_OS_I = c, frame.A_IK = R, frame.v_S_I = v, frame.Omega_I = Omega;
    box = {&frame, c, R, half};
  }
  FramedBox(const FramedBox&) = delete;
  FramedBox& operator=(const FramedBox&) = delete;
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
    const FramedBox A(Vec3::Zero(), turned(2.0 * vec()), hA);
    const FramedBox B(vec().normalized() * (1.6 + 0.4 * uniform(random)), turned(2.0 * vec()), hB);
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
    const FramedBox A(Vec3::Zero(), Mat3::Identity(), hA);
    const FramedBox B(Vec3(0.4 * uniform(random), 0.4 * uniform(random), 0.5 + gap),
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

TEST(BoxContact, WithinReachIsWhatIsThereAtAnyDistance) {
  // An axis that separates bodies by more than the reach is passed by no contact within it: looking
  // no further loses none, and changes no bit of those that are there.
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  int left = 0, kept = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const FramedBox A(Vec3::Zero(), turned(2.0 * vec()), Vec3::Constant(0.6) + 0.3 * vec());
    const FramedBox B(vec().normalized() * (1.4 + 0.6 * uniform(random)), turned(2.0 * vec()),
                      Vec3::Constant(0.6) + 0.3 * vec());
    const double reach = 0.1 * (1.0 + uniform(random));
    Contacts all, near;
    const int n = betweenBoxes(A.box, B.box, true, all);
    if (const int m = betweenBoxes(A.box, B.box, true, near, reach); m == 0) {
      for (int i = 0; i < n; ++i)
        EXPECT_GT(all[static_cast<std::size_t>(i)].at.g, reach) << "trial " << trial;
      ++left;
    } else {
      ASSERT_EQ(m, n) << "trial " << trial;
      for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_EQ(near[at].id, all[at].id);
        EXPECT_EQ(near[at].at.g, all[at].at.g);
        EXPECT_EQ(near[at].at.P, all[at].at.P);
      }
      ++kept;
    }
  }
  EXPECT_GT(std::min(left, kept), 1000);
}

TEST(BoxContact, OfAlignedCubesIsTheirFourCorners) {
  // Every corner is a vertex of both and a crossing of edges at once: one contact each, and the
  // same ones after a shift by rounding.
  for (const double shift : {0.0, 1e-16, -1e-12, 1e-9}) {
    const FramedBox A(Vec3::Zero(), Mat3::Identity(), Vec3::Constant(0.5));
    const FramedBox B(Vec3(shift, -shift, 1.0), Mat3::Identity(), Vec3::Constant(0.5));
    Contacts out;
    ASSERT_EQ(betweenBoxes(A.box, B.box, true, out), 4) << shift;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(out[static_cast<std::size_t>(i)].id, i) << shift;
  }
}

TEST(BoxContact, OfAWideBoxOnANarrowOneStandsOnTheNarrowOne) {
  const FramedBox A(Vec3::Zero(), Mat3::Identity(), Vec3::Constant(0.5));
  const FramedBox B(Vec3(0, 0, 0.6), Mat3::Identity(), Vec3(2.0, 0.5, 0.1));
  Contacts out;
  ASSERT_EQ(betweenBoxes(A.box, B.box, true, out), 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_GE(out[static_cast<std::size_t>(i)].id, 8);
    EXPECT_NEAR(out[static_cast<std::size_t>(i)].at.g, 0.0, 1e-15);
  }
}

/// The contacts of two boxes moved on by s with their velocities.
void movedOn(const FramedBox& A, const FramedBox& B, double s, Contacts& out, int& n) {
  const auto moved = [s](const FramedBox& x) {
    return std::pair<Vec3, Mat3>(x.frame.r_OS_I + s * x.frame.v_S_I,
                                 turned(s * x.frame.Omega_I) * x.frame.A_IK);
  };
  const auto [cA, RA] = moved(A);
  const auto [cB, RB] = moved(B);
  const FramedBox a(cA, RA, A.box.half, A.frame.v_S_I, A.frame.Omega_I),
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
    const FramedBox A(Vec3::Zero(), turned(2.0 * vec()), Vec3(0.5, 0.7, 0.3), vec(), vec());
    const FramedBox B(1.3 * vec().normalized(), turned(2.0 * vec()), Vec3(0.6, 0.4, 0.5), vec(),
                      vec());
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

/// Two boxes that lie on each other, B displaced and tilted by about k.
struct Lying {
  FramedBox A, B;
  template <class Random>
  Lying(double k, Random&& vec, const Vec3& turn = Vec3::Zero())
      : A(Vec3::Zero(), turned(vec()), Vec3(0.5, 0.7, 0.3), vec(), vec()),
        B(A.box.R * (Vec3(0.0, 0.0, 0.8 + 2.0 * k) + k * vec()),
          turned(A.box.R * (turn + k * vec())) * A.box.R, Vec3(0.5, 0.7, 0.5), vec(), vec()) {}
};

/// Rows of the velocity of B's point at P relative to A's along d, for [v; Ω] of B at B's centre.
Eigen::Matrix<double, 1, 6> row(const FramedBox& B, const Vec3& P, const Vec3& d) {
  Eigen::Matrix<double, 1, 6> out;
  out << d.transpose(), (P - B.frame.r_OS_I).cross(d).transpose();
  return out;
}

TEST(BoxContact, ThatClosesTogetherCanStickTogether) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  constexpr double k = 1e-3;
  int compared = 0;
  for (int trial = 0; trial < 100; ++trial) {
    // Vertices of one, vertices of both, and edges that cross at half a right angle.
    const Lying on(k, vec, trial % 3 == 2 ? Vec3(0, 0, 0.8) : Vec3::Zero());
    Contacts found;
    const int n = betweenBoxes(on.A.box, on.B.box, true, found);
    if (n < 4) continue;  // two edges are nearest
    ++compared;
    const Contacts before = found;
    closeTogether(on.A.box, 20.0 * k, true, {found.data(), static_cast<std::size_t>(n)});
    Eigen::MatrixXd T(2 * n, 6), was(2 * n, 6);
    for (int i = 0; i < n; ++i) {
      const ContactPoint &at = found[static_cast<std::size_t>(i)].at,
                         &old = before[static_cast<std::size_t>(i)].at;
      EXPECT_EQ(at.g, old.g);
      // Rounding of numbers of about 1.
      EXPECT_LT((row(on.B, at.P, at.d[0]) - row(on.B, old.P, old.d[0])).norm(), 1e-14);
      // Gaps and tilts are a few k, and so is the way of a point.
      EXPECT_LT((at.P - old.P).norm(), 20.0 * k);
      for (int t = 0; t < 2; ++t) {
        T.row(2 * i + t) = row(on.B, at.P, at.d[1 + t]);
        was.row(2 * i + t) = row(on.B, old.P, old.d[1 + t]);
      }
    }
    // Bodies that slide on each other have three ways to do it, whatever the number of contacts.
    const Eigen::VectorXd s = T.jacobiSvd().singularValues();
    EXPECT_GT(s[2], 0.1);
    EXPECT_LT(s[3], 1e-14);
    EXPECT_GT(was.jacobiSvd().singularValues()[3], 0.01 * k);
  }
  EXPECT_GT(compared, 20) << "seed " << kSeed;
}

TEST(BoxContact, TwoThatCloseTogetherSlideOnTheirOwnFaces) {
  // Tilted about an edge of B: nothing tells the tilt but the two contacts, so they stay as they
  // are.
  const FramedBox A(Vec3::Zero(), Mat3::Identity(), Vec3(2, 2, 0.5));
  const FramedBox B(Vec3(0, 0, 1.05), turned(Vec3(0, 0.1, 0)), Vec3::Constant(0.5));
  Contacts found;
  const int n = betweenBoxes(A.box, B.box, true, found);
  const Contacts before = found;
  closeTogether(A.box, 0.01, true, {found.data(), static_cast<std::size_t>(n)});
  for (int i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_LT((found[at].at.P - before[at].at.P).norm(), 1e-15);
    for (int d = 0; d < 3; ++d) EXPECT_EQ(found[at].at.d[d], before[at].at.d[d]);
  }
}

TEST(BoxContact, OneAcrossTheFaceStaysAsItIs) {
  // Four corners on a face of A, and one whose normal lies in that face: no plane along the face
  // holds its gap.
  const FramedBox A(Vec3::Zero(), Mat3::Identity(), Vec3::Constant(0.5));
  const FramedBox B(Vec3(0.1, 0.2, 1.0 - 1e-4), Mat3::Identity(), Vec3::Constant(0.5));
  Contacts found;
  const int n = betweenBoxes(A.box, B.box, true, found);
  ASSERT_EQ(n, 4);
  found[1].at.P[2] += 1e-3, found[1].at.g += 1e-3;
  BoxContact& across = found[4];
  across = found[0];
  std::rotate(std::begin(across.at.d), std::begin(across.at.d) + 1, std::end(across.at.d));
  const Contacts before = found;
  closeTogether(A.box, 0.01, true, {found.data(), 5});
  for (int d = 0; d < 3; ++d) EXPECT_EQ(across.at.d[d], before[4].at.d[d]);
  EXPECT_EQ(across.at.P, before[4].at.P);
  EXPECT_EQ(across.at.Pdot, before[4].at.Pdot);
  EXPECT_NE(found[1].at.P, before[1].at.P);  // the one out of the plane was moved into it
}

TEST(BoxContact, RatesStayThoseOfTheMotionWhereContactsCloseTogether) {
  constexpr unsigned kSeed = 12;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  constexpr double s = 1e-5, reach = 0.2;
  constexpr double kTolerance = 3e-6;  // as in RatesAreThoseOfTheMotion
  int compared = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Lying on(2e-2, vec, trial % 2 ? Vec3(0, 0, 0.8) : Vec3::Zero());
    Contacts c[3];
    int n[3] = {betweenBoxes(on.A.box, on.B.box, true, c[0]), 0, 0};
    closeTogether(on.A.box, reach, true, {c[0].data(), static_cast<std::size_t>(n[0])});
    for (const int side : {1, 2}) {
      const double way = side == 1 ? -s : s;
      const auto moved = [way](const FramedBox& x) {
        return std::pair<Vec3, Mat3>(x.frame.r_OS_I + way * x.frame.v_S_I,
                                     turned(way * x.frame.Omega_I) * x.frame.A_IK);
      };
      const auto [cA, RA] = moved(on.A);
      const auto [cB, RB] = moved(on.B);
      const FramedBox a(cA, RA, on.A.box.half), b(cB, RB, on.B.box.half);
      n[side] = betweenBoxes(a.box, b.box, false, c[side]);
      closeTogether(a.box, reach, false, {c[side].data(), static_cast<std::size_t>(n[side])});
    }
    if (n[1] != n[0] || n[2] != n[0]) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n[0]); ++i) {
      ASSERT_EQ(c[1][i].id, c[2][i].id);
      ++compared;
      const ContactPoint &at = c[0][i].at, &before = c[1][i].at, &after = c[2][i].at;
      EXPECT_LT((at.Pdot - (after.P - before.P) / (2.0 * s)).norm(), kTolerance);
      for (int d = 0; d < 3; ++d)
        EXPECT_LT((at.ddot[d] - (after.d[d] - before.d[d]) / (2.0 * s)).norm(), kTolerance);
    }
  }
  EXPECT_GT(compared, 100) << "seed " << kSeed;
}

}  // namespace
}  // namespace dynamy
