/// What `dynamy check` does with one model.
#pragma once
#include <dynamy/io/model/model_loader.hpp>
#include <string>

#include "program.hpp"

namespace dynamy::app {

struct CheckChoice {
  std::string model;  ///< path
  Overrides set;
  bool json = false;      ///< print JSON
  bool strict = false;    ///< refuse a start that joints do not allow
  bool elements = false;  ///< also compare all elements with differences
};

/// Reads, builds and verifies the model and prints its sizes; returns the exit status. The types
/// are loaded (Program::load). Throws ModelError.
int check(Program& program, const CheckChoice& choice);

}  // namespace dynamy::app
