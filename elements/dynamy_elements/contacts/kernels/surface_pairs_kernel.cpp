// Shapes on polyhedra, meshes and height fields: all that stands out of the surface
// (surface_contact.hpp). A surface has one side, so that gaps are known up to the size of B only.
#include <algorithm>
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_mesh.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

/// Distance, in radii of a ball, from which on it searches for a surface that it may pass.
constexpr double kSeen = 1000.0;
/// Work of a ball on a mesh, of which the few faces near it are looked at.
constexpr double kBallWork = 15.0;

/// Largest gap of B reported on a surface of A, which has one side: at most B's size [m].
double seenFrom(const PairReport& report) {
  const TouchingShape& b = report.pair().b;
  if (report.request().refresh) return b.bound;
  return std::min(b.bound, 0.5 * b.thickness + std::max(report.request().gTol, 0.0));
}

std::string nearestOf(const Surface& A, std::uint64_t f) {
  const int number = static_cast<int>(f);
  return number < A.features() ? A.featureName(number) : "nearest";
}

std::uint64_t withNearest(const TouchingShape& a) {
  return static_cast<std::uint64_t>(a.surface->features()) + (a.polyhedron ? 1 : 0);
}

/// Balls roll over a convex body without a jump, over a mesh from valley to valley.
class BallOnSurface final : public PairKernel {
 public:
  double work(const TouchingShape& a, const TouchingShape&) const override {
    return a.polyhedron ? kGapWork : kBallWork;
  }
  void contacts(PairReport& report) const override;
  double gap(const PosedPair& p, std::size_t) const override {
    const double reach = seen(p.b);
    SurfaceContacts found;
    const int n = p.a.surface->contacts(p.A, p.B, p.b.features[0], reach, found);
    return std::min(reach, leastGap(found, n));
  }
  std::uint64_t features(const TouchingShape& a, const TouchingShape&) const override {
    return withNearest(a);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape&,
                          std::uint64_t f) const override {
    return nearestOf(*a.surface, f);
  }
  Following following(const TouchingShape& a, const TouchingShape&) const override {
    return a.polyhedron ? Following::gaps : Following::jumping;
  }
  double seen(const TouchingShape& b) const override { return kSeen * b.bound; }
  double seenBelow(const TouchingShape& b) const override { return b.thickness; }
};

void BallOnSurface::contacts(PairReport& report) const {
  const auto& [a, b, A, B, plane] = report.pair();
  const ContactRequest& asked = report.request();
  SurfaceContacts found;
  const double further =
      asked.refresh ? std::numeric_limits<double>::infinity() : std::max(asked.gTol, 0.0);
  const RoundFeature& ball = b.features[0];
  const int n = a.surface->contacts(A, B, ball, 0.5 * ball.radius + further, found);
  if (!a.polyhedron || !asked.refresh || n == 0) return report.addAll(found, n);
  // The point nearest to the ball moves over a convex body without a jump. It is one contact,
  // whose gap can be followed.
  found[0] = *std::min_element(
      found.begin(), found.begin() + n,
      [](const SurfaceContact& one, const SurfaceContact& two) { return one.at.g < two.at.g; });
  found[0].id = a.surface->features();
  report.addAll(found, 1);
}

/// Contacts that jump between the features of the surface. `kFind(pair, reach, bias, found)`.
template <auto kFind>
class OnSurface : public PairKernel {
 public:
  void contacts(PairReport& report) const override {
    OnSurfaceContacts found;
    const bool bias = report.request().bias;
    report.addAll(found, kFind(report.pair(), seenFrom(report), bias, found));
  }
  double gap(const PosedPair& p, std::size_t) const override {
    const double reach = seen(p.b);
    OnSurfaceContacts found;
    return std::min(reach, leastGap(found, kFind(p, reach, false, found)));
  }
  Following following(const TouchingShape&, const TouchingShape&) const override {
    return Following::jumping;
  }
  double seen(const TouchingShape& b) const override { return b.bound; }
  double seenBelow(const TouchingShape& b) const override { return b.thickness; }
};

int capsuleAt(const PosedPair& p, double reach, bool, OnSurfaceContacts& found) {
  return capsuleOnSurface(p.A, *p.a.surface, p.B, p.b, reach, found);
}
int discAt(const PosedPair& p, double reach, bool, OnSurfaceContacts& found) {
  return discOnMesh(p.A, *p.a.surface, discBody(p.B, p.b), reach, found);
}
int smoothAt(const PosedPair& p, double reach, bool, OnSurfaceContacts& found) {
  return smoothOnMesh(p.A, *p.a.surface, p.B, p.b.features[0], reach, found);
}
int polyhedronAt(const PosedPair& p, double reach, bool bias, OnSurfaceContacts& found) {
  return polyhedronOnMesh(p.A, *p.a.surface, placedPolyhedron(p.B, p.b), reach, bias, found);
}

