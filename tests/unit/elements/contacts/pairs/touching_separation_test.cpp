// The largest separation of bodies that touch along a normal which was chosen, by rounding or more
// of distance or overlap: it is not less than along that normal, as it is the largest. Of smooth
// bodies it is along that normal.
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>

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

void touchPolyhedra(unsigned seed, int places) {
  Random r(seed);
  for (int trial = 0; trial < places; ++trial) {
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
        << "trial " << trial << ", seed " << seed << ", gap " << gap;
    DiscContacts found;
    const int m = discOnPolyhedron(placed(A.frame, body), b, kInfinity, -1.0, true, found);
    expectNotDeeper(found, m, f, trial);
  }
}

TEST(TouchingSeparation, OfADiscAndAPolyhedronIsAtLeastThatAlongTheNormal) {
  touchPolyhedra(61, kPlaces);
}

TEST(LongTouchingSeparation, OfADiscAndAPolyhedron) { touchPolyhedra(65, 300000); }

/// `missing`: by how much less the separation found may be [m].
void touchDiscs(unsigned seed, int places, double missing) {
  Random r(seed);
  for (int trial = 0; trial < places; ++trial) {
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
    EXPECT_GT(separation(a, b), f - missing)
        << "trial " << trial << ", seed " << seed << ", gap " << gap;
  }
}

TEST(TouchingSeparation, OfTwoDiscsIsAtLeastThatAlongTheNormal) {
  touchDiscs(62, kPlaces, kRoundedGap);
}

TEST(LongTouchingSeparation, OfTwoDiscs) {
  // The separation of a normal that is off by δ is off by δ² of the radii of curvature, 1 m: its
  // search may end at the square root of a hundredfold rounding in one case of many.
  touchDiscs(66, 1000000, 1e-11);
}

TEST(TouchingSeparation, OfAnEllipsoidAndAPolyhedronHasTheNormalOfTouching) {
  // It touches a corner along the normal of a face, between two or among three, where the contact
  // passes from feature to feature: on neither of them by a rounding.
  Random r(63);
  for (int trial = 0; trial < kPlaces; ++trial) {
    const Polyhedron body =
        trial % 2 ? Polyhedron(r.hull(10)) : Polyhedron(boxTriangles({0.6, 0.4, 0.3}));
    const Mover A = inSpace(r, 0.3 * r.vec());
    const int corner = trial / 14 % static_cast<int>(body.corners().size());
    const Vec3 n = A.frame.A_IK * normalAt(r, body, corner, 1 + trial / 3 % 3);
    const SupportFeature smooth =
        ellipsoid({0.35 + 0.2 * r.number(), 0.35 + 0.2 * r.number(), 0.35 + 0.2 * r.number()});
    Mover B = inSpace(r, Vec3::Zero());
    const double gap = kGaps[trial % 12];
    const Vec3 lowest = B.frame.A_IK * smooth.point(-(B.frame.A_IK.transpose() * n));
    B.frame.r_OS_I = A.frame.r_OS_I + A.frame.A_IK * body.corner(corner) + gap * n - lowest;
    const ContactPoint at = smoothOnPolyhedron(placed(A.frame, body), B.frame, smooth);
    if (gap < -1e-8) continue;  // another corner or edge may separate more
    EXPECT_NEAR(at.g, gap, 4.0 * kRoundedGap) << "trial " << trial << ", seed 63, gap " << gap;
    EXPECT_LT((at.d[0] - n).norm(), 1e-7) << "trial " << trial << ", seed 63, gap " << gap;
  }
}

/// One of the contacts found has this gap and normal. On a thin body others may be of its far side,
/// with deep overlaps: a mesh does not know what is inside.
void expectOne(std::span<const NumberedContact> found, double gap, const Vec3& n, int trial) {
  EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                          [&](const NumberedContact& c) {
                            return std::abs(c.at.g - gap) < 4.0 * kRoundedGap &&
                                   (c.at.d[0] - n).norm() < 1e-7;
                          }))
      << "trial " << trial << ", seed 64, gap " << gap << ", contacts " << found.size();
}

TEST(TouchingSeparation, OfRoundBodiesOnAMeshHasTheNormalOfTouching) {
  // As above; capsules with an end, the side, or the border between them.
  Random r(64);
  for (int trial = 0; trial < kPlaces; ++trial) {
    const std::vector<Vec3> triangles = trial % 2 ? r.hull(10) : boxTriangles({0.6, 0.4, 0.3});
    const Polyhedron body(triangles);
    const Surface mesh(triangles, true);
    const Mover A = inSpace(r, 0.3 * r.vec());
    const int corner = trial / 14 % static_cast<int>(body.corners().size());
    const Vec3 n = A.frame.A_IK * normalAt(r, body, corner, 1 + trial / 3 % 3);
    const double gap = trial % 12 < 9 ? kGaps[trial % 12] : 0.0;
    const Vec3 place = A.frame.r_OS_I + A.frame.A_IK * body.corner(corner) + gap * n;
    Mover B = inSpace(r, Vec3::Zero());
    OnSurfaceContacts out;
    int found = 0;
    if (trial / 5 % 2 == 0) {
      const SupportFeature smooth =
          ellipsoid({0.35 + 0.2 * r.number(), 0.35 + 0.2 * r.number(), 0.35 + 0.2 * r.number()});
      B.frame.r_OS_I = place - B.frame.A_IK * smooth.point(-(B.frame.A_IK.transpose() * n));
      found = smoothOnMesh(A.frame, mesh, B.frame, smooth, 0.1, out);
    } else {
      const double R = 0.1, half = 0.6;
      const Vec3 across = n.cross(r.vec()).normalized();
      B.frame.A_IK.col(0) = n, B.frame.A_IK.col(2) = across;
      B.frame.A_IK.col(1) = across.cross(n);
      const double along[] = {half, -half, half * r.number(), half * r.number()};
      B.frame.r_OS_I = place + R * n + along[trial % 4] * across;
      found = capsuleOnSurface(A.frame, mesh, B.frame, capsule(R, half), 0.1, out);
    }
    expectOne({out.data(), static_cast<std::size_t>(found)}, gap, n, trial);
  }
}

