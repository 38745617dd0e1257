#include <dynamy/core/version.hpp>
#include <string>

// Exit status 0 if the library that was found belongs to the headers that were found.
int main() {
  const std::string headers = std::to_string(dynamy::kVersionMajor) + "." +
                              std::to_string(dynamy::kVersionMinor) + "." +
                              std::to_string(dynamy::kVersionPatch);
  return dynamy::versionString() == headers ? 0 : 1;
}
