/// dynamy new-plugin NAME --kind KIND: writes a folder with a plug-in that builds, runs and passes
/// its test without changes. All texts come from app/templates.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <cctype>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <filesystem>
#include <memory>

#include "page.hpp"
#include "paths.hpp"
#include "program.hpp"
#include "shell_text.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

struct PluginTexts {
  std::string name, kind, out;
};

struct KindText {
  const char *kind, *about;
};
constexpr std::array kKinds{
    KindText{"system", "a mechanical system in coordinates of its own, here a pendulum."},
    KindText{"contact",
             "a contact given by its gap and relative velocity, here a pendulum's wall."},
    KindText{"force", "a force on frames, here the drag of air."},
    KindText{"law", "a set-valued force law, here friction that is stronger in one direction."},
    KindText{"scheme", "a time-stepping scheme, here velocities first, then positions."},
    KindText{"solver", "a solver of inclusions, here a fixed-point iteration."},
    KindText{"observer", "an observer of all steps, here a sum of percussions."},
    KindText{"shape", "a shape with its pairs on half spaces and balls, here a hollow ball."},
    KindText{"smooth_shape", "a smooth shape that touches all others, here a pebble."}};

/// Names that are reserved by cmake or the headers of dynamY.
constexpr std::array kTaken{"all",        "attributes",     "clean",      "element",  "frame",
                            "help",       "install",        "kinematics", "model",    "observer",
                            "one_step",   "package",        "registry",   "shape",    "state",
                            "simulation", "simple_contact", "test",       "topology", "unit"};

/// "SlidingDoor", "sliding-door", "sliding_door" → "sliding_door".
std::string snake(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0 && !out.empty() && out.back() != '_')
      out += '_';
    out += c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

/// "sliding_door" → "SlidingDoor".
std::string camel(const std::string& snakeName) {
  std::string out;
  bool up = true;
  for (const char c : snakeName) {
    if (c != '_') out += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    up = c == '_';
  }
  return out;
}

void checkName(const Program& program, const std::string& given) {
  const auto fail = [&](const std::string& why) {
    throw CLI::ValidationError("PLUGIN", '"' + given + "\": " + why);
  };
  if (given.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") !=
          std::string::npos ||
      given.empty() || std::isalpha(static_cast<unsigned char>(given[0])) == 0)
    fail("a name has letters, digits, - and _, and begins with a letter; --out names the folder");
  const std::string name = snake(given);
  for (const char* taken : kTaken)
    if (name == taken) fail("is a word of cmake or dynamY; choose another one");
  if (const RegisteredType* type = program.registry.find(camel(name)))
    fail("the type " + type->name + " exists already in the library \"" + type->library + '"');
}

const KindText& kindOf(const std::string& kind) {
  std::vector<std::string> known;
  for (const KindText& k : kKinds) {
    if (kind == k.kind) return k;
    known.emplace_back(k.kind);
  }
  throw CLI::ValidationError("--kind",
                             "no kind \"" + kind + "\" — " + unknownNameHint(kind, known));
}

void newPlugin(Program& program, const PluginTexts& t) {
  const KindText& kind = kindOf(t.kind);
  program.load();
  checkName(program, t.name);
  const std::string name = snake(t.name);
  const fs::path folder = t.out.empty() ? fs::path(name) : fs::path(t.out);
  std::error_code error;
  if (fs::exists(folder, error) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw FileError(folder.string(), "exists already; nothing in it was touched");
  fs::create_directories(folder, error);
  if (error) throw FileError(folder.string(), "cannot create the folder: " + error.message());
  const std::array<std::pair<std::string, std::string>, 5> kFiles{
      {{"CMakeLists.txt.in", "CMakeLists.txt"},
       {t.kind + ".cpp.in", name + ".cpp"},
       {t.kind + ".xml.in", name + ".xml"},
       {"test.cpp.in", name + "_test.cpp"},
       {"README.md.in", "README.md"}}};
  for (const auto& [from, to] : kFiles) {
    const Values values{{"name", name}, {"Class", camel(name)}, {"about", kind.about}};
    writeWholeFile(folder / to, filled(pageFile(from), values));
  }
  const std::string dir = shellWord(folder.string());
  fmt::print(
      " wrote   {0}/  CMakeLists.txt {1}.cpp {1}.xml {1}_test.cpp README.md\n\n"
      "   cmake -S {0} -B {0}/build && cmake --build {0}/build\n"
      "   DYNAMY_PLUGIN_PATH={0}/build dynamy run {0}/{1}.xml\n"
      "   ctest --test-dir {0}/build --output-on-failure\n",
      dir, name);
}

}  // namespace

void addNewPlugin(CLI::App& app, Program& program) {
  auto t = std::make_shared<PluginTexts>();
  CLI::App* c =
      app.add_subcommand("new-plugin", "write a plug-in that builds, runs and passes its test");
  c->add_option("PLUGIN", t->name,
                "of the library, e.g. sliding_door; the type is then SlidingDoor")
      ->required();
  c->add_option("--kind", t->kind,
                "system, contact, force, law, scheme, solver, observer, shape or smooth_shape")
      ->required();
  c->add_option("--out", t->out, "folder to write; default: NAME")
      ->type_name("DIR")
      ->check(someName());
  c->callback([t, &program] { newPlugin(program, *t); });
}

}  // namespace dynamy::app
