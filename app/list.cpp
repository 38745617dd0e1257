/// dynamy list, dynamy describe NAME, dynamy schema: from the registry, plug-ins included.
#include <fmt/format.h>

#include <dynamy/io/describe.hpp>
#include <dynamy/io/json_writer.hpp>
#include <dynamy/io/schema.hpp>
#include <memory>

#include "program.hpp"

namespace dynamy::app {
namespace {

std::string json(const Registry& registry) {
  std::string out;
  JsonWriter j(out, 2);
  j.beginArray();
  for (const RegisteredType* t : registry.types())
    j.beginObject()
        .member("name", t->name)
        .member("kind", kindText(t->kind))
        .member("from", t->library)
        .member("about", t->attributes.aboutText())
        .endObject();
  j.endArray();
  return out + "\n";
}

void addPlugin(CLI::App& command, Program& program) {
  command.add_option("--plugin", program.libraries, "shared library with further types");
}

}  // namespace

void addList(CLI::App& app, Program& program) {
  auto asJson = std::make_shared<bool>(false);
  CLI::App* c = app.add_subcommand("list", "all types that models can use");
  addPlugin(*c, program);
  c->add_flag("--json", *asJson, "print JSON");
  c->callback([asJson, &program] {
    program.load();
    fmt::print("{}", *asJson ? json(program.registry) : listTypes(program.registry));
  });
}

void addDescribe(CLI::App& app, Program& program) {
  auto name = std::make_shared<std::string>();
  CLI::App* c = app.add_subcommand("describe", "what a type is, and its attributes");
  c->add_option("NAME", *name, "type, or a word of the model file")->required();
  addPlugin(*c, program);
  c->callback([name, &program] {
    program.load();
    fmt::print("{}", describe(program.registry, *name));
  });
}

void addSchema(CLI::App& app, Program& program) {
  CLI::App* c = app.add_subcommand("schema", "the XML schema of the model file, for editors");
  addPlugin(*c, program);
  c->callback([&program] {
    program.load();
    fmt::print("{}", schemaText(program.registry));
  });
}

}  // namespace dynamy::app
