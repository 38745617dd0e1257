#include <cmath>
#include <cstdlib>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/start_values.hpp>
#include <dynamy/simulation/model/initial_values.hpp>

namespace dynamy {

void placeInState(const Model& model, const std::string& name, const std::string& value, State& x) {
  double* place = numberOfState(model, name, x);
  if (place == nullptr)
    throw ModelError("no coordinate or velocity named \"" + name + '"',
                     unknownNameHint(name, namesOfState(model)));
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (value.empty() || *end != '\0' || !std::isfinite(number))
    throw ModelError("start of " + name + ": \"" + value + "\" is no finite number");
  *place = number;
}

}  // namespace dynamy
