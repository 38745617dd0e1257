// Cylinders, cones and tori with each other, with capsules, and on boxes and polyhedra.
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/between_discs.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

/// Work of two rims, of a rim on a capsule, and on each corner of a polyhedron (bench_gaps).
constexpr double kRimWork = 50.0, kRimOnCapsule = 20.0, kRimOnCorner = 2.7;

class Discs final : public PairKernel {
 public:
  double work(const TouchingShape&, const TouchingShape& b) const override {
    return b.kind == Touch::capsule ? kRimOnCapsule : kRimWork;
  }
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    const ContactRequest& asked = report.request();
    DiscContacts found;
    report.addAll(found, betweenDiscs(discBody(p.A, p.a), discBody(p.B, p.b), report.reach(),
                                      asked.gTol, asked.bias, found));
  }
  double gap(const PosedPair& p, std::size_t) const override {
    return separation(discBody(p.A, p.a), discBody(p.B, p.b));
  }
  std::uint64_t features(const TouchingShape& a, const TouchingShape& b) const override {
    return kDiscPair + followed(a, b);
  }
  std::string featureName(const TouchingShape&, const TouchingShape&,
                          std::uint64_t f) const override;
  /// Where a line without a radius touches, the normal jumps.
  Following following(const TouchingShape& a, const TouchingShape& b) const override {
    return a.thickness > 0.0 && b.thickness > 0.0 ? Following::pairwise : Following::jumping;
  }
  std::uint64_t followed(const TouchingShape& a, const TouchingShape& b) const override {
    return following(a, b) == Following::pairwise ? TwoDiscs::kCount : 0;
  }
  void follow(PairReport& report) const override {
    const PosedPair& p = report.pair();
    const DiscBody a = discBody(p.A, p.a), b = discBody(p.B, p.b);
    followFeatures(report, TwoDiscs(a, b, report.request().flat));
  }
  FollowedPartners partners(const TouchingShape& a, const TouchingShape& b,
                            std::uint64_t f) const override;
};

class DiscOnPolyhedron final : public PairKernel {
 public:
  double work(const TouchingShape& a, const TouchingShape&) const override {
    return kRimOnCorner * static_cast<double>(a.polyhedron->corners().size());
  }
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    const ContactRequest& asked = report.request();
    DiscContacts found;
    report.addAll(found, discOnPolyhedron(placedPolyhedron(p.A, p.a), discBody(p.B, p.b),
                                          report.reach(), asked.gTol, asked.bias, found));
  }
  double gap(const PosedPair& p, std::size_t) const override {
    return separation(placedPolyhedron(p.A, p.a), discBody(p.B, p.b));
  }
  static std::uint64_t own(const TouchingShape& a) {
    return static_cast<std::uint64_t>(discFeatures(*a.polyhedron));
  }
  std::uint64_t features(const TouchingShape& a, const TouchingShape& b) const override {
    return own(a) + followed(a, b);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape&,
                          std::uint64_t f) const override;
  Following following(const TouchingShape&, const TouchingShape&) const override {
    return Following::pairwise;
  }
  std::uint64_t followed(const TouchingShape& a, const TouchingShape&) const override {
    return static_cast<std::uint64_t>(DiscFeatures::count(*a.polyhedron));
  }
  void follow(PairReport& report) const override {
    const PosedPair& p = report.pair();
    const PlacedPolyhedron a = placedPolyhedron(p.A, p.a);
    const DiscBody b = discBody(p.B, p.b);
    followFeatures(report, DiscFeatures(a, b, report.request().flat));
  }
  FollowedPartners partners(const TouchingShape& a, const TouchingShape& b,
                            std::uint64_t f) const override;
};

std::string ofRim(std::uint64_t rim, std::uint64_t k) {
  return "rim" + std::to_string(rim) + "." + std::to_string(k);
}

