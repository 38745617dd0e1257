#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy_elements/laws/adhesion.hpp>

namespace dynamy {
void UnilateralAdhesion::declare(Attributes& a) {
  a.about(
      "Contact that also pulls, up to a given force: C_N = [-force Δt, ∞), friction |Λ_T| ≤ mu "
      "(Λ_N "
      "+ force Δt). Once pulled off it pulls no more until it touches again. Magnets, glue, "
      "suction "
      "cups, cohesion.");
  a.required("force", Unit::force, "largest pull").nonNegative();
  a.optional("mu", Unit::none, 0.0, "coefficient of friction").nonNegative();
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of the normal direction")
      .between(0.0, 1.0);
  a.example("<UnilateralAdhesion force=\"20\" mu=\"0.3\"/>");
}

UnilateralAdhesion::UnilateralAdhesion(const Parameters& x)
    : SetValuedForceLaw(x),
      force_(x["force"]),
      mu_(x["mu"]),
      contact_(x["epsilonN"], 0.0, x["mu"]) {}

int UnilateralAdhesion::dim(int geometric) const { return mu_ > 0.0 ? contact_.dim(geometric) : 1; }

void UnilateralAdhesion::prox(const LawInput& in, const double* r, const double* xi,
                              double* Lambda) const {
  const double a = pull(in);
  Lambda[0] += a;
  contact_.prox(in, r, xi, Lambda);
  Lambda[0] -= a;
}

bool UnilateralAdhesion::proxDerivative(const LawInput& in, double rho, const double* xi,
                                        const double* Lambda, double* A, double* B) const {
  double shifted[kMostRows] = {};
  std::copy_n(Lambda, in.dim, shifted);
  shifted[0] += pull(in);
  return contact_.proxDerivative(in, rho, xi, shifted, A, B);
}

SimpleSet UnilateralAdhesion::simpleSet(const LawInput& in) const {
  if (in.dim > 1) return {};
  return {SimpleSet::Shape::interval, -pull(in), kInfinity};
}

Status UnilateralAdhesion::status(const LawInput& in, const double* argument) const {
  double shifted[kMostRows] = {};
  std::copy_n(argument, in.dim, shifted);
  const double a = pull(in);
  shifted[0] += a;
  if (a > 0.0 && !(shifted[0] > 0.0)) return Status::lower;
  return contact_.status(in, shifted);
}

}  // namespace dynamy
