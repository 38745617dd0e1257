// Contact of polyhedra against brute force: distances over all pairs of features, depths from the
// hull of all differences, boxes as polyhedra against boxes.
#include <dynamy_elements/contacts/pairs/box_contact.hpp>

#include "unit/elements/contacts/faceted_bodies.hpp"

namespace dynamy {
namespace {

using namespace testing;

TEST(Polyhedron, OfABoxHasItsFacesAndEdges) {
  const Polyhedron box(boxTriangles({0.3, 0.4, 0.5}));
  EXPECT_EQ(box.corners().size(), 8u);
  EXPECT_EQ(box.faces().size(), 6u);
  EXPECT_EQ(box.edges().size(), 12u);
  EXPECT_EQ(box.halfWidth(), 0.3);
  for (const Polyhedron::Face& f : box.faces()) EXPECT_EQ(f.count, 4);
  for (const Polyhedron::Edge& e : box.edges())
    EXPECT_NEAR(box.face(e.f).n.cross(box.face(e.g).n).dot(e.e), 1.0, 1e-15);
}

TEST(PolyhedronContact, OfTwoBoxesIsThatOfBoxes) {
  Random random(5);
  const Vec3 hA(0.5, 0.7, 0.3), hB(0.6, 0.4, 0.5);
  const Polyhedron a(boxTriangles(hA)), b(boxTriangles(hB));
  int faces = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // Anywhere, and lying on each other with a small tilt.
    const bool lying = trial % 2 == 0;
    const Mover A(Vec3::Zero(), turned(random.vec()), random.vec(), random.vec());
    const Mover B(lying ? Vec3(A.frame.A_IK * Vec3(0.3 * random.number(), 0.3, 0.81))
                        : Vec3(1.2 * random.vec().normalized()),
                  lying ? Mat3(A.frame.A_IK * turned(0.01 * random.vec() + Vec3(0, 0, 0.4)))
                        : turned(2.0 * random.vec()),
                  random.vec(), random.vec());
    std::array<BoxContact, kMostBoxContacts> truth;
    const int n = betweenBoxes({&A.frame, A.frame.r_OS_I, A.frame.A_IK, hA},
                               {&B.frame, B.frame.r_OS_I, B.frame.A_IK, hB}, true, truth);
    PolyhedraContacts found;
    ASSERT_EQ(n, betweenPolyhedra(placed(A.frame, a), placed(B.frame, b), kInfinity, true, found))
        << "trial " << trial << ", seed 5";
    faces += n > 2;
    for (int i = 0; i < n; ++i) {
      const ContactPoint& t = truth[static_cast<std::size_t>(i)].at;
      // The same contact: the nearest of those found.
      const auto c =
          std::min_element(found.begin(), found.begin() + n, [&](const auto& x, const auto& y) {
            return (x.at.P - t.P).squaredNorm() < (y.at.P - t.P).squaredNorm();
          });
      // Roundings of lengths of 1, over the sine 0.05 of the flattest crossing.
      EXPECT_NEAR(c->at.g, t.g, 1e-14);
      EXPECT_LT((c->at.P - t.P).norm(), 1e-12);
      EXPECT_LT((c->at.Pdot - t.Pdot).norm(), 1e-11);
      EXPECT_LT((c->at.d[0] - t.d[0]).norm(), 1e-13);
      EXPECT_LT((c->at.ddot[0] - t.ddot[0]).norm(), 1e-12);
    }
  }
  EXPECT_GT(faces, 100);
}

TEST(PolyhedronContact, OfParallelEdgesThatMeetIsThereWhileTheyAreApart) {
  // Bricks side by side that turn by ±θ: the edges in front are δ apart, δ sin θ beside the faces.
  const Vec3 half(0.2, 0.1, 0.1);
  const Polyhedron brick(boxTriangles(half));
  for (const double theta : {0.02, 0.2, 0.4})
    for (const double delta : {-1e-6, 1e-12, 1e-9, 1e-6, 1e-2}) {
      const double front = half.x() * std::cos(theta) + half.y() * std::sin(theta) + delta / 2.0;
      const Mover A(-front * Vec3::UnitX(), turned(theta * Vec3::UnitZ())),
          B(front * Vec3::UnitX(), turned(-theta * Vec3::UnitZ()));
      std::array<BoxContact, kMostBoxContacts> ofBoxes;
      PolyhedraContacts ofPolyhedra;
      const int boxes =
                    betweenBoxes({&A.frame, A.frame.r_OS_I, A.frame.A_IK, half},
                                 {&B.frame, B.frame.r_OS_I, B.frame.A_IK, half}, false, ofBoxes),
                polyhedra = betweenPolyhedra(placed(A.frame, brick), placed(B.frame, brick),
                                             kInfinity, false, ofPolyhedra);
      const auto least = [](const auto& contacts, int n) {
        return leastGap({contacts.data(), static_cast<std::size_t>(n)});
      };
      if (delta > 1e-3) {  // they pass each other: what is beside is at most 1e-4 of the half width
        EXPECT_GT(least(ofBoxes, boxes), 1.01 * delta) << theta;
        EXPECT_GT(least(ofPolyhedra, polyhedra), 1.01 * delta) << theta;
        continue;
      }
      const double g = delta * std::cos(theta);  // up to rounding of positions of 0.4 m
      EXPECT_NEAR(least(ofBoxes, boxes), g, 1e-15) << theta << ' ' << delta;
      EXPECT_NEAR(least(ofPolyhedra, polyhedra), g, 1e-15) << theta << ' ' << delta;
    }
}

TEST(PolyhedronContact, SmallestGapIsTheDistanceWhereFeaturesMeet) {
  Random random(6);
  int met = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Vec3> ta = random.hull(12), tb = random.hull(16);
    const Polyhedron a(ta), b(tb);
    const Mover A(0.2 * random.vec(), turned(random.vec()));
    const Mover B(2.1 * random.vec().normalized(), turned(random.vec()));
    const Distance truth = distance(moved(A.frame, ta), moved(B.frame, tb));
    PolyhedraContacts found;
    const int n = betweenPolyhedra(placed(A.frame, a), placed(B.frame, b), kInfinity, false, found);
    if (separation(placed(A.frame, a), placed(B.frame, b)) <= 0.0) continue;
    double smallest = kInfinity;
    for (int i = 0; i < n; ++i)
      smallest = std::min(smallest, found[static_cast<std::size_t>(i)].at.g);
    // Features nearer than 1e-6 of a body are one.
    EXPECT_GT(smallest, truth.value - 1e-5);
    if (!truth.isContact) continue;
    ++met;
    EXPECT_NEAR(smallest, truth.value, 1e-6) << "trial " << trial << ", seed 6";
  }
  EXPECT_GT(met, 40);
}

