#include <fmt/format.h>

#include <dynamy/io/reference/declaration_text.hpp>
#include <dynamy/io/reference/reference_pages.hpp>
#include <dynamy/io/xml/vocabulary.hpp>

namespace dynamy {
namespace {

const char* titleOf(Kind kind) {
  switch (kind) {
    case Kind::system:
      return "Systems";
    case Kind::contact:
      return "Contacts and joints";
    case Kind::force:
      return "Forces";
    case Kind::law:
      return "Force laws";
    case Kind::shape:
      return "Shapes";
    case Kind::rule:
      return "Rules between materials";
    case Kind::scheme:
      return "Schemes";
    case Kind::solver:
      return "Solvers";
    case Kind::impact:
      return "Impact laws";
    case Kind::observer:
      return "Observers";
    case Kind::part:
      return "Parts of systems";
  }
  return "Elements";
}

/// Escapes the text of a declaration outside of code, so that it forms no tags or table cells by
/// accident.
std::string prose(const std::string& text) {
  std::string out;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (!code && (c == '<' || c == '*' || c == '|')) out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

/// Formats code inside of a table.
std::string code(const std::string& text) {
  if (text == "-") return "";
  std::string out = "`";
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out + '`';
}

std::string attributeTable(const Attributes& a) {
  if (a.list().empty()) return {};
  std::string out =
      "\n| attribute | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";
  for (const Attribute& x : a.list()) {
    const std::string unit(unitText(x.unit));
    const std::string standard = defaultText(x);
    out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", x.name,
                       x.choices.empty() || x.type == AttributeType::vector ? prose(typeText(x))
                                                                            : code(typeText(x)),
                       unit == "-" ? "" : prose(unit),
                       standard == "required" ? "**required**" : code(standard),
                       rangeText(x) == "-" ? "" : prose(rangeText(x)), prose(x.text));
  }
  return out;
}

std::string exampleBlock(const Attributes& a) {
  return a.exampleText().empty() ? "" : "\n```xml\n" + a.exampleText() + "\n```\n";
}

std::string link(const RegisteredType& t) {
  return fmt::format("[`<{}>`]({}.md#{})", t.name, kindText(t.kind), t.name);
}

class Pages {
 public:
  explicit Pages(const Registry& registry) : types_(registry.types()) {}

  std::vector<ReferencePage> all() {
    std::vector<ReferencePage> out{{"index.md", index()}, {"model_file.md", modelFile()}};
    const RegisteredType* before = nullptr;
    for (const RegisteredType* t : types_) {
      if (before == nullptr || before->kind != t->kind)
        out.push_back({std::string(kindText(t->kind)) + ".md",
                       "# " + std::string(titleOf(t->kind)) + "\n\n" + kMade});
      out.back().text += section(*t);
      before = t;
    }
    return out;
  }

 private:
  static constexpr const char* kMade = "<!-- made by: dynamy describe --pages -->\n";

  std::string index() const {
    std::string out = "# Reference\n\n" + std::string(kMade) +
                      "\nEverything a model file can say; `dynamy describe NAME` prints "
                      "the same. Numbers are SI; suffixes such as `5mm` work.\n\n"
                      "* [Words of the model file](model_file.md)\n";
    const RegisteredType* before = nullptr;
    for (const RegisteredType* t : types_) {
      if (before != nullptr && before->kind == t->kind)
        out += " · ";
      else
        out += fmt::format("{}* [{}]({}.md): ", before == nullptr ? "" : "\n", titleOf(t->kind),
                           kindText(t->kind));
      out += link(*t);
      before = t;
    }
    out += '\n';
    return out;
  }

  std::string section(const RegisteredType& t) const {
    std::string out = fmt::format("\n<a id=\"{0}\"></a>\n## {0}\n", t.name);
    if (!t.attributes.aboutText().empty()) out += '\n' + prose(t.attributes.aboutText()) + '\n';
    out += attributeTable(t.attributes);
    std::string children;
    for (const ChildRule& rule : t.attributes.children()) {
      std::string names;
      for (const RegisteredType* c : types_)
        if (c->kind == rule.kind && (rule.only.empty() || rule.only == c->name))
          names += (names.empty() ? "" : ", ") + link(*c);
      children += fmt::format("* {} {}: {}{}\n", countText(rule), kindText(rule.kind),
                              prose(rule.text), names.empty() ? "" : " (" + names + ")");
    }
    if (!children.empty()) out += "\nInside:\n\n" + children;
    return out + exampleBlock(t.attributes);
  }

  std::string modelFile() const {
    std::string out = "# Words of the model file\n\n" + std::string(kMade);
    const Vocabulary vocabulary;
    for (const Word& w : vocabulary.words()) {
      out += fmt::format("\n<a id=\"{0}\"></a>\n## {0}\n\n{1}\n", w.name,
                         prose(w.attributes.aboutText()));
      out += attributeTable(w.attributes);
      std::string inside;
      for (const std::string& child : w.children)
        inside += fmt::format("{}[`<{}>`](#{})", inside.empty() ? "" : ", ", child, child);
      for (const Kind kind : w.kinds)
        if (hasTypes(kind))
          inside += fmt::format("{}[{}]({}.md)", inside.empty() ? "" : ", ", titleOf(kind),
                                kindText(kind));
      if (!inside.empty()) out += "\nInside: " + inside + "\n";
      out += exampleBlock(w.attributes);
    }
    return out;
  }

  bool hasTypes(Kind kind) const {
    for (const RegisteredType* t : types_)
      if (t->kind == kind) return true;
    return false;
  }

  std::vector<const RegisteredType*> types_;
};

}  // namespace

std::vector<ReferencePage> referencePages(const Registry& registry) {
  return Pages(registry).all();
}

}  // namespace dynamy
