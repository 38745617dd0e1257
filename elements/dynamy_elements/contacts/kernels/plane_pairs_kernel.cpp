// Sections of shapes in a plane of motion: polygons, ellipses and contours.
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

PlacedPolygon polygonOfA(const PosedPair& p) { return {&p.A, &p.a.polygon_K, p.plane}; }
PlacedPolygon polygonOfB(const PosedPair& p) { return {&p.B, &p.b.polygon_K, p.plane}; }

class Polygons final : public PairKernel {
 public:
  bool fits(const TouchingShape& a, const TouchingShape& b) const override {
    return !a.polygon_K.empty() && !b.polygon_K.empty();
  }
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    PolygonContacts found;
    const ContactRequest& asked = report.request();
    const double infinity = std::numeric_limits<double>::infinity();
    const PlacedPolygon a = polygonOfA(p);
    const int n = betweenPolygons(a, polygonOfB(p), infinity, asked.bias, found);
    closeTogether(a, asked.gTol, asked.bias, {found.data(), static_cast<std::size_t>(n)});
    report.addAll(found, n);
  }
  double gap(const PosedPair& p, std::size_t) const override {
    return separation(polygonOfA(p), polygonOfB(p));
  }
  std::uint64_t features(const TouchingShape& a, const TouchingShape& b) const override {
    return a.polygon_K.size() + b.polygon_K.size() + followed(a, b);
  }
  std::string featureName(const TouchingShape& a, const TouchingShape& b,
                          std::uint64_t f) const override {
    const std::uint64_t ofA = a.polygon_K.size(), ofB = b.polygon_K.size();
    if (f < ofB) return "B.corner" + std::to_string(f);
    if (f -= ofB; f < ofA) return "A.corner" + std::to_string(f);
    if (f -= ofA; f < ofA * ofB)
      return "B.corner" + std::to_string(f / ofA) + "-A.face" + std::to_string(f % ofA);
    f -= ofA * ofB;
    return "A.corner" + std::to_string(f / ofB) + "-B.face" + std::to_string(f % ofB);
  }
  Following following(const TouchingShape&, const TouchingShape&) const override {
    return Following::pairwise;
  }
  std::uint64_t followed(const TouchingShape& a, const TouchingShape& b) const override {
    return static_cast<std::uint64_t>(featurePairs(a.polygon_K, b.polygon_K));
  }
  void follow(PairReport& report) const override {
    followFeatures(report, polygonOfA(report.pair()), polygonOfB(report.pair()));
  }
  FollowedPartners partners(const TouchingShape& shapeA, const TouchingShape& shapeB,
                            std::uint64_t f) const override {
    const std::uint64_t a = shapeA.polygon_K.size(), b = shapeB.polygon_K.size();
    return f < b ? FollowedPartners{f * a, a} : FollowedPartners{a * b + (f - b) * b, b};
  }
};

class CapsuleOnPolygonPair final : public PairKernel {
 public:
  bool fits(const TouchingShape& a, const TouchingShape&) const override {
    return !a.polygon_K.empty();
  }
  void contacts(PairReport& report) const override {
    const PosedPair& p = report.pair();
    CapsuleOnPolygon found;
    report.addAll(found, capsuleOnPolygon(polygonOfA(p), p.B, p.b, found));
  }
  double gap(const PosedPair& p, std::size_t) const override {
    CapsuleOnPolygon found;
    return leastGap(found, capsuleOnPolygon(polygonOfA(p), p.B, p.b, found));
  }
  std::uint64_t features(const TouchingShape& a, const TouchingShape&) const override {
    return 2 + a.polygon_K.size();
  }
  std::string featureName(const TouchingShape&, const TouchingShape&,
                          std::uint64_t f) const override {
    return f < 2 ? "B.end" + std::to_string(f) : "A.corner" + std::to_string(f - 2);
  }
  Following following(const TouchingShape&, const TouchingShape&) const override {
    return Following::jumping;
  }
};

/// One contact on a polygon.
template <auto kAt>
class OnPolygon final : public OneContact<kAt> {
 public:
  bool fits(const TouchingShape& a, const TouchingShape&) const override {
    return !a.polygon_K.empty();
  }
};

ContactPoint ellipses(const PosedPair& p) {
  return smoothInPlane(p.A, p.a.features[0], p.B, p.b.features[0], p.plane);
}
ContactPoint ellipseAtPolygon(const PosedPair& p) {
  return smoothOnPolygon(polygonOfA(p), p.B, p.b.features[0]);
}
ContactPoint capsuleAtEllipse(const PosedPair& p) {
  return capsuleOnSmooth(p.A, p.a.features[0], p.B, p.b, p.plane);
}
ContactPoint ballAtPolygon(const PosedPair& p) {
  return ballOnPolygon(polygonOfA(p), p.B, p.b.features[0]);
}
ContactPoint ballAtContour(const PosedPair& p) {
  return ballOnContour(p.A, p.a.features[0], p.B, p.b.features[0], p.plane);
}

}  // namespace

void addPlanePairs(PairTable& table) {
  using enum PairTable::Room;
  using Kind = Touch;
  table.add(std::make_unique<Polygons>(), {plane},
            {{Kind::section, Kind::section},
             {Kind::polygon, Kind::section},
             {Kind::box, Kind::section},
             {Kind::polygon, Kind::polygon},
             {Kind::box, Kind::polygon},
             {Kind::box, Kind::box}});
  table.add(
      std::make_unique<CapsuleOnPolygonPair>(), {plane},
      {{Kind::section, Kind::capsule}, {Kind::polygon, Kind::capsule}, {Kind::box, Kind::capsule}});
  table.add(
      std::make_unique<OnPolygon<ellipseAtPolygon>>(), {plane},
      {{Kind::section, Kind::smooth}, {Kind::polygon, Kind::smooth}, {Kind::box, Kind::smooth}});
  table.add(std::make_unique<OnPolygon<ballAtPolygon>>(), {plane},
            {{Kind::section, Kind::ball}, {Kind::polygon, Kind::ball}});
  table.add(std::make_unique<OneContact<ellipses>>(), {plane},
            {{Kind::smooth, Kind::ball}, {Kind::smooth, Kind::smooth}});
  table.add(std::make_unique<OneContact<capsuleAtEllipse>>(), {plane},
            {{Kind::smooth, Kind::capsule}});
  table.add(std::make_unique<OneContact<ballAtContour>>(), {plane}, {{Kind::contour, Kind::ball}});
}

}  // namespace dynamy
