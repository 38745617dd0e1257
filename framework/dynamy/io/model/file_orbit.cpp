#include <cmath>
#include <dynamy/io/model/file_orbit.hpp>
#include <dynamy/io/model/start_values.hpp>

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

}  // namespace

Orbit orbit(const FileOrbit& wanted, Registry& registry, PluginLoader& plugins) {
  OrbitRequest request;
  request.tolerance = wanted.tolerance;
  LoadOptions options;
  options.set = wanted.set, options.orbit = &request.section;
  Model model = loadModel(wanted.file, registry, plugins, options);
  if (!wanted.section.empty()) readSection(wanted.section, request.section);
  if (wanted.period > 0.0) request.section.signal.clear(), request.section.period = wanted.period;
  if (wanted.returns > 0) request.section.returns = wanted.returns;
  if (!request.section.given())
    throw ModelError("nothing says where the orbit begins",
                     "give a signal that passes a value once a period, --section toy.phiM=0-, or "
                     "the period of a forcing, --period 0.5; or an <orbit> in the model");
  State start = model.initialState();
  for (const auto& [name, value] : wanted.start) placeInState(model, name, value, start);
  return orbit(model, request, wanted.start.empty() ? nullptr : &start);
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
  j.endArray().member("multiplierError", o.multiplierError).member("zeros", o.zeros);
  j.member("residual", o.residual).member("newton", o.newton).member("tolerance", o.tolerance);
  j.member("switches", o.switches).member("impacts", o.impacts);
}

}  // namespace dynamy
