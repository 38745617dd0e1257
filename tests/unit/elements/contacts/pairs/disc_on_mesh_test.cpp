// Cylinders, tori and cones on meshes against those on polyhedra, and differences.
#include <dynamy_elements/contacts/pairs/disc_on_mesh.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_polyhedron.hpp>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;

TEST(DiscOnMesh, HasTheSmallestGapOfAPolyhedronWithTheseTriangles) {
  Random r(61);
  int met = 0, edges = 0, corners = 0;
  for (int trial = 0; trial < 750; ++trial) {
    const std::vector<Vec3> triangles = r.hull(10);
    const Polyhedron body(triangles);
    const Surface mesh(triangles, false);
    const Mover A = inSpace(r, 0.1 * r.vec()),
                B = inSpace(r, (1.2 + 0.4 * r.number()) * r.vec().normalized());
    const DiscBody b = placedDisc(B.frame, kDiscs[trial % 6]);
    const double truth = separation(placed(A.frame, body), b);
    // A body that is not apart meets faces that it is far below as well.
    if (truth < 1e-3 || truth > 0.3) continue;
    OnSurfaceContacts found;
    const int n = discOnMesh(A.frame, mesh, b, 0.31, found);
    ASSERT_GT(n, 0) << "trial " << trial << ", seed 61";
    const auto least =
        std::min_element(found.begin(), found.begin() + n,
                         [](const auto& a, const auto& c) { return a.at.g < c.at.g; });
    ++met;
    const int faces = 10 * static_cast<int>(mesh.faces().size());
    corners += least->id >= faces && least->id < faces + mesh.corners();
    edges += least->id >= faces + mesh.corners();
    // Lengths of 1, rounded; edges on rims that touch at small angles lose the root of it.
    EXPECT_NEAR(least->at.g, truth, 1e-12) << "trial " << trial << ", seed 61";
  }
  EXPECT_GT(met, 150);
  EXPECT_GT(edges, 30);
  EXPECT_GT(corners, 10);
}

TEST(DiscOnMesh, RatesAreThoseOfTheMotion) {
  Random r(62);
  int compared = 0;
  for (int trial = 0; trial < 750; ++trial) {
    const Surface mesh(r.hull(10), false);
    const Mover A = inSpace(r, 0.1 * r.vec()), B = inSpace(r, 1.1 * r.vec().normalized());
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      OnSurfaceContacts out;
      const int n = discOnMesh(fA, mesh, placedDisc(fB, kDiscs[trial % 6]), 0.3, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
  }
  EXPECT_GT(compared, 300) << "seed 62";
}

}  // namespace
}  // namespace dynamy
