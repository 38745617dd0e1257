// Contacts of two faces are never nearer than the bodies: separations of the bodies from
// projections of all corners on all axes that can separate them.
#include <dynamy_elements/contacts/pairs/box_contact.hpp>

#include "unit/elements/contacts/faceted_bodies.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// Gap between two sets of points along n, from the first to the second.
double gapAlong(const Vec3& n, const std::vector<Vec3>& A, const std::vector<Vec3>& B) {
  double most = -kInfinity, least = kInfinity;
  for (const Vec3& p : A) most = std::max(most, n.dot(p));
  for (const Vec3& p : B) least = std::min(least, n.dot(p));
  return least - most;
}

struct Axes {
  std::vector<Vec3> corners, faces, edges;
};
/// Largest gap along all normals of faces and products of edges.
double separationOf(const Axes& A, const Axes& B) {
  double most = -kInfinity;
  const auto take = [&](const Vec3& n) {
    most = std::max({most, gapAlong(n, A.corners, B.corners), gapAlong(-n, A.corners, B.corners)});
  };
  for (const Vec3& n : A.faces) take(n);
  for (const Vec3& n : B.faces) take(n);
  for (const Vec3& a : A.edges)
    for (const Vec3& b : B.edges)
      if (const Vec3 n = a.cross(b); n.norm() > kCross) take(n.normalized());
  return most;
}

Axes axesOf(const PlacedBox& box) {
  Axes out;
  for (int i = 0; i < 8; ++i) out.corners.push_back(box.vertex(i));
  for (int k = 0; k < 3; ++k) out.faces.emplace_back(box.R.col(k));
  out.edges = out.faces;
  return out;
}
Axes axesOf(const Frame& f, const Polyhedron& body) {
  Axes out;
  out.corners = moved(f, body.corners());
  for (const Polyhedron::Face& x : body.faces()) out.faces.emplace_back(f.A_IK * x.n);
  for (const Polyhedron::Edge& x : body.edges()) out.edges.emplace_back(f.A_IK * x.e);
  return out;
}

/// Distance of B's centre along `direction` at which the bodies are apart by `wanted` [m].
template <class Apart>
double distanceOf(double wanted, Apart&& apart) {
  double near = 0.0, far = 10.0;
  while (far - near > 1e-12) {
    const double middle = 0.5 * (near + far);
    (apart(middle) > wanted ? far : near) = middle;
  }
  return far;
}

/// Features nearer than kSameFeature of the smaller body's half width are one. Bodies apart may
/// have corners a hundred of these beside a face.
constexpr double kTolerance = 5.0 * kSameFeature;

TEST(FacePairDepth, OfBoxesApartHasNoCrossingOfEdgesBesideTheCorner) {
  // Two bricks of a wall that was hit, 2.7 µm apart at a corner of one. Lines of edges 7 and 0
  // cross 0.11 m from each other, with a normal across the face on which the corner is.
  const auto rotation = [](double w, double x, double y, double z) {
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    const double p[4] = {w / length, x / length, y / length, z / length};
    return Mat3(rotationMatrix(p));
  };
  const Vec3 half(0.2, 0.1, 0.1);
  const Mover A({0.0432135, 0.60487, 0.1}, rotation(0.704882, 0.704882, 0.056049, 0.056049)),
      B({0.3471783, 0.4881587, 0.2230696}, rotation(0.268157, 0.471642, -0.153112, 0.825956));
  const PlacedBox a{&A.frame, A.frame.r_OS_I, A.frame.A_IK, half},
      b{&B.frame, B.frame.r_OS_I, B.frame.A_IK, half};
  const double apart = separationOf(axesOf(a), axesOf(b));
  ASSERT_NEAR(apart, 2.7e-6, 1e-7);
  std::array<BoxContact, kMostBoxContacts> found;
  const int n = betweenBoxes(a, b, true, found);
  // One of the corner's gap, up to rounding, and no other near the bodies.
  EXPECT_NEAR(leastGap({found.data(), static_cast<std::size_t>(n)}), apart, 1e-15);
}

TEST(FacePairDepth, OfBoxesIsAtMostTheirLeastOverlap) {
  constexpr unsigned kSeed = 8;
  Random random(kSeed);
  int several = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Vec3 hA = Vec3::Constant(0.1) + 0.4 * random.vec().cwiseAbs(),
               hB = Vec3::Constant(0.1) + 0.4 * random.vec().cwiseAbs();
    const Mat3 RA = turned(2.0 * random.vec());
    // Turned anyhow, or little against each other; from 1 µm to 0.1 m deep.
    const Mat3 RB = trial % 2 ? turned(2.0 * random.vec()) : Mat3(turned(0.3 * random.vec()) * RA);
    const Vec3 d = random.vec().normalized();
    const double depth = 0.1 * std::pow(10.0, -2.5 * (1.0 + random.number()));
    const Mover A(Vec3::Zero(), RA);
    const PlacedBox a{&A.frame, Vec3::Zero(), RA, hA};
    const auto at = [&](double x) { return PlacedBox{nullptr, x * d, RB, hB}; };
    const double x = distanceOf(-depth, [&](double s) { return separation(a, at(s)); });
    const Mover B(x * d, RB);
    PlacedBox b = at(x);
    b.frame = &B.frame;
    std::array<BoxContact, kMostBoxContacts> found;
    const int n = betweenBoxes(a, b, false, found);
    several += n > 1;
    ASSERT_GT(n, 0) << "trial " << trial << ", seed " << kSeed;
    const double apart = separationOf(axesOf(a), axesOf(b));
    ASSERT_NEAR(apart, -depth, 1e-11);
    for (int i = 0; i < n; ++i) {
      const BoxContact& c = found[static_cast<std::size_t>(i)];
      EXPECT_GT(c.at.g, apart - kTolerance * std::min(hA.minCoeff(), hB.minCoeff()))
          << "contact " << c.id << ", trial " << trial << ", seed " << kSeed;
    }
  }
  EXPECT_GT(several, 1500);
}

TEST(FacePairDepth, OfPolyhedraIsAtMostTheirLeastOverlap) {
  constexpr unsigned kSeed = 9;
  Random random(kSeed);
  int several = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Polyhedron a(trial % 2 ? random.hull(9) : boxTriangles({0.5, 0.9, 0.7})),
        b(trial % 3 ? boxTriangles({0.6, 0.4, 0.8}) : random.hull(8));
    const Mover A(Vec3::Zero(), turned(2.0 * random.vec()));
    const Mat3 RB = turned(2.0 * random.vec());
    const Vec3 d = random.vec().normalized();
    const double depth = 0.1 * std::pow(10.0, -2.5 * (1.0 + random.number()));
    const double x = distanceOf(-depth, [&](double s) {
      const Mover B(s * d, RB);
      return separation(placed(A.frame, a), placed(B.frame, b));
    });
    const Mover B(x * d, RB);
    PolyhedraContacts found;
    const int n = betweenPolyhedra(placed(A.frame, a), placed(B.frame, b), kInfinity, false, found);
    several += n > 1;
    ASSERT_GT(n, 0) << "trial " << trial << ", seed " << kSeed;
    const double apart = separationOf(axesOf(A.frame, a), axesOf(B.frame, b));
    for (int i = 0; i < n; ++i) {
      const NumberedContact& c = found[static_cast<std::size_t>(i)];
      EXPECT_GT(c.at.g, apart - kTolerance) << "contact " << c.id << ", trial " << trial;
    }
  }
  EXPECT_GT(several, 1000);
}

}  // namespace
}  // namespace dynamy
