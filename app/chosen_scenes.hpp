/// Selects the scenes of a benchmark that the command line names.
#pragma once
#include <CLI/CLI.hpp>
#include <algorithm>
#include <dynamy/core/error.hpp>
#include <dynamy/core/suggestion.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

/// The scenes of `all` whose names are in `names`, in the order of `all`; every scene if `names` is
/// empty. Throws CLI::ValidationError with the nearest name if a scene is unknown.
template <class Scene>
std::vector<Scene> chosenScenes(std::vector<Scene> all, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Scene& s : all) known.push_back(s.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::string hint = didYouMean(nearest(name, known));
      throw CLI::ValidationError("--scene",
                                 "no scene \"" + name + '"' + (hint.empty() ? "" : " — ") + hint);
    }
  if (!names.empty())
    std::erase_if(all, [&](const Scene& s) {
      return std::find(names.begin(), names.end(), s.name) == names.end();
    });
  return all;
}

}  // namespace dynamy::app
