// Balls and points:
//
//   on a ball            g = |c_B − c_A| − R_A − R_B   n = (c_B − c_A)/|…|
//   on a box             g = |c − p| − R               p of the box, nearest to c
//   on round shapes      the same with the nearest point of an axis, a side or a cap
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

ContactPoint twoBalls(const PosedPair& p) {
  return betweenBalls(p.A, p.a.features[0], p.B, p.b.features[0], p.plane);
}
ContactPoint ballAtBox(const PosedPair& p) {
  return ballOnBox(p.A, p.a, p.B, p.b.features[0], p.plane);
}
ContactPoint ballAtCapsule(const PosedPair& p) {
  return ballOnCapsule(p.A, p.a, p.B, p.b.features[0], p.plane);
}
ContactPoint ballAtCylinder(const PosedPair& p) {
  return ballOnCylinder(p.A, p.a, p.B, p.b.features[0]);
}
ContactPoint ballAtTorus(const PosedPair& p) { return ballOnTorus(p.A, p.a, p.B, p.b.features[0]); }
ContactPoint ballAtCone(const PosedPair& p) {
  return ballOnCone(discBody(p.A, p.a), p.B, p.b.features[0]);
}

/// A box touches as its section in a plane if one of its edges is along the normal.
template <std::size_t kCorners>
class BallOnBox final : public OneContact<ballAtBox> {
 public:
  bool fits(const TouchingShape& a, const TouchingShape&) const override {
    return a.features.size() == kCorners;
  }
  void contacts(PairReport& report) const override {
    const PosedPair& pair = report.pair();
    const ContactPoint at = ballAtBox(pair);
    // The contact is reported at the same distance as that of two balls.
    const double reach = 0.5 * (pair.b.bound + pair.a.half.minCoeff());
    if (report.request().refresh || at.g <= reach) report.add(0, at);
  }
};

}  // namespace

void addBallPairs(PairTable& table) {
  using enum PairTable::Room;
  table.add(std::make_unique<OneContact<twoBalls>>(), {space, plane}, {{Touch::ball, Touch::ball}});
  table.add(std::make_unique<OneContact<ballAtCapsule>>(), {space, plane},
            {{Touch::capsule, Touch::ball}});
  table.add(std::make_unique<OneContact<ballAtCylinder>>(), {space},
            {{Touch::cylinder, Touch::ball}});
  table.add(std::make_unique<OneContact<ballAtTorus>>(), {space}, {{Touch::torus, Touch::ball}});
  table.add(std::make_unique<OneContact<ballAtCone>>(), {space}, {{Touch::cone, Touch::ball}});
  table.add(std::make_unique<BallOnBox<8>>(), {space}, {{Touch::box, Touch::ball}});
  table.add(std::make_unique<BallOnBox<4>>(), {plane}, {{Touch::box, Touch::ball}});
}

}  // namespace dynamy
