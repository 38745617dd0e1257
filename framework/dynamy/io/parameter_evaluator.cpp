#include <dynamy/core/parameters.hpp>
#include <dynamy/io/attribute_reader.hpp>
#include <dynamy/io/parameter_evaluator.hpp>

namespace dynamy {
namespace {

/// The range of a parameter as the range of its value.
Attribute valueDeclaration(const Attribute& declared, const Parameters& x) {
  Attribute a = declared;
  if (x.has("min")) a.min = x["min"];
  if (x.has("max")) a.max = x["max"];
  return a;
}

bool isName(std::string_view name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
  };
  if (name.empty() || !letter(name[0])) return false;
  for (const char c : name)
    if (!letter(c) && (c < '0' || c > '9')) return false;
  return true;
}

}  // namespace

ParameterEvaluator::Item* ParameterEvaluator::find(const std::string& name) {
  for (Item& item : items_)
    if (item.name == name) return &item;
  return nullptr;
}

std::vector<std::string> ParameterEvaluator::names() const {
  std::vector<std::string> out;
  for (const Item& item : items_) out.push_back(item.name);
  return out;
}

void ParameterEvaluator::add(const XmlNode& node) {
  const XmlAttribute* name = node.attribute("name");
  if (name == nullptr) {
    faults_->add(*scope_, node.place, node, "missing attribute \"name\"", "name in expressions");
    return;
  }
  if (!isName(name->value)) {
    faults_->add(
        *scope_, name->valuePlace, node,
        "the name of a parameter consists of letters, digits and _, is \"" + name->value + '"');
    return;
  }
  if (const Item* first = find(name->value)) {
    Diagnostic d = scope_->document->diagnostic(
        name->valuePlace, node, "the parameter \"" + name->value + "\" is given twice");
    d.notes.push_back(
        {.place = first->node->attribute("name")->valuePlace, .text = "first given here"});
    faults_->add(std::move(d));
    return;
  }
  items_.push_back({name->value, &node});
}

void ParameterEvaluator::evaluate() {
  for (Item& item : items_) evaluate(item);
}

/// Evaluates what the values of `item` use; false if it uses itself.
bool ParameterEvaluator::dependenciesReady(Item& item) {
  for (const XmlAttribute& a : item.node->attributes) {
    for (const std::string& name : namesInBraces(a.value)) {
      Item* used = find(name);
      if (used == nullptr) continue;
      if (used->progress == Progress::running) {
        faults_->add(*scope_, a.valuePlace, *item.node,
                     "the parameter \"" + item.name + "\" depends on itself");
        return false;
      }
      evaluate(*used);
    }
  }
  return true;
}

void ParameterEvaluator::evaluate(Item& item) {
  if (item.progress != Progress::waiting) return;
  item.progress = Progress::running;
  Parameters x;
  x.type = "parameter";
  const bool good =
      dependenciesReady(item) &&
      AttributeReader(*faults_, nullptr).read(*item.node, *scope_, word_->attributes, {}, x);
  item.progress = Progress::done;
  if (!good || scope_->broken.contains(item.name)) {
    scope_->broken.insert(item.name);
    return;
  }

  // The value of the file must fit its range even if it is replaced.
  const Attribute a = valueDeclaration(*word_->attributes.find("value"), x);
  ParameterValue value = x["value"];
  value.declaration = &a;
  if (const auto fault = readValue(a, value)) {
    faults_->add(*scope_, value.place, *item.node, fault->text);
    scope_->broken.insert(item.name);
    return;
  }
  // A wrong replacement is told once: what uses the parameter stays silent.
  double result = value.numbers[0];
  for (const Replacement& r : replacements_) {
    if (r.name != item.name) continue;
    ParameterValue replaced = value;
    replaced.text = numberText(r.value);
    if (const auto fault = readValue(a, replaced)) {
      r.report(fault->text);
      scope_->broken.insert(item.name);
      return;
    }
    result = r.value;
  }
  scope_->symbols.constant(item.name, result);
}

}  // namespace dynamy
