/// The libraries that the framework was built with, for `dynamy --version`. No part of dynamY is
/// left out where a library is missing: the build fails instead.
#pragma once
#include <string>

namespace dynamy {

/// "HDF5 1.10.8, zlib 1.2.13, …"
std::string libraryVersions();

}  // namespace dynamy
