/// Values of coordinates and velocities that a user names, as `--start toy.phiS=0.1`.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// Sets the coordinate or velocity `name` ("toy.phiS") in a state. Throws ModelError with the
/// nearest known name.
void placeInState(const Model& model, const std::string& name, const std::string& value, State& x);

}  // namespace dynamy
