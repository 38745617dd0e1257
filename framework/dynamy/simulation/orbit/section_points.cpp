#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/orbit/orbit_multipliers.hpp>
#include <dynamy/simulation/orbit/section_points.hpp>

namespace dynamy {

std::vector<std::vector<double>> sectionPoints(Model& model, const OrbitSection& section,
                                               const State& start,
                                               const SectionPointsRequest& request) {
  OrbitSection once = section;
  once.returns = 1;
  ReturnMap map(model, once, request.tolerance);
  std::vector<std::vector<double>> out;
  State x = start;
  try {
    for (int i = 0; i < request.transient + request.kept; ++i) {
      x = map.next(x);
      if (i < request.transient) continue;
      out.emplace_back();
      for (const auto& [name, value] : coordinatesOf(model, x)) out.back().push_back(value);
    }
  } catch (const ModelError&) {
    return out;  // the motion does not come back
  }
  return out;
}

}  // namespace dynamy
