#include <dynamy/system/description.hpp>
#include <mutex>
#include <set>

namespace dynamy {
namespace {

/// The same text for good: types have some hundred of them, scenes millions of signals.
std::string_view kept(std::string text) {
  static std::mutex mutex;
  static std::set<std::string> all;
  const std::scoped_lock lock(mutex);
  return *all.insert(std::move(text)).first;
}

}  // namespace

void Description::signal(std::string name, Unit unit, std::string text, SignalFunction value) {
  signals.push_back({std::move(name), unit, kept(std::move(text)), std::move(value)});
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
