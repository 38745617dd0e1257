#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/laws/preloaded_spring.hpp>

namespace dynamy {
namespace {

/// Displacements below this value are in the notch x = 0  [m or rad].
constexpr double kNotch = 1e-9;

}  // namespace

void PreloadedSpring::declare(Attributes& a) {
  a.about(
      "Spring with preload on a displacement x, the gap of a CoordinateContact or what a Rope has "
      "left (elastic with sides=\"one\"): force -c x - a "
      "Sign(x); one side: c max(-x, 0) plus a in contact, a preloaded stop or buffer. At x = 0 it "
      "holds like a joint until its force exceeds the preload.");
  a.required("stiffness", Unit::stiffness, "stiffness c [N/m]; of a rotation [N m/rad]")
      .nonNegative();
  a.optional("preload", Unit::force, 0.0, "preload a [N]; of a rotation [N m]").nonNegative();
  a.choice("sides", {"both", "one"}, "both", "one: it pushes where x is negative and never pulls");
  a.example("<PreloadedSpring stiffness=\"60000\" preload=\"2000\" sides=\"one\"/>");
}

PreloadedSpring::PreloadedSpring(const Parameters& x)
    : SetValuedForceLaw(x),
      stiffness_(x["stiffness"]),
      preload_(x["preload"]),
      oneSided_(x["sides"].text == "one") {}

convex::Interval PreloadedSpring::interval(const LawInput& in) const {
  const double factor = in.scale * in.dt, a = preload_ * factor, at = x(in);
  const double spring = stiffness_ * factor * (oneSided_ ? std::max(-at, 0.0) : -at);
  return {oneSided_ ? spring : spring - a, spring + a};
}

bool PreloadedSpring::notched(const LawInput& in, NotchedForce& out) const {
  const double factor = in.scale * in.dt, a = preload_ * factor, c = stiffness_ * factor;
  out = oneSided_ ? NotchedForce{a, 0.0, c, 0.0} : NotchedForce{a, -a, c, c};
  return in.dim == 1;
}

double PreloadedSpring::argument(const LawInput& in, double r, double xi, double Lambda) const {
  return in.dt > 0.0 ? Lambda - r * (xi + x(in) / in.dt) : Lambda - r * xi;
}

void PreloadedSpring::prox(const LawInput& in, const double* r, const double* xi,
                           double* Lambda) const {
  Lambda[0] = convex::prox(interval(in), argument(in, r[0], xi[0], Lambda[0]));
}

bool PreloadedSpring::proxDerivative(const LawInput& in, double rho, const double* xi,
                                     const double* Lambda, double* A, double* B) const {
  const double P = convex::proxDerivative(interval(in), argument(in, rho, xi[0], Lambda[0]));
  A[0] = 1.0 - P, B[0] = rho * P;
  return true;
}

Status PreloadedSpring::status(const LawInput& in, const double* argument) const {
  const double at = x(in);
  if (at > kNotch) return Status::lower;
  if (at < -kNotch) return Status::upper;
  const convex::Interval C = interval(in);
  return argument[0] < C.lower   ? Status::lower
         : argument[0] > C.upper ? Status::upper
                                 : Status::locked;
}

}  // namespace dynamy
