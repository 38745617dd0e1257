/// dynamy list, dynamy describe NAME, dynamy schema: print the registry, including plug-ins.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/reference/describe.hpp>
#include <dynamy/io/reference/reference_pages.hpp>
#include <dynamy/io/reference/schema.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <filesystem>
#include <memory>

#include "program.hpp"

namespace dynamy::app {
namespace {

std::vector<std::string> kindTexts() {
  std::vector<std::string> all;
  for (const Kind kind :
       {Kind::system, Kind::contact, Kind::force, Kind::law, Kind::shape, Kind::rule, Kind::scheme,
        Kind::solver, Kind::impact, Kind::observer, Kind::part})
    all.emplace_back(kindText(kind));
  return all;
}

/// "Laws" → "law": kinds are understood in any case and in the plural.
std::string singular(std::string kind) {
  const std::vector<std::string> all = kindTexts();
  for (const std::string& k : all)
    if (typingDistance(k, kind) == 0 || typingDistance(k + "s", kind) == 0) return k;
  return kind;
}

/// Types of one kind; all types if `kind` is empty.
std::vector<const RegisteredType*> typesOf(const Registry& registry, const std::string& kind) {
  std::vector<const RegisteredType*> types = registry.types();
  std::erase_if(
      types, [&](const RegisteredType* t) { return !kind.empty() && kindText(t->kind) != kind; });
  return types;
}

/// Names, one per line, for scripts; if `kind` is empty also the words of the model file.
std::string names(const Registry& registry, const std::string& kind) {
  std::string out;
  for (const RegisteredType* t : typesOf(registry, kind)) out += t->name + "\n";
  const Vocabulary vocabulary;
  if (kind.empty())
    for (const Word& word : vocabulary.words()) out += word.name + "\n";
  return out;
}

std::string json(const Registry& registry, const std::string& kind) {
  std::string out;
  JsonWriter j(out, 2);
  j.beginArray();
  for (const RegisteredType* t : typesOf(registry, kind))
    j.beginObject()
        .member("name", t->name)
        .member("kind", kindText(t->kind))
        .member("from", t->library)
        .member("about", t->attributes.aboutText())
        .endObject();
  j.endArray();
  return out + "\n";
}

/// The line below all types: where more of them are; "" if nowhere.
std::string moreTypes(const PluginLoader& plugins) {
  const std::vector<std::string> names = plugins.available();
  return names.empty() ? ""
                       : fmt::format("\nPlug-ins bring more, dynamy list --plugin NAME: {}\n",
                                     fmt::join(names, ", "));
}

/// Loads the libraries of the user's folders until one of them brings the type `name`.
void loadTypeOf(const std::string& name, Program& program) {
  if (name.empty() || program.registry.find(name) != nullptr) return;
  for (const std::string& library : program.plugins.available()) {
    Registry types;  // of this library alone: a faulty one shall not matter
    try {
      PluginLoader(program.plugins).load(library, types);
    } catch (const ModelError&) {
      continue;
    }
    if (types.find(name) == nullptr) continue;
    program.plugins.load(library, program.registry);
    return;
  }
}

}  // namespace

void addList(CLI::App& app, Program& program) {
  struct Form {
    bool json = false, names = false;
    std::string kind;
  };
  auto form = std::make_shared<Form>();
  CLI::App* c = app.add_subcommand("list", "all types that models can use");
  addPlugins(*c, program, false);
  c->add_option("--kind", form->kind, "types of this kind only")
      ->type_name("KIND")
      ->transform([](const std::string& kind) { return singular(kind); })
      ->check(CLI::IsMember(kindTexts()));
  c->add_flag("--names", form->names, "print names only");
  c->add_flag("--json", form->json, "print JSON");
  c->callback([form, &program] {
    program.load();
    if (form->json)
      fmt::print("{}", json(program.registry, form->kind));
    else if (form->names)
      fmt::print("{}", names(program.registry, form->kind));
    else
      fmt::print("{}{}", listTypes(typesOf(program.registry, form->kind)),
                 form->kind.empty() ? moreTypes(program.plugins) : "");
  });
}

void addDescribe(CLI::App& app, Program& program) {
  struct What {
    std::string name, pages;
  };
  auto what = std::make_shared<What>();
  CLI::App* c = app.add_subcommand("describe", "what a type is, and its attributes");
  CLI::Option* name = c->add_option("NAME", what->name, "type, or a word of the model file");
  c->add_option("--pages", what->pages, "write all of it as Markdown pages into DIR")
      ->type_name("DIR")
      ->excludes(name);
  addPlugins(*c, program, false);
  c->callback([what, &program] {
    if (what->name.empty() && what->pages.empty()) throw CLI::RequiredError("NAME or --pages");
    program.load();
    loadTypeOf(what->name, program);
    if (what->pages.empty()) {
      fmt::print("{}", describe(program.registry, what->name));
      return;
    }
    std::filesystem::create_directories(what->pages);
    for (const ReferencePage& page : referencePages(program.registry))
      writeWholeFile(std::filesystem::path(what->pages) / page.file, page.text);
  });
}

void addSchema(CLI::App& app, Program& program) {
  CLI::App* c = app.add_subcommand("schema", "the XML schema of the model file, for editors");
  addPlugins(*c, program, false);
  c->callback([&program] {
    program.load();
    fmt::print("{}", schemaText(program.registry));
  });
}

}  // namespace dynamy::app
