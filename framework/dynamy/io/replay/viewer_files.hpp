#pragma once
/// \file
/// The files of app/viewer as text inside the library: the build turns each into a string literal
/// (cmake/EmbedText.cmake), so that an installed program needs no data folder to write a replay.

#include <string_view>

namespace dynamy {

/// The text of app/viewer/`name`; empty if there is no such file.
std::string_view viewerFile(std::string_view name);

}  // namespace dynamy
