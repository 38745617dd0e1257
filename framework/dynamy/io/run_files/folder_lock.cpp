#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <thread>
#include <utility>

namespace dynamy {
namespace fs = std::filesystem;
namespace {

constexpr const char* kName = "run.lock";
constexpr int kLockTries = 100;     ///< others may remove their file between open and lock
constexpr int kLooksForHolder = 4;  ///< a query for the holder holds the lock for a moment
constexpr auto kBetweenLooks = std::chrono::milliseconds(20);

std::string ownText() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> when{};
  std::strftime(when.data(), when.size(), "%Y-%m-%d %H:%M:%S", &local);
  return fmt::format("process {} on {} since {}", ::getpid(), host.data(), when.data());
}

std::string textOf(int file) {
  std::array<char, 512> text{};
  const ssize_t n = ::pread(file, text.data(), text.size(), 0);
  std::string out(text.data(), n > 0 ? static_cast<std::size_t>(n) : 0);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out.empty() ? "another process" : out;
}

/// True if the open file still has this name. The holder of the lock may have removed it.
bool isThere(int file, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// True if the lock was taken. On file systems without locks every run gets it and continues as if
/// it were alone.
bool taken(int file) {
  for (int look = 0; look < kLooksForHolder; ++look) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return false;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : file_(folder / kName) {
  for (int i = 0; i < kLockTries; ++i) {
    opened_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (opened_ < 0)
      throw WriteError(file_.string(), std::string("cannot write: ") + std::strerror(errno));
    if (!taken(opened_)) {
      const std::string who = textOf(opened_);
      release();
      throw FileError(folder.string(), "another run writes into this folder (" + who +
                                           "): wait for its end, stop it, or choose another --out");
    }
    if (!isThere(opened_, file_)) {
      release();
      continue;
    }
    const std::string text = ownText() + '\n';
    if (::ftruncate(opened_, 0) == 0 && ::pwrite(opened_, text.data(), text.size(), 0) < 0) {
      // a full disk: the lock holds, only the name is missing
    }
    return;
  }
  throw FileError(file_.string(), "changes hands faster than it can be taken: try again");
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::move(other.file_)), opened_(std::exchange(other.opened_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(file_, other.file_), std::swap(opened_, other.opened_);
  return *this;
}

FolderLock::~FolderLock() {
  if (opened_ >= 0) ::unlink(file_.c_str());  // its own, while the lock is held
  release();
}

void FolderLock::release() noexcept {
  if (opened_ >= 0) ::close(opened_);
  opened_ = -1;
}

std::string FolderLock::holder(const fs::path& folder) {
  const int file = ::open((folder / kName).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};
  const bool held = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  std::string who = held ? textOf(file) : "";
  ::close(file);
  return who;
}

}  // namespace dynamy
