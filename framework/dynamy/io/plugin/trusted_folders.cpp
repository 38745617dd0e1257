#include <algorithm>
#include <cstdlib>
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/plugin/trusted_folders.hpp>
#include <fstream>

namespace dynamy {

namespace fs = std::filesystem;

namespace {

/// The folder that an environment variable names; empty unless it is absolute, because a relative
/// one would be found in the current folder.
fs::path folderOf(const char* variable) {
  const char* const text = std::getenv(variable);
  const fs::path folder = text == nullptr ? "" : text;
  return folder.is_absolute() ? folder : fs::path();
}

std::string trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r");
  return begin == std::string::npos ? std::string() : line.substr(begin, end - begin + 1);
}

bool isBelow(const fs::path& folder, const fs::path& top) {
  return std::mismatch(top.begin(), top.end(), folder.begin(), folder.end()).first == top.end();
}

}  // namespace

fs::path trustFile() {
  if (const fs::path own = folderOf("XDG_CONFIG_HOME"); !own.empty())
    return own / "dynamy" / "trusted";
  if (const fs::path home = folderOf("HOME"); !home.empty())
    return home / ".config" / "dynamy" / "trusted";
  return {};
}

TrustedFolders TrustedFolders::of(const fs::path& file) {
  TrustedFolders out;
  std::ifstream in(file);
  if (file.empty() || !in) return out;
  if (const std::string who = writableByOthers(file); !who.empty()) {
    out.notes_.push_back({.place = Place(file.string()), .text = "is not read: " + who});
    return out;
  }
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    std::string text = trimmed(line);
    if (text.empty() || text[0] == '#') continue;
    if (text.starts_with("~/")) text = (folderOf("HOME") / text.substr(2)).string();
    if (fs::path(text).is_absolute())
      out.folders_.emplace_back(text);
    else
      out.notes_.push_back(
          {.place = Place(file.string(), number),
           .text = "\"" + text + "\" is no absolute folder and counts for nothing"});
  }
  return out;
}

bool TrustedFolders::holds(const fs::path& folder) const {
  std::error_code error;
  const fs::path wanted = fs::canonical(folder, error);
  if (error) return false;
  return std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& f) {
    const fs::path top = fs::canonical(f, error);
    return !error && isBelow(wanted, top);
  });
}

}  // namespace dynamy