/// On a polyhedron, pairs of features are followed one by one.
class CapsuleOnSurface final : public OnSurface<capsuleAt> {
 public:
  static std::uint64_t own(const TouchingShape& a) {
    return static_cast<std::uint64_t>(capsuleFeatures(*a.surface));
  }
  std::uint64_t features(const TouchingShape& a, const TouchingShape& b) const override {
    return own(a) + followed(a, b);
  }
  Following following(const TouchingShape& a, const TouchingShape& b) const override {
    return a.polyhedron && b.thickness > 0.0 ? Following::pairwise : Following::jumping;
  }
  std::uint64_t followed(const TouchingShape& a, const TouchingShape& b) const override {
    if (following(a, b) != Following::pairwise) return 0;
    return static_cast<std::uint64_t>(CapsuleFeatures::count(a));
  }
  void follow(PairReport& report) const override {
    const auto& [a, b, A, B, plane] = report.pair();
    followFeatures(report, CapsuleFeatures(A, a, B, b));
  }
  FollowedPartners partners(const TouchingShape& a, const TouchingShape& b,
                            std::uint64_t f) const override {
    if (followed(a, b) == 0) return {};
    const auto all = static_cast<std::uint64_t>(a.surface->features());
    return {f < 2 * all ? f / all : f - 2 * all + 2, 1};
  }
  std::string featureName(const TouchingShape& a, const TouchingShape&,
                          std::uint64_t f) const override;
  double seen(const TouchingShape& b) const override { return kSeen * b.bound; }
};

std::string CapsuleOnSurface::featureName(const TouchingShape& a, const TouchingShape&,
                                          std::uint64_t f) const {
  const Surface& A = *a.surface;
  const auto all = static_cast<std::uint64_t>(A.features()),
             edges = static_cast<std::uint64_t>(A.edges());
  if (f < 2 * all)
    return "B.end" + std::to_string(f / all) + "-" + A.featureName(static_cast<int>(f % all));
  if (f >= own(a)) {
    f -= own(a);
    if (f < 2) return "B.end" + std::to_string(f);
    f -= 2;
    return (f < edges ? "edge" + std::to_string(f) : "A.corner" + std::to_string(f - edges)) +
           "-side";
  }
  f -= 2 * all;
  return f < edges ? "edge" + std::to_string(f) : "A.corner" + std::to_string(f - edges);
}

class SmoothOnMesh final : public OnSurface<smoothAt> {
 public:
  std::uint64_t features(const TouchingShape& a, const TouchingShape&) const override {
    return withNearest(a);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape&,
                          std::uint64_t f) const override {
    return nearestOf(*a.surface, f);
  }
};

class DiscOnMesh final : public OnSurface<discAt> {
 public:
  std::uint64_t features(const TouchingShape& a, const TouchingShape&) const override {
    return discOnMeshFeatures(*a.surface);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape&,
                          std::uint64_t f) const override;
};

std::string meshRim(std::uint64_t rim, std::uint64_t k) {
  return "rim" + std::to_string(rim) + "." + std::to_string(k);
}

std::string DiscOnMesh::featureName(const TouchingShape& a, const TouchingShape&,
                                    std::uint64_t f) const {
  const Surface& A = *a.surface;
  const std::size_t faces = A.faces().size(), corners = static_cast<std::size_t>(A.corners()),
                    edges = static_cast<std::size_t>(A.edges());
  const std::string over = "-face" + std::to_string(f % faces);
  if (f < 2 * faces) return "B.rim" + std::to_string(f / faces) + over;
  if (f < 10 * faces) {
    const std::uint64_t point = f / faces - 2;
    return "B.rim" + std::to_string(point / 4) + ".point" + std::to_string(point % 4) + over;
  }
  f -= 10 * faces;
  if (f < corners) return "A.corner" + std::to_string(f);
  f -= corners;
  if (f < edges) return "edge" + std::to_string(f) + "-side";
  f -= edges;
  return "edge" + std::to_string(f / 4) + "-" + meshRim(f / 2 % 2, f % 2);
}

class PolyhedronOnMesh final : public OnSurface<polyhedronAt> {
 public:
  std::uint64_t features(const TouchingShape& a, const TouchingShape& b) const override {
    return meshFeatures(*a.surface, *b.polyhedron);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape& b,
                          std::uint64_t f) const override;
};

std::string PolyhedronOnMesh::featureName(const TouchingShape& shapeA, const TouchingShape& shapeB,
                                          std::uint64_t f) const {
  const Surface& A = *shapeA.surface;
  const Polyhedron& B = *shapeB.polyhedron;
  const std::size_t faces = A.faces().size(), b = B.corners().size() * faces,
                    a = static_cast<std::size_t>(A.corners());
  if (f < b) return "B.corner" + std::to_string(f / faces) + "-face" + std::to_string(f % faces);
  if (f < a + b) return "A.corner" + std::to_string(f - b);
  f -= a + b;
  return "edges" + std::to_string(f / B.edges().size()) + "-" +
         std::to_string(f % B.edges().size());
}

}  // namespace

void addSurfacePairs(PairTable& table) {
  using enum PairTable::Room;
  constexpr Touch M = Touch::surface, P = Touch::polyhedron;
  table.add(std::make_unique<BallOnSurface>(), {space}, {{P, Touch::ball}, {M, Touch::ball}});
  table.add(std::make_unique<CapsuleOnSurface>(), {space},
            {{P, Touch::capsule}, {M, Touch::capsule}});
  table.add(std::make_unique<DiscOnMesh>(), {space},
            {{M, Touch::cylinder}, {M, Touch::torus}, {M, Touch::cone}});
  table.add(std::make_unique<SmoothOnMesh>(), {space}, {{M, Touch::smooth}});
  table.add(std::make_unique<PolyhedronOnMesh>(), {space}, {{M, Touch::box}, {M, P}});
}

}  // namespace dynamy
