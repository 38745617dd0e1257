#include "architecture/source_tree.hpp"
#include <build_paths.hpp>

#include <stdio.h>  // popen

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace dynamy::architecture {
namespace {

namespace fs = std::filesystem;

// Asks git for tracked files and for new ones that are not ignored; empty without git.
std::vector<std::string> pathsFromGit(const std::string& root) {
  const std::string command =
      "git -C '" + root + "' ls-files --cached --others --exclude-standard 2>/dev/null";
  std::string output;
  if (FILE* pipe = popen(command.c_str(), "r")) {
    char buffer[4096];
    while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, n);
    pclose(pipe);
  }
  std::vector<std::string> paths;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) paths.push_back(line);
  return paths;
}

std::vector<std::string> pathsFromFolder(const fs::path& root) {
  const std::set<std::string> skipped = {".git",   "build",        "runs",       "install",
                                         ".cache", "node_modules", "__pycache__"};
  std::vector<std::string> paths;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::end(it); ++it) {
    const bool topOrHidden = it.depth() == 0 || it->path().filename() == "node_modules";
    if (it->is_directory() && topOrHidden && skipped.contains(it->path().filename().string())) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file()) {
      paths.push_back(it->path().lexically_relative(root).generic_string());
    }
  }
  return paths;
}

std::vector<SourceFile> readTree() {
  const fs::path root = DYNAMY_SOURCE_DIR;
  std::vector<std::string> paths = pathsFromGit(root.string());
  if (paths.empty()) paths = pathsFromFolder(root);
  std::sort(paths.begin(), paths.end());

  std::vector<SourceFile> files;
  for (const std::string& path : paths) {
    std::ifstream stream(root / path, std::ios::binary);
    if (!stream || !fs::is_regular_file(root / path)) continue;
    std::ostringstream text;
    text << stream.rdbuf();
    if (text.str().find('\0') != std::string::npos) continue;
    SourceFile file{path, {}};
    std::istringstream lines(text.str());
    for (std::string line; std::getline(lines, line);) file.lines.push_back(line);
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

const std::vector<SourceFile>& sourceTree() {
  static const std::vector<SourceFile> files = readTree();
  return files;
}

const SourceFile& sourceFile(const std::string& path) {
  for (const SourceFile& file : sourceTree()) {
    if (file.path == path) return file;
  }
  throw std::runtime_error(path + " is missing");
}

std::vector<const SourceFile*> filesUnder(const std::vector<std::string>& folders,
                                          const std::vector<std::string>& endings) {
  std::vector<const SourceFile*> found;
  for (const SourceFile& file : sourceTree()) {
    const auto begins = [&](const std::string& folder) { return file.path.starts_with(folder); };
    const auto ends = [&](const std::string& ending) { return file.path.ends_with(ending); };
    if (std::any_of(folders.begin(), folders.end(), begins) &&
        (endings.empty() || std::any_of(endings.begin(), endings.end(), ends))) {
      found.push_back(&file);
    }
  }
  return found;
}

std::vector<Include> includesOf(const SourceFile& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> includes;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    if (file.lines[i].find("include") == std::string::npos) continue;
    std::smatch match;
    if (std::regex_search(file.lines[i], match, pattern)) {
      includes.push_back({match[1].str(), static_cast<int>(i) + 1});
    }
  }
  return includes;
}

std::string_view withoutComment(std::string_view line) { return line.substr(0, line.find("//")); }

std::string place(const SourceFile& file, int line) {
  return file.path + ":" + std::to_string(line);
}

}  // namespace dynamy::architecture
