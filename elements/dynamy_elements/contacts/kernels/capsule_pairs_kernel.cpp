// Capsules with each other and on boxes: ends, sides and edges (capsule_features.hpp).
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

int twoCapsules(const PosedPair& p, RoundContacts& found) {
  return betweenCapsules(p.A, p.a, p.B, p.b, p.plane, found);
}
int capsuleAtBox(const PosedPair& p, RoundContacts& found) {
  return capsuleOnBox(p.A, p.a, p.B, p.b, found);
}

/// Contacts of a capsule, `kFeatures` at most.
template <auto kFind, std::uint64_t kFeatures>
class CapsulePair : public PairKernel {
 public:
  void contacts(PairReport& report) const override {
    RoundContacts found;
    report.addAll(found, kFind(report.pair(), found));
  }
  double gap(const PosedPair& pair, std::size_t) const override {
    RoundContacts found;
    return leastGap(found, kFind(pair, found));
  }
  std::uint64_t features(const TouchingShape&, const TouchingShape&) const override {
    return kFeatures;
  }
  /// Where a line without a radius touches, the normal jumps.
  Following following(const TouchingShape&, const TouchingShape& b) const override {
    return b.thickness > 0.0 ? Following::pairwise : Following::jumping;
  }
};

class Capsules final : public CapsulePair<twoCapsules, kCapsules> {
 public:
  std::string featureName(const TouchingShape&, const TouchingShape&,
                          std::uint64_t f) const override {
    return f == 0 ? "crossing" : (f < 3 ? "B.end" : "A.end") + std::to_string((f - 1) % 2);
  }
  std::uint64_t followed(const TouchingShape&, const TouchingShape&) const override {
    return kCapsules;
  }
  void follow(PairReport& report) const override {
    const auto& [a, b, A, B, plane] = report.pair();
    followFeatures(report, TwoCapsules(A, a, B, b, plane));
  }
};

class CapsuleOnBox final : public CapsulePair<capsuleAtBox, kCapsuleOnBox> {
 public:
  std::string featureName(const TouchingShape&, const TouchingShape&,
                          std::uint64_t f) const override {
    if (f < 2) return "B.end" + std::to_string(f);
    return f < 14 ? "edge" + std::to_string(f - 2) : "A.corner" + std::to_string(f - 14);
  }
  std::uint64_t followed(const TouchingShape&, const TouchingShape&) const override {
    return kCapsuleOnBox;
  }
  void follow(PairReport& report) const override {
    const auto& [a, b, A, B, plane] = report.pair();
    followFeatures(report, CapsuleFeatures(A, a, B, b));
  }
};

}  // namespace

void addCapsulePairs(PairTable& table) {
  using enum PairTable::Room;
  table.add(std::make_unique<Capsules>(), {space, plane}, {{Touch::capsule, Touch::capsule}});
  table.add(std::make_unique<CapsuleOnBox>(), {space}, {{Touch::box, Touch::capsule}});
}

}  // namespace dynamy
