#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/blocks/input.hpp>

namespace dynamy {

void Input::declare(Attributes& a) {
  a.about(
      "A number that a program sets between steps, e.g. a controller in Python; formulas read it. "
      "Signal: out.");
  a.optional("value", Unit::any, 0.0, "number at the start");
  a.example("<Input name=\"motor\"/>");
}

Input::Input(const Parameters& x) : ExternalForce(x), value_(x["value"]) {}

void Input::describe(Description& d) const {
  d.signal("out", Unit::any, "the number set last",
           [](const SignalView& v) { return v.memory[0]; });
}

}  // namespace dynamy
