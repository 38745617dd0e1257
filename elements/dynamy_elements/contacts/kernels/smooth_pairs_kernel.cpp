// Ellipsoids and smooth shapes in space: one contact, found by a search for its normal.
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

ContactPoint twoSmooth(const PosedPair& p) {
  return betweenSmooth(p.A, p.a.features[0], p.B, p.b.features[0]);
}
ContactPoint smoothAtPolyhedron(const PosedPair& p) {
  return smoothOnPolyhedron(placedPolyhedron(p.A, p.a), p.B, p.b.features[0]);
}
ContactPoint discAtSmooth(const PosedPair& p) {
  return discOnSmooth(p.A, p.a.features[0], discBody(p.B, p.b));
}

/// A cylinder, cone, torus or capsule B on a smooth A.
class SmoothOnDisc final : public OneContact<discAtSmooth, Following::searched> {
 public:
  double gap(const PosedPair& p, std::size_t) const override {
    return smoothOnDisc(discBody(p.B, p.b), p.A, p.a.features[0]).g;
  }
};

}  // namespace

void addSmoothPairs(PairTable& table) {
  using enum PairTable::Room;
  constexpr Touch S = Touch::smooth;
  table.add(std::make_unique<OneContact<twoSmooth, Following::searched>>(), {space},
            {{S, Touch::ball}, {S, S}});
  table.add(std::make_unique<OneContact<smoothAtPolyhedron, Following::searched>>(), {space},
            {{Touch::box, S}, {Touch::polyhedron, S}});
  table.add(std::make_unique<SmoothOnDisc>(), {space},
            {{S, Touch::capsule}, {S, Touch::cylinder}, {S, Touch::torus}, {S, Touch::cone}});
}

}  // namespace dynamy
