// Faceted shapes: hull and mass, balls on polyhedra against balls on boxes, on meshes against
// planes.
#include <dynamy_elements/contacts/shapes/faceted_shapes.hpp>
#include <dynamy_elements/contacts/shapes/surface.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy_elements/forces/gravity.hpp>

#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

std::vector<Vec3> boxCorners(const Vec3& half) {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i)
    out.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                     i & 4 ? half.z() : -half.z());
  return out;
}

std::string numbers(const std::vector<Vec3>& points) {
  std::string out;
  for (const Vec3& p : points)
    for (const double x : p) out += numberText(x) + " ";
  return out;
}

TEST(ConvexHull, HoldsAllPointsAndClosesAroundThem) {
  std::mt19937 random(4);
  std::normal_distribution<double> number;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i)
      points.emplace_back(number(random), number(random), number(random));
    const std::vector<Triangle> hull = convexHull(points);
    std::vector<int> used;
    for (const Triangle& t : hull) {
      const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
      const Vec3 n = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
      for (const Vec3& p : points) EXPECT_LT(n.dot(p - at(0)), 1e-11) << "seed 4, " << trial;
      used.insert(used.end(), t.begin(), t.end());
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    EXPECT_EQ(hull.size(), 2 * used.size() - 4);  // Euler's formula for triangles
  }
  EXPECT_TRUE(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}).empty());
}

TEST(ConvexHull, OfACubeHasItsMass) {
  std::vector<Vec3> points = boxCorners({0.2, 0.3, 0.5});
  for (Vec3& p : points) p += Vec3(1.0, 2.0, -1.0);
  points.emplace_back(1.1, 2.0, -1.2);  // inside
  const PolyhedronShape shape(
      Parameters::of<PolyhedronShape>("Polyhedron", "", {{"points", numbers(points)}}));
  EXPECT_EQ(Surface(shape.geometry().points, true).points().size(), 8u);
  const Box box(Parameters::of<Box>("Box", "", {{"size", {0.4, 0.6, 1.0}}}));
  const MassProperties a = shape.massProperties(), b = box.massProperties();
  // Sums of a few products of size 10.
  EXPECT_NEAR(a.volume, b.volume, 1e-14);
  EXPECT_LT((a.centre_B - Vec3(1.0, 2.0, -1.0)).norm(), 1e-14);
  EXPECT_LT((a.inertia_B - b.inertia_B).norm(), 1e-13);
}

TEST(Surface, OfABoxMeetsBallsAsABoxDoes) {
  const Vec3 half(0.5, 0.7, 0.3);
  const PolyhedronShape shape(
      Parameters::of<PolyhedronShape>("Polyhedron", "", {{"points", numbers(boxCorners(half))}}));
  const Surface surface(shape.geometry().points, true);
  TouchingShape box;
  box.kind = TouchingShape::Kind::box, box.half = half;
  constexpr unsigned kSeed = 9;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  for (int trial = 0; trial < 500; ++trial) {
    Frame A, B;
    double p[4] = {1, 0, 0, 0};
    rotate(p, 2.0 * vec());
    A.r_OS_I = 0.1 * vec(), A.A_IK = rotationMatrix(p), A.v_S_I = vec(), A.Omega_I = vec();
    B.r_OS_I = 1.2 * vec(), B.v_S_I = vec(), B.Omega_I = vec();
    const RoundFeature ball{0.1 * vec(), 0.2};
    const ContactPoint truth = ballOnBox(A, box, B, ball, Vec3::Zero());
    SurfaceContacts out;
    ASSERT_EQ(surface.contacts(A, B, ball, 10.0, out), 1) << "trial " << trial << " seed " << kSeed;
    const ContactPoint& c = out[0].at;
    // Lengths of 2 m, divided by distances of 1e-3 m and more: a thousand roundings.
    EXPECT_NEAR(c.g, truth.g, 1e-14);
    EXPECT_LT((c.d[0] - truth.d[0]).norm(), 1e-12) << trial;
    EXPECT_LT((c.P - truth.P).norm(), 1e-12);
    EXPECT_LT((c.ddot[0] - truth.ddot[0]).norm(), 1e-10);
    EXPECT_LT((c.Pdot - truth.Pdot).norm(), 1e-10);
  }
}

/// Heights over a grid of 8 × 8 points, 0.25 m apart, from (−1, −1) on.
std::vector<Vec3> triangles(const std::function<double(double, double)>& z) {
  std::vector<double> heights;
  std::string text;
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) text += numberText(z(-1.0 + 0.25 * i, -1.0 + 0.25 * j)) + " ";
  const HeightFieldShape shape(Parameters::of<HeightFieldShape>(
      "HeightField", "", {{"columns", 8.0}, {"heights", text}, {"spacing", {0.25, 0.25}}}));
  std::vector<Vec3> points = shape.geometry().points;
  for (Vec3& p : points) p -= Vec3(1.0, 1.0, 0.0);
  return points;
}
Surface field(const std::function<double(double, double)>& z) { return {triangles(z), false}; }

int contactsAt(const Surface& surface, const Vec3& c, double R, SurfaceContacts& out) {
  Frame A, B;
  B.r_OS_I = c;
  return surface.contacts(A, B, {Vec3::Zero(), R}, 0.5 * R, out);
}

