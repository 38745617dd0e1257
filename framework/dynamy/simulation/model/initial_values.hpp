/// Places of coordinates and velocities in a state, by the names of their signals: "toy.phiS".
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// A coordinate or a velocity that has a name, and where it stands in a state.
struct NamedNumber {
  std::string name;
  bool velocity = false;  ///< in u, else in q
  Eigen::Index index = 0;
  std::string rate = {};  ///< of a coordinate: the velocity that is its rate, if q̇ = u
};

/// All of them, in the order of the model.
std::vector<NamedNumber> numbersOfState(const Model& model);

/// The number in `x` that the signal `name` shows; null: no coordinate or velocity has this name.
double* numberOfState(const Model& model, const std::string& name, State& x);

/// Names of all coordinates and velocities.
std::vector<std::string> namesOfState(const Model& model);

/// Sets the coordinate or velocity `name` of x. A velocity of a body that joints carry in their
/// coordinates changes as by a percussion P along it, M δu = Jᵀ P with u_own = J u, so that all
/// joints hold. Throws ModelError for unknown names, for coordinates of such a body, for a velocity
/// that joints do not let change, and for one of the four numbers of a rotation.
void setNumber(const Model& model, const std::string& name, double value, State& x);

/// The model's initial state with one number changed. Throws ModelError for unknown names, and for
/// one of the four numbers of a rotation, which are not free.
void changeInitialValue(const Model& model, const std::string& name, double value, State& x);

}  // namespace dynamy
