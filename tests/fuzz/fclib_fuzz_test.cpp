// Valid FCLIB files with flipped bits, with other bytes, cut off: each is read with sizes that fit,
// or refused with a message that names the place. Thousands in one process: nothing may crash, and
// what the HDF5 library leaves behind must not grow.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <build_paths.hpp>

#include <algorithm>
#include <cstring>
#include <dynamy/core/error.hpp>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <filesystem>
#include <random>
#include <support/contact_problems.hpp>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> kept() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(fs::path(DYNAMY_SOURCE_DIR) / "tests/data/fclib"))
    out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

void expectSizes(const FclibProblem& p, unsigned seed) {
  const int rows = p.rows();
  EXPECT_EQ(rows, p.dim * p.contacts()) << "seed " << seed;
  EXPECT_EQ(p.mu.size(), p.dim == 1 ? 0 : p.contacts()) << "seed " << seed;
  EXPECT_TRUE(p.mu.size() == 0 || p.mu.minCoeff() >= 0.0) << "seed " << seed;
  if (p.global) {
    EXPECT_EQ(p.M.rows(), p.f.size()) << "seed " << seed;
    EXPECT_EQ(p.M.cols(), p.f.size()) << "seed " << seed;
    EXPECT_EQ(p.H.rows(), p.f.size()) << "seed " << seed;
    EXPECT_EQ(p.H.cols(), rows) << "seed " << seed;
  } else {
    EXPECT_EQ(p.W.rows(), rows) << "seed " << seed;
    EXPECT_EQ(p.W.cols(), rows) << "seed " << seed;
  }
}

/// The most memory that this process ever took [bytes].
double largestMemory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return 1024.0 * static_cast<double>(used.ru_maxrss);
}

/// Mutations [from, to) of the kept files; returns how many were refused.
int mutate(unsigned from, unsigned to) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "mutated.hdf5";
  const std::vector<fs::path> files = kept();
  std::vector<std::string> contents;
  contents.reserve(files.size());
  for (const fs::path& f : files) contents.push_back(readWholeFile(f));
  int refused = 0;
  for (unsigned seed = from; seed < to; ++seed) {
    std::mt19937 generator(seed);
    const auto random = [&generator] { return static_cast<unsigned>(generator()); };
    std::string bytes = contents[random() % contents.size()];
    const unsigned kind = random() % 10;
    if (kind == 0)
      bytes.resize(random() % bytes.size());
    else
      for (unsigned k = random() % 3; k < 3; ++k) {
        char& byte = bytes[random() % bytes.size()];
        byte = kind < 6 ? static_cast<char>(byte ^ (1 << (random() % 8)))
                        : static_cast<char>(random() % 256);
      }
    writeWholeFile(file, bytes);
    try {
      const FclibProblem p = readFclib(file);
      expectSizes(p, seed);
      condensed(p);
    } catch (const ModelError& e) {
      ++refused;
      EXPECT_FALSE(e.diagnostics().front().text.empty()) << "seed " << seed;
    }
    // Files of 30 kB; what is left of earlier ones is among it.
    if (largestMemory() > 1e9) {
      ADD_FAILURE() << "more than 1 GB after seed " << seed;
      break;
    }
  }
  return refused;
}

TEST(FclibFuzz, ChangedFilesAreReadOrRefused) {
  const int refused = mutate(0, 1500);
  // Most bits of a file are numbers of W or free space; what is left must be noticed.
  EXPECT_GT(refused, 100);
}

TEST(LongFclibFuzz, ChangedFilesAreReadOrRefused) { mutate(10'000, 110'000); }

