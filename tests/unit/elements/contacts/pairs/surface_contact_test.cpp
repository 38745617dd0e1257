// Capsules and polyhedra on polyhedra and meshes: against boxes, distances over all pairs of
// features, and differences.
#include <dynamy_elements/contacts/pairs/round_contact.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;

TEST(SurfaceContact, OfACapsuleOnABoxIsThatOfBoxes) {
  Random random(9);
  const Vec3 half(0.3, 0.5, 0.7);
  const Surface surface(boxTriangles(half), true);
  TouchingShape box;
  box.kind = TouchingShape::Kind::box, box.half = half;
  const TouchingShape rod = capsule(0.1, 0.6);
  int edges = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Mover A(0.1 * random.vec(), turned(random.vec()), random.vec(), random.vec());
    const Mover B(1.1 * random.vec().normalized(), turned(2.0 * random.vec()), random.vec(),
                  random.vec());
    RoundContacts truth;
    const int n = capsuleOnBox(A.frame, box, B.frame, rod, truth);
    OnSurfaceContacts found;
    ASSERT_EQ(n, capsuleOnSurface(A.frame, surface, B.frame, rod, 10.0, found))
        << "trial " << trial << ", seed 9";
    edges += n > 2;
    for (int i = 0; i < n; ++i) {
      const ContactPoint& t = truth[static_cast<std::size_t>(i)].at;
      const auto c =
          std::min_element(found.begin(), found.begin() + n, [&](const auto& x, const auto& y) {
            return (x.at.P - t.P).squaredNorm() < (y.at.P - t.P).squaredNorm();
          });
      EXPECT_NEAR(c->at.g, t.g, 1e-14);
      EXPECT_LT((c->at.d[0] - t.d[0]).norm(), 1e-12);
      EXPECT_LT((c->at.P - t.P).norm(), 1e-12);
      EXPECT_LT((c->at.Pdot - t.Pdot).norm(), 1e-9 * (1.0 + t.Pdot.norm()));
    }
  }
  EXPECT_GT(edges, 50);
}

/// Triangles of heights over the square of 2 m about the origin, 0.25 m apart.
std::vector<Vec3> fieldOf(const std::function<double(double, double)>& z) {
  std::vector<Vec3> out;
  const auto at = [&](int i, int j) {
    const double x = -1.0 + 0.25 * i, y = -1.0 + 0.25 * j;
    return Vec3(x, y, z(x, y));
  };
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (const Vec3& p :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        out.push_back(p);
  return out;
}
double hills(double x, double y) { return 0.2 * std::sin(5.0 * x) * std::cos(4.0 * y); }

TEST(SurfaceContact, OfAPolyhedronOverHillsIsTheirDistance) {
  Random random(10);
  const std::vector<Vec3> ground = fieldOf(hills);
  const Surface mesh(ground, false);
  const Mover A(Vec3::Zero(), Mat3::Identity());
  int met = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vec3> t = trial % 2 ? boxTriangles({0.15, 0.2, 0.25}) : random.hull(12);
    if (trial % 2 == 0)
      for (Vec3& p : t) p *= 0.25;
    const Polyhedron body(t);
    const Mover B(Vec3(0.5 * random.number(), 0.5 * random.number(), 0.45),
                  turned(2.0 * random.vec()));
    const Distance truth = distance(ground, moved(B.frame, t));
    if (!truth.isContact || overlap(ground, moved(B.frame, t))) continue;
    OnSurfaceContacts found;
    const int n = polyhedronOnMesh(A.frame, mesh, placed(B.frame, body), 0.5, false, found);
    double smallest = kInfinity;
    for (int i = 0; i < n; ++i)
      smallest = std::min(smallest, found[static_cast<std::size_t>(i)].at.g);
    // Over a hill all points of both are on the sides that look at each other, if the body does not
    // reach through it.
    ++met;
    EXPECT_NEAR(smallest, truth.value, 1e-12) << "trial " << trial << ", seed 10";
  }
  EXPECT_GT(met, 30);
}

TEST(SurfaceContact, OfAPolyhedronOnAMeshHasTheRatesOfTheMotion) {
  Random random(11);
  const Surface mesh(fieldOf(hills), false);
  const Polyhedron body(boxTriangles({0.15, 0.2, 0.25}));
  const TouchingShape rod = capsule(0.1, 0.3);
  int compared = 0, ofCapsules = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Mover A(0.05 * random.vec(), turned(0.2 * random.vec()), random.vec(), random.vec());
    const Mover B(Vec3(0.5 * random.number(), 0.5 * random.number(), 0.45),
                  turned(2.0 * random.vec()), random.vec(), random.vec());
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      OnSurfaceContacts out;
      const int n = polyhedronOnMesh(fA, mesh, placed(fB, body), 0.3, true, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
    ofCapsules += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      OnSurfaceContacts out;
      const int n = capsuleOnSurface(fA, mesh, fB, rod, 0.3, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
  }
  EXPECT_GT(compared, 100) << "seed 11";
  EXPECT_GT(ofCapsules, 100);
}

TEST(SurfaceContact, OfABoxOnARidgeAreTwoCrossingsAndOnAPeakOneCorner) {
  const Mover A(Vec3::Zero(), Mat3::Identity());
  const Polyhedron box(boxTriangles({0.3, 0.2, 0.1}));
  OnSurfaceContacts found;
  // The ridge runs along y under the middle of the box and crosses two of its lower edges.
  const Surface ridge(fieldOf([](double x, double) { return -0.5 * std::abs(x); }), false);
  const Mover over(Vec3(0.01, 0.02, 0.1), Mat3::Identity());
  int n = polyhedronOnMesh(A.frame, ridge, placed(over.frame, box), 0.01, false, found);
  ASSERT_EQ(n, 2);
  for (int i = 0; i < n; ++i) {
    const ContactPoint& c = found[static_cast<std::size_t>(i)].at;
    EXPECT_NEAR(c.g, 0.0, 1e-15);
    EXPECT_NEAR(c.d[0].z(), 1.0, 1e-15);
    EXPECT_NEAR(std::abs(c.P.y() - 0.02), 0.2, 1e-15);
  }
  const Surface peak(fieldOf([](double x, double y) { return x == 0.0 && y == 0.0 ? 0.1 : 0.0; }),
                     false);
  const Mover above(Vec3(0.05, 0.0, 0.21), turned({0, 0, 0.3}));
  n = polyhedronOnMesh(A.frame, peak, placed(above.frame, box), 0.05, false, found);
  ASSERT_EQ(n, 1);
  EXPECT_NEAR(found[0].at.g, 0.01, 1e-15);
  EXPECT_LT((found[0].at.P - Vec3(0.0, 0.0, 0.1)).norm(), 1e-15);
}

}  // namespace
}  // namespace dynamy
