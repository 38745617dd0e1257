// Ellipsoids against dense samples of directions, balls, boxes seen by balls, and differences.
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

#include <cmath>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// The largest separation over all directions: a grid, refined around the best three times.
double separatedNear(const std::function<double(const Vec3&)>& f, const Vec3& start) {
  Vec3 best = start.normalized();
  double most = f(best), width = 1.6;
  for (int level = 0; level < 12; ++level, width *= 0.3) {
    const Vec3 c = best, x = c.unitOrthogonal(), y = c.cross(x);
    for (int i = -15; i <= 15; ++i)
      for (int j = -15; j <= 15; ++j) {
        const Vec3 n =
            (c + std::tan(width / 15.0 * i / 1.1) * x + std::tan(width / 15.0 * j / 1.1) * y)
                .normalized();
        if (const double s = f(n); s > most) most = s, best = n;
      }
  }
  return most;
}

TEST(SmoothContact, OfEllipsoidsIsTheLargestSeparationOfAllDirections) {
  Random r(31);
  const SupportFeature a = ellipsoid({0.5, 0.3, 0.8}, {0.1, 0.0, 0.0}),
                       b = ellipsoid({0.2, 0.6, 0.4});
  int apart = 0, overlapping = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Mover A = inSpace(r, Vec3::Zero());
    const Mover B = inSpace(r, (trial % 2 ? 1.5 : 1.0) * r.vec().normalized());
    const auto f = [&](const Vec3& n) { return -reach(B.frame, b, -n) - reach(A.frame, a, n); };
    const double truth = separatedNear(f, B.frame.r_OS_I);
    if (truth < -0.1) continue;
    (truth > 0.0 ? apart : overlapping)++;
    const ContactPoint c = betweenSmooth(A.frame, a, B.frame, b);
    // The last grid is 1e-6 rad wide: f is flat to its square there.
    EXPECT_NEAR(c.g, truth, 1e-11) << "trial " << trial << ", seed 31";
    // The points of both lie opposite to each other.
    const Vec3 pA = A.frame.r_OS_I + A.frame.A_IK * a.point(A.frame.A_IK.transpose() * c.d[0]);
    EXPECT_LT((c.P - pA - c.g * c.d[0]).norm(), 1e-7);
  }
  EXPECT_GT(apart, 30);
  EXPECT_GT(overlapping, 3);
}

TEST(SmoothContact, OfBallsIsThatOfBalls) {
  Random r(32);
  const SupportFeature a = ellipsoid(Vec3::Constant(0.5), {0.1, 0.2, 0.0}),
                       b = ball(0.3, {0, 0, 0.1});
  for (int trial = 0; trial < 50; ++trial) {
    const Mover A = inSpace(r, Vec3::Zero()), B = inSpace(r, r.vec().normalized());
    const ContactPoint c = betweenSmooth(A.frame, a, B.frame, b),
                       t = betweenBalls(A.frame, {a.c_K, 0.5}, B.frame, {b.c_K, 0.3}, Vec3::Zero());
    // P is B's point, that of balls A's: compared where n and its rate are.
    EXPECT_NEAR(c.g, t.g, 1e-14);
    EXPECT_LT((c.d[0] - t.d[0]).norm(), 1e-7);
    EXPECT_LT((c.ddot[0] - t.ddot[0]).norm(), 1e-6);
  }
}

TEST(SmoothContact, OfEllipsoidsHasTheRatesOfTheMotion) {
  Random r(33);
  const SupportFeature a = ellipsoid({0.5, 0.3, 0.8}, {0.1, 0.0, 0.0}),
                       b = ellipsoid({0.2, 0.6, 0.4});
  int compared = 0;
  for (int trial = 0; trial < 100; ++trial)
    compared +=
        expectRatesFit(inSpace(r, Vec3::Zero()), inSpace(r, 1.4 * r.vec().normalized()),
                       [&](const Frame& fA, const Frame& fB) {
                         return std::vector<NumberedContact>{{0, betweenSmooth(fA, a, fB, b)}};
                       });
  EXPECT_GT(compared, 80);
}

TEST(SmoothContact, OfABallOnABoxIsThatOfBoxes) {
  Random r(34);
  const Vec3 half(0.3, 0.5, 0.7);
  const Polyhedron body(boxTriangles(half));
  TouchingShape box;
  box.kind = TouchingShape::Kind::box, box.half = half;
  const SupportFeature b = ellipsoid(Vec3::Constant(0.2), {0.1, 0.0, 0.05});
  for (int trial = 0; trial < 300; ++trial) {
    const Mover A = inSpace(r, 0.1 * r.vec()), B = inSpace(r, 1.2 * r.vec());
    const ContactPoint t = ballOnBox(A.frame, box, B.frame, {b.c_K, 0.2}, Vec3::Zero());
    if (t.g < -0.15) continue;  // the centre is inside, or on an edge
    const ContactPoint c = smoothOnPolyhedron(placed(A.frame, body), B.frame, b);
    EXPECT_NEAR(c.g, t.g, 1e-13) << "trial " << trial << ", seed 34";
    // n is found where f is flat: to the root of a rounding.
    EXPECT_LT((c.d[0] - t.d[0]).norm(), 1e-6) << trial;
    EXPECT_LT((c.ddot[0] - t.ddot[0]).norm(), 1e-4) << trial;
    EXPECT_LT((c.P - t.P).norm(), 1e-6);
    EXPECT_LT((c.Pdot - t.Pdot).norm(), 1e-4);
  }
}

