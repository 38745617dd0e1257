#pragma once
/// \file
/// Colours as CSS writes them: "#c8553d", "#fa0", or one of the 148 names of CSS Color Level 4.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dynamy {

/// Red, green, blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// The colour of a text in any case; none if it is no name and no "#rgb" or "#rrggbb".
std::optional<Rgb> cssColour(std::string_view text);

/// The name of a colour that is nearest to a misspelt one; "" if none is near.
std::string nearestColour(std::string_view text);

}  // namespace dynamy
