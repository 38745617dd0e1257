// Ellipses, capsules and lines in a plane, ellipsoids on meshes: against dense samples of
// directions, least distances, polyhedra of the same triangles, and differences.
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>

#include <cmath>
#include <numbers>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;
using testing::reach;

Vec3 away(Random& random, double distance) {
  const double angle = std::numbers::pi * random.number();
  return {distance * std::cos(angle), 0.0, distance * std::sin(angle)};
}

/// Corners on a circle, counterclockwise about the plane's normal.
std::vector<Vec3> corners(Random& random, int n) {
  std::vector<double> angles;
  for (int i = 0; i < n; ++i)
    angles.push_back(2.0 * std::numbers::pi * (i + 0.4 * random.number()) / n);
  const Vec3 x = Vec3::UnitX(), y = kPlane.cross(x);
  std::vector<Vec3> out;
  for (const double a : angles) out.emplace_back(0.6 * (std::cos(a) * x + std::sin(a) * y));
  return out;
}

/// The largest of f over the directions in the plane.
double separatedInPlane(const std::function<double(const Vec3&)>& f) {
  const auto at = [&](double a) { return f(Vec3(std::cos(a), 0.0, std::sin(a))); };
  constexpr int kGrid = 2000;
  double best = 0.0, most = -kInfinity, width = std::numbers::pi / kGrid;
  for (int i = 0; i < kGrid; ++i)
    if (const double a = 2.0 * width * i, s = at(a); s > most) most = s, best = a;
  for (; width > 1e-12; width *= 0.2)
    for (int i = -10; i <= 10; ++i)
      if (const double a = best + 0.1 * width * i, s = at(a); s > most) most = s, best = a;
  return most;
}

double reach(const Frame& f, const std::vector<Vec3>& points, const Vec3& n) {
  double most = -kInfinity;
  for (const Vec3& p : points) most = std::max(most, n.dot(f.r_OS_I + f.A_IK * p));
  return most;
}

/// Capsule about a way of 0.8 along z.
TouchingShape uprightCapsule(double radius = 0.15) {
  TouchingShape s;
  s.kind = TouchingShape::Kind::capsule, s.half = {radius, radius, 0.4}, s.thickness = radius;
  for (const double side : {-0.4, 0.4}) {
    SupportFeature end;
    end.c_K = {0.0, 0.0, side}, end.radius = radius;
    s.features.push_back(end);
  }
  return s;
}
double reach(const Frame& f, const TouchingShape& s, const Vec3& n) {
  return std::max(reach(f, s.features[0], n), reach(f, s.features[1], n));
}

TEST(SmoothInPlane, EllipsesOnAllSeparateMostOfAllDirections) {
  Random r(71);
  const SupportFeature b = ellipsoid({0.2, 0.7, 0.5}, {0.05, 0.0, 0.1});
  SupportFeature disc;
  disc.radius = 0.3;
  const TouchingShape pill = uprightCapsule();
  int met[4] = {}, overlapping = 0, compared = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int kind = trial % 4;
    const std::vector<Vec3> polygon = corners(r, 6);
    const SupportFeature a = kind == 0 ? ellipsoid({0.5, 0.3, 0.2}) : disc;
    const Mover A = inPlane(r, Vec3::Zero()), B = inPlane(r, away(r, 0.9 + 0.4 * r.number()));
    const auto contact = [&](const Frame& fA, const Frame& fB) {
      if (kind == 2) return smoothOnPolygon({&fA, &polygon, kPlane}, fB, b);
      return kind == 3 ? capsuleOnSmooth(fB, b, fA, pill, kPlane)
                       : smoothInPlane(fA, a, fB, b, kPlane);
    };
    const auto ofA = [&](const Vec3& n) {
      if (kind == 2) return reach(A.frame, polygon, n);
      return kind == 3 ? reach(A.frame, pill, n) : reach(A.frame, a, n);
    };
    const auto f = [&](const Vec3& n) { return -reach(B.frame, b, -n) - ofA(n); };
    const double truth = separatedInPlane(f);
    if (truth < -0.05) continue;
    ++met[kind], overlapping += truth < 0.0;
    const ContactPoint c = contact(A.frame, B.frame);
    // The capsule is the second of its pair: the normal is from the ellipse.
    const Vec3 n = kind == 3 ? Vec3(-c.d[0]) : c.d[0];
    // No direction separates more, and n as much: both are extreme. Lengths of 1.
    EXPECT_GT(c.g, truth - 1e-12) << "trial " << trial << ", seed 71";
    if (truth > 0.0) {
      EXPECT_NEAR(f(n), c.g, 1e-12) << "trial " << trial << ", seed 71";
    }
    EXPECT_NEAR(n.y(), 0.0, 1e-15);
    const Mover &first = kind == 3 ? B : A, &second = kind == 3 ? A : B;
    compared += expectRatesFit(first, second, [&](const Frame& f1, const Frame& f2) {
      return std::vector<NumberedContact>{{0, kind == 3 ? contact(f2, f1) : contact(f1, f2)}};
    });
  }
  for (const int n : met) EXPECT_GT(n, 50);
  EXPECT_GT(overlapping, 10);
  EXPECT_GT(compared, 200);
}

