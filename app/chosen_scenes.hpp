/// Scenes of a bench that the command line asks for.
#pragma once
#include <CLI/CLI.hpp>
#include <algorithm>
#include <dynamy/core/error.hpp>
#include <dynamy/core/suggestion.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

/// Those of `all` that `names` names, in the order of `all`; all, if none is named. Throws
/// CLI::ValidationError with the nearest name.
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
