/// The libraries that the framework was built with, for `dynamy --version`. If a library is
/// missing, the build fails; no part of dynamY is left out.
#pragma once
#include <string>

namespace dynamy {

/// "HDF5 1.10.8, zlib 1.2.13, …"
std::string libraryVersions();

}  // namespace dynamy
