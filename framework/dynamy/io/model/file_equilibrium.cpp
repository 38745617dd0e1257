#include <fmt/format.h>

#include <cmath>
#include <dynamy/io/model/file_equilibrium.hpp>
#include <dynamy/io/model/start_values.hpp>

namespace dynamy {
namespace {

Equilibrium find(const FileEquilibrium& wanted, LoadOptions options, Registry& registry,
                 PluginLoader& plugins) {
  for (const auto& [name, value] : wanted.start) options.numbers.push_back(name);
  Model model = loadModel(wanted.file, registry, plugins, options);
  State x = model.initialState();
  if (wanted.atRest) x.u.setZero();
  for (const auto& [name, value] : wanted.start) placeInState(model, name, value, x);
  return equilibrium(model, x, wanted.options);
}

}  // namespace

Equilibrium equilibrium(const FileEquilibrium& wanted, Registry& registry, PluginLoader& plugins) {
  LoadOptions options;
  options.set = wanted.set;
  return find(wanted, options, registry, plugins);
}

std::vector<RestRange> restRanges(const FileEquilibrium& wanted, const std::string& parameter,
                                  double a, double b, int count, Registry& registry,
                                  PluginLoader& plugins) {
  FileEquilibrium still = wanted;
  still.options.relax = false;
  LoadOptions options;
  options.set = wanted.set, options.set.emplace_back(parameter, "");
  loadModel(wanted.file, registry, plugins,
            [&] {  // an unknown parameter is an error, not a value without a rest
              options.set.back().second = fmt::format("{}", a);
              return options;
            }());
  return restRanges(a, b, count, [&](double value) {
    options.set.back().second = fmt::format("{}", value);
    return find(still, options, registry, plugins);
  });
}

void writeEquilibrium(JsonWriter& j, const Equilibrium& e) {
  j.member("kind", e.rest ? "rest" : "steady motion");
  j.member("residual", e.residual).member("moved", e.moved);
  if (std::isfinite(e.margin)) j.member("margin", e.margin);
  if (e.growing >= 0) j.member("growing", e.growing);
  j.member("relaxations", e.relaxations).member("steps", e.steps);
  j.key("sampled").values(e.sampled);
  j.key("state").beginObject();
  for (const auto& [signal, value] : e.state) j.member(signal, value);
  j.endObject().key("contacts").beginArray();
  for (const CarryingContact& c : e.contacts) {
    j.beginObject().member("name", c.name).member("status", c.status);
    j.key("force").values(c.lambda);
    if (std::isfinite(c.margin)) j.member("margin", c.margin);
    j.endObject();
  }
  j.endArray();
}

void writeRanges(JsonWriter& j, const std::string& parameter,
                 const std::vector<RestRange>& ranges) {
  j.key("ranges").beginArray();
  for (const RestRange& r : ranges) {
    j.beginObject().member("parameter", parameter).member("from", r.from).member("to", r.to);
    j.member("endsFrom", r.endsFrom).member("endsTo", r.endsTo).endObject();
  }
  j.endArray();
}

}  // namespace dynamy
