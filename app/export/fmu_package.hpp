/// FmuPackage: makes the files of an FMU from a model file:
///
///   modelDescription.xml                   variables, capabilities
///   binaries/x86_64-linux/MODEL.so         the interface, the same in every FMU
///   binaries/x86_64-linux/libdynamy.so.…   what it needs; plug-ins in the folder dynamy
///   documentation/externalDependencies.txt libraries of the system that it needs
///   resources/contents.json                variables, for the library
///   resources/model/…                      the model file and the files that it names
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "export/zip_file.hpp"
#include "program.hpp"

namespace dynamy::app {

struct FmuTask {
  std::string model, out;
  std::vector<std::string> set, signals;
  bool allLibraries = false;  ///< also those of the system
};

struct FmuResult {
  ZipFile zip;
  std::string identifier;  ///< of the library
  std::size_t parameters = 0, inputs = 0, outputs = 0;
};

/// Throws ModelError, FileError.
FmuResult fmuPackage(Program& program, const FmuTask& task);

}  // namespace dynamy::app
