/// Handle: what a fmi3Instance points to: an instance and the calls of the other program.
#pragma once
#include <memory>
#include <string>

#include "fmu/fmi3.hpp"

namespace dynamy::fmu {
class FmuInstance;
}

namespace dynamy::fmi3 {

struct Handle {
  Environment environment = nullptr;
  LogMessage log = nullptr;
  IntermediateUpdate update = nullptr;
  bool earlyReturn = false;
  std::unique_ptr<fmu::FmuInstance> instance;

  Handle();
  ~Handle();
  /// Reports an error of the function `call` to the other program.
  void say(Status status, const char* call, const std::string& text) const;
};

/// Reports that a function is not served.
Status unserved(Instance i, const char* call);

}  // namespace dynamy::fmi3
