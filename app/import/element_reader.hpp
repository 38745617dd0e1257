/// Reading of elements of a machine's file: numbers and words with errors at their place, and notes
/// about all that has no equivalent in a model.
#pragma once
#include <dynamy/io/xml/fault_list.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/machine.hpp"

namespace dynamy::app {

/// A reason why an element or attribute has no equivalent.
struct Unsupported {
  std::string_view name, why;
};

/// The first child of this tag, nullptr if there is none; all children of this tag.
const XmlNode* childOf(const XmlNode& node, std::string_view tag);
std::vector<const XmlNode*> childrenOf(const XmlNode& node, std::string_view tag);
/// Value of an attribute that may be missing.
std::string valueOf(const XmlNode& node, const char* name, const std::string& otherwise);

class ElementReader {
 public:
  /// Both are borrowed.
  ElementReader(const XmlDocument& document, Machine& machine)
      : documents_{&document}, machine_(machine) {}
  /// A further file, borrowed, whose elements are read, too.
  void alsoOf(const XmlDocument& document) { documents_.push_back(&document); }

  /// Adds an error; reading goes on.
  void fault(const XmlNode& node, const Place& place, const std::string& text,
             const std::string& hint = {});
  void fault(const XmlNode& node, const std::string& text, const std::string& hint = {}) {
    fault(node, node.place, text, hint);
  }
  void note(const XmlNode& node, const std::string& text);
  void note(const XmlNode& node, const Place& place, const std::string& text);
  void throwIfAny() const { faults_.throwIfAny(); }

  /// Value of a required attribute; "" with an error that names the nearest attribute given.
  std::string required(const XmlNode& node, const char* name);
  double number(const XmlNode& node, const char* name, double otherwise);
  double requiredNumber(const XmlNode& node, const char* name);
  /// Numbers of an attribute; empty if it is missing, or with an error if there are not `count` of
  /// them (0: any count).
  std::vector<double> numbers(const XmlNode& node, const char* name, std::size_t count = 0);
  Vec3 vector(const XmlNode& node, const char* name, const Vec3& otherwise);
  /// The same of the element's text.
  std::vector<double> numbersOf(const XmlNode& node, std::size_t count = 0);
  double numberOf(const XmlNode& node);

  /// One of `words`; the first of them, with an error, if the value is another one.
  std::string word(const XmlNode& node, const char* name, const std::string& value,
                   const std::vector<std::string>& words);

  /// Notes all children and attributes that are not among those read here, with the reason if
  /// there is one in `why`.
  void readOnly(const XmlNode& node, std::initializer_list<std::string_view> attributes,
                std::initializer_list<std::string_view> children,
                std::initializer_list<Unsupported> why = {});

  /// The file itself; that of a place.
  const XmlDocument& document() const { return *documents_.front(); }
  const XmlDocument& documentOf(const Place& place) const;

 private:
  std::vector<double> parsed(const XmlNode& node, const std::string& what, std::string_view text,
                             std::size_t count, const std::function<Place(std::size_t)>& place);
  std::vector<const XmlDocument*> documents_;
  Machine& machine_;
  FaultList faults_;
  /// Notes of readOnly() that may be repeated: index in the machine's, and how often.
  std::map<std::string, std::pair<std::size_t, int>> repeated_;
};

}  // namespace dynamy::app
