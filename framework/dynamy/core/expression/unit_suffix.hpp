/// Units directly behind a number: `30deg`, `5mm`, `1e3N/m` → SI factor and family.
///
/// value [SI] = number · factor. A flat table with named families, no algebra of dimensions: an
/// attribute only needs to know whether "5mm" is a length. Rejected: exponents of the base units,
/// which cannot tell a moment [Nm] from an energy [J] nor an angle from a pure number.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dynamy {

enum class UnitFamily {
  none,
  length,               // m
  area,                 // m²
  volume,               // m³
  time,                 // s
  mass,                 // kg
  angle,                // rad
  frequency,            // Hz
  velocity,             // m/s
  angularVelocity,      // rad/s
  acceleration,         // m/s²
  angularAcceleration,  // rad/s²
  force,                // N
  moment,               // Nm
  impulse,              // Ns
  energy,               // J
  power,                // W
  pressure,             // Pa
  stiffness,            // N/m
  damping,              // Ns/m
  angularStiffness,     // Nm/rad
  angularDamping,       // Nms/rad
  density,              // kg/m³
  inertia               // kg m²
};

struct UnitSuffix {
  double factor = 1.0;  ///< number · factor is the SI value
  UnitFamily family = UnitFamily::none;
};

/// Factor and family of a suffix such as "mm" or "N/m"; nothing if it is unknown. Case matters.
std::optional<UnitSuffix> parseUnitSuffix(std::string_view text);

/// All suffixes, for "did you mean".
std::span<const std::string> unitSuffixes();

/// SI unit of a family as text, "m" or "kg/m3"; "" for none.
std::string_view siUnit(UnitFamily family);

/// A number with an optional unit.
struct Quantity {
  double value = 0.0;  ///< in SI units
  UnitFamily family = UnitFamily::none;
};

/// Reads text = [sign] number [suffix], blanks around it allowed: "-30deg". Raises ExpressionError
/// with the place.
Quantity parseQuantity(std::string_view text);

}  // namespace dynamy
