#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/file_gradient.hpp>
#include <dynamy/io/model/parameter_hint.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <limits>

namespace dynamy {
namespace {

/// "ball.z@0.6" → signal and instant.
SignalAt signalAt(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) return {text, std::numeric_limits<double>::quiet_NaN()};
  const std::string time = text.substr(at + 1);
  Attribute seconds;
  seconds.unit = Unit::time;
  ParameterValue value;
  value.declaration = &seconds, value.text = time, value.given = true;
  if (const auto fault = readValue(seconds, value))
    throw ModelError('"' + text + "\": " + fault->text,
                     "write the signal and its time, ball.z@0.6");
  return {text.substr(0, at), value.numbers[0]};
}

constexpr std::string_view kInstantPrefix = "t:";

/// "floor=impact#2", "block/3=stick", "ball.y=0.5-" → what is wanted.
WantedInstant instantOf(const std::string& text) {
  const ModelError fault('"' + text + "\" is no event",
                         "write a contact and what happens to it, t:floor=impact, t:floor=slip; or "
                         "a signal, its value and the direction, t:ball.y=0.5-; the second such "
                         "event is t:floor=impact#2");
  WantedInstant out;
  out.text = text;
  const std::size_t equals = text.rfind('='), hash = text.rfind('#');
  if (equals == std::string::npos || equals <= kInstantPrefix.size()) throw ModelError(fault);
  const bool counted = hash != std::string::npos && hash > equals;
  out.of = text.substr(kInstantPrefix.size(), equals - kInstantPrefix.size());
  std::string what = text.substr(equals + 1, counted ? hash - equals - 1 : std::string::npos);
  char* end = nullptr;
  if (counted) {
    const long count = std::strtol(text.c_str() + hash + 1, &end, 10);
    if (*end != '\0' || count < 1 || count > 1'000'000) throw ModelError(fault);
    out.count = static_cast<int>(count);
  }
  if (what == "impact") return out;
  out.what = WantedInstant::What::status;
  for (const Status s : {Status::open, Status::separating, Status::stick, Status::slip,
                         Status::lower, Status::upper, Status::locked})
    if (what == statusText(s)) return out.status = s, out;
  if (what.size() < 2 || (what.back() != '+' && what.back() != '-')) throw ModelError(fault);
  out.what = what.back() == '+' ? WantedInstant::What::rise : WantedInstant::What::fall;
  what.pop_back();
  out.value = std::strtod(what.c_str(), &end);
  if (*end != '\0' || !std::isfinite(out.value)) throw ModelError(fault);
  return out;
}

/// Parameters, else initial values, with their values in the model.
void placeVaried(const std::vector<std::string>& by, const std::map<std::string, double>& values,
                 const Model& model, GradientRequest& request) {
  std::vector<std::string> known = namesOfState(model);
  for (const auto& [name, value] : values) known.push_back(name);
  State start = model.initialState();
  for (const std::string& name : by) {
    const auto found = values.find(name);
    const double* number = numberOfState(model, name, start);
    if (found != values.end())
      request.by.emplace_back(*found);
    else if (number != nullptr)
      request.by.emplace_back(name, *number), request.initial.push_back(name);
    else
      throw ModelError("no parameter, coordinate or velocity \"" + name + '"',
                       parameterHint(model, name, known));
  }
}

}  // namespace

Gradient gradient(const FileGradient& wanted, Registry& registry, PluginLoader& plugins) {
  std::map<std::string, double> values;
  LoadOptions options;
  options.set = wanted.set, options.parameters = &values;
  options.numbers = wanted.by;
  for (const std::string& text : wanted.of)
    if (text.rfind(kInstantPrefix, 0) != 0) options.signals.push_back(signalAt(text).signal);
  const Model model = loadModel(wanted.file, registry, plugins, options);
  std::erase_if(options.numbers, [&](const std::string& name) { return values.contains(name); });
  GradientRequest request;
  request.checks = wanted.checks, request.tolerance = wanted.tolerance;
  for (const std::string& text : wanted.of) {
    if (text.rfind(kInstantPrefix, 0) == 0)
      request.instants.push_back(instantOf(text));
    else
      request.of.push_back(signalAt(text));
  }
  placeVaried(wanted.by, values, model, request);
  options.parameters = nullptr;
  return gradient(
      [&](const std::vector<Varied>& changed) {
        options.set = wanted.set;
        for (const auto& [name, value] : changed)
          options.set.emplace_back(name, fmt::format("{}", value));
        return loadModel(wanted.file, registry, plugins, options);
      },
      request);
}

void writeGradient(JsonWriter& j, const Gradient& g) {
  j.key("values").beginArray();
  for (const GradientValue& v : g.values) {
    j.beginObject().member("of", v.of).member("at", v.at);
    if (!v.measure.empty()) j.member("measure", v.measure);
    j.member("value", v.value).member("error", v.error);
    for (const auto& [name, all] : {std::pair("d", &v.d), {"dError", &v.dError}}) {
      j.key(name).beginObject();
      for (std::size_t i = 0; i < g.by.size(); ++i) j.member(g.by[i], (*all)[i]);
      j.endObject();
    }
    for (const auto& [name, all] : {std::pair("left", &v.left), {"right", &v.right}}) {
      if (all->empty()) continue;
      j.key(name).beginObject();
      for (std::size_t i = 0; i < g.by.size(); ++i) {
        if (g.refused[i].empty()) continue;
        const SideDerivative& d = (*all)[i];
        j.key(g.by[i]).beginObject();
        j.member("d", d.d).member("dError", d.error).member("value", d.limit);
        j.endObject();
      }
      j.endObject();
    }
    j.endObject();
  }
  j.endArray().key("refused").beginObject();
  for (std::size_t i = 0; i < g.by.size(); ++i)
    if (!g.refused[i].empty()) j.member(g.by[i], g.refused[i]);
  j.endObject();
}

}  // namespace dynamy
