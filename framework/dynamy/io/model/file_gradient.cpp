#include <fmt/format.h>

#include <cmath>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/io/model/file_gradient.hpp>
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

}  // namespace

Gradient gradient(const FileGradient& wanted, Registry& registry, PluginLoader& plugins) {
  std::map<std::string, double> values;
  LoadOptions options;
  options.set = wanted.set, options.parameters = &values;
  loadModel(wanted.file, registry, plugins, options);
  GradientRequest request;
  request.checks = wanted.checks, request.tolerance = wanted.tolerance;
  for (const std::string& text : wanted.of) request.of.push_back(signalAt(text));
  std::vector<std::string> known;
  for (const auto& [name, value] : values) known.push_back(name);
  for (const std::string& name : wanted.by) {
    const auto found = values.find(name);
    if (found == values.end())
      throw ModelError("no parameter \"" + name + '"', unknownNameHint(name, known));
    request.by.emplace_back(*found);
  }
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
    j.endObject();
  }
  j.endArray().key("refused").beginObject();
  for (std::size_t i = 0; i < g.by.size(); ++i)
    if (!g.refused[i].empty()) j.member(g.by[i], g.refused[i]);
  j.endObject();
}

}  // namespace dynamy
