#pragma once
/// \file
/// Checks whether the files of a run folder are complete and belong together, without changing any:
/// run.json, the tables, the film, the checkpoints. Each recorded file is compared with its number
/// of bytes and its CRC-32, which are in run.json at the end of a run, and in a checkpoint.

#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

struct FileVerdict {
  std::string file;  ///< in the folder
  bool good = true;
  std::string text;  ///< its content, or its fault
};

/// One verdict per file, run.json first. \throws FileError if the folder holds no run
std::vector<FileVerdict> checkFolder(const std::filesystem::path& folder);

}  // namespace dynamy
