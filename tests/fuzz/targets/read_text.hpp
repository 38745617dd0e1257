/// What the targets that read models share: a text gives a model or errors, each with its place.
#pragma once
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <dynamy/io/model/model_loader.hpp>
#include <string>

namespace dynamy::fuzz {

/// Registry of the framework's types; `load` adds those of a library.
struct World {
  Registry registry;
  PluginLoader plugins;
  World() { registerFramework(registry); }
};

/// Reads and builds `text` as the file "fuzz.xml". A text that names a library or a file is left
/// out: it would read what stands on this machine.
template <class Use>
void readText(World& world, const std::string& text, const Overrides& set, const Use& use) {
  if (text.find("plugin") != std::string::npos || text.find("include") != std::string::npos) return;
  try {
    Model model =
        loadModelText(text, "fuzz.xml", world.registry, world.plugins, {.set = set}, "/nowhere");
    use(model);
  } catch (const ModelError& e) {
    for (const Diagnostic& d : e.diagnostics()) {
      const bool whole = d.text.find("--set") != std::string::npos || d.place.file == "fuzz.xml";
      if (!d.text.empty() && (d.place.line > 0 || whole)) continue;
      std::fprintf(stderr, "broken promise: an error has its place: %s\n", d.format().c_str());
      std::abort();
    }
  }
}

}  // namespace dynamy::fuzz
