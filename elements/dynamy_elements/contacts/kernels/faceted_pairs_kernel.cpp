// Boxes and polyhedra: vertices on faces, edges on edges (facets.hpp).
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

std::string edgePair(std::uint64_t i, std::size_t edgesOfB) {
  return "edges" + std::to_string(i / edgesOfB) + "-" + std::to_string(i % edgesOfB);
}

std::string boxFeature(std::uint64_t f) {
  if (f < 8) return "B.corner" + std::to_string(f);
  if (f < 16) return "A.corner" + std::to_string(f - 8);
  return "edges" + std::to_string((f - 16) / 12) + "-" + std::to_string((f - 16) % 12);
}

std::string ofPolyhedra(const Polyhedron& A, const Polyhedron& B, std::uint64_t f) {
  const std::size_t b = B.corners().size(), a = A.corners().size();
  if (f < b) return "B.corner" + std::to_string(f);
  if (f < a + b) return "A.corner" + std::to_string(f - b);
  return edgePair(f - a - b, B.edges().size());
}

/// Name of a pair of features that is followed on its own.
std::string followedPair(const Polyhedron& A, const Polyhedron& B, std::uint64_t f) {
  const auto over = [](const char* corner, std::uint64_t i, const char* face, std::uint64_t j) {
    return corner + std::to_string(i) + face + std::to_string(j);
  };
  const std::size_t facesA = A.faces().size(), facesB = B.faces().size(),
                    ofB = B.corners().size() * facesA, ofA = A.corners().size() * facesB;
  if (f < ofB) return over("B.corner", f / facesA, "-A.face", f % facesA);
  f -= ofB;
  if (f < ofA) return over("A.corner", f / facesB, "-B.face", f % facesB);
  return edgePair(f - ofA, B.edges().size());
}

/// Work of each corner of two polyhedra (bench_gaps).
constexpr double kCornerWork = 0.3;

/// Two bodies with flat faces. `own`: features besides the pairs that are followed.
class FacetedPair : public PairKernel {
 public:
  virtual std::uint64_t own(const TouchingShape& a, const TouchingShape& b) const = 0;
  virtual std::string ownName(const TouchingShape& a, const TouchingShape& b,
                              std::uint64_t f) const = 0;

  std::uint64_t features(const TouchingShape& a, const TouchingShape& b) const override {
    return own(a, b) + followed(a, b);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape& b,
                          std::uint64_t f) const override {
    const std::uint64_t first = own(a, b);
    return f < first ? ownName(a, b, f) : followedPair(*a.polyhedron, *b.polyhedron, f - first);
  }
  Following following(const TouchingShape&, const TouchingShape&) const override {
    return Following::pairwise;
  }
  std::uint64_t followed(const TouchingShape& a, const TouchingShape& b) const override {
    return static_cast<std::uint64_t>(featurePairs(*a.polyhedron, *b.polyhedron));
  }
  void follow(PairReport& report) const override {
    const PosedPair& p = report.pair();
    followFeatures(report, placedPolyhedron(p.A, p.a), placedPolyhedron(p.B, p.b));
  }
};

/// One of them may be a box.
class Polyhedra final : public FacetedPair {
 public:
  double work(const TouchingShape& a, const TouchingShape& b) const override {
    return kCornerWork *
           static_cast<double>(a.polyhedron->corners().size() + b.polyhedron->corners().size());
  }
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    PolyhedraContacts found;
    const PlacedPolyhedron a = placedPolyhedron(p.A, p.a);
    const ContactRequest& asked = report.request();
    const int n =
        betweenPolyhedra(a, placedPolyhedron(p.B, p.b), report.reach(), asked.bias, found);
    closeTogether(a, asked.gTol, asked.bias, {found.data(), static_cast<std::size_t>(n)});
    report.addAll(found, n);
  }
  double gap(const PosedPair& p, std::size_t) const override {
    return separation(placedPolyhedron(p.A, p.a), placedPolyhedron(p.B, p.b));
  }
  std::uint64_t own(const TouchingShape& a, const TouchingShape& b) const override {
    return static_cast<std::uint64_t>(polyhedraFeatures(*a.polyhedron, *b.polyhedron));
  }
  std::string ownName(const TouchingShape& a, const TouchingShape& b,
                      std::uint64_t f) const override {
    return ofPolyhedra(*a.polyhedron, *b.polyhedron, f);
  }
};

class Boxes final : public FacetedPair {
 public:
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    std::array<BoxContact, kMostBoxContacts> found;
    const PlacedBox a = placedBox(p.A, p.a);
    const ContactRequest& asked = report.request();
    const int n = betweenBoxes(a, placedBox(p.B, p.b), asked.bias, found, report.reach());
    closeTogether(a, asked.gTol, asked.bias, {found.data(), static_cast<std::size_t>(n)});
    report.addAll(found, n);
  }
  double gap(const PosedPair& p, std::size_t) const override {
    return separation(placedBox(p.A, p.a), placedBox(p.B, p.b));
  }
  std::uint64_t own(const TouchingShape&, const TouchingShape&) const override {
    return kBoxFeatures;
  }
  std::string ownName(const TouchingShape&, const TouchingShape&, std::uint64_t f) const override {
    return boxFeature(f);
  }
};

}  // namespace

void addFacetedPairs(PairTable& table) {
  using enum PairTable::Room;
  constexpr Touch P = Touch::polyhedron;
  table.add(std::make_unique<Polyhedra>(), {space}, {{P, Touch::box}, {P, P}});
  table.add(std::make_unique<Boxes>(), {space}, {{Touch::box, Touch::box}});
}

}  // namespace dynamy
