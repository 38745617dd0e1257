/// Parameters: the checked values of one element, made from XML by io/model/model_loader or in C++
/// by `Parameters::of<T>`.
///
/// The same declaration (`T::declare(Attributes&)`) checks both ways, so that a C++ model gets the
/// same messages as an XML file. Separate settings structs per element were rejected: they would be
/// a second declaration to keep in step.
#pragma once
#include <dynamy/core/declared/element.hpp>
#include <dynamy/core/types.hpp>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy {

/// A piece of a value: text and the byte at which it begins.
struct ValuePart {
  std::string text;
  std::size_t offset = 0;
};

/// Value of one attribute; converts to the type that the declaration states. Converting to another
/// type is a programmer's error.
class ParameterValue {
 public:
  const Attribute* declaration = nullptr;
  std::string text;  ///< as written, after {…} were replaced; words, names, expressions
  std::vector<double> numbers;  ///< number, integer, vector, in SI
  Place place;                  ///< of the value in the file
  bool given = false;           ///< false: the default
  /// Place of `length` bytes from byte `offset` of `text`; empty: made in C++.
  std::function<Place(std::size_t offset, std::size_t length)> locate;

  operator double() const;  // NOLINT(google-explicit-constructor): x["mass"] reads as a number
  operator const std::string&() const;  // NOLINT(google-explicit-constructor)
  int integer() const;
  bool flag() const;
  Vec3 vec3() const;
  Eigen::VectorXd vector() const;
  std::vector<std::string> words() const;  ///< split at white space
  /// Split at `separator`, without the blanks around the parts; an empty text has no parts.
  std::vector<ValuePart> parts(char separator) const;
  /// The file that the text names, counted from the folder of the file in which it stands. Throws
  /// ModelError if there is no such file.
  std::filesystem::path existingFile() const;
  /// The error to throw for `length` bytes from byte `offset` of the text, e.g. of a formula.
  ModelError fault(std::string message, std::string hint, std::size_t offset,
                   std::size_t length) const;
};

/// A value given in C++: number, text or vector; becomes the text an XML author would have written.
class GivenValue {
 public:
  std::string name, text;
  GivenValue(std::string n, double v);
  GivenValue(std::string n, const char* v) : name(std::move(n)), text(v) {}
  GivenValue(std::string n, std::string v) : name(std::move(n)), text(std::move(v)) {}
  GivenValue(std::string n, std::initializer_list<double> v);
  GivenValue(std::string n, const Vec3& v);
};

class Parameters {
 public:
  Parameters() = default;
  Parameters(Parameters&&) = default;
  Parameters& operator=(Parameters&&) = default;

  /// For C++ models: checks `given` against T's declaration; throws ModelError with all faults.
  template <class T>
  static Parameters of(std::string type, std::string name, const std::vector<GivenValue>& given) {
    Attributes a;
    if constexpr (requires { T::declareCommon(a); }) T::declareCommon(a);
    T::declare(a);
    return fromGiven(std::move(a), std::move(type), std::move(name), given);
  }
  /// Checks `given` against an existing declaration, e.g. of a registered type.
  static Parameters of(const Attributes& declaration, std::string type, std::string name,
                       const std::vector<GivenValue>& given) {
    return fromGiven(declaration, std::move(type), std::move(name), given);
  }
  /// For C++ models: adds a child element, e.g. the law of a contact.
  template <class T>
  Parameters&& with(std::unique_ptr<T> child) && {
    children.push_back({T::kKind, std::move(child)});
    return std::move(*this);
  }

  const ParameterValue& operator[](
      std::string_view name) const;       ///< throws std::logic_error if not declared
  bool has(std::string_view name) const;  ///< declared and given (or with a default)
  /// Child elements of kind T::kKind, in the order of the file, handed over to the caller.
  template <class T>
  std::vector<std::unique_ptr<T>> take() const;
  /// The only child of kind T::kKind or null.
  template <class T>
  std::unique_ptr<T> takeOne() const;

  std::string type, name;
  Place place;

  // Filled by the model loader.
  struct Child {
    Kind kind;
    std::unique_ptr<Element> element;
  };
  const Attributes* declaration = nullptr;  // of the registry, or `own` when made in C++
  std::unique_ptr<const Attributes> own;
  std::vector<ParameterValue> values;  // one per declared attribute, in their order
  mutable std::vector<Child> children;
  /// Names and values of the model's `<parameter>`: formulas may use them without braces.
  std::vector<std::pair<std::string, double>> symbols;

 private:
  static Parameters fromGiven(Attributes a, std::string type, std::string name,
                              const std::vector<GivenValue>& given);
};

template <class T>
std::vector<std::unique_ptr<T>> Parameters::take() const {
  std::vector<std::unique_ptr<T>> out;
  for (Child& c : children)
    if (c.kind == T::kKind && c.element) out.emplace_back(static_cast<T*>(c.element.release()));
  return out;
}

template <class T>
std::unique_ptr<T> Parameters::takeOne() const {
  auto all = take<T>();
  return all.empty() ? nullptr : std::move(all.front());
}

/// What is wrong with the text of a value, and which bytes of it are wrong.
struct ValueFault {
  std::string text;  ///< e.g. `must be > 0, is -1`
  std::string hint;
  std::size_t offset = 0, length = 0;
};

/// Checks `value.text` (already without braces) against its declaration and fills
/// `value.numbers`. Ranges apply to given values only; a default outside the range means "none".
std::optional<ValueFault> readValue(const Attribute& a, ParameterValue& value);

/// Expected words as a list `"a", "b", "c"` of at most `most` words, with `…` for the rest.
std::string quotedList(const std::vector<std::string>& words, std::size_t most = 12);

/// The hint for an unknown name: did you mean …, else the list of known names, else "".
std::string unknownNameHint(std::string_view name, const std::vector<std::string>& known);

}  // namespace dynamy
