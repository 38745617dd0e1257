#include <cmath>
#include <dynamy/system/announced_signals.hpp>

namespace dynamy {

void announceInstants(Description& d, std::function<double(double)> next) {
  if (!std::isfinite(next(0.0))) return;
  d.signal(kNextInstant, Unit::time, "when a formula next jumps or has a kink by the time alone",
           [next = std::move(next)](const SignalView& v) { return next(v.t); });
}

}  // namespace dynamy
