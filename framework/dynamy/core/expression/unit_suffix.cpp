#include <array>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <numbers>
#include <utility>
#include <vector>

namespace dynamy {
namespace {

struct TableEntry {
  std::string_view name;
  UnitSuffix unit;
};

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kRpm = std::numbers::pi / 30.0;

/// The first entry of a family is its SI unit.
constexpr auto kTable = [] {
  using enum UnitFamily;
  return std::to_array<TableEntry>({
      {"m", {1.0, length}},
      {"mm", {1e-3, length}},
      {"cm", {1e-2, length}},
      {"km", {1e3, length}},
      {"um", {1e-6, length}},
      {"µm", {1e-6, length}},
      {"μm", {1e-6, length}},
      {"m2", {1.0, area}},
      {"cm2", {1e-4, area}},
      {"mm2", {1e-6, area}},
      {"m3", {1.0, volume}},
      {"cm3", {1e-6, volume}},
      {"mm3", {1e-9, volume}},
      {"s", {1.0, time}},
      {"ms", {1e-3, time}},
      {"us", {1e-6, time}},
      {"µs", {1e-6, time}},
      {"μs", {1e-6, time}},
      {"min", {60.0, time}},
      {"h", {3600.0, time}},
      {"kg", {1.0, mass}},
      {"g", {1e-3, mass}},
      {"t", {1e3, mass}},
      {"rad", {1.0, angle}},
      {"deg", {kDegree, angle}},
      {"°", {kDegree, angle}},
      {"mrad", {1e-3, angle}},
      {"Hz", {1.0, frequency}},
      {"kHz", {1e3, frequency}},
      {"m/s", {1.0, velocity}},
      {"mm/s", {1e-3, velocity}},
      {"cm/s", {1e-2, velocity}},
      {"km/h", {1.0 / 3.6, velocity}},
      {"rad/s", {1.0, angularVelocity}},
      {"deg/s", {kDegree, angularVelocity}},
      {"rpm", {kRpm, angularVelocity}},
      {"m/s2", {1.0, acceleration}},
      {"mm/s2", {1e-3, acceleration}},
      {"rad/s2", {1.0, angularAcceleration}},
      {"deg/s2", {kDegree, angularAcceleration}},
      {"N", {1.0, force}},
      {"mN", {1e-3, force}},
      {"kN", {1e3, force}},
      {"MN", {1e6, force}},
      {"Nm", {1.0, moment}},
      {"Nmm", {1e-3, moment}},
      {"kNm", {1e3, moment}},
      {"Ns", {1.0, impulse}},
      {"J", {1.0, energy}},
      {"mJ", {1e-3, energy}},
      {"kJ", {1e3, energy}},
      {"W", {1.0, power}},
      {"kW", {1e3, power}},
      {"Pa", {1.0, pressure}},
      {"kPa", {1e3, pressure}},
      {"MPa", {1e6, pressure}},
      {"GPa", {1e9, pressure}},
      {"N/m", {1.0, stiffness}},
      {"N/cm", {1e2, stiffness}},
      {"N/mm", {1e3, stiffness}},
      {"kN/m", {1e3, stiffness}},
      {"kN/mm", {1e6, stiffness}},
      {"Ns/m", {1.0, damping}},
      {"Ns/mm", {1e3, damping}},
      {"kNs/m", {1e3, damping}},
      {"Nm/rad", {1.0, angularStiffness}},
      {"Nm/deg", {1.0 / kDegree, angularStiffness}},
      {"Nmm/rad", {1e-3, angularStiffness}},
      {"Nmm/deg", {1e-3 / kDegree, angularStiffness}},
      {"Nms/rad", {1.0, angularDamping}},
      {"Nms/deg", {1.0 / kDegree, angularDamping}},
      {"kg/m3", {1.0, density}},
      {"g/cm3", {1e3, density}},
      {"kgm2", {1.0, inertia}},
      {"gcm2", {1e-7, inertia}},
  });
}();

/// "Ns/mm" of "10Ns/mm": the rest of the text if it is meant as a unit with a divisor; else "".
std::string_view wholeUnit(std::string_view text, const Token& number, const Token& end) {
  if (number.unit.empty() || end.kind != TokenKind::over) return {};
  const std::string_view rest = text.substr(number.offset + number.length - number.unit.size());
  const std::size_t over = rest.find('/');
  const char next = over + 1 < rest.size() ? rest[over + 1] : ' ';
  const bool letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
  return letter && rest.find_first_of(" */+-(", over + 1) == std::string_view::npos
             ? rest
             : std::string_view();
}

std::vector<std::string> unitNames() {
  std::vector<std::string> names;
  for (const TableEntry& entry : kTable) names.emplace_back(entry.name);
  return names;
}

}  // namespace

std::optional<UnitSuffix> parseUnitSuffix(std::string_view text) {
  for (const TableEntry& entry : kTable) {
    if (entry.name == text) return entry.unit;
  }
  return std::nullopt;
}

std::span<const std::string> unitSuffixes() {
  static const std::vector<std::string> kNames = unitNames();
  return kNames;
}

std::string_view siUnit(UnitFamily family) {
  for (const TableEntry& entry : kTable) {
    if (entry.unit.family == family) return entry.name;
  }
  return "";
}

Quantity parseQuantity(std::string_view text) {
  const std::vector<Token> tokens = tokenize(text);
  std::size_t i = 0;
  double sign = 1.0;
  if (tokens[i].kind == TokenKind::minus || tokens[i].kind == TokenKind::plus) {
    sign = tokens[i].kind == TokenKind::minus ? -1.0 : 1.0;
    ++i;
  }
  const Token& number = tokens[i];
  if (number.kind != TokenKind::number) {
    throw ExpressionError("expected a number, found " + describe(number, text), number.offset,
                          number.length);
  }
  const Token& end = tokens[i + 1];
  if (const std::string_view unit = wholeUnit(text, number, end); !unit.empty())
    throw ExpressionError("unknown unit \"" + std::string(unit) + "\" after a number",
                          static_cast<std::size_t>(unit.data() - text.data()), unit.size());
  if (end.kind != TokenKind::end) {
    const bool comma = text.substr(end.offset, 1) == ",";
    throw ExpressionError(
        "expected the end after the number, found " + describe(end, text) +
            (comma ? "; decimals have a point, numbers stand between blanks" : ""),
        end.offset, end.length);
  }
  return {sign * number.value, number.family};
}

}  // namespace dynamy
