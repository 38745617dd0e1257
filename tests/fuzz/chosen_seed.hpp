/// The seed of a fuzz test: another one in every run, unless DYNAMY_SEED gives it.
#pragma once
#include <cstdlib>
#include <random>

namespace dynamy::fuzz {

inline unsigned chosenSeed() {
  const char* given = std::getenv("DYNAMY_SEED");
  return given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10))
                          : std::random_device{}();
}

}  // namespace dynamy::fuzz
