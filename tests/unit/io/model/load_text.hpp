/// Loads models from text with the dummy elements, and gives their errors as text.
#pragma once
#include <dynamy/io/model/model_loader.hpp>
#include <filesystem>
#include <unit/io/plugin/dummy_elements.hpp>

namespace dynamy::dummy {

namespace fs = std::filesystem;

/// Loads `text` as the file m.xml with the dummy elements.
inline Model load(const std::string& text, const Overrides& set = {},
                  const fs::path& folder = ".") {
  Registry registry = dummy::registry();
  PluginLoader plugins((std::vector<fs::path>()));
  return loadModelText(text, "m.xml", registry, plugins, {.set = set}, folder);
}

/// All messages, or "".
inline std::string errors(const std::string& text, const Overrides& set = {},
                          const fs::path& folder = ".") {
  try {
    load(text, set, folder);
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

/// The first line of the first message: place, element, text and hint.
inline std::string firstError(const std::string& text, const Overrides& set = {}) {
  const std::string all = errors(text, set);
  return all.substr(0, all.find('\n'));
}

/// The model around one section; the section stands in line 2.
inline std::string around(const std::string& inside) {
  return "<dynamy version=\"1\">\n" + inside + "\n</dynamy>";
}
inline std::string inSystems(const std::string& inside) {
  return around("<systems>" + inside + "</systems>");
}

inline const Ball& ball(const Model& m, std::size_t i = 0) {
  return static_cast<const Ball&>(*m.systems().at(i));
}
inline const Stop& stop(const Model& m, std::size_t i = 0) {
  return static_cast<const Stop&>(*m.contacts().at(i));
}

}  // namespace dynamy::dummy
