#include <fmt/format.h>
#include <dynamy/core/version.hpp>

namespace dynamy {

std::string versionString() {
  return fmt::format("{}.{}.{}", kVersionMajor, kVersionMinor, kVersionPatch);
}

}  // namespace dynamy
