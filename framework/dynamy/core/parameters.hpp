/// Parameters: the checked values of one element, made from XML by io/model_loader or in C++ by
/// `Parameters::of<T>`.
///
/// The same declaration (`T::declare(Attributes&)`) checks both ways, so that a C++ model gets the
/// same messages as an XML file. Separate settings structs per element were rejected: they would be
/// a second declaration to keep in step.
#pragma once
#include <dynamy/core/element.hpp>
#include <dynamy/core/types.hpp>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Value of one attribute; converts to what the declaration says. Converting to another type is a
/// programmer's error.
class ParameterValue {
 public:
  const Attribute* declaration = nullptr;
  std::string text;  ///< as written, after {…} were replaced; words, names, expressions
  std::vector<double> numbers;  ///< number, integer, vector, in SI
  Place place;                  ///< of the value in the file
  bool given = false;           ///< false: the default

  operator double() const;  // NOLINT(google-explicit-constructor): x["mass"] reads as a number
  operator const std::string&() const;  // NOLINT(google-explicit-constructor)
  int integer() const;
  bool flag() const;
  Vec3 vec3() const;
  Eigen::VectorXd vector() const;
  std::vector<std::string> words() const;  ///< split at white space
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
    T::declare(a);
    return fromGiven(std::move(a), std::move(type), std::move(name), given);
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
  std::vector<ParameterValue> values;
  mutable std::vector<Child> children;

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

/// Checks one value text (already without braces) against its declaration and fills `numbers`;
/// returns an empty text or the fault, e.g. `must be > 0, is -1`. `offset`/`length` point at the
/// faulty part.
std::string readValue(const Attribute& a, ParameterValue& value, std::size_t& offset,
                      std::size_t& length);

}  // namespace dynamy
