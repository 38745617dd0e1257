/// The files of bench/work_precision as text inside the program (cmake/EmbedText.cmake), so that an
/// installed program carries its scenes.
#pragma once
#include <string_view>

namespace dynamy::app {

/// The text of the file called `name`; empty if there is none.
std::string_view precisionFile(std::string_view name);

}  // namespace dynamy::app
