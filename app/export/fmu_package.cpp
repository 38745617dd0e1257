#include "export/fmu_package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <dynamy/core/hash.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <functional>
#include <set>

#include "export/fmu_description.hpp"
#include "export/needed_libraries.hpp"

namespace dynamy::app {
namespace {

namespace fs = std::filesystem;
using fmu::Role;

#if defined(__aarch64__)
constexpr const char* kPlatform = "binaries/aarch64-linux/";
#else
constexpr const char* kPlatform = "binaries/x86_64-linux/";
#endif
constexpr double kSamples = 500.0;  ///< steps of communication of a run, if the model names none

/// A name of C made of that of a file.
std::string identifierOf(const fs::path& model) {
  std::string out;
  for (const char c : model.stem().string()) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9';
    if (digit && out.empty()) out += '_';
    out += letter || digit ? c : '_';
  }
  return out;
}

/// A file of the model with those that it includes and those that elements name; absolute. A library
/// is among them if the model names it by its path.
void collectFiles(const fs::path& model, const PluginLoader& plugins, std::set<fs::path>& files) {
  if (!files.insert(model).second) return;
  const XmlDocument document = XmlDocument::read(model);
  const fs::path folder = model.parent_path();
  std::error_code error;
  const std::function<void(const XmlNode&)> visit = [&](const XmlNode& node) {
    for (const XmlNode& child : node.children) visit(child);
    if (const XmlAttribute* a = node.attribute("file"); a != nullptr && !a->value.empty())
      if (const fs::path file = (folder / a->value).lexically_normal();
          fs::is_regular_file(file, error)) {
        if (node.tag == "include")
          collectFiles(file, plugins, files);
        else
          files.insert(file);
      }
    const XmlAttribute* library = node.tag == "plugin" ? node.attribute("library") : nullptr;
    if (library == nullptr || library->value.find('/') == std::string::npos) return;
    for (const PluginLoader::Loaded& l : plugins.loaded())
      if (fs::equivalent(l.file, folder / library->value, error))
        files.insert((folder / library->value).lexically_normal());
  };
  visit(document.root());
}

/// The deepest folder that holds all these files.
fs::path commonFolder(const std::set<fs::path>& files) {
  fs::path out = files.begin()->parent_path();
  for (const fs::path& file : files)
    while (!out.empty() && out != out.root_path() &&
           std::mismatch(out.begin(), out.end(), file.begin(), file.end()).first != out.end())
      out = out.parent_path();
  return out;
}

/// The variables of a model: time, its parameters, inputs and signals.
std::vector<fmu::Variable> variablesOf(const Model& model, const FmuTask& task,
                                       const std::map<std::string, double>& parameters) {
  std::vector<fmu::Variable> out;
  std::set<std::string> names{"time"};
  const auto add = [&](fmu::Variable v) {
    if (!names.insert(v.name).second) names.insert(v.name += v.role == Role::input ? ".in" : "'");
    out.push_back(std::move(v));
  };
  out.push_back({Role::time, "time", "time", "s", "time of the simulation", 0.0});
  for (const auto& [name, value] : parameters)
    add({Role::parameter, name, name, "", "parameter of the model", value});
  const State start = model.initialState();
  for (const auto& f : model.forces())
    if (f->type() == "Input")
      add({Role::input, f->name(), f->name(), "", "input of the model",
           start.memory[model.topology().memories().of(*f).first]});
  const std::vector<std::string>& signals =
      task.signals.empty() ? model.record.signals : task.signals;
  const auto places = task.signals.empty() ? model.record.places : std::vector<Place>{};
  for (const NamedSignal* s : chooseSignals(model, signals, places)) {
    const std::string unit(unitText(s->signal.unit));
    add({fmu::isStatus(*s) ? Role::status : Role::output, s->name, s->name, unit == "-" ? "" : unit,
         std::string(s->signal.text), 0.0});
  }
  return out;
}

/// Adds libdynamy, the plug-ins and, if wanted, the libraries of the system; returns the text about
/// those that are not in the package.
std::string addLibraries(ZipFile& zip, const PluginLoader& plugins, bool all) {
  const NeededLibrary own = frameworkLibrary();
  zip.addFile(kPlatform + own.name, own.file);
  for (const PluginLoader::Loaded& l : plugins.loaded())
    zip.addFile(kPlatform + ("dynamy/" + l.file.filename().string()), l.file);
  std::string missing;
  for (const NeededLibrary& l : librariesOfFramework()) {
    const bool carried = all && !l.ofSystem;
    if (carried) zip.addFile(kPlatform + l.name, l.file);
    if (!carried && l.direct) missing += l.name + '\n';
  }
  return "Shared libraries that the system has to provide:\n" + missing;
}

FmuHead headOf(const Model& model, const std::string& identifier) {
  FmuHead head;
  head.identifier = identifier, head.title = model.title;
  head.text = model.doc.substr(0, model.doc.find('\n'));
  head.until = model.simulation.until, head.tolerance = model.simulation.tolerance;
  head.step = model.record.every > 0.0 ? model.record.every : head.until / kSamples;
  if (!(head.tolerance > 0.0)) head.fixedStep = model.simulation.step;
  return head;
}

}  // namespace

FmuResult fmuPackage(Program& program, const FmuTask& task) {
  std::map<std::string, double> parameters;
  LoadOptions options;
  options.set = assignments(task.set);
  options.parameters = &parameters;
  for (const std::string& signal : task.signals)
    if (!signal.ends_with('*')) options.signals.push_back(signal);
  Model model = loadModel(task.model, program.registry, program.plugins, options);
  { const Simulation check(model); }  // an FMU that cannot run is none
  FmuResult out;
  out.identifier = identifierOf(task.model);

  // The model with its files, as they lie to each other.
  std::set<fs::path> files;
  collectFiles(fs::absolute(task.model).lexically_normal(), program.plugins, files);
  const fs::path folder = commonFolder(files);
  for (const fs::path& file : files)
    out.zip.addFile("resources/model/" + file.lexically_relative(folder).generic_string(), file);

  const std::string missing = addLibraries(out.zip, program.plugins, task.allLibraries);
  out.zip.add("documentation/externalDependencies.txt", missing);
  const fs::path library =
      frameworkLibrary().file.parent_path() / "dynamy" / "fmu" / "dynamy_fmu.so";
  if (!fs::exists(library))
    throw ModelError("the library of FMUs is not built: no file " + library.string(),
                     "in a clone scripts/build-release dynamy plugins builds it");
  out.zip.addFile(kPlatform + (out.identifier + ".so"), library);

  fmu::FmuContents contents;
  contents.model =
      fs::absolute(task.model).lexically_normal().lexically_relative(folder).generic_string();
  contents.set = options.set;
  contents.variables = variablesOf(model, task, parameters);
  for (const fmu::Variable& v : contents.variables) {
    out.parameters += v.role == Role::parameter ? 1 : 0,
        out.inputs += v.role == Role::input ? 1 : 0;
    out.outputs += v.role == Role::output || v.role == Role::status ? 1 : 0;
  }
  // The token changes with every file, so that no library takes the description of another FMU.
  Hash hash;
  hash.addBytes(contents.json());
  for (const auto& [name, content] : out.zip.files()) hash.addBytes(name), hash.addBytes(content);
  contents.token = fmt::format("{{{:016x}}}", hash.value());
  out.zip.add("resources/contents.json", contents.json());
  out.zip.add("modelDescription.xml", fmuDescription(headOf(model, out.identifier), contents));
  return out;
}

}  // namespace dynamy::app
