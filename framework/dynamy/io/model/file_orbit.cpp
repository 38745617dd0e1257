#include <fmt/format.h>

#include <cmath>
#include <dynamy/io/model/file_orbit.hpp>
#include <dynamy/io/model/start_values.hpp>
#include <dynamy/simulation/orbit/orbit_branch.hpp>

namespace dynamy {
namespace {

/// "toy.phiM=0-" → a section.
void readSection(const std::string& text, OrbitSection& section) {
  const std::size_t at = text.find('=');
  const char last = text.empty() ? ' ' : text.back();
  const std::size_t length = text.size() - (last == '+' || last == '-' ? 1 : 0);
  const std::string value = at < length ? text.substr(at + 1, length - at - 1) : "";
  char* end = nullptr;
  section.signal = text.substr(0, at), section.value = std::strtod(value.c_str(), &end);
  section.falling = last == '-', section.period = 0.0;
  if (value.empty() || *end != '\0' || !std::isfinite(section.value))
    throw ModelError('"' + text + "\" is no section",
                     "write the signal, its value and the direction in which it passes it: "
                     "toy.phiM=0-");
}

/// The orbit for the values that are set, followed from the one for the model's own values.
State followedFromOwn(const FileOrbit& wanted, Registry& registry, PluginLoader& plugins) {
  std::map<std::string, double> own, other;
  LoadOptions options;
  options.parameters = &own;
  loadModel(wanted.file, registry, plugins, options);
  options.set = wanted.set, options.parameters = &other;
  loadModel(wanted.file, registry, plugins, options);
  // One parameter is followed by its value, several by the part of the way.
  const bool one = !own.empty() && wanted.set.size() == 1;
  const std::string& first = wanted.set.front().first;
  const double from = one ? own[first] : 0.0, to = one ? other[first] : 1.0;
  const OrbitMaker make = [&](double value, OrbitSection& section) {
    const double part = (value - from) / (to - from);
    FileOrbit at = wanted;
    at.set.clear();
    for (const auto& [name, text] : wanted.set)
      at.set.emplace_back(
          name, fmt::format("{}", one ? value : (1.0 - part) * own[name] + part * other[name]));
    return loadOrbitModel(at, registry, plugins, section);
  };
  return followedOrbit(make, from, to, wanted.tolerance);
}

}  // namespace

Model loadOrbitModel(const FileOrbit& wanted, Registry& registry, PluginLoader& plugins,
                     OrbitSection& section) {
  LoadOptions options;
  options.set = wanted.set, options.orbit = &section, options.numbers = wanted.mirror;
  for (const auto& [name, value] : wanted.start) options.numbers.push_back(name);
  Model model = loadModel(wanted.file, registry, plugins, options);
  if (!wanted.section.empty()) readSection(wanted.section, section);
  if (wanted.period > 0.0) section.signal.clear(), section.period = wanted.period;
  if (wanted.returns > 0) section.returns = wanted.returns;
  if (!wanted.mirror.empty()) section.mirror = wanted.mirror;
  if (!section.given())
    throw ModelError("nothing says where the orbit begins",
                     "give a signal that passes a value once a period, --section toy.phiM=0-, or "
                     "the period of a forcing, --period 0.5; or an <orbit> in the model");
  return model;
}

State startOf(const Model& model, const FileOrbit& wanted) {
  State start = model.initialState();
  for (const auto& [name, value] : wanted.start) placeInState(model, name, value, start);
  return start;
}

Orbit orbit(const FileOrbit& wanted, Registry& registry, PluginLoader& plugins) {
  OrbitRequest request;
  request.tolerance = wanted.tolerance;
  Model model = loadOrbitModel(wanted, registry, plugins, request.section);
  const State start = startOf(model, wanted);
  try {
    return orbit(model, request, wanted.start.empty() ? nullptr : &start);
  } catch (const ModelError&) {
    if (wanted.set.empty() || !wanted.start.empty()) throw;
  }
  // From the orbit of the model's own values, with all of them changed together.
  const State near = followedFromOwn(wanted, registry, plugins);
  return orbit(model, request, &near);
}

void writeOrbit(JsonWriter& j, const Orbit& o) {
  j.member("period", o.period).member("periodError", o.periodError);
  j.member("section", o.section.text());
  for (const auto& [name, all] : {std::pair("state", &o.state), {"shift", &o.shift}}) {
    j.key(name).beginObject();
    for (const auto& [signal, value] : *all) j.member(signal, value);
    j.endObject();
  }
  j.key("multipliers").beginArray();
  for (const std::complex<double>& m : o.multipliers)
    j.beginArray().value(m.real()).value(m.imag()).endArray();
  j.endArray();
  if (o.half.size() > 0) {
    j.key("halfMultipliers").beginArray();
    for (const std::complex<double>& m : o.half)
      j.beginArray().value(m.real()).value(m.imag()).endArray();
    j.endArray();
  }
  j.member("multiplierError", o.multiplierError).member("zeros", o.zeros);
  j.member("residual", o.residual).member("newton", o.newton).member("tolerance", o.tolerance);
  j.member("switches", o.switches).member("impacts", o.impacts);
}

}  // namespace dynamy