/// The widths of texts, integers and numbers as the file says them: the library would make room for
/// them before it finds that nothing is there.
TEST(FclibFuzz, WidthsThatNoNumberHasAreRefused) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "wide.hdf5";
  FclibProblem p = randomProblem(3, 2, 8, 0.5, 0.0, 1);
  p.title = "a title of 21 letters";
  writeFclib(file, p);
  const std::string bytes = readWholeFile(file);
  // Class and version, three bytes of flags, four of the width [HDF5 file format, IV.A.2.d].
  const std::string kText("\x13\x10\0\0\x16\0\0\0", 8), kInteger("\x10\x08\0\0\x04\0\0\0", 8),
      kNumber("\x11\x20\x3f\0\x08\0\0\0", 8);
  for (const std::string& type : {kText, kInteger, kNumber})
    for (const char high : {'\x10', '\x40', '\x7f'}) {
      std::string changed = bytes;
      std::size_t count = 0;
      for (std::size_t at = 0; (at = changed.find(type, at)) != std::string::npos; ++count)
        changed[at + 7] = high;
      ASSERT_GT(count, 0U);
      writeWholeFile(file, changed);
      EXPECT_THROW(readFclib(file), ModelError) << count;
    }
  EXPECT_LT(largestMemory(), 1e9);
}

/// The names of each group stand in a heap, whose first free block is made to lead to itself: the
/// library would follow it until no memory is left.
TEST(FclibFuzz, FreeBlocksWithoutAnEndAreRefused) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "endless.hdf5";
  const auto number = [](const std::string& bytes, std::size_t at) {
    std::uint64_t out = 0;
    std::memcpy(&out, bytes.data() + at, sizeof out);
    return out;
  };
  for (const fs::path& sound : kept()) {
    const std::string bytes = readWholeFile(sound);
    std::size_t heaps = 0;
    for (std::size_t at = 0; (at = bytes.find("HEAP", at)) != std::string::npos; at += 4) {
      // Signature, version and 3 bytes; size, first free block, address [HDF5 file format, III.D].
      const std::uint64_t block = number(bytes, at + 16), place = number(bytes, at + 24) + block;
      if (block == 1) continue;  // none is free
      std::string changed = bytes;
      std::memcpy(changed.data() + place, &block, sizeof block);
      ++heaps;
      writeWholeFile(file, changed);
      EXPECT_THROW(readFclib(file), ModelError) << sound << " at " << at;
    }
    EXPECT_GT(heaps, 0U) << sound;
  }
  EXPECT_LT(largestMemory(), 1e9);
}

/// Every entry of every integer vector replaced: sizes, storages, pointers, indices.
TEST(FclibFuzz, WrongIntegersOfTheStructureAreRefused) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "mutated.hdf5";
  const FclibProblem p = randomProblem(3, 2, 8, 0.5, 0.0, 1);
  writeFclib(file, p);
  const std::string bytes = readWholeFile(file);
  Eigen::SparseMatrix<double> W = p.W;
  W.makeCompressed();
  // p of W as it lies in the file: 7 integers of 4 bytes.
  const std::string pointers(reinterpret_cast<const char*>(W.outerIndexPtr()), 7 * sizeof(int));
  const std::size_t at = bytes.find(pointers);
  ASSERT_NE(at, std::string::npos);
  for (int entry = 0; entry < 7; ++entry)
    for (const int value : {-1, 1 << 30, W.outerIndexPtr()[entry] == 6 ? 20 : 6}) {
      if (value == W.outerIndexPtr()[entry]) continue;
      std::string changed = bytes;
      changed.replace(at + static_cast<std::size_t>(entry) * sizeof(int), sizeof(int),
                      reinterpret_cast<const char*>(&value), sizeof(int));
      writeWholeFile(file, changed);
      // Pointers that rise all the same are another matrix, and no wrong structure.
      std::vector<int> now(W.outerIndexPtr(), W.outerIndexPtr() + 7);
      now[static_cast<std::size_t>(entry)] = value;
      const bool rises =
          std::is_sorted(now.begin(), now.end()) && now.front() == 0 && now.back() <= W.nonZeros();
      if (rises)
        EXPECT_NO_THROW(readFclib(file)) << entry << ' ' << value;
      else
        EXPECT_THROW(readFclib(file), ModelError) << entry << ' ' << value;
    }
}

}  // namespace
}  // namespace dynamy
