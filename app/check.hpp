/// `dynamy check`: reads, builds and verifies one model.
#pragma once
#include <dynamy/io/model/model_loader.hpp>
#include <string>

#include "program.hpp"

namespace dynamy::app {

struct CheckChoice {
  std::string model;  ///< path
  Overrides set;
  bool json = false;      ///< print JSON
  bool strict = false;    ///< refuse an initial state that violates joints
  bool elements = false;  ///< also compare all elements with finite differences
};

/// Reads, builds and verifies the model and prints its sizes; returns the exit status. Requires
/// that Program::load has loaded the types. Throws ModelError.
int check(Program& program, const CheckChoice& choice);

}  // namespace dynamy::app
