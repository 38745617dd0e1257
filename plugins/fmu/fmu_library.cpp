#include "fmu_library.hpp"

#include <dlfcn.h>

#include <array>
#include <stdexcept>

namespace dynamy {

FmuLibrary::FmuLibrary(std::shared_ptr<const FmuFile> file) : file_(std::move(file)) {
  library_ = dlopen(file_->library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr)
    throw std::runtime_error("its library cannot be loaded: " + std::string(dlerror()));
}

void* FmuLibrary::address(const char* name) const {
  const std::string full = (file_->version == 2 ? "fmi2" : "fmi3") + std::string(name);
  void* found = dlsym(library_, full.c_str());
  if (found == nullptr) throw std::runtime_error("its library has no function " + full);
  return found;
}

void FmuLibrary::check(const char* name, int status) const {
  static const std::array<const char*, 5> kWords{"", "", "discarded the call", "failed",
                                                 "failed fatally"};
  constexpr int kWarning = 1;
  if (status <= kWarning) return;
  const auto place = static_cast<std::size_t>(status);
  throw std::runtime_error("fmi" + std::to_string(file_->version) + name + ' ' +
                           (place < kWords.size() ? kWords[place] : "is not finished") +
                           (logged.empty() ? "" : ": " + logged));
}

}  // namespace dynamy
