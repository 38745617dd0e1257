/// Complex types of the schema: `word.x` for words and `type.X` for registered types, with
/// attributes and children; `default.X` for registered types, with the attributes alone. Rejected:
/// global elements and xs:any, with which an editor would suggest what the loader refuses.

#include <fmt/format.h>

#include <algorithm>
#include <dynamy/io/reference/declaration_text.hpp>
#include <dynamy/io/reference/schema.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <dynamy/io/xml/xml.hpp>

namespace dynamy {
namespace {

class SchemaWriter {
 public:
  explicit SchemaWriter(const Registry& registry) : types_(registry.types()) {}

  std::string write() {
    out_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n"
        "  <xs:element name=\"dynamy\" type=\"word.dynamy\"/>\n"
        "  <xs:simpleType name=\"braces\">\n"
        "    <xs:restriction base=\"xs:string\"><xs:pattern value=\".*\\{.*\\}.*\"/>"
        "</xs:restriction>\n"
        "  </xs:simpleType>\n";
    for (const Word& word : vocabulary_.words()) writeWord(word);
    for (const RegisteredType* type : types_) {
      writeType(*type, false);
      writeType(*type, true);
    }
    return out_ + "</xs:schema>\n";
  }

 private:
  void writeWord(const Word& word) {
    begin("word." + word.name, word.attributes, word.text);
    std::vector<std::string> children;
    for (const std::string& child : word.children) children.push_back(element(child, "word"));
    for (const RegisteredType* t : types_) {
      if (word.name == "defaults") children.push_back(element(t->name, "default"));
      if (std::find(word.kinds.begin(), word.kinds.end(), t->kind) != word.kinds.end())
        children.push_back(element(t->name, "type"));
    }
    if (word.name == "defaults") children.push_back(element("doc", "word"));
    choice(children);
    attributes(word.attributes, true);
    end();
  }

  void writeType(const RegisteredType& type, bool asDefault) {
    begin((asDefault ? "default." : "type.") + type.name, type.attributes, false);
    if (!asDefault) {
      std::vector<std::string> children{element("doc", "word")};
      for (const RegisteredType* t : types_)
        for (const ChildRule& rule : type.attributes.children())
          if (t->kind == rule.kind && (rule.only.empty() || rule.only == t->name))
            children.push_back(element(t->name, "type"));
      std::sort(children.begin(), children.end());
      children.erase(std::unique(children.begin(), children.end()), children.end());
      if (!type.attributes.children().empty()) children.push_back(element("replicate", "word"));
      choice(children);
    }
    attributes(type.attributes, false);
    for (const char* common : {"name", "class"})
      if (type.attributes.find(common) == nullptr && (!asDefault || common[0] == 'c'))
        out_ += fmt::format("    <xs:attribute name=\"{}\" type=\"xs:string\"/>\n", common);
    end();
  }

  void begin(const std::string& name, const Attributes& a, bool mixed) {
    out_ += fmt::format("  <xs:complexType name=\"{}\"{}>\n", name, mixed ? " mixed=\"true\"" : "");
    document(a.aboutText(), "    ");
  }
  void end() { out_ += "  </xs:complexType>\n"; }

  void document(const std::string& text, const std::string& indent) {
    if (!text.empty())
      out_ += indent + "<xs:annotation><xs:documentation>" + escapeXmlText(text) +
              "</xs:documentation></xs:annotation>\n";
  }

  static std::string element(const std::string& name, const char* prefix) {
    return fmt::format("      <xs:element name=\"{0}\" type=\"{1}.{0}\"/>\n", name, prefix);
  }

  /// Writes that any number of these children may follow in any order.
  void choice(const std::vector<std::string>& children) {
    if (children.empty()) return;
    out_ += "    <xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n";
    for (const std::string& child : children) out_ += child;
    out_ += "    </xs:choice>\n";
  }

  void attributes(const Attributes& declared, bool demand) {
    for (const Attribute& a : declared.list()) {
      const bool words = a.type == AttributeType::choice || a.type == AttributeType::flag;
      out_ += fmt::format("    <xs:attribute name=\"{}\"{}{}>\n", escapeXmlValue(a.name),
                          words ? "" : " type=\"xs:string\"",
                          demand && a.mustBeGiven() ? " use=\"required\"" : "");
      document(documentation(a), "      ");
      if (words)
        enumeration(a.type == AttributeType::flag ? std::vector<std::string>{"true", "false"}
                                                  : a.choices);
      out_ += "    </xs:attribute>\n";
    }
  }

  /// Writes a type that allows one of the words, or an {expression}.
  void enumeration(const std::vector<std::string>& words) {
    out_ +=
        "      <xs:simpleType><xs:union memberTypes=\"braces\"><xs:simpleType>"
        "<xs:restriction base=\"xs:string\">\n";
    for (const std::string& word : words)
      out_ += "        <xs:enumeration value=\"" + escapeXmlValue(word) + "\"/>\n";
    out_ += "      </xs:restriction></xs:simpleType></xs:union></xs:simpleType>\n";
  }

  static std::string documentation(const Attribute& a) {
    std::string text = a.text + " (" + typeText(a);
    if (unitText(a.unit) != "-") text += " [" + std::string(unitText(a.unit)) + ']';
    if (rangeText(a) != "-") text += ", " + rangeText(a);
    const std::string value = defaultText(a);
    if (value == "required")
      text += ", required";
    else if (value != "-")
      text += ", default " + value;
    return text + ')';
  }

  std::vector<const RegisteredType*> types_;
  Vocabulary vocabulary_;
  std::string out_;
};

}  // namespace

std::string schemaText(const Registry& registry) { return SchemaWriter(registry).write(); }

}  // namespace dynamy
