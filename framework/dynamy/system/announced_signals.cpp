#include <algorithm>
#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/system/announced_signals.hpp>

namespace dynamy {

void announceInstants(Description& d, std::function<double(double)> next) {
  if (!std::isfinite(next(0.0))) return;
  d.signal(kNextInstant, Unit::time, "when a formula next jumps or has a kink by the time alone",
           [next = std::move(next)](const SignalView& v) { return next(v.t); });
}

void announceSamples(Description& d, const std::function<double(double)>& next) {
  announceInstants(d, next);
  d.signal(kNextSample, Unit::time, "when the block next takes a sample",
           [next](const SignalView& v) { return next(v.t); });
}

void refuseSwitching(const Element& e, const std::string& scheme) {
  Description d;
  e.describe(d);
  const auto switches = [](const Signal& s) { return s.name == kSwitching; };
  if (std::none_of(d.signals.begin(), d.signals.end(), switches)) return;
  Diagnostic fault;
  fault.place = e.place();
  fault.element = e.type() + (e.name().empty() ? "" : " name=\"" + e.name() + "\"");
  fault.text = "the signal \"" + std::string(kSwitching) +
               "\" is asked of contact elements only: <" + scheme +
               "> would not see where this one switches";
  fault.hint =
      "make it a contact element, give a step instead of the tolerance, or name the signal "
      "otherwise";
  throw ModelError(fault);
}

}  // namespace dynamy
