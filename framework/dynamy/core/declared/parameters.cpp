/// Values of attributes: access for elements, and models built in C++, whose names and values are
/// checked against the same declaration as those of a file.

#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <fstream>
#include <stdexcept>

namespace dynamy {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

std::string label(const std::string& type, const std::string& name) {
  if (name.empty()) return type;
  return (type.empty() ? "element" : type) + " name=\"" + name + '"';
}

}  // namespace

// ---- ParameterValue ----

ParameterValue::operator double() const {
  expects(numbers.size() == 1, "the attribute is declared as a number and has a value");
  return numbers[0];
}

ParameterValue::operator const std::string&() const { return text; }

int ParameterValue::integer() const {
  expects(numbers.size() == 1 && declaration->type == AttributeType::integer,
          "the attribute is declared as an integer and has a value");
  return static_cast<int>(numbers[0]);
}

bool ParameterValue::flag() const {
  expects(declaration->type == AttributeType::flag, "the attribute is declared as a flag");
  return text == "true";
}

Vec3 ParameterValue::vec3() const {
  expects(numbers.size() == 3, "the attribute is declared as a vector of 3 and has a value");
  return {numbers[0], numbers[1], numbers[2]};
}

Eigen::VectorXd ParameterValue::vector() const {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

std::vector<std::string> ParameterValue::words() const {
  std::vector<std::string> out;
  for (std::size_t i = text.find_first_not_of(kSpace); i != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, i), text.size());
    out.push_back(text.substr(i, end - i));
    i = text.find_first_not_of(kSpace, end);
  }
  return out;
}

std::vector<ValuePart> ParameterValue::parts(char separator) const {
  std::vector<ValuePart> out;
  if (text.find_first_not_of(kSpace) == std::string::npos) return out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    std::string_view part = std::string_view(text).substr(begin, end - begin);
    const std::size_t first = std::min(part.find_first_not_of(kSpace), part.size());
    part.remove_prefix(first);
    part = part.substr(0, part.find_last_not_of(kSpace) + 1);
    out.push_back({std::string(part), begin + first});
    begin = end + 1;
  }
  return out;
}

std::filesystem::path ParameterValue::existingFile() const {
  namespace fs = std::filesystem;
  fs::path path = fs::path(place.file).parent_path() / text;
  std::error_code error;
  if (fs::is_regular_file(path, error) && std::ifstream(path)) return path;
  throw fault(fs::is_directory(path, error) ? "this is a folder, not a file"
              : fs::exists(path, error)     ? "the file cannot be read"
                                            : "there is no such file",
              "a path is relative to the model in which it stands", 0, text.size());
}

ModelError ParameterValue::fault(std::string message, std::string hint, std::size_t offset,
                                 std::size_t length) const {
  Diagnostic d{.place = locate ? locate(offset, length) : place,
               .text = std::move(message),
               .hint = std::move(hint)};
  if (!locate && declaration != nullptr)
    d.text = declaration->name + "=\"" + text + "\": " + d.text;
  return ModelError(std::move(d));
}

// ---- GivenValue ----

GivenValue::GivenValue(std::string n, double v) : name(std::move(n)), text(numberText(v)) {}

GivenValue::GivenValue(std::string n, std::initializer_list<double> v) : name(std::move(n)) {
  for (const double x : v) text += (text.empty() ? "" : " ") + numberText(x);
}

GivenValue::GivenValue(std::string n, const Vec3& v)
    : GivenValue(std::move(n), {v[0], v[1], v[2]}) {}

// ---- Parameters ----

const ParameterValue& Parameters::operator[](std::string_view attribute) const {
  for (const ParameterValue& v : values)
    if (v.declaration->name == attribute) return v;
  std::vector<std::string> known;
  for (const ParameterValue& v : values) known.push_back(v.declaration->name);
  const std::string near = nearest(attribute, known);
  throw std::logic_error("it reads the attribute \"" + std::string(attribute) +
                         "\", which its declare() does not name" +
                         (near.empty() ? std::string() : " — did you mean \"" + near + "\"?"));
}

bool Parameters::has(std::string_view attribute) const {
  for (const ParameterValue& v : values)
    if (v.declaration->name == attribute) return v.given || v.declaration->defaultValue.has_value();
  return false;
}