TEST(PolyhedronContact, SeparationIsTheDepthOfTheOriginInTheHullOfDifferences) {
  Random random(7);
  int overlaps = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const std::vector<Vec3> ta = random.hull(9), tb = random.hull(11);
    const Polyhedron a(ta), b(tb);
    const Mover A(Vec3::Zero(), turned(random.vec()));
    const Mover B(1.5 * random.vec().normalized(), turned(random.vec()));
    std::vector<Vec3> all;
    for (const Vec3& p : a.corners())
      for (const Vec3& q : b.corners())
        all.push_back(B.frame.r_OS_I + B.frame.A_IK * q - A.frame.A_IK * p);
    double truth = -kInfinity;  // of the origin over the faces of B − A, from outside
    for (const Triangle& t : convexHull(all)) {
      const auto at = [&](std::size_t k) { return all[static_cast<std::size_t>(t[k])]; };
      truth = std::max(truth, -(at(1) - at(0)).cross(at(2) - at(0)).normalized().dot(at(0)));
    }
    if (truth > 0.0) continue;
    ++overlaps;
    // Edges that cross at less than asin 0.05 are no axes: they are faces of the hull that are
    // almost those of a face of a body.
    EXPECT_NEAR(separation(placed(A.frame, a), placed(B.frame, b)), truth, 1e-12)
        << "trial " << trial << ", seed 7";
  }
  EXPECT_GT(overlaps, 20);
}

TEST(PolyhedronContact, RatesAreThoseOfTheMotion) {
  Random random(8);
  int compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Polyhedron a(random.hull(12)), b(random.hull(16));
    const Mover A(Vec3::Zero(), turned(random.vec()), random.vec(), random.vec());
    const Mover B(1.8 * random.vec().normalized(), turned(random.vec()), random.vec(),
                  random.vec());
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      PolyhedraContacts out;
      const int n = betweenPolyhedra(placed(fA, a), placed(fB, b), kInfinity, true, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
  }
  EXPECT_GT(compared, 100) << "seed 8";
}

}  // namespace
}  // namespace dynamy
