/// The files of the repository as text, for tests that read the sources themselves.
/// Rejected: a script in another language, because these tests shall run wherever the others run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dynamy::architecture {

/// One text file; `path` is relative to the root of the repository, with '/'.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

/// One line `#include <name>` or `#include "name"`.
struct Include {
  std::string name;
  int line = 0;  ///< counted from 1
};

/// All text files that belong to the repository: those git tracks or would track, else (no git) all
/// outside of the folders that builds and runs make. Files with a zero byte are left out.
const std::vector<SourceFile>& sourceTree();

/// The file at `path`; throws std::runtime_error if there is none.
const SourceFile& sourceFile(const std::string& path);

/// The endings of files of code.
inline const std::vector<std::string> kCode = {".cpp", ".hpp"};

/// The files under one of the folders, e.g. {"framework/", "elements/"}, with one of the endings;
/// an empty list of endings means all.
std::vector<const SourceFile*> filesUnder(const std::vector<std::string>& folders,
                                          const std::vector<std::string>& endings = {});

std::vector<Include> includesOf(const SourceFile& file);

/// The line without what follows //; strings are not looked into.
std::string_view withoutComment(std::string_view line);

/// "path:line" for messages.
std::string place(const SourceFile& file, int line);

}  // namespace dynamy::architecture
