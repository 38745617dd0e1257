#pragma once
/// \file
/// Looks whether the files of a run folder are whole and belong together, without changing any:
/// run.json, the tables, the film, the checkpoints. What a file says of another is compared with
/// it: bytes and CRC-32 of each recorded file are in run.json at the end of a run, and in a
/// checkpoint.

#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

struct FileVerdict {
  std::string file;  ///< in the folder
  bool good = true;
  std::string text;  ///< what is in it, or what is wrong with it
};

/// One verdict a file, run.json first. \throws FileError if the folder holds no run
std::vector<FileVerdict> checkFolder(const std::filesystem::path& folder);

}  // namespace dynamy
