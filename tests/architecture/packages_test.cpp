/// cmake/packages.txt is the one list of packages: README.md shows it, and no source and no
/// find_package uses a library that it does not name.
#include <gtest/gtest.h>

#include <build_paths.hpp>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

// section → packages
std::map<std::string, std::set<std::string>> packageList() {
  std::map<std::string, std::set<std::string>> list;
  std::string section;
  for (const std::string& line : sourceFile("cmake/packages.txt").lines) {
    std::smatch match;
    if (std::regex_search(line, match, std::regex(R"(^\[(\w+)\])"))) {
      section = match[1];
    } else if (std::regex_search(line, match, std::regex(R"(^([^#\s]+))"))) {
      list[section].insert(match[1]);
    }
  }
  return list;
}

std::set<std::string> allPackages() {
  std::set<std::string> all;
  for (const auto& [section, names] : packageList()) all.insert(names.begin(), names.end());
  return all;
}

// The words of `apt-get install …` between the two markers in README.md.
std::set<std::string> packagesInReadme() {
  std::set<std::string> names;
  bool inside = false;
  for (const std::string& line : sourceFile("README.md").lines) {
    if (line.find("<!-- packages -->") != std::string::npos) inside = true;
    if (line.find("<!-- /packages -->") != std::string::npos) inside = false;
    if (!inside || line.starts_with("```") || line.starts_with("<!--")) continue;
    static const std::regex word(R"([A-Za-z0-9][A-Za-z0-9+.-]*)");
    for (std::sregex_iterator it(line.begin(), line.end(), word), end; it != end; ++it) {
      names.insert(it->str());
    }
  }
  for (const char* other : {"sudo", "apt-get", "install"}) names.erase(other);
  return names;
}

// Beginning of a header's name → package; "" for what the compiler itself brings.
const std::map<std::string, std::string> kHeaders = {
    {"Eigen/", "libeigen3-dev"},
    {"boost/", "libboost-dev"},
    {"boost/dll", "libboost-filesystem-dev"},
    {"boost/filesystem", "libboost-filesystem-dev"},
    {"fmt/", "libfmt-dev"},
    {"CLI/", "libcli11-dev"},
    {"ceres/", "libceres-dev"},
    {"glog/", "libceres-dev"},
    {"tinyxml2.h", "libtinyxml2-dev"},
    {"gtest/", "libgtest-dev"},
    {"gmock/", "libgmock-dev"},
    {"rapidcheck", "librapidcheck-dev"},
    {"benchmark/", "libbenchmark-dev"},
    {"fcl/", "libfcl-dev"},
    {"hdf5", "libhdf5-dev"},
    {"zlib.h", "zlib1g-dev"},
    {"zip.h", "libzip-dev"},
    {"pybind11/", "pybind11-dev"},
    {"omp.h", ""},
    {"immintrin.h", ""},
    {"cxxabi.h", ""},
    {"dlfcn.h", ""},
    {"elf.h", ""},
    {"link.h", ""},
    {"fcntl.h", ""},
    {"unistd.h", ""},
    {"arpa/", ""},
    {"netinet/", ""},
    {"signal.h", ""},
    {"poll.h", ""},
    {"spawn.h", ""},
    {"stdio.h", ""},
    {"stdlib.h", ""},
    {"string.h", ""},
    {"time.h", ""},
    {"sys/", ""},
    {"bits/", ""},
};

// find_package name → package
const std::map<std::string, std::string> kCMake = {
    {"Eigen3", "libeigen3-dev"},
    {"Boost", "libboost-dev"},
    {"fmt", "libfmt-dev"},
    {"tinyxml2", "libtinyxml2-dev"},
    {"CLI11", "libcli11-dev"},
    {"Ceres", "libceres-dev"},
    {"GTest", "libgtest-dev"},
    {"rapidcheck", "librapidcheck-dev"},
    {"benchmark", "libbenchmark-dev"},
    {"fcl", "libfcl-dev"},
    {"HDF5", "libhdf5-dev"},
    {"ZLIB", "zlib1g-dev"},
    {"OpenMP", "g++"},
    {"Threads", "g++"},
    {"dynamy", "g++"},
    {"Python3", "python3"},
    {"pybind11", "pybind11-dev"},
};

// A header of ours, under one of the folders that the compiler searches, or made from NAME.in.
bool isInTree(const std::string& header) {
  const std::filesystem::path root = DYNAMY_SOURCE_DIR;
  if (std::filesystem::exists(root / "tests" / (header + ".in"))) return true;
  for (const char* folder : {"framework/", "elements/", "plugins/", "app/", "tests/"}) {
    for (const SourceFile& file : sourceTree()) {
      if (file.path == folder + header) return true;
    }
  }
  return false;
}

// The longest beginning that fits; nullptr if none does.
const std::string* packageOfHeader(const std::string& header) {
  const std::string* package = nullptr;
  std::size_t longest = 0;
  for (const auto& [begin, name] : kHeaders) {
    if (header.starts_with(begin) && begin.size() > longest) {
      package = &name;
      longest = begin.size();
    }
  }
  return package;
}

}  // namespace

TEST(Packages, ReadmeShowsTheSameList) {
  std::set<std::string> expected = packageList()["build"];
  expected.merge(packageList()["test"]);
  ASSERT_GT(expected.size(), 5u);
  EXPECT_EQ(packagesInReadme(), expected);
}

TEST(Packages, EveryIncludedLibraryIsListed) {
  const std::set<std::string> listed = allPackages();
  // Drivers of other engines are built only where those engines are installed.
  const std::string exempt = "bench/peers/";
  for (const SourceFile* source : filesUnder(
           {"framework/", "elements/", "plugins/", "app/", "tests/", "bench/"}, {".cpp", ".hpp"})) {
    if (source->path.starts_with(exempt)) continue;
    for (const Include& include : includesOf(*source)) {
      const std::string& name = include.name;
      const bool standard = std::regex_match(name, std::regex("[a-z0-9_]+"));
      const bool own =
          isInTree(name) ||
          source->lines[static_cast<std::size_t>(include.line) - 1].find('"') != std::string::npos;
      if (standard || own) continue;
      const std::string* package = packageOfHeader(name);
      ASSERT_NE(package, nullptr) << place(*source, include.line) << ": which package brings <"
                                  << name << ">? Say it in this test and in cmake/packages.txt";
      EXPECT_TRUE(package->empty() || listed.contains(*package))
          << place(*source, include.line) << ": <" << name << "> needs " << *package
          << ", which cmake/packages.txt does not name";
    }
  }
}

TEST(Packages, EveryFindPackageIsListed) {
  const std::set<std::string> listed = allPackages();
  const std::regex pattern(R"((find_package|find_dependency)\((\w+))");
  for (const SourceFile& source : sourceTree()) {
    const bool cmake = source.path.ends_with("CMakeLists.txt") || source.path.ends_with(".cmake") ||
                       source.path.ends_with(".cmake.in");
    if (!cmake || source.path.starts_with("bench/peers/")) continue;
    for (const std::string& line : source.lines) {
      std::smatch match;
      if (line.starts_with("#") || !std::regex_search(line, match, pattern)) continue;
      const auto found = kCMake.find(match[2]);
      ASSERT_NE(found, kCMake.end()) << source.path << ": " << line;
      EXPECT_TRUE(listed.contains(found->second)) << source.path << ": " << line;
    }
  }
}

}  // namespace dynamy::architecture
