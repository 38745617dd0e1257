/// modelDescription.xml of an FMU, by the schema of FMI 3.0.
#pragma once
#include <string>

#include "fmu/fmu_contents.hpp"

namespace dynamy::app {

/// What the description says beside the variables.
struct FmuHead {
  std::string identifier;   ///< of the library: a name of C
  std::string title, text;  ///< of the model
  double until = 1.0;       ///< end of the experiment [s]
  double step = 0.0;        ///< of the communication [s]
  double tolerance = 0.0;   ///< 0: the model has none
  double fixedStep = 0.0;   ///< of the model [s]; 0: it chooses its steps
};

std::string fmuDescription(const FmuHead& head, const fmu::FmuContents& contents);

/// Exponents of kg, m, s and rad in a unit such as "N m s/rad"; an unknown word gives none.
struct UnitExponents {
  int kg = 0, m = 0, s = 0, rad = 0;
};
UnitExponents unitExponents(const std::string& unit);

}  // namespace dynamy::app
