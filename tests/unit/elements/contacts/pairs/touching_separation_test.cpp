// The largest separation of bodies that touch along a normal which was chosen, by rounding or more
// of distance or overlap: it is not less than along that normal, as it is the largest.
#include <dynamy_elements/contacts/pairs/between_discs.hpp>

#include <cmath>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;

constexpr int kPlaces = 20000;
constexpr double kGaps[] = {0.0,    1e-16, -1e-16, 1e-15, -1e-15, 1e-12,
                            -1e-12, 1e-9,  -1e-9,  -1e-7, -1e-5,  -1e-3};

/// Sizes of round bodies, with capsules.
constexpr DiscSizes kAll[] = {{0.5, 0.3, 0.0}, {0.05, 0.4, 0.0},      {0.0, 0.4, 0.1},
                              {0.7, 0.1, 0.0}, {0.4, 0.3, 0.0, true}, {0.1, 0.5, 0.0, true},
                              {0.4, 0.0, 0.2}};

/// A direction between the normals of the faces that meet in a corner; along an edge or a face for
/// two or one of them.
Vec3 normalAt(Random& r, const Polyhedron& body, int corner, int faces) {
  const std::vector<int>& all = body.facesAt(corner);
  Vec3 n = Vec3::Zero();
  for (int k = 0; k < std::min(faces, static_cast<int>(all.size())); ++k)
    n += (1.01 + r.number()) * body.face(all[static_cast<std::size_t>(k)]).n;
  return n.normalized();
}

/// Axes of a round body for a normal of touching: anywhere, across the axis, along the axis, and
/// along a line of a cone's side.
Mat3 axesFor(Random& r, const Vec3& n, const DiscSizes& s, int kind) {
  const Vec3 across = n.cross(r.vec()).normalized();
  if (kind == 0) return turned(2.0 * r.vec());
  Vec3 a = kind == 1 ? across : n;
  if (kind == 3 && s.tip) {
    // −n is normal to the side: −n·a = sin β.
    const double c = std::hypot(s.rho, 2.0 * s.half);
    a = (2.0 * s.half * across - s.rho * n) / c;
  }
  Mat3 R;
  R.col(2) = a, R.col(0) = a.unitOrthogonal(), R.col(1) = a.cross(R.col(0));
  return R;
}

/// Rounding of lengths of 2 m.
constexpr double kRoundedGap = 4e-15;

/// The contacts found tell no more overlap than there is along the normal of touching. Features
/// nearer than 1e-6 of a body are one, with four of them between two contacts.
void expectNotDeeper(const DiscContacts& found, int n, double f, int trial) {
  ASSERT_GT(n, 0) << trial;
  double least = kInfinity;
  for (int i = 0; i < n; ++i) least = std::min(least, found[static_cast<std::size_t>(i)].at.g);
  EXPECT_GT(least, f - 4e-6) << "trial " << trial;
}

TEST(TouchingSeparation, OfADiscAndAPolyhedronIsAtLeastThatAlongTheNormal) {
  Random r(61);
  for (int trial = 0; trial < kPlaces; ++trial) {
    const Polyhedron body =
        trial % 2 ? Polyhedron(r.hull(10)) : Polyhedron(boxTriangles({0.6, 0.4, 0.3}));
    const DiscSizes& s = kAll[trial / 2 % 7];
    const Mover A = inSpace(r, 0.3 * r.vec());
    const int corner = trial / 14 % static_cast<int>(body.corners().size());
    const Vec3 n = A.frame.A_IK * normalAt(r, body, corner, 1 + trial / 3 % 3);
    Mover B = inSpace(r, Vec3::Zero());
    B.frame.A_IK = axesFor(r, n, s, trial / 5 % 4);
    const double gap = kGaps[trial % 12];
    const DiscBody unplaced = placedDisc(B.frame, s);
    B.frame.r_OS_I =
        A.frame.r_OS_I + A.frame.A_IK * body.corner(corner) + gap * n - unplaced.furthest(-n);
    const DiscBody b = placedDisc(B.frame, s);
    double along = -kInfinity;
    for (const Vec3& p : body.corners())
      along = std::max(along, n.dot(A.frame.r_OS_I + A.frame.A_IK * p));
    const double f = -b.support(-n) - along;
    EXPECT_GT(separation(placed(A.frame, body), b), f - kRoundedGap)
        << "trial " << trial << ", seed 61, gap " << gap;
    DiscContacts found;
    const int m = discOnPolyhedron(placed(A.frame, body), b, kInfinity, -1.0, true, found);
    expectNotDeeper(found, m, f, trial);
  }
}

TEST(TouchingSeparation, OfTwoDiscsIsAtLeastThatAlongTheNormal) {
  Random r(62);
  for (int trial = 0; trial < kPlaces; ++trial) {
    const DiscSizes &sA = kAll[trial % 7], &sB = kAll[trial / 7 % 7];
    Mover A = inSpace(r, Vec3::Zero()), B = inSpace(r, Vec3::Zero());
    const Vec3 n = r.vec().normalized();
    A.frame.A_IK = axesFor(r, -n, sA, trial / 3 % 4),
    B.frame.A_IK = axesFor(r, n, sB, trial / 5 % 4);
    const double gap = kGaps[trial % 12];
    const DiscBody a = placedDisc(A.frame, sA), unplaced = placedDisc(B.frame, sB);
    B.frame.r_OS_I = a.furthest(n) + gap * n - unplaced.furthest(-n);
    const DiscBody b = placedDisc(B.frame, sB);
    const double f = -b.support(-n) - a.support(n);
    DiscContacts found;
    expectNotDeeper(found, betweenDiscs(a, b, kInfinity, -1.0, true, found), f, trial);
    EXPECT_GT(separation(a, b), f - kRoundedGap) << "trial " << trial << ", seed 62, gap " << gap;
  }
}

}  // namespace
}  // namespace dynamy
