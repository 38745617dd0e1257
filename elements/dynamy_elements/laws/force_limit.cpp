#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy_elements/laws/force_limit.hpp>

namespace dynamy {

void ForceLimit::declare(Attributes& a) {
  a.about(
      "A constraint whose force stays between two limits: γ = 0 inside, −ξ ∈ N_C(Λ) with C = "
      "[lower "
      "Δt, upper Δt] in every row. A limit that is not given is infinite. Overload clutches, "
      "drives "
      "of limited force.");
  for (const char* name : {"lower", "upper"}) {
    Attribute& limit = a.add(AttributeType::number, name, std::nullopt,
                             std::string(name) + " limit of the force [N]; of a rotation [N m]");
    limit.unit = Unit::force;
    limit.optionalValue = true;
  }
  a.example("<ForceLimit lower=\"-2\" upper=\"5\"/>");
}

ForceLimit::ForceLimit(const Parameters& x) : SetValuedForceLaw(x), limit_{-kInfinity, kInfinity} {
  if (x.has("lower")) limit_.lower = x["lower"];
  if (x.has("upper")) limit_.upper = x["upper"];
  if (!(limit_.lower <= limit_.upper))
    throw ModelError("the lower limit lies above the upper one", "exchange lower and upper");
}

convex::Interval ForceLimit::interval(const LawInput& in) const {
  // ∞ · 0 would be NaN: an infinite limit stays infinite in an impact.
  const double factor = in.scale * in.dt;
  return {std::isinf(limit_.lower) ? limit_.lower : limit_.lower * factor,
          std::isinf(limit_.upper) ? limit_.upper : limit_.upper * factor};
}

SimpleSet ForceLimit::simpleSet(const LawInput& in) const {
  if (in.dim != 1) return {};
  const convex::Interval C = interval(in);
  return {SimpleSet::Shape::interval, C.lower, C.upper};
}

void ForceLimit::prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const {
  const convex::Interval C = interval(in);
  for (int i = 0; i < in.dim; ++i) Lambda[i] = convex::prox(C, Lambda[i] - r[i] * xi[i]);
}

bool ForceLimit::proxDerivative(const LawInput& in, double rho, const double* xi,
                                const double* Lambda, double* A, double* B) const {
  const convex::Interval C = interval(in);
  std::fill(A, A + in.dim * in.dim, 0.0);
  std::fill(B, B + in.dim * in.dim, 0.0);
  for (int i = 0; i < in.dim; ++i) {
    const double P = convex::proxDerivative(C, Lambda[i] - rho * xi[i]);
    A[i * in.dim + i] = 1.0 - P, B[i * in.dim + i] = rho * P;
  }
  return true;
}

Status ForceLimit::status(const LawInput& in, const double* argument) const {
  const convex::Interval C = interval(in);
  for (int i = 0; i < in.dim; ++i) {
    if (argument[i] < C.lower) return Status::lower;
    if (argument[i] > C.upper) return Status::upper;
  }
  return Status::locked;
}

void OneWayClutch::declare(Attributes& a) {
  a.about(
      "A clutch that turns freely one way and holds the other: 0 ≤ γ ⊥ λ ≥ 0, C = ℝ₀⁺ (free = "
      "negative: both signs reversed). A moment beyond the limit, if there is one, makes it slip. "
      "Sprag clutches, ratchets, free wheels.");
  a.choice("free", {"positive", "negative"}, "positive", "sign of the velocity that is free");
  Attribute& limit = a.add(AttributeType::number, "limit", std::nullopt,
                           "largest force it holds [N]; of a rotation [N m]; default: any");
  limit.unit = Unit::force;
  limit.optionalValue = true;
  limit.nonNegative();
  a.example("<OneWayClutch free=\"positive\"/>");
}

namespace {

convex::Interval oneWay(const Parameters& x) {
  const double limit = x.has("limit") ? double(x["limit"]) : kInfinity;
  return x["free"].text == "positive" ? convex::Interval{0.0, limit}
                                      : convex::Interval{-limit, 0.0};
}

}  // namespace

OneWayClutch::OneWayClutch(const Parameters& x) : ForceLimit(x, oneWay(x)) {}

}  // namespace dynamy
