#include <cmath>
#include <cstdlib>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/start_values.hpp>
#include <tuple>

namespace dynamy {

void placeInState(const Model& model, const std::string& name, const std::string& value, State& x) {
  std::vector<std::string> known;
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const SystemHandle& s = model.topology().system(i);
    const std::string of = model.systems()[static_cast<std::size_t>(i)]->name() + ".";
    const Description& d = model.description(i);
    for (const auto& [all, into, from] :
         {std::tuple{&d.coordinates, &x.q, s.q0}, std::tuple{&d.velocities, &x.u, s.u0}})
      for (const auto& [own, index] : *all) {
        known.push_back(of + own);
        if (known.back() != name) continue;
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        if (value.empty() || *end != '\0' || !std::isfinite(number))
          throw ModelError("start of " + name + ": \"" + value + "\" is no finite number");
        (*into)[from + index] = number;
        return;
      }
  }
  throw ModelError("no coordinate or velocity named \"" + name + '"', unknownNameHint(name, known));
}

}  // namespace dynamy
