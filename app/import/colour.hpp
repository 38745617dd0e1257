/// Colours of machines' files as those of a model.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dynamy::app {

/// "#rrggbb" of red, green, blue from 0 to 1; further numbers do not count.
inline std::string hexColour(const std::vector<double>& rgba) {
  std::string out = "#";
  for (std::size_t i = 0; i < 3; ++i)
    out += fmt::format("{:02x}", std::lround(255.0 * std::clamp(rgba[i], 0.0, 1.0)));
  return out;
}

}  // namespace dynamy::app
