#include <dynamy/core/declared/attributes.hpp>

#include <array>
#include <charconv>

namespace dynamy {

std::string numberText(double x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return {text.data(), end};
}

std::string_view unitText(Unit unit) {
  switch (unit) {
    case Unit::none:
    case Unit::any:
      return "-";
    case Unit::length:
      return "m";
    case Unit::angle:
      return "rad";
    case Unit::time:
      return "s";
    case Unit::mass:
      return "kg";
    case Unit::inertia:
      return "kg m^2";
    case Unit::velocity:
      return "m/s";
    case Unit::angularVelocity:
      return "rad/s";
    case Unit::acceleration:
      return "m/s^2";
    case Unit::force:
      return "N";
    case Unit::torque:
      return "N m";
    case Unit::stiffness:
      return "N/m";
    case Unit::damping:
      return "N s/m";
    case Unit::rotationalStiffness:
      return "N m/rad";
    case Unit::rotationalDamping:
      return "N m s/rad";
    case Unit::density:
      return "kg/m^3";
    case Unit::frequency:
      return "Hz";
    case Unit::impulse:
      return "N s";
    case Unit::angularImpulse:
      return "N m s";
    case Unit::energy:
      return "J";
    case Unit::power:
      return "W";
  }
  return "-";
}

std::string_view unitFamilyText(Unit unit) {
  switch (unit) {
    case Unit::none:
    case Unit::any:
      return "a number";
    case Unit::length:
      return "a length";
    case Unit::angle:
      return "an angle";
    case Unit::time:
      return "a time";
    case Unit::mass:
      return "a mass";
    case Unit::inertia:
      return "an inertia";
    case Unit::velocity:
      return "a velocity";
    case Unit::angularVelocity:
      return "an angular velocity";
    case Unit::acceleration:
      return "an acceleration";
    case Unit::force:
      return "a force";
    case Unit::torque:
      return "a torque";
    case Unit::stiffness:
      return "a stiffness";
    case Unit::damping:
      return "a damping";
    case Unit::rotationalStiffness:
      return "a rotational stiffness";
    case Unit::rotationalDamping:
      return "a rotational damping";
    case Unit::density:
      return "a density";
    case Unit::frequency:
      return "a frequency";
    case Unit::impulse:
      return "an impulse";
    case Unit::angularImpulse:
      return "an angular impulse";
    case Unit::energy:
      return "an energy";
    case Unit::power:
      return "a power";
  }
  return "a number";
}

std::string_view kindText(Kind kind) {
  switch (kind) {
    case Kind::system:
      return "system";
    case Kind::contact:
      return "contact";
    case Kind::force:
      return "force";
    case Kind::law:
      return "law";
    case Kind::shape:
      return "shape";
    case Kind::rule:
      return "rule";
    case Kind::scheme:
      return "scheme";
    case Kind::solver:
      return "solver";
    case Kind::impact:
      return "impact";
    case Kind::observer:
      return "observer";
    case Kind::part:
      return "part";
  }
  return "element";
}

Attribute& Attributes::add(AttributeType type, std::string name,
                           std::optional<std::string> defaultValue, std::string text) {
  Attribute a;
  a.name = std::move(name);
  a.type = type;
  a.defaultValue = std::move(defaultValue);
  a.text = std::move(text);
  list_.push_back(std::move(a));
  return list_.back();
}

Attribute& Attributes::required(std::string name, Unit unit, std::string text) {
  Attribute& a = add(AttributeType::number, std::move(name), std::nullopt, std::move(text));
  a.unit = unit;
  return a;
}

Attribute& Attributes::optional(std::string name, Unit unit, double defaultValue,
                                std::string text) {
  Attribute& a =
      add(AttributeType::number, std::move(name), numberText(defaultValue), std::move(text));
  a.unit = unit;
  return a;
}

Attribute& Attributes::vector(std::string name, Unit unit, int size, std::string defaultValue,
                              std::string text) {
  Attribute& a =
      add(AttributeType::vector, std::move(name), std::move(defaultValue), std::move(text));
  a.unit = unit;
  a.size = size;
  return a;
}

Attribute& Attributes::requiredVector(std::string name, Unit unit, int size, std::string text) {
  Attribute& a = add(AttributeType::vector, std::move(name), std::nullopt, std::move(text));
  a.unit = unit;
  a.size = size;
  return a;
}

Attribute& Attributes::choice(std::string name, std::vector<std::string> words,
                              std::string defaultValue, std::string text) {
  Attribute& a =
      add(AttributeType::choice, std::move(name), std::move(defaultValue), std::move(text));
  a.choices = std::move(words);
  return a;
}

Attribute& Attributes::reference(std::string name, std::string kind, std::string text) {
  Attribute& a = add(AttributeType::reference, std::move(name), std::nullopt, std::move(text));
  a.referenceKind = std::move(kind);
  return a;
}

void Attributes::child(Kind kind, int min, int max, std::string text, std::string only) {
  children_.push_back({kind, min, max, std::move(text), std::move(only)});
}

const Attribute* Attributes::find(std::string_view name) const {
  for (const Attribute& a : list_)
    if (a.name == name) return &a;
  return nullptr;
}

}  // namespace dynamy
