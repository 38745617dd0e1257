#pragma once
/// \file
/// Errors of files: path and reason in one line that can be shown to the user. They are separate
/// from ModelError, because a full disk or a foreign folder is no fault of a model and has no line
/// in it.

#include <stdexcept>
#include <string>

namespace dynamy {

/// A file or folder that cannot be read, written or replaced. what() reads "path: reason".
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& reason)
      : std::runtime_error(path + ": " + reason) {}
};

/// A file cannot be written: the disk or the quota is full, the file is longer than the system
/// allows, the folder is not ours.
class WriteError : public FileError {
 public:
  using FileError::FileError;
};

}  // namespace dynamy
