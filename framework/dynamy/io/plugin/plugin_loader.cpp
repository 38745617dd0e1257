#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <cstdlib>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/plugin/plugin_entry.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <system_error>

namespace dynamy {

namespace fs = std::filesystem;

namespace {

/// Names of the libraries in a folder, as they are written in a model.
std::vector<std::string> librariesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error, none;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string file = it->path().filename().string();
    if (file.starts_with("lib") && file.ends_with(".so") && it->is_regular_file(none))
      names.push_back(file.substr(3, file.size() - 6));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// True if the text is a path: it holds a '/'. Any other text is a name that is searched, as in a
/// shell.
bool isPath(const std::string& library) { return library.find('/') != std::string::npos; }

/// The file name of a library: "my_elements" and "libmy_elements.so" both give libmy_elements.so.
fs::path fileOf(const std::string& library) {
  return isPath(library) || library.ends_with(".so") ? library : "lib" + library + ".so";
}

void append(std::vector<fs::path>& to, const std::vector<fs::path>& folders, const fs::path& file) {
  for (const fs::path& folder : folders) to.push_back(folder / file);
}

/// True if a library is directly in one of these folders.
bool isIn(const std::vector<fs::path>& folders, const fs::path& file) {
  std::error_code error;
  const fs::path folder = fs::canonical(file.parent_path(), error);
  return !error && std::any_of(folders.begin(), folders.end(), [&](const fs::path& f) {
    return fs::canonical(f, error) == folder && !error;
  });
}

/// Text about a file that was tried and not loaded.
std::string lookedFor(const fs::path& path) {
  std::error_code error;
  std::string text = "looked for " + fs::absolute(path).lexically_normal().string();
  if (fs::is_directory(path, error)) return text + ", which is a folder";
  return fs::exists(path, error) ? text + ", which is no file" : text;
}

/// Throws ModelError for a missing library, with every path tried and the nearest name, unless
/// there is better advice.
[[noreturn]] void throwMissing(const std::string& library, const std::vector<fs::path>& tried,
                               std::string advice = {}) {
  std::vector<std::string> known;
  for (const fs::path& path : tried)
    for (std::string& name : librariesIn(path.parent_path()))
      if (std::find(known.begin(), known.end(), name) == known.end())
        known.push_back(std::move(name));
  if (advice.empty()) advice = didYouMean(nearest(nameOfLibrary(library), known));
  if (advice.empty())
    advice = "build it (one of dynamY's own: scripts/build-release " + nameOfLibrary(library) +
             "), and put it where it is looked for, or name its folder in DYNAMY_PLUGIN_PATH";
  Diagnostic d{.text = "no library \"" + library + '"', .hint = std::move(advice)};
  std::vector<std::string> told;
  for (const fs::path& path : tried) {
    std::string text = lookedFor(path);
    if (std::find(told.begin(), told.end(), text) != told.end()) continue;
    d.notes.push_back({.text = text});
    told.push_back(std::move(text));
  }
  throw ModelError(std::move(d));
}

/// Advice if the library that the user named is not found; libraries in the current folder are
/// never found by name. Empty: no special advice.
std::string adviceFor(const std::string& library) {
  if (library == kStandardElements) return "install dynamY again: its own elements are missing";
  std::error_code error;
  const bool here = !isPath(library) && fs::is_regular_file(fileOf(library), error);
  return here ? "the one in the current folder is ./" + fileOf(library).string() : "";
}

/// The first path that is a regular file; empty: none is.
fs::path firstFile(const std::vector<fs::path>& paths) {
  std::error_code error;
  for (const fs::path& path : paths)
    if (fs::is_regular_file(path, error)) return path;
  return {};
}

}  // namespace

PluginLoader::PluginLoader() : readsConfiguration_(true) {
  if (const char* path = std::getenv("DYNAMY_PLUGIN_PATH")) {
    const std::string all = path;
    for (std::size_t begin = 0; begin <= all.size();) {
      const std::size_t end = std::min(all.find(':', begin), all.size());
      if (end > begin) own_.emplace_back(all.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  boost::system::error_code error;
  const auto framework = boost::dll::symbol_location(frameworkFingerprint, error);
  if (!error) installed_.push_back(fs::absolute(framework.string()).parent_path() / "dynamy");
  const auto program = boost::dll::program_location(error);
  if (error) return;
  const fs::path beside = fs::path(program.string()).parent_path().parent_path() / "lib" / "dynamy";
  if (installed_.empty() || installed_.back() != beside) installed_.push_back(beside);
}

PluginLoader::PluginLoader(std::vector<fs::path> folders) : installed_(std::move(folders)) {}

std::vector<std::string> PluginLoader::available() const {
  std::vector<std::string> out;
  for (const auto* folders : {&own_, &installed_})
    for (const fs::path& folder : *folders)
      for (std::string& name : librariesIn(folder))
        if (name != kStandardElements &&
            std::none_of(loaded_.begin(), loaded_.end(),
                         [&](const Loaded& l) { return l.name == name; }))
          out.push_back(std::move(name));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::string PluginLoader::libraryOf(std::string_view type) const {
  constexpr std::size_t kShortest = 4;  // shorter names begin many words
  std::string found;
  for (std::string& name : available()) {
    std::string letters = name;
    std::erase(letters, '_');
    const bool begins = letters.size() >= kShortest && type.size() >= letters.size() &&
                        typingDistance(type.substr(0, letters.size()), letters) == 0;
    if (begins && letters.size() > found.size()) found = std::move(name);
  }
  return found;
}

std::vector<fs::path> PluginLoader::candidates(const std::string& library) const {
  const fs::path file = fileOf(library);
  if (isPath(library)) return {file};
  std::vector<fs::path> out;
  if (library != kStandardElements) append(out, own_, file);
  append(out, installed_, file);
  return out;
}

std::vector<fs::path> PluginLoader::candidates(const std::string& library,
                                               const fs::path& modelFolder) const {
  if (isPath(library)) return {modelFolder / library};
  std::vector<fs::path> out = candidates(library);
  if (library != kStandardElements) out.push_back(modelFolder / fileOf(library));
  return out;
}

bool PluginLoader::isLoaded(const fs::path& file) const {
  return std::any_of(loaded_.begin(), loaded_.end(),
                     [&](const Loaded& l) { return l.file == file; });
}

void PluginLoader::load(const std::string& library, Registry& registry) {
  const std::vector<fs::path> tried = candidates(library);
  const fs::path file = firstFile(tried);
  if (file.empty()) throwMissing(library, tried, adviceFor(library));
  open(fs::canonical(file), true, registry);
}

void PluginLoader::load(const std::string& library, const fs::path& modelFolder,
                        Registry& registry) {
  const std::string name = nameOfLibrary(library);
  for (const Loaded& l : loaded_)
    if (l.chosen && !isPath(library) && nameOfLibrary(l.file.string()) == name) return;
  const std::vector<fs::path> tried = candidates(library, modelFolder);
  const fs::path file = firstFile(tried);
  if (file.empty()) throwMissing(library, tried);
  if (isLoaded(fs::canonical(file))) return;
  if (!isIn(own_, file) && !isIn(installed_, file))
    requireTrust(file, "library",
                 "name it: --plugin " + fs::absolute(file).lexically_normal().string());
  open(fs::canonical(file), false, registry);
}

void PluginLoader::requireTrust(const fs::path& file, const std::string& what,
                                const std::string& ifOwn) const {
  const fs::path folder = fs::canonical(fs::absolute(file).parent_path());
  const fs::path list = readsConfiguration_ ? trustFile() : fs::path();
  const TrustedFolders configured = TrustedFolders::of(list);
  if (!trustsModels_ && !trusted_.holds(folder) && !configured.holds(folder)) {
    Diagnostic d{.text = "the " + what + ' ' + (folder / file.filename()).string() +
                         " comes with the model; its code runs only if you trust it",
                 .hint = "add " + howToTrust_};
    if (!list.empty()) d.hint += ", or the line " + folder.string() + " to " + list.string();
    d.notes = configured.notes();
    throw ModelError(std::move(d));
  }
  const std::string here = (folder / file.filename()).string();
  if (const std::string who = writableByOthers(here); !who.empty())
    throw ModelError("the " + what + ' ' + here + " comes with the model, and " + who +
                         ", so that it may be anybody's",
                     "if it is yours, " + ifOwn);
}

void PluginLoader::load(const Fingerprint& library, Registry& registry) {
  for (const Loaded& l : loaded_) {
    if (nameOfLibrary(l.file.string()) != library.name) continue;
    if (fingerprintOf(l.file) == library.fingerprint) return;
    throw ModelError("the library " + l.file.string() +
                         " is not the one that was used (fingerprint " + fingerprintOf(l.file) +
                         ", not " + library.fingerprint + ')',
                     "name that one: --plugin PATH");
  }
  std::string others;
  const std::vector<fs::path> tried = candidates(fileOf(library.name).string());
  std::error_code error;
  for (const fs::path& path : tried) {
    if (isPath(library.name) || !fs::is_regular_file(path, error)) continue;
    const std::string found = fingerprintOf(path);
    if (found == library.fingerprint) return open(fs::canonical(path), false, registry);
    others += (others.empty() ? "" : ", ") + path.string() + " (" + found + ')';
  }
  throw ModelError(
      others.empty()
          ? "the library \"" + library.name + "\" that was used is in none of your folders"
          : "the library \"" + library.name + "\" that was used had the fingerprint " +
                library.fingerprint + "; there is only " + others,
      "name it: --plugin PATH, or put its folder into DYNAMY_PLUGIN_PATH");
}

std::vector<Fingerprint> PluginLoader::fingerprints() const {
  std::vector<Fingerprint> out;
  for (const Loaded& l : loaded_)
    if (nameOfLibrary(l.file.string()) != kStandardElements)
      out.push_back({nameOfLibrary(l.file.string()), fingerprintOf(l.file)});
  return out;
}

void PluginLoader::open(const fs::path& file, bool chosen, Registry& registry) {
  for (Loaded& l : loaded_) {
    if (l.file != file) continue;
    l.chosen = l.chosen || chosen;
    return;
  }
  // The C struct is checked first; C++ is called only if everything agrees.
  const std::string name = file.filename().string();
  const PluginInfo& info = openPlugin(file);
  for (const Loaded& l : loaded_)
    if (l.name == info.name)
      throw ModelError(name + ": a plug-in named \"" + info.name + "\" is loaded already, from " +
                           l.file.string(),
                       "name one of them only, or rename one in its line DYNAMY_PLUGIN");
  loaded_.push_back({info.name, info.version, file, chosen});
  registry.library(info.name);
  try {
    info.registerElements(registry);
  } catch (const ModelError&) {
    throw;
  } catch (const std::exception& e) {
    throw ModelError(name + ": its registration failed: " + e.what());
  } catch (...) {
    throw ModelError(name + ": its registration threw something that is no std::exception");
  }
}

}  // namespace dynamy
