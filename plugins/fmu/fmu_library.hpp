/// FmuLibrary: the library of an FMU, and calls of its functions, which return a status.
#pragma once
#include <string>

#include "fmu_file.hpp"

namespace dynamy {

class FmuLibrary {
 public:
  /// Loads it; it stays loaded, since some FMUs leave threads or data behind. Throws
  /// std::runtime_error.
  explicit FmuLibrary(std::shared_ptr<const FmuFile> file);
  const FmuFile& file() const { return *file_; }
  /// The function of this name without the prefix fmi2 or fmi3. Throws std::runtime_error.
  template <class F>
  F* function(const char* name) const {
    return reinterpret_cast<F*>(address(name));
  }
  /// Calls it. Throws std::runtime_error with its name and what the FMU logged if it has failed.
  template <class... Arguments>
  void call(const char* name, Arguments... arguments) const {
    check(name, function<int(Arguments...)>(name)(arguments...));
  }
  mutable std::string logged;  ///< the last message of the FMU about a failure

 private:
  void* address(const char* name) const;
  void check(const char* name, int status) const;
  std::shared_ptr<const FmuFile> file_;
  void* library_ = nullptr;
};

}  // namespace dynamy
