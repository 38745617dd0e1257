// Features of a shape over a half space:   g = n·(c − p) − h(−n),   n fixed in the half space
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

/// The lowest corner of a box among those that may be closed; null: B is no box. If contacts are
/// requested by key, a corner that is not requested must not move them when it passes below.
const SupportFeature* lowestCorner(const OverHalfSpace& over, const PairReport& report) {
  const TouchingShape& B = report.pair().b;
  if (B.kind != Touch::box) return nullptr;
  const SupportFeature* lowest = nullptr;
  for (std::size_t f = 0; f < B.features.size(); ++f)
    if (!report.sink().leftOut(report.id() + f) &&
        (!lowest || over.gap(B.features[f]) < over.gap(*lowest)))
      lowest = &B.features[f];
  return lowest;
}

/// A circle is followed as four of its points while it lies flat, else as its lowest point.
void presence(const PairReport& report, const OverHalfSpace& over, const SupportFeature& f) {
  const double flat = report.request().flat, lift = over.lift(f);
  if (f.flatOnly)
    report.sink().presence(flat - lift);
  else if (lift < DiscBody::kFlat * f.rho)
    report.sink().circle(lift);
}

class OnHalfSpace final : public PairKernel {
 public:
  /// A contour that goes in may touch a plane at more than one point.
  bool fits(const TouchingShape&, const TouchingShape& b) const override {
    return !b.features.empty() && (b.kind != Touch::contour || b.features[0].contour->convex());
  }

  void contacts(PairReport& report) const override {
    const auto& [a, b, A, B, plane] = report.pair();
    const OverHalfSpace over(A, a, B);
    const SupportFeature* lowest = lowestCorner(over, report);
    const bool follows = report.request().follow;
    if (follows) noteFlat(report, over);
    for (std::size_t f = 0; f < b.features.size(); ++f) {
      const SupportFeature& feature = b.features[f];
      const bool touches = over.touches(feature), isRim = feature.kind == SupportFeature::Kind::rim,
                 asked = follows && !report.sink().leftOut(report.id() + f);
      if (follows ? feature.flatOnly && !asked : !touches) continue;
      report.add(f, over.gap(feature), [&] {
        const bool lies = isRim && !touches;  // all of its points are equally low
        ContactPoint at =
            over.contact(lies ? report.pair().b.features[f + 1] : feature, report.pair().plane);
        if (lowest && &feature != lowest)
          intoPlane(at.d[0], at.ddot[0], over.contact(*lowest, report.pair().plane), at);
        return at;
      });
      if (asked && (isRim || feature.flatOnly)) presence(report, over, feature);
    }
  }

  double gap(const PosedPair& pair, std::size_t f) const override {
    return OverHalfSpace(pair.A, pair.a, pair.B).gap(pair.b.features[f]);
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

}  // namespace

void addHalfSpacePairs(PairTable& table) {
  constexpr Touch H = Touch::halfSpace;
  table.add(std::make_unique<OnHalfSpace>(), {PairTable::Room::space, PairTable::Room::plane},
            {{H, Touch::ball},
             {H, Touch::capsule},
             {H, Touch::cylinder},
             {H, Touch::torus},
             {H, Touch::cone},
             {H, Touch::smooth},
             {H, Touch::other},
             {H, Touch::contour},
             {H, Touch::section},
             {H, Touch::polygon},
             {H, Touch::box},
             {H, Touch::polyhedron},
             {H, Touch::surface}});
}

}  // namespace dynamy
