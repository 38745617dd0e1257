#include <dlfcn.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <cstdlib>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/plugin_loader.hpp>
#include <system_error>

namespace dynamy {

namespace fs = std::filesystem;

PluginInfo frameworkFingerprint() {
  return {kPluginAbi,
          kVersionText,
          EIGEN_WORLD_VERSION,
          EIGEN_MAJOR_VERSION,
          EIGEN_MINOR_VERSION,
          EIGEN_MAX_ALIGN_BYTES,
          DYNAMY_COMPILER_TEXT,
          DYNAMY_STANDARD_LIBRARY_TEXT,
          "",
          "",
          nullptr};
}

namespace {

std::string text(const char* t) { return t == nullptr ? "?" : t; }

/// "0.1" of "0.1.7": what must agree before version 1.
std::string series(const std::string& version) {
  return version.substr(0, version.find('.', version.find('.') + 1));
}

std::string eigenVersion(const PluginInfo& p) {
  return std::to_string(p.eigenWorld) + '.' + std::to_string(p.eigenMajor) + '.' +
         std::to_string(p.eigenMinor);
}

/// Names of the libraries in a folder, as one writes them in a model.
std::vector<std::string> librariesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string file = it->path().filename().string();
    if (file.starts_with("lib") && file.ends_with(".so"))
      names.push_back(file.substr(3, file.size() - 6));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// What the dynamic linker said, without the words that the library around it adds.
std::string linkerReason(const std::string& what) {
  const std::string before = "dlerror system message: ";
  const std::size_t begin = what.find(before), end = what.rfind(')');
  if (begin == std::string::npos || end == std::string::npos) return what;
  return what.substr(begin + before.size(), end - begin - before.size());
}

/// A path is taken as it is; a name is searched.
bool isPath(const std::string& library) {
  const fs::path given(library);
  return given.has_parent_path() || given.extension() == ".so";
}

/// Keeps the library in memory whatever is closed later.
void pin(const fs::path& file) { ::dlopen(file.c_str(), RTLD_LAZY | RTLD_NODELETE | RTLD_NOLOAD); }

}  // namespace

std::string pluginMismatch(const PluginInfo& plugin, const PluginInfo& host) {
  const auto differ = [](const std::string& theirs, const std::string& ours,
                         const std::string& hint) {
    return "built with " + theirs + ", dynamy uses " + ours + " — " + hint;
  };
  const std::string rebuild = "rebuild it against this dynamy";
  if (plugin.abi != host.abi)
    return differ("plug-in interface " + std::to_string(plugin.abi), std::to_string(host.abi),
                  rebuild);
  if (series(text(plugin.frameworkVersion)) != series(text(host.frameworkVersion)))
    return differ("dynamy " + text(plugin.frameworkVersion), text(host.frameworkVersion), rebuild);
  if (eigenVersion(plugin) != eigenVersion(host))
    return differ("Eigen " + eigenVersion(plugin), eigenVersion(host),
                  "compile both with the same Eigen");
  if (plugin.eigenMaxAlignBytes != host.eigenMaxAlignBytes)
    return differ("Eigen alignment " + std::to_string(plugin.eigenMaxAlignBytes) + " bytes",
                  std::to_string(host.eigenMaxAlignBytes), "compile both with the same -march");
  if (text(plugin.standardLibrary) != text(host.standardLibrary))
    return differ(text(plugin.standardLibrary) + " (" + text(plugin.compiler) + ')',
                  text(host.standardLibrary) + " (" + text(host.compiler) + ')',
                  "compile both with the same standard library");
  if (plugin.name == nullptr || plugin.version == nullptr || plugin.registerElements == nullptr)
    return "its plug-in entry is incomplete — use the macro DYNAMY_PLUGIN";
  return {};
}

PluginLoader::PluginLoader() {
  if (const char* path = std::getenv("DYNAMY_PLUGIN_PATH")) {
    const std::string all = path;
    for (std::size_t begin = 0; begin <= all.size();) {
      const std::size_t end = std::min(all.find(':', begin), all.size());
      if (end > begin) folders_.emplace_back(all.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  boost::system::error_code error;
  const auto program = boost::dll::program_location(error);
  if (!error)
    folders_.push_back(fs::path(program.string()).parent_path().parent_path() / "lib" / "dynamy");
  const auto framework = boost::dll::symbol_location(frameworkFingerprint, error);
  if (!error) {
    const fs::path installed = fs::path(framework.string()).parent_path() / "dynamy";
    if (folders_.empty() || folders_.back() != installed) folders_.push_back(installed);
  }
}

std::vector<fs::path> PluginLoader::candidates(const std::string& library,
                                               const fs::path& modelFolder) const {
  const fs::path file = isPath(library) ? fs::path(library) : fs::path("lib" + library + ".so");
  if (file.is_absolute()) return {file};
  std::vector<fs::path> out;
  if (!modelFolder.empty()) out.push_back(modelFolder / file);
  for (const fs::path& folder : folders_) out.push_back(folder / file);
  return out;
}

fs::path PluginLoader::find(const std::string& library, const fs::path& modelFolder) const {
  const std::vector<fs::path> tried = candidates(library, modelFolder);
  std::error_code error;
  for (const fs::path& path : tried)
    if (fs::is_regular_file(path, error)) return fs::canonical(path);

  // Nothing there: every path tried, and the nearest name.
  std::vector<std::string> known;
  for (const fs::path& path : tried)
    for (std::string& name : librariesIn(path.parent_path()))
      if (std::find(known.begin(), known.end(), name) == known.end())
        known.push_back(std::move(name));
  Diagnostic d{.text = "no library \"" + library + '"',
               .hint = didYouMean(
                   nearest(isPath(library) ? fs::path(library).stem().string() : library, known))};
  std::vector<std::string> told;
  for (const fs::path& path : tried) {
    std::string text = "looked for " + fs::absolute(path).lexically_normal().string();
    if (std::find(told.begin(), told.end(), text) != told.end()) continue;
    d.notes.push_back({.text = text});
    told.push_back(std::move(text));
  }
  throw ModelError(std::move(d));
}

void PluginLoader::load(const std::string& library, const fs::path& modelFolder,
                        Registry& registry) {
  const fs::path file = find(library, modelFolder);
  for (const Loaded& l : loaded_)
    if (l.file == file) return;
  const std::string name = file.filename().string();

  // Load and pin; an undefined symbol is found now, not in the middle of a run.
  boost::dll::shared_library handle;
  try {
    handle.load(file.string(), boost::dll::load_mode::rtld_now);
  } catch (const std::exception& e) {
    throw ModelError(name + ": cannot be loaded: " + linkerReason(e.what()),
                     "was it built against dynamy " + versionString() + "?");
  }
  pin(file);
  if (!handle.has("dynamy_plugin_info"))
    throw ModelError(name + ": is no plug-in of dynamy",
                     "its source needs the line DYNAMY_PLUGIN(name, version, registerElements)");

  // The C struct first; C++ only if everything agrees.
  const PluginInfo* info = handle.get<const PluginInfo*()>("dynamy_plugin_info")();
  if (info == nullptr) throw ModelError(name + ": its plug-in entry is empty");
  if (const std::string why = pluginMismatch(*info, frameworkFingerprint()); !why.empty())
    throw ModelError(name + ": " + why);
  for (const Loaded& l : loaded_)
    if (l.name == info->name)
      throw ModelError(name + ": a plug-in named \"" + info->name + "\" is loaded already, from " +
                           l.file.string(),
                       "name one of them only, or rename one in its line DYNAMY_PLUGIN");
  loaded_.push_back({info->name, info->version, file});
  registry.library(info->name);
  info->registerElements(registry);
}

}  // namespace dynamy