std::string DiscOnPolyhedron::featureName(const TouchingShape& a, const TouchingShape&,
                                          std::uint64_t f) const {
  const Polyhedron& A = *a.polyhedron;
  const std::size_t corners = A.corners().size(), edges = A.edges().size();
  if (f >= own(a)) return DiscFeatures::name(A, static_cast<int>(f - own(a)));
  if (f < 2) return "B.rim" + std::to_string(f);
  if (f < 10) return "B.rim" + std::to_string((f - 2) / 4) + ".point" + std::to_string((f - 2) % 4);
  f -= 10;
  if (f < corners) return "A.corner" + std::to_string(f);
  f -= corners;
  if (f < edges) return "edge" + std::to_string(f) + "-side";
  f -= edges;
  return "edge" + std::to_string(f / 4) + "-" + ofRim(f / 2 % 2, f % 2);
}

FollowedPartners DiscOnPolyhedron::partners(const TouchingShape& a, const TouchingShape&,
                                            std::uint64_t f) const {
  const Polyhedron& A = *a.polyhedron;
  const std::uint64_t faces = A.faces().size(), corners = A.corners().size(),
                      edges = A.edges().size(), ofCorners = 10 * faces,
                      ofEdges = ofCorners + 5 * corners;
  if (f < 10) return {f * faces, faces};
  f -= 10;
  if (f < corners) return {ofCorners + 5 * f, 5};
  f -= corners;
  return f < edges ? FollowedPartners{ofEdges + 6 * f, 2}
                   : FollowedPartners{ofEdges + 6 * ((f - edges) / 4) + 2 + (f - edges) % 4, 1};
}

FollowedPartners Discs::partners(const TouchingShape& a, const TouchingShape& b,
                                 std::uint64_t f) const {
  constexpr std::uint64_t kOn = TwoDiscs::kOnBody, kBeside = 20;  // rims on a side
  if (followed(a, b) == 0 || f >= kDiscPair) return {};
  if (f >= kRimPairs)
    return {TwoDiscs::kRims + (f - kRimPairs) / 2 * TwoDiscs::kOfRims,
            f % 2 == kRimPairs % 2 ? std::uint64_t{TwoDiscs::kOfRims} : 0};
  if (f >= kBOnSide) return {kBeside + f - kBOnSide, 1};
  if (f >= kAOnSide) return {kOn + kBeside + f - kAOnSide, 1};
  if (f == kSides) return {TwoDiscs::kSides, 2};
  const std::uint64_t of = f < 10 ? 0 : kOn;
  return {of + 2 * (f % 10), 2};
}

std::string Discs::featureName(const TouchingShape&, const TouchingShape&, std::uint64_t f) const {
  if (f >= kDiscPair) return TwoDiscs::name(static_cast<int>(f - kDiscPair));
  if (f >= kRimPairs) {
    f -= kRimPairs;
    return "A.rim" + std::to_string(f / 4) + "-B." + ofRim(f / 2 % 2, f % 2);
  }
  if (f >= kBOnSide) return "side-B." + ofRim((f - kBOnSide) / 2, f % 2 == kBOnSide % 2 ? 0 : 1);
  if (f >= kAOnSide) return "side-A." + ofRim((f - kAOnSide) / 2, f % 2 == kAOnSide % 2 ? 0 : 1);
  if (f == kSides) return "sides";
  const std::string of = f < 10 ? "B.rim" : "A.rim";
  f %= 10;
  if (f < 2) return of + std::to_string(f);
  return of + std::to_string((f - 2) / 4) + ".point" + std::to_string((f - 2) % 4);
}

}  // namespace

void addDiscPairs(PairTable& table) {
  using enum PairTable::Room;
  table.add(std::make_unique<Discs>(), {space},
            {{Touch::cylinder, Touch::capsule},
             {Touch::torus, Touch::capsule},
             {Touch::cone, Touch::capsule},
             {Touch::cylinder, Touch::cylinder},
             {Touch::cylinder, Touch::torus},
             {Touch::cylinder, Touch::cone},
             {Touch::torus, Touch::torus},
             {Touch::torus, Touch::cone},
             {Touch::cone, Touch::cone}});
  table.add(std::make_unique<DiscOnPolyhedron>(), {space},
            {{Touch::box, Touch::cylinder},
             {Touch::box, Touch::torus},
             {Touch::box, Touch::cone},
             {Touch::polyhedron, Touch::cylinder},
             {Touch::polyhedron, Touch::torus},
             {Touch::polyhedron, Touch::cone}});
}

}  // namespace dynamy
