// What lies inside of a bore: bearings with play, pistons, balls in tubes.
//
//   in a plane   circles, and the corners of bodies with corners:   g = R − |c⊥| − r
//   in space     balls, and cylinders at both ends of the common length
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/bore_contact.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

/// Balls: the one of a ball, both ends of a capsule, all corners of a polygon or a box.
class BallsInBore final : public PairKernel {
 public:
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    for (std::size_t f = 0; f < p.b.features.size(); ++f)
      if (ContactPoint at; ballInBore(p.A, p.a, p.B, p.b.features[f], p.plane, at))
        report.add(f, at);
  }
  double gap(const PosedPair& p, std::size_t f) const override {
    ContactPoint at;
    const bool inside = ballInBore(p.A, p.a, p.B, p.b.features[f], p.plane, at);
    return inside ? at.g : std::numeric_limits<double>::infinity();
  }
  std::size_t swept(const TouchingShape& b) const override { return b.features.size(); }
  std::uint64_t features(const TouchingShape&, const TouchingShape& b) const override {
    return b.features.size();
  }
  std::string featureName(const TouchingShape&, const TouchingShape& b,
                          std::uint64_t f) const override {
    return b.features.size() > 1 ? b.features[f].name : std::string();
  }
};

class CylinderInBore final : public PairKernel {
 public:
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    BoreContacts found;
    report.addAll(found, cylinderInBore(p.A, p.a, p.B, p.b, found));
  }
  double gap(const PosedPair& p, std::size_t) const override {
    BoreContacts found;
    return leastGap(found, cylinderInBore(p.A, p.a, p.B, p.b, found));
  }
  std::uint64_t features(const TouchingShape&, const TouchingShape&) const override {
    return kMostBoreContacts;
  }
  std::string featureName(const TouchingShape&, const TouchingShape&,
                          std::uint64_t f) const override {
    return std::string(f % 2 == 0 ? "end0" : "end1") + (f < 2 ? "" : ".other");
  }
};

}  // namespace

void addBorePairs(PairTable& table) {
  using enum PairTable::Room;
  constexpr Touch B = Touch::bore;
  table.add(std::make_unique<BallsInBore>(), {plane},
            {{B, Touch::ball},
             {B, Touch::capsule},
             {B, Touch::section},
             {B, Touch::polygon},
             {B, Touch::box}});
  table.add(std::make_unique<BallsInBore>(), {space}, {{B, Touch::ball}});
  table.add(std::make_unique<CylinderInBore>(), {space}, {{B, Touch::cylinder}});
}

}  // namespace dynamy
