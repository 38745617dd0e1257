#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/laws/belt_friction.hpp>

namespace dynamy {

void BeltFriction::declare(Attributes& a) {
  a.about(
      "Rope or belt on a drum (Euler-Eytelwein): the rope forces S1, S2 of the two sides obey "
      "e^(-mu wrap) S2 ≤ S1 ≤ e^(mu wrap) S2; at either limit the rope slips. Rows of the contact: "
      "slack (force: mean rope force) and slip (force: S1 - S2).");
  a.required("mu", Unit::none, "coefficient of friction between rope and drum").nonNegative();
  a.required("wrap", Unit::angle, "angle of wrap; several turns: more than 360 degrees")
      .nonNegative();
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of a rope that goes taut")
      .between(0.0, 1.0);
  a.example("<BeltFriction mu=\"0.2\" wrap=\"180deg\"/>");
}

double BeltFriction::coefficient(double mu, double wrap) {
  return 2.0 * std::tanh(0.5 * mu * wrap);
}

BeltFriction::BeltFriction(const Parameters& x)
    : UnilateralCoulomb(x, x["epsilonN"], coefficient(x["mu"], x["wrap"])) {}

}  // namespace dynamy
