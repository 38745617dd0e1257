/// Identifies the build of the program.
#pragma once
#include <string>

namespace dynamy::app {

/// Version, compiler and a fingerprint, as in "0.1.0, gcc 12.2, build 3f…". The fingerprint covers
/// the build identifiers that the linker gave the program, the framework and the loaded standard
/// elements. Equal texts mean equal machine code.
std::string buildText();

}  // namespace dynamy::app