TEST(SmoothContact, OfEllipsoidsOnPolyhedraIsTheLargestSeparation) {
  Random r(35);
  const SupportFeature b = ellipsoid({0.2, 0.6, 0.4});
  int met = 0, compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Polyhedron body(r.hull(12));
    const Mover A = inSpace(r, Vec3::Zero()), B = inSpace(r, 1.6 * r.vec().normalized());
    const auto f = [&](const Vec3& n) {
      double most = -kInfinity;
      for (const Vec3& p : body.corners())
        most = std::max(most, n.dot(A.frame.r_OS_I + A.frame.A_IK * p));
      return -reach(B.frame, b, -n) - most;
    };
    const double truth = separatedNear(f, B.frame.r_OS_I);
    if (truth < 1e-3) continue;
    ++met;
    const ContactPoint c = smoothOnPolyhedron(placed(A.frame, body), B.frame, b);
    // No direction separates more than the distance of two points, and n as much: both are extreme.
    EXPECT_GT(c.g, truth - 1e-12) << "trial " << trial << ", seed 35";
    EXPECT_NEAR(f(c.d[0]), c.g, 1e-12);
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      return std::vector<NumberedContact>{{0, smoothOnPolyhedron(placed(fA, body), fB, b)}};
    });
  }
  EXPECT_GT(met, 25);
  EXPECT_GT(compared, 20);
}

TEST(SmoothContact, OfEllipsoidsOnRoundBodiesIsTheLargestSeparation) {
  Random r(36);
  const SupportFeature b = ellipsoid({0.2, 0.6, 0.4});
  // Cylinder, coin, torus, capsule, cones: half length, radius of the discs, of the tube.
  const double sizes[][3] = {{0.5, 0.3, 0.0}, {0.05, 0.4, 0.0}, {0.0, 0.4, 0.1}, {0.4, 0.0, 0.2},
                             {0.4, 0.3, 0.0}, {0.1, 0.5, 0.0},  {0.6, 0.1, 0.0}};
  int met = 0, overlapping = 0, compared = 0;
  for (int trial = 0; trial < 350; ++trial) {
    const double* s = sizes[trial % 7];
    const bool tip = trial % 7 > 3;
    const auto disc = [&](const Frame& f) {
      return DiscBody{&f, f.r_OS_I, f.A_IK.col(2), f.A_IK.col(0), s[0], s[1], s[2], tip};
    };
    const Mover A = inSpace(r, Vec3::Zero()),
                B = inSpace(r, (0.9 + 0.4 * r.number()) * r.vec().normalized());
    const DiscBody a = disc(A.frame);
    const auto f = [&](const Vec3& n) { return -reach(B.frame, b, -n) - a.support(n); };
    const double truth = separatedNear(f, B.frame.r_OS_I);
    if (truth < -0.05) continue;
    ++met, overlapping += truth < 0.0;
    const ContactPoint c = smoothOnDisc(a, B.frame, b);
    // No direction separates more, and n as much: both are extreme.
    EXPECT_GT(c.g, truth - 1e-12) << "trial " << trial << ", seed 36";
    EXPECT_NEAR(f(c.d[0]), c.g, 1e-12) << "trial " << trial << ", seed 36";
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      return std::vector<NumberedContact>{{0, smoothOnDisc(disc(fA), fB, b)}};
    });
  }
  EXPECT_GT(met, 175);
  EXPECT_GT(overlapping, 8);
  EXPECT_GT(compared, 175);
}

/// No direction separates by more than the distance of two points, and none of the bodies' points are
/// nearer than a direction separates: both together prove a gap.
TEST(SmoothContact, OfEllipsoidsIsProvenWhereBodiesAreApart) {
  Random r(38);
  int proven = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    // Also far from the origin, where coordinates round to 1e-13 m.
    const double far = trial % 4 == 0 ? 1e3 : 1.0;
    const Mover A = inSpace(r, far * r.vec()), B = inSpace(r, A.frame.r_OS_I + 2.0 * r.vec());
    const SupportFeature b =
        ellipsoid(Vec3::Constant(0.1) + 0.4 * r.vec().cwiseAbs(), 0.1 * r.vec());
    const double rounding = 1e-12 * far;  // some thousand operations on coordinates of this size
    const bool round = trial % 2 == 0;
    const Polyhedron body(r.hull(4 + trial % 12));
    const double half = trial % 3 == 0 ? 0.0 : 0.5, tube = trial % 3 == 0 ? 0.1 : 0.0;
    const DiscBody disc{
        &A.frame, A.frame.r_OS_I, A.frame.A_IK.col(2),         A.frame.A_IK.col(0), half,
        0.4,      tube,           half > 0.0 && trial % 5 == 0};
    const PlacedPolyhedron of = placed(A.frame, body);
    const ContactPoint c =
        round ? smoothOnDisc(disc, B.frame, b) : smoothOnPolyhedron(of, B.frame, b);
    if (c.g < 1e-6) continue;
    ++proven;
    const Vec3 &n = c.d[0], q = c.P - c.g * n;
    double most = -kInfinity, outside = -kInfinity;
    if (round) {
      most = disc.support(n), outside = (q - disc.nearest(q)).norm() - disc.r;
    } else {
      for (const Vec3& p : body.corners()) most = std::max(most, n.dot(of.c + of.R * p));
      for (const Polyhedron::Face& face : body.faces())
        outside = std::max(outside, face.n.dot(of.R.transpose() * (q - of.c)) - face.height);
    }
    EXPECT_NEAR(-reach(B.frame, b, -n) - most, c.g, rounding) << "trial " << trial;
    EXPECT_LT(outside, rounding) << "trial " << trial;
  }
  EXPECT_GT(proven, 2000);
}

}  // namespace
}  // namespace dynamy