TEST(CapsuleOnPolygon, IsTheirDistanceAndHasTheRatesOfTheMotion) {
  Random r(72);
  int ends = 0, beside = 0, compared = 0, overlapping = 0;
  for (int trial = 0; trial < 600; ++trial) {
    // Every second one is a line.
    const TouchingShape pill = uprightCapsule(trial % 2 == 0 ? 0.15 : 0.0);
    const std::vector<Vec3> polygon = corners(r, 5);
    const Mover A = inPlane(r, Vec3::Zero()), B = inPlane(r, away(r, 0.9 + 0.4 * r.number()));
    const double truth = separatedInPlane(
        [&](const Vec3& n) { return -reach(B.frame, pill, -n) - reach(A.frame, polygon, n); });
    if (truth < -0.02) continue;
    CapsuleOnPolygon found;
    const int n = capsuleOnPolygon({&A.frame, &polygon, kPlane}, B.frame, pill, found);
    const auto least =
        std::min_element(found.begin(), found.begin() + n,
                         [](const auto& a, const auto& c) { return a.at.g < c.at.g; });
    // Lengths of 1, rounded. Where a line overlaps a corner of the polygon, other contacts may be
    // deeper by a hundredth of the longest edge, which is shorter than the circle's width of 1.2.
    EXPECT_LT(least->at.g, truth + 1e-12) << "trial " << trial << ", seed 72";
    const bool mayBeDeeper = truth < 0.0 && trial % 2 == 1;
    EXPECT_GT(least->at.g, truth - (mayBeDeeper ? 0.012 : 1e-12))
        << "trial " << trial << ", seed 72";
    overlapping += truth < 0.0;
    (least->id < 2 ? ends : beside)++;
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      CapsuleOnPolygon out;
      const int m = capsuleOnPolygon({&fA, &polygon, kPlane}, fB, pill, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + m);
    });
  }
  EXPECT_GT(ends, 60);
  EXPECT_GT(beside, 60);
  EXPECT_GT(overlapping, 10);
  EXPECT_GT(compared, 600);
}

/// Touching and a little deeper, wherever rounding puts the corners.
TEST(CapsuleOnPolygon, KeepsBothCornersOfAnEdgeThatIsParallel) {
  Random r(74);
  const std::vector<Vec3> square = {
      {-0.2, 0.0, -0.2}, {0.2, 0.0, -0.2}, {0.2, 0.0, 0.2}, {-0.2, 0.0, 0.2}};
  for (int trial = 0; trial < 300; ++trial) {
    const double radius = trial % 2 == 0 ? 0.15 : 0.0, g = trial % 3 == 0 ? 0.0 : -1e-6;
    const Mat3 turn = turned(3.0 * r.number() * kPlane);
    const Mover A(r.number() * turn.col(0), turn, Vec3::Zero(), Vec3::Zero());
    const Vec3 above(0.1 * r.number(), 0.0, 0.2 + radius + g);
    const Mat3 flat = turn * turned(0.5 * std::numbers::pi * kPlane);
    const Mover B(A.frame.r_OS_I + turn * above, flat, Vec3::Zero(), Vec3::Zero());
    CapsuleOnPolygon found;
    const int n =
        capsuleOnPolygon({&A.frame, &square, kPlane}, B.frame, uprightCapsule(radius), found);
    int touching = 0;
    for (int i = 0; i < n; ++i) {
      const NumberedContact& c = found[static_cast<std::size_t>(i)];
      if (c.at.g > 1e-3) continue;
      ++touching;
      // Lengths of 1, rounded.
      EXPECT_NEAR(c.at.g, g, 1e-14) << "trial " << trial << ", seed 74";
      EXPECT_NEAR((c.at.d[0] - turn.col(2)).norm(), 0.0, 1e-14) << "trial " << trial;
    }
    EXPECT_EQ(touching, 2) << "trial " << trial << ", seed 74";
  }
}

TEST(SmoothOnMesh, HasTheSmallestGapOfAPolyhedronWithTheseTriangles) {
  Random r(73);
  const SupportFeature b = ellipsoid({0.2, 0.5, 0.3}, {0.05, 0.0, 0.1});
  int met = 0, edges = 0, corner = 0, compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Vec3> triangles = r.hull(10);
    const Polyhedron body(triangles);
    const Surface mesh(triangles, false);
    const Mover A(0.1 * r.vec(), turned(2.0 * r.vec()), r.vec(), r.vec());
    const Mover B((1.3 + 0.3 * r.number()) * r.vec().normalized(), turned(2.0 * r.vec()), r.vec(),
                  r.vec());
    const double truth = smoothOnPolyhedron(placed(A.frame, body), B.frame, b).g;
    if (truth < 1e-3 || truth > 0.3) continue;
    OnSurfaceContacts found;
    const int n = smoothOnMesh(A.frame, mesh, B.frame, b, 0.31, found);
    ASSERT_GT(n, 0) << "trial " << trial << ", seed 73";
    const auto least =
        std::min_element(found.begin(), found.begin() + n,
                         [](const auto& a, const auto& c) { return a.at.g < c.at.g; });
    ++met;
    const int faces = static_cast<int>(mesh.faces().size());
    edges += least->id >= faces && least->id < faces + mesh.edges();
    corner += least->id >= faces + mesh.edges();
    // Lengths of 1, rounded.
    EXPECT_NEAR(least->at.g, truth, 1e-12) << "trial " << trial << ", seed 73";
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      OnSurfaceContacts out;
      const int m = smoothOnMesh(fA, mesh, fB, b, 0.31, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + m);
    });
  }
  EXPECT_GT(met, 80);
  EXPECT_GT(edges, 15);
  EXPECT_GT(corner, 5);
  EXPECT_GT(compared, 80);
}

}  // namespace
}  // namespace dynamy
