// The largest separation of two bodies against its definition: over all normals of faces and
// products of edges, each with all corners: nothing is passed over.
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>

#include <numbers>

#include "unit/elements/contacts/faceted_bodies.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// Corners of a body in the world.
struct Corners {
  std::vector<Vec3> at;
  explicit Corners(const PlacedPolyhedron& body) {
    for (int i = 0; i < static_cast<int>(body.of->corners().size()); ++i)
      at.push_back(body.vertex(i));
  }
  double along(const Vec3& n) const {
    double most = -kInfinity;
    for (const Vec3& p : at) most = std::max(most, n.dot(p));
    return most;
  }
  /// Of those further along n than `height`, their number.
  int beyond(const Vec3& n, double height) const {
    return static_cast<int>(
        std::count_if(at.begin(), at.end(), [&](const Vec3& p) { return n.dot(p) > height; }));
  }
};

/// Edges count as outermost along n if no corner is further by this [m]; strictly, if all others
/// are nearer by it.
constexpr double kOutermost = 1e-9;

/// The largest separation over normals of faces and of those pairs of edges that are outermost
/// along their normal; at least over strictly outermost ones, at most over the others, too.
struct ByDefinition {
  double least = -kInfinity, most = -kInfinity;
  ByDefinition(const PlacedPolyhedron& A, const PlacedPolyhedron& B) {
    const Corners a(A), b(B);
    for (const Polyhedron::Face& f : A.of->faces())
      face(-a.along(A.R * f.n) - b.along(-(A.R * f.n)));
    for (const Polyhedron::Face& f : B.of->faces())
      face(-b.along(B.R * f.n) - a.along(-(B.R * f.n)));
    for (int i = 0; i < static_cast<int>(A.of->edges().size()); ++i)
      for (int j = 0; j < static_cast<int>(B.of->edges().size()); ++j)
        edges(a, A.edge(i), b, B.edge(j));
  }

 private:
  void face(double f) { least = std::max(least, f), most = std::max(most, f); }
  void edges(const Corners& a, const PlacedEdge& ofA, const Corners& b, const PlacedEdge& ofB) {
    const Vec3 cross = ofA.e.cross(ofB.e);
    if (cross.norm() < kCross) return;
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 n = sign * cross.normalized();
      const double atA = n.dot(ofA.o), atB = n.dot(ofB.o), f = atB - atA;
      if (a.beyond(n, atA + kOutermost) > 0 || b.beyond(-n, kOutermost - atB) > 0) continue;
      most = std::max(most, f);
      if (a.beyond(n, atA - kOutermost) == 2 && b.beyond(-n, -atB - kOutermost) == 2)
        least = std::max(least, f);
    }
  }
};

/// Two bodies at places where they are apart, touch or overlap; their axes may be parallel, or
/// almost parallel.
class Places {
 public:
  explicit Places(unsigned seed) : random_(seed) {}
  template <class Separation>
  std::pair<Frame, Frame> next(Separation&& separation) {
    const Mover A(0.2 * random_.vec(), turned(2.0 * random_.vec()));
    const double tilts[] = {3.0, 3.0, 0.0, 1e-9, 1e-6, 1e-3};
    const Mat3 turn = turned(tilts[number_ % 6] * random_.vec());
    Frame B = A.frame;
    B.A_IK = A.frame.A_IK * turn * quarterTurns();
    const double gaps[] = {-1e-9, 0.0, 1e-9, -1e-6, 1e-4, 0.02, -0.1, -0.4, 0.3};
    const Vec3 way =
        number_ % 4 == 0 ? Vec3(A.frame.A_IK.col(number_ % 3)) : random_.vec().normalized();
    double in = 0.0, out = 5.0;
    for (int i = 0; i < 55; ++i) {
      const double middle = 0.5 * (in + out);
      B.r_OS_I = A.frame.r_OS_I + middle * way;
      (separation(A.frame, B) < gaps[number_ % 9] ? in : out) = middle;
    }
    ++number_;
    return {A.frame, B};
  }
  Random& random() { return random_; }

 private:
  Mat3 quarterTurns() {
    const Vec3 quarters = (2.0 * random_.vec()).array().round();
    return turned(0.5 * std::numbers::pi * quarters);
  }
  Random random_;
  int number_ = 0;
};

// Roundings of lengths of 3, over the sine 0.05 of the flattest pair of edges.
constexpr double kRounding = 3e-14;

void expectThatOverAllAxes(int trials, unsigned seed) {
  Places places(seed);
  for (int trial = 0; trial < trials; ++trial) {
    const bool boxes = trial % 3 == 0;
    const Polyhedron a(boxes ? boxTriangles({0.5, 0.7, 0.4})
                             : places.random().hull(4 + trial % 14)),
        b(boxes ? boxTriangles({0.6, 0.5, 0.5}) : places.random().hull(12));
    const auto [A, B] = places.next(
        [&](const Frame& f, const Frame& g) { return separation(placed(f, a), placed(g, b)); });
    const ByDefinition truth(placed(A, a), placed(B, b));
    const double found = separation(placed(A, a), placed(B, b));
    ASSERT_GE(found, truth.least - kRounding) << "trial " << trial << ", seed " << seed;
    ASSERT_LE(found, truth.most + kRounding) << "trial " << trial << ", seed " << seed;
  }
}

TEST(LargestSeparation, OfPolyhedraIsThatOverAllAxes) { expectThatOverAllAxes(1000, 11); }

TEST(LongLargestSeparation, OfAMillionPairsOfPolyhedraIsThatOverAllAxes) {
  expectThatOverAllAxes(1000000, 12);
}

}  // namespace
}  // namespace dynamy
