/// Which build of the program this is.
#pragma once
#include <string>

namespace dynamy::app {

/// Version, compiler, and a fingerprint of the build identifiers that the linker gave the program,
/// the framework and the standard elements, which are loaded: equal texts, equal machine code.
/// "0.1.0, gcc 12.2, build 3f…"
std::string buildText();

}  // namespace dynamy::app
