#include <dynamy_elements/contacts/kernels/given_pair.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>

namespace dynamy {
namespace {

ShapeAt shapeAt(const TouchingShape& s, const Frame& f) {
  ShapeAt out{*s.shape, f};
  out.c = f.r_OS_I + f.A_IK * s.p_K;
  if (s.kind == TouchingShape::Kind::halfSpace) out.n = f.A_IK * s.n_K;
  if (s.kind == TouchingShape::Kind::ball) out.radius = s.features[0].radius;
  return out;
}

/// The plug-in's function knows the shape of its own family as b.
class GivenPair final : public PairKernel {
 public:
  GivenPair(const ShapeFamily& own, const ShapePair& pair) : own_(own), pair_(pair) {}

  void contacts(PairReport& report) const override {
    for (int f = 0; f < pair_.contacts; ++f)
      report.add(static_cast<std::size_t>(f), point(report.pair(), f));
  }
  double gap(const PosedPair& p, std::size_t f) const override {
    return find(p, static_cast<int>(f)).g;
  }
  std::uint64_t features(const TouchingShape&, const TouchingShape&) const override {
    return static_cast<std::uint64_t>(pair_.contacts);
  }
  std::string featureName(const TouchingShape&, const TouchingShape&,
                          std::uint64_t f) const override {
    return pair_.contacts > 1 ? "contact" + std::to_string(f) : std::string();
  }
  std::size_t swept(const TouchingShape&) const override {
    return static_cast<std::size_t>(pair_.contacts);
  }

 private:
  bool ownIsB(const PosedPair& p) const { return p.b.family == &own_; }
  PairContact find(const PosedPair& p, int f) const {
    const ShapeAt A = shapeAt(p.a, p.A), B = shapeAt(p.b, p.B);
    return ownIsB(p) ? pair_.contact(A, B, f) : pair_.contact(B, A, f);
  }
  ContactPoint point(const PosedPair& p, int f) const {
    const PairContact found = find(p, f);
    const double sign = ownIsB(p) ? 1.0 : -1.0;
    ContactPoint out;
    out.g = found.g, out.P = found.P, out.Pdot = found.Pdot;
    setDirections(out, sign * found.n, sign * found.ndot, p.plane);
    return out;
  }

  const ShapeFamily& own_;
  const ShapePair& pair_;
};

}  // namespace

void addFamily(PairTable& table, const ShapeFamily& family) {
  for (const ShapePair& pair : family.pairs)
    table.add(std::make_unique<GivenPair>(family, pair), family, *pair.other);
}

}  // namespace dynamy
