#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/model/attribute_reader.hpp>
#include <dynamy/io/model/braces.hpp>
#include <dynamy/io/model/parameter_evaluator.hpp>

namespace dynamy {
namespace {

/// Declaration of the attribute "value" with the range of the parameter.
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

std::vector<std::string> ParameterEvaluator::names() const {
  std::vector<std::string> out;
  for (const Item& item : items_) out.push_back(item.name);
  return out;
}

void ParameterEvaluator::add(const XmlNode& node) {
  const XmlAttribute* name = node.attribute("name");
  if (name == nullptr) {
    // A misspelt attribute "name" is reported; uses of the parameter give no further errors.
    AttributeReader reader(*faults_, nullptr);
    if (AttributeReader::isMisspelt("name", node, word_->attributes, {})) {
      reader.allDeclared(node, *scope_, word_->attributes, {});
      for (const XmlAttribute& a : node.attributes) scope_->broken.insert(a.value);
    } else {
      faults_->add(*scope_, node.place, node, "missing attribute \"name\"", "name in expressions");
    }
    return;
  }
  if (!isName(name->value)) {
    faults_->add(
        *scope_, name->valuePlace, node,
        "the name of a parameter consists of letters, digits and _, is \"" + name->value + '"');
    return;
  }
  const auto [at, isNew] = index_.emplace(name->value, items_.size());
  if (!isNew) {
    Diagnostic d = scope_->document->diagnostic(
        name->valuePlace, node, "the parameter \"" + name->value + "\" is given twice");
    d.notes.push_back({.place = items_[at->second].node->attribute("name")->valuePlace,
                       .text = "first given here"});
    faults_->add(std::move(d));
    return;
  }
  items_.push_back({name->value, &node});
}

void ParameterEvaluator::evaluate() {
  for (std::size_t i = 0; i < items_.size(); ++i) evaluate(i);
}

/// Marks an item as running and finds the parameters that its values use.
ParameterEvaluator::Pending ParameterEvaluator::start(std::size_t item) {
  Pending out{item, {}};
  items_[item].progress = Progress::running;
  for (const XmlAttribute& a : items_[item].node->attributes)
    for (const std::string& name : namesInBraces(a.value))
      if (const auto used = index_.find(name); used != index_.end())
        out.uses.emplace_back(used->second, &a);
  return out;
}

/// ": a → b → a", the loop of parameters that closes at `item`; "" if it uses itself.
std::string ParameterEvaluator::loop(const std::vector<Pending>& stack, std::size_t item) const {
  if (stack.back().item == item) return {};
  constexpr int kMostNames = 8;
  std::string out = " → " + items_[item].name;
  int count = 0;
  for (auto p = stack.rbegin(); p->item != item; ++p)
    if (++count <= kMostNames) out = " → " + items_[p->item].name + out;
  return ": " + items_[item].name + (count > kMostNames ? " → …" : "") + out;
}

/// Evaluates depth first with an explicit stack, so that a chain of parameters may have any length.
void ParameterEvaluator::evaluate(std::size_t item) {
  std::vector<Pending> stack;
  if (items_[item].progress == Progress::waiting) stack.push_back(start(item));
  while (!stack.empty()) {
    Pending& top = stack.back();
    Item& current = items_[top.item];
    if (!top.good || top.next == top.uses.size()) {
      finish(current, top.good);
      stack.pop_back();
      continue;
    }
    const auto [used, attribute] = top.uses[top.next++];
    if (items_[used].progress == Progress::running) {
      faults_->add(*scope_, attribute->valuePlace, *current.node,
                   "the parameter \"" + current.name + "\" depends on itself" + loop(stack, used));
      top.good = false;
    } else if (items_[used].progress == Progress::waiting) {
      stack.push_back(start(used));
    }
  }
}

/// Computes the number of an item once all parameters that it uses are known.
void ParameterEvaluator::finish(Item& item, bool good) {
  Parameters x;
  x.type = "parameter";
  good = good &&
         AttributeReader(*faults_, nullptr).read(*item.node, *scope_, word_->attributes, {}, x);
  item.progress = Progress::done;
  if (!good || scope_->broken.contains(item.name)) {
    scope_->broken.insert(item.name);
    return;
  }

  if (x.has("min") && x.has("max") && x["min"] > x["max"]) {
    faults_->add(*scope_, x["min"].place, *item.node, "min lies above max", "exchange the two");
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
  const double result = replaced(item, a, value);
  if (!scope_->broken.contains(item.name)) scope_->numbers[item.name] = result;
}

/// The number that replaces the one of the file, if there is one. A wrong replacement is reported
/// once, and uses of the parameter give no further errors.
double ParameterEvaluator::replaced(const Item& item, const Attribute& declared,
                                    const ParameterValue& value) {
  double result = value.numbers[0];
  const auto [begin, end] = replacements_.equal_range(item.name);
  for (auto at = begin; at != end; ++at) {
    ParameterValue other = value;
    other.text = numberText(at->second.value);
    if (const auto fault = readValue(declared, other)) {
      at->second.report(fault->text);
      scope_->broken.insert(item.name);
      return result;
    }
    result = at->second.value;
  }
  return result;
}

}  // namespace dynamy
