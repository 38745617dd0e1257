#include <dynamy/core/constants.hpp>
#include <dynamy_elements/blocks/pid_settings.hpp>

namespace dynamy {
namespace {

void limit(Attributes& a, const char* name, const char* text) {
  Attribute& x = a.add(AttributeType::number, name, std::nullopt, text);
  x.unit = Unit::any;
  x.mayBeAbsent();
}

}  // namespace

void PidSettings::declare(Attributes& a, const char* aboutRate) {
  a.add(AttributeType::expression, "error", std::nullopt,
        "error e as a formula of t and signals, e.g. 1 - cart.x");
  a.optional("kp", Unit::any, 0.0, "gain of the error");
  a.optional("ki", Unit::any, 0.0, "gain of its integral [1/s]");
  a.optional("kd", Unit::any, 0.0, "gain of its rate [s]");
  a.optional("filter", Unit::time, 0.0, "time constant Tf of the rate [s]").nonNegative();
  a.add(AttributeType::expression, "rate", std::nullopt, aboutRate).mayBeAbsent();
  a.add(AttributeType::expression, "feedforward", "0", "f as a formula of t and signals");
  limit(a, "lower", "least output; default: none");
  limit(a, "upper", "largest output; default: none");
  a.choice("antiWindup", {"clamp", "back", "none"}, "clamp",
           "what keeps I from growing at a limit: clamp: I stays while it would drive the output "
           "further out; back: I also follows (out - output without limits)/tracking");
  a.optional("tracking", Unit::time, 1.0, "time constant of antiWindup=\"back\" [s]").positive();
}

PidSettings::PidSettings(const Parameters& x)
    : error(x, "error", 1),
      rate(x, "rate", 1),
      feedforward(x, "feedforward", 1),
      kp(x["kp"]),
      ki(x["ki"]),
      kd(x["kd"]),
      filter(x["filter"]),
      lower(x.has("lower") ? double(x["lower"]) : -kInfinity),
      upper(x.has("upper") ? double(x["upper"]) : kInfinity),
      tracking(x["tracking"]),
      antiWindup(x["antiWindup"].text == "clamp"  ? AntiWindup::clamp
                 : x["antiWindup"].text == "back" ? AntiWindup::back
                                                  : AntiWindup::none) {
  if (!(lower <= upper))
    throw ModelError("the lower limit lies above the upper one", "exchange lower and upper");
}

}  // namespace dynamy
