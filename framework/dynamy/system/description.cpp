#include <dynamy/core/kept_text.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

void Description::signal(std::string name, Unit unit, std::string text, SignalFunction value) {
  signals.push_back({std::move(name), unit, keptText(std::move(text)), std::move(value)});
}

void Description::coordinate(std::string name, Unit unit, int i, std::string text) {
  coordinates.emplace_back(name, i);
  signal(std::move(name), unit, std::move(text), [i](const SignalView& v) { return v.q[i]; });
}

void Description::velocity(std::string name, Unit unit, int i, std::string text) {
  velocities.emplace_back(name, i);
  signal(std::move(name), unit, std::move(text), [i](const SignalView& v) { return v.u[i]; });
}

}  // namespace dynamy