/// Directions evenly spread on a spiral.
std::vector<Vec3> spread(int count) {
  std::vector<Vec3> all;
  for (int k = 0; k < count; ++k) {
    const double up = 1.0 - 2.0 * (k + 0.5) / count, out = std::sqrt(1.0 - up * up);
    all.push_back({out * std::cos(2.399963 * k), out * std::sin(2.399963 * k), up});
  }
  return all;
}

/// Error of a separation of bodies of 1 m, with a margin of a hundred.
constexpr double kRounded = 1e-13;

TEST(DeepSeparation, OfTwoDiscsIsTheLargestOfAllDirections) {
  // Bodies in each other: along arcs of directions a maximum may be followed by a minimum.
  Random r(67);
  const std::vector<Vec3> all = spread(3000);
  for (int trial = 0; trial < 2000; ++trial) {
    const Mover A = inSpace(r, Vec3::Zero()), B = inSpace(r, 0.5 * r.vec());
    const DiscBody a = placedDisc(A.frame, kAll[trial % 7]),
                   b = placedDisc(B.frame, kAll[trial / 7 % 7]);
    double most = -kInfinity;
    for (const Vec3& n : all) most = std::max(most, -b.support(-n) - a.support(n));
    EXPECT_GT(separation(a, b), most - kRounded) << "trial " << trial;
  }
}

TEST(DiscDistance, IsThatOfTheNearestPoints) {
  // Apart, near and in each other, with axes at random, parallel or across. No direction separates bodies
  // by more than two points are apart. Steps from one hull of discs to the nearest point of the other
  // approach their distance; at 2 cm curved sides of 0.5 m leave (1 + 0.02/0.5)⁻⁸⁰⁰⁰ of the way after
  // 4000, nearly parallel flat ones more: 2e-9 m here.
  Random r(68);
  const std::vector<Vec3> all = spread(3000);
  int apart = 0;
  double worst = 0.0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Mover A = inSpace(r, Vec3::Zero());
    Mover B = inSpace(r, (0.4 + 0.8 * std::abs(r.number())) * r.vec());
    const Mat3& K = A.frame.A_IK;
    if (trial % 5 == 0) B.frame.A_IK = K;
    if (trial % 5 == 1)
      B.frame.A_IK.col(0) = K.col(1), B.frame.A_IK.col(1) = K.col(2),
      B.frame.A_IK.col(2) = K.col(0);
    const DiscBody a = placedDisc(A.frame, kAll[trial % 7]),
                   b = placedDisc(B.frame, kAll[trial / 7 % 7]);
    double most = -kInfinity;
    for (const Vec3& n : all) most = std::max(most, -b.support(-n) - a.support(n));
    const double found = separation(a, b);
    ASSERT_GT(found, most - kRounded) << "trial " << trial;
    Vec3 x = b.c;
    double way = kInfinity;
    for (int k = 0; k < 4000; ++k) {
      const Vec3 y = a.nearest(x);
      x = b.nearest(y);
      way = (x - y).norm();
    }
    ASSERT_LT(found, way - a.r - b.r + kRounded) << "trial " << trial;
    if (!(found + a.r + b.r > 0.02))
      continue;  // the hulls of their discs are in each other, or near
    ++apart, worst = std::max(worst, way - a.r - b.r - found);
  }
  EXPECT_GT(apart, 1000);
  EXPECT_LT(worst, 1e-8);
}

TEST(DeepSeparation, OfADiscAndAPolyhedronIsTheLargestOfAllDirections) {
  Random r(68);
  const std::vector<Vec3> all = spread(3000);
  for (int trial = 0; trial < 2000; ++trial) {
    const Polyhedron body =
        trial % 2 ? Polyhedron(r.hull(10)) : Polyhedron(boxTriangles({0.6, 0.4, 0.3}));
    const Mover A = inSpace(r, Vec3::Zero()), B = inSpace(r, 0.4 * r.vec());
    const DiscBody b = placedDisc(B.frame, kAll[trial / 2 % 7]);
    double most = -kInfinity;
    for (const Vec3& n : all) {
      double along = -kInfinity;
      for (const Vec3& p : body.corners())
        along = std::max(along, n.dot(A.frame.r_OS_I + A.frame.A_IK * p));
      most = std::max(most, -b.support(-n) - along);
    }
    EXPECT_GT(separation(placed(A.frame, body), b), most - kRounded) << "trial " << trial;
  }
}

}  // namespace
}  // namespace dynamy