TEST(Surface, IsOnePlaneWhereItIsFlat) {
  const Surface flat = field([](double x, double) { return 0.5 * x; });
  const Vec3 n = Vec3(-0.5, 0.0, 1.0).normalized();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-0.7, 0.5);
  for (int trial = 0; trial < 500; ++trial) {
    // On edges and corners of the grid, and between.
    Vec3 foot(uniform(random), uniform(random), 0.0);
    if (trial % 3 == 0) foot.x() = 0.25 * std::round(4.0 * foot.x());
    if (trial % 5 == 0) foot.y() = 0.25 * std::round(4.0 * foot.y());
    foot.z() = 0.5 * foot.x();
    SurfaceContacts out;
    ASSERT_EQ(contactsAt(flat, foot + 0.11 * n, 0.1, out), 1) << trial;
    EXPECT_NEAR(out[0].at.g, 0.01, 1e-15);
    EXPECT_LT((out[0].at.d[0] - n).norm(), 1e-15);
  }
}

TEST(Surface, HasTwoContactsInAValleyAndOneOnARidge) {
  SurfaceContacts out;
  const Surface valley = field([](double x, double) { return std::abs(x); });
  // Both slopes at 45°: the distance of (0, z) from each is z/√2.
  ASSERT_EQ(contactsAt(valley, {0.0, 0.1, 0.3}, 0.2, out), 2);
  EXPECT_NEAR(out[0].at.g, 0.3 / std::sqrt(2.0) - 0.2, 1e-15);
  EXPECT_NEAR(out[1].at.g, 0.3 / std::sqrt(2.0) - 0.2, 1e-15);
  const Surface ridge = field([](double x, double) { return -std::abs(x); });
  ASSERT_EQ(contactsAt(ridge, {0.05, 0.1, 0.2}, 0.2, out), 1);
  EXPECT_NEAR(out[0].at.g, std::hypot(0.05, 0.2) - 0.2, 1e-15);
  EXPECT_EQ(ridge.featureName(out[0].id).substr(0, 4), "edge");
}

double toSegmentOf(const Vec3& c, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((c - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - c).norm();
}

/// Distance of c from a triangle: over its inside by barycentric coordinates, else of its sides.
double toTriangle(const Vec3& c, const Vec3& a, const Vec3& b, const Vec3& d) {
  const Vec3 n = (b - a).cross(d - a).normalized();
  Mat3 axes;
  axes << b - a, d - a, n;
  const Vec3 x = axes.inverse() * (c - a);
  if (x[0] >= 0.0 && x[1] >= 0.0 && x[0] + x[1] <= 1.0) return std::abs(x[2]);
  return std::min({toSegmentOf(c, a, b), toSegmentOf(c, b, d), toSegmentOf(c, d, a)});
}

TEST(Surface, NearestContactIsTheDistanceOverHills) {
  const std::vector<Vec3> t =
      triangles([](double x, double y) { return 0.2 * std::sin(5.0 * x) * std::cos(4.0 * y); });
  const Surface hills(t, false);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-0.5, 0.3);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3 c(uniform(random), uniform(random), 0.35);
    double nearest = 1e300;
    for (std::size_t i = 0; i < t.size(); i += 3)
      nearest = std::min(nearest, toTriangle(c, t[i], t[i + 1], t[i + 2]));
    SurfaceContacts out;
    const int n = contactsAt(hills, c, 0.4, out);
    ASSERT_GT(n, 0);
    double least = 1e300;
    for (int i = 0; i < n; ++i)
      least = std::min(least, out[static_cast<std::size_t>(i)].at.g + 0.4);
    EXPECT_NEAR(least, nearest, 1e-14) << trial << ", seed 8";
  }
}

/// Velocity of a ball that rolled for 0.3 s over the ground.
template <class S>
Eigen::VectorXd rolled(const Given& ground) {
  Model m;
  addBody<Ground, S>(m, "world", {}, "", ground);
  addBody<RigidBody, Sphere>(m, "ball",
                             {{"position", {-0.3, 0.05, 0.1}}, {"velocity", {2.0, 0.3, 0.0}}},
                             "Sphere", {{"radius", 0.1}, {"mass", 1.0}, {"material", "steel"}});
  addRule(m, "steel steel");
  m.add(std::make_unique<Gravity>(Parameters::of<Gravity>("Gravity", "", {})));
  m.addCompletion(addShapeContacts);
  m.simulation.until = 0.3, m.simulation.step = 1e-3;
  m.build();
  Simulation simulation(m);
  simulation.run();
  return simulation.state().u;
}

TEST(Surface, IsRolledOverAsAPlaneIs) {
  std::string zeros;
  for (int i = 0; i < 64; ++i) zeros += "0 ";
  const Eigen::VectorXd plane = rolled<HalfSpace>({{"material", "steel"}});
  const Eigen::VectorXd mesh = rolled<HeightFieldShape>({{"material", "steel"},
                                                         {"columns", 8.0},
                                                         {"heights", zeros},
                                                         {"spacing", {0.25, 0.25}},
                                                         {"position", {-0.9, -0.9, 0.0}}});
  // The tangents of the two have other directions: roundings, and the tolerance of the solver,
  // 1e-10.
  EXPECT_LT((plane - mesh).norm(), 1e-8);
}

}  // namespace
}  // namespace dynamy
