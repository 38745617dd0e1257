// Both Stribeck laws are laws of constant friction, with the size that applies in the current step.
#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/laws/stribeck_friction.hpp>

namespace dynamy {
namespace {

void declareCurve(Attributes& a) {
  a.optional("speed", Unit::velocity, 0.1, "slip speed v_s at which friction has weakened")
      .positive();
  a.optional("exponent", Unit::none, 1.0, "exponent p of v/v_s").positive();
  a.choice("decay", {"exponential", "rational"}, "exponential",
           "how it weakens: exp(-(v/v_s)^p) or 1/(1 + (v/v_s)^p)");
}

StribeckCurve curve(const Parameters& x, const char* atRest, const char* far) {
  StribeckCurve out;
  out.atRest = x[atRest];
  out.far = x[far];
  out.speed = x["speed"], out.exponent = x["exponent"];
  out.rational = x["decay"].text == "rational";
  return out;
}

}  // namespace

double StribeckCurve::operator()(double v) const {
  const double x = std::pow(v / speed, exponent);
  return far + (atRest - far) * (rational ? 1.0 / (1.0 + x) : std::exp(-x)) + viscous * v;
}

double StribeckCurve::at(const LawInput& in, int first, int k) const {
  double square = 0.0;
  for (int i = first; i < first + k; ++i) square += in.gammaA[i] * in.gammaA[i];
  return (*this)(std::sqrt(square));
}

// ---- StribeckFriction --------------------------------------------------------------------------

void StribeckFriction::declare(Attributes& a) {
  a.about(
      "Dry friction of given size that changes with the slip speed v: a(v) = kineticForce + (force "
      "- kineticForce) f(v) + viscous v, f from 1 at rest to 0; v of the beginning of the step. "
      "Belts, bowed strings, brakes that squeal.");
  a.required("force", Unit::force, "friction at rest [N]; of a rotation [N m]").nonNegative();
  a.optional("kineticForce", Unit::force, 0.0, "what it weakens to").nonNegative();
  declareCurve(a);
  a.optional("viscous", Unit::damping, 0.0, "growth with speed").nonNegative();
  a.example("<StribeckFriction force=\"1\" kineticForce=\"0.4\" speed=\"0.2\"/>");
}

StribeckFriction::StribeckFriction(const Parameters& x)
    : SetValuedForceLaw(x), curve_(curve(x, "force", "kineticForce")) {
  curve_.viscous = x["viscous"];
}

GivenFriction StribeckFriction::now(const LawInput& in) const {
  const double a = curve_.at(in, 0, in.dim);
  return {a, a};
}

void StribeckFriction::prox(const LawInput& in, const double* r, const double* xi,
                            double* Lambda) const {
  now(in).prox(in, r, xi, Lambda);
}

bool StribeckFriction::proxDerivative(const LawInput& in, double rho, const double* xi,
                                      const double* Lambda, double* A, double* B) const {
  return now(in).proxDerivative(in, rho, xi, Lambda, A, B);
}

SimpleSet StribeckFriction::simpleSet(const LawInput& in) const { return now(in).simpleSet(in); }

Status StribeckFriction::status(const LawInput& in, const double* argument) const {
  return now(in).status(in, argument);
}

// ---- UnilateralStribeck ------------------------------------------------------------------------

void UnilateralStribeck::declare(Attributes& a) {
  a.about(
      "Contact with dry friction whose coefficient changes with the slip speed v: mu(v) = "
      "kineticMu "
      "+ (mu - kineticMu) f(v), f from 1 at rest to 0; v of the beginning of the step.");
  a.required("mu", Unit::none, "coefficient of friction at rest").nonNegative();
  a.required("kineticMu", Unit::none, "what it weakens to").nonNegative();
  declareCurve(a);
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of the normal direction")
      .between(0.0, 1.0);
  a.example("<UnilateralStribeck mu=\"0.4\" kineticMu=\"0.2\" speed=\"0.05\"/>");
}

UnilateralStribeck::UnilateralStribeck(const Parameters& x)
    : NormalTimesReservoir(x), epsilonN_(x["epsilonN"]), mu_(curve(x, "mu", "kineticMu")) {}

UnilateralCoulomb UnilateralStribeck::now(const LawInput& in) const {
  return {epsilonN_, 0.0, mu_.at(in, 1, in.dim - 1)};
}

void UnilateralStribeck::epsilon(int dim, double* epsilon) const {
  epsilon[0] = epsilonN_;
  std::fill(epsilon + 1, epsilon + dim, 0.0);
}

void UnilateralStribeck::project(const LawInput& in, double N, const double* r, int k,
                                 double* x) const {
  now(in).project(in, N, r, k, x);
}

double UnilateralStribeck::support(const LawInput& in, int k, const double* y, double* gradient,
                                   double* hessian) const {
  return now(in).support(in, k, y, gradient, hessian);
}

void UnilateralStribeck::naturalMap(const LawInput& in, double rho, const double* xi,
                                    const double* Lambda, double* e) const {
  now(in).naturalMap(in, rho, xi, Lambda, e);
}

bool UnilateralStribeck::proxDerivative(const LawInput& in, double rho, const double* xi,
                                        const double* Lambda, double* A, double* B) const {
  return now(in).proxDerivative(in, rho, xi, Lambda, A, B);
}

SimpleSet UnilateralStribeck::simpleSet(const LawInput& in) const { return now(in).simpleSet(in); }

}  // namespace dynamy