Parameters Parameters::fromGiven(Attributes a, std::string type, std::string name,
                                 const std::vector<GivenValue>& given) {
  Parameters x;
  x.type = std::move(type);
  x.name = std::move(name);
  x.own = std::make_unique<const Attributes>(std::move(a));
  x.declaration = x.own.get();

  Diagnostics faults;
  const auto report = [&](std::string text, std::string hint) {
    faults.add(
        {.element = label(x.type, x.name), .text = std::move(text), .hint = std::move(hint)});
  };

  // Names that are not declared, or given twice.
  std::vector<std::string> known;
  for (const Attribute& d : x.declaration->list()) known.push_back(d.name);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (x.declaration->find(given[i].name) == nullptr)
      report("unknown attribute \"" + given[i].name + '"',
             meantAttribute(given[i].name, known).hint);
    for (std::size_t j = 0; j < i; ++j)
      if (given[j].name == given[i].name)
        report("attribute \"" + given[i].name + "\" is given twice", {});
  }

  // Values in the order of the declaration.
  for (const Attribute& d : x.declaration->list()) {
    ParameterValue value;
    value.declaration = &d;
    value.text = d.defaultValue.value_or("");
    for (const GivenValue& g : given)
      if (g.name == d.name) value.text = g.text, value.given = true;
    if (!value.given && d.mustBeGiven()) {
      report("missing attribute \"" + d.name + '"', d.text);
    } else if (value.given || d.defaultValue) {
      if (const auto fault = readValue(d, value))
        report(d.name + "=\"" + value.text + "\": " + fault->text, fault->hint);
    }
    x.values.push_back(std::move(value));
  }
  faults.throwIfAny();
  return x;
}

Element::Element(const Parameters& x) : name_(x.name), type_(x.type), place_(x.place) {}

// ---- Words in messages ----

std::string quotedList(const std::vector<std::string>& words, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < std::min(words.size(), most); ++i)
    out += (i > 0 ? ", \"" : "\"") + words[i] + '"';
  return words.size() > most ? out + ", …" : out;
}

namespace {

/// "ball.*" for all names of "ball", if a list of all names would be cut.
std::vector<std::string> byOwners(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 12;
  if (names.size() <= kMost) return names;
  std::vector<std::string> out;
  for (const std::string& name : names) {
    const std::size_t dot = name.rfind('.');
    std::string shown = dot == std::string::npos ? name : name.substr(0, dot) + ".*";
    if (std::find(out.begin(), out.end(), shown) == out.end()) out.push_back(std::move(shown));
  }
  return out;
}

/// "ball" and "ball[3]", where there are ball[0] to ball[2]: what their names are; else "".
std::string copiesOf(std::string_view name, const std::vector<std::string>& known) {
  const std::string stem = std::string(name.substr(0, name.find('['))) + '[';
  if (name.find('.') != std::string_view::npos) return {};
  const std::string *first = nullptr, *last = nullptr;
  int count = 0;
  for (const std::string& k : known)
    if (k.starts_with(stem) && k.find(']') + 1 == k.size())
      first = first == nullptr ? &k : first, last = &k, ++count;
  if (count < 2) return {};
  return "there are " + std::to_string(count) + ", \"" + *first + "\" to \"" + *last + '"';
}

/// "table-box.g" for "box-table.g", if it is known; else "".
std::string otherWayRound(std::string_view name, const std::vector<std::string>& known) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  for (std::size_t at = name.find('-'); at < dot; at = name.find('-', at + 1)) {
    std::string swapped = std::string(name.substr(at + 1, dot - at - 1)) + '-' +
                          std::string(name.substr(0, at)) + std::string(name.substr(dot));
    if (std::find(known.begin(), known.end(), swapped) != known.end()) return swapped;
  }
  return {};
}

}  // namespace

std::string unknownNameHint(std::string_view name, const std::vector<std::string>& known) {
  if (const std::string meant = signalOfOthers(name, known); !meant.empty())
    return didYouMean(meant);
  if (std::string copies = copiesOf(name, known); !copies.empty()) return copies;
  if (const std::string other = otherWayRound(name, known); !other.empty())
    return didYouMean(other);
  // Names of the same owner are the likeliest: "hinge.phi" means one of "hinge.angle", "hinge.g".
  const std::string_view owner = name.substr(0, name.rfind('.') + 1);
  std::vector<std::string> same, last;
  for (const std::string& k : known)
    if (!owner.empty() && k.starts_with(owner))
      same.push_back(k), last.push_back(k.substr(owner.size()));
  if (!same.empty()) {
    const std::string near = nearest(name.substr(owner.size()), last);
    constexpr std::size_t kMostOfOne = 24;
    return near.empty() ? "known: " + quotedList(same, kMostOfOne)
                        : didYouMean(std::string(owner) + near);
  }
  if (const std::string near = nearest(name, known); !near.empty()) return didYouMean(near);
  return known.empty() ? std::string() : "known: " + quotedList(byOwners(known));
}

}  // namespace dynamy
