/// Declaration of the attributes of an element: one declaration feeds the XML reader, C++ model
/// building, `dynamy describe`, the XSD, the reference pages and "did you mean".
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Family of units of a number; values are stored in SI, angles in radians.
enum class Unit {
  none,
  length,
  angle,
  time,
  mass,
  inertia,
  velocity,
  angularVelocity,
  acceleration,
  force,
  torque,
  stiffness,
  damping,
  rotationalStiffness,
  rotationalDamping,
  density,
  frequency,
  impulse,
  angularImpulse,
  energy,
  power,
  any  ///< a suffix of any family, e.g. for coordinates that mix lengths and angles
};
/// "m", "rad", "kg m^2", … ; "-" for none and any.
std::string_view unitText(Unit unit);
/// The family in a sentence: "a length", "an angle", … ; "a number" for none and any.
std::string_view unitFamilyText(Unit unit);

/// What an attribute holds.
enum class AttributeType {
  number,      ///< one real number; suffix of its unit family allowed
  integer,     ///< one whole number
  flag,        ///< true | false
  choice,      ///< one word of a list
  text,        ///< free text
  name,        ///< a name given by the user
  reference,   ///< name of something in the model, of the kind `referenceKind`
  vector,      ///< `size` numbers (0: any count)
  names,       ///< list of names or words
  expression,  ///< formula over variables the element defines; compiled by the element
  expressions  ///< list of formulas, separated by ';'
};

/// Kinds of types a plug-in can register; the base class of a registered type decides its kind.
enum class Kind {
  system,
  contact,
  force,
  law,
  shape,
  rule,
  scheme,
  solver,
  impact,
  observer,
  part
};
std::string_view kindText(Kind kind);

/// One declared attribute.
struct Attribute {
  std::string name;
  AttributeType type = AttributeType::number;
  Unit unit = Unit::none;
  int size = 1;                             ///< count of numbers of a vector, 0: any
  std::optional<std::string> defaultValue;  ///< as written in XML; empty: required
  std::string text;                         ///< one line for describe
  double min = -std::numeric_limits<double>::infinity(),
         max = std::numeric_limits<double>::infinity();
  bool minOpen = false, maxOpen = false;  ///< true: the bound itself is not allowed
  bool nonZero = false;                   ///< a vector or number that must not vanish
  bool optionalValue = false;             ///< may be absent without a default; ask Parameters::has
  bool code = false;                      ///< names a file whose code runs in this process
  std::vector<std::string> choices;
  std::string referenceKind;  ///< "system", "frame", "material", …

  /// In this unit; for formulas, whose unit is not checked without it.
  Attribute& in(Unit u) {
    unit = u;
    return *this;
  }
  Attribute& positive() {
    min = 0.0, minOpen = true;
    return *this;
  }
  Attribute& nonNegative() {
    min = 0.0, minOpen = false;
    return *this;
  }
  Attribute& between(double a, double b) {
    min = a, max = b;
    return *this;
  }
  Attribute& atLeast(double a) {
    min = a;
    return *this;
  }
  Attribute& notZero() {
    nonZero = true;
    return *this;
  }
  /// `inf` is a value, too.
  Attribute& mayBeInfinite() {
    choices = {"inf"};
    return *this;
  }
  /// May be absent although it has no default.
  Attribute& mayBeAbsent() {
    optionalValue = true;
    return *this;
  }
  /// Names a file whose code runs in this process: a model may name one only in a folder that the
  /// user trusts, as with plug-ins.
  Attribute& runsCode() {
    code = true;
    return *this;
  }
  bool mustBeGiven() const { return !defaultValue && !optionalValue; }
};

/// Shortest text that reads back as the same number; "inf" for infinity, "nan" for no number.
std::string numberText(double x);

/// Child elements an element accepts.
struct ChildRule {
  Kind kind = Kind::law;
  int min = 0, max = 1;
  std::string text;
  std::string only;  ///< a single type name, or empty for any type of the kind
};

/// The list that `T::declare(Attributes&)` fills. References returned stay valid until the next
/// declaration.
class Attributes {
 public:
  Attribute& required(std::string name, Unit unit, std::string text);  ///< number
  Attribute& optional(std::string name, Unit unit, double defaultValue,
                      std::string text);  ///< number with default
  Attribute& vector(std::string name, Unit unit, int size, std::string defaultValue,
                    std::string text);
  Attribute& requiredVector(std::string name, Unit unit, int size, std::string text);
  Attribute& add(AttributeType type, std::string name, std::optional<std::string> defaultValue,
                 std::string text);
  Attribute& choice(std::string name, std::vector<std::string> words, std::string defaultValue,
                    std::string text);
  Attribute& reference(std::string name, std::string kind,
                       std::string text);  ///< required reference
  void child(Kind kind, int min, int max, std::string text, std::string only = {});
  void about(std::string text) {
    about_ = std::move(text);
  }  ///< what the element is, with its equation
  void example(std::string xml) { example_ = std::move(xml); }  ///< an example that runs

  const std::vector<Attribute>& list() const { return list_; }
  const std::vector<ChildRule>& children() const { return children_; }
  const Attribute* find(std::string_view name) const;
  const std::string& aboutText() const { return about_; }
  const std::string& exampleText() const { return example_; }

 private:
  std::vector<Attribute> list_;
  std::vector<ChildRule> children_;
  std::string about_, example_;
};

}  // namespace dynamy
