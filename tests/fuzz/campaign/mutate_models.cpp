/// A campaign of mutated models through `dynamy check`, each in a process of its own:
///   mutate_models [--count N] [--from I] [--seed S] [--keep DIR] [MODEL...]
/// Promised: no crash, exit status 0, 1 (bodies inside each other), 2 or 3 (a warning), at most 10 s of CPU time
/// and 1 GB of memory, and every error with its place file:line:column. What breaks a promise is
/// printed and kept in DIR; the exit status is then 1. Mutant I of seed S is always the same:
/// --seed S --from I --count 1 makes it again.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <dynamy/io/files/output_file.hpp>
#include <map>
#include <regex>

#include "check.hpp"
#include "mutator.hpp"

namespace dynamy::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kSeconds = 10;
constexpr rlim_t kBytes = 1000000000;

struct Task {
  std::uint64_t count = 1000, from = 0, seed = 1;
  fs::path keep = "mutants";
  std::vector<fs::path> models;
};

/// How a check ended.
struct Verdict {
  std::string fault;  ///< which promise is broken; empty: none
  std::string messages;
  int status = 0;
  double seconds = 0.0, memory = 0.0;  ///< CPU time [s], most memory [bytes]
};

bool isAccepted(const Verdict& v) {
  // An exception that nobody expected ends with kFailed as well, but says so.
  const bool inside = v.status == app::kFailed && v.messages.empty();
  return v.status == app::kOk || inside || v.status == app::kQualified;
}

/// Errors of a file as a whole have no line.
bool isOfTheFile(const std::string& line) {
  static const std::vector<std::string> all{"the file is empty", "the text is UTF-16",
                                            "there is no element in it"};
  return std::any_of(all.begin(), all.end(), [&](const std::string& text) {
    return line.find("error: " + text) != std::string::npos;
  });
}

/// The first error without a place, or "" if all have one.
std::string withoutPlace(const std::string& messages) {
  static const std::regex error("(^|.*: )error: .*"), placed("^[^ ].*:[0-9]+:[0-9]+: error: .*");
  std::size_t errors = 0;
  for (std::size_t begin = 0; begin < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', begin), messages.size());
    const std::string line = messages.substr(begin, std::min<std::size_t>(end - begin, 400));
    begin = end + 1;
    if (line.find("error: ") == std::string::npos || !std::regex_match(line, error)) continue;
    ++errors;
    if (!std::regex_match(line, placed) && !isOfTheFile(line)) return line;
  }
  return errors == 0 ? "no error is told: " + messages.substr(0, 300) : "";
}

/// In the child: limits, silence, the check.
[[noreturn]] void checkHere(app::Program& program, const fs::path& file, int messages) {
  const rlimit time{kSeconds, kSeconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const rlimit memory{2 * kBytes, 2 * kBytes};  // of addresses, those of the libraries among them
  setrlimit(RLIMIT_AS, &memory);
  dup2(messages, STDERR_FILENO);
  dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  app::CheckChoice choice;
  choice.model = file.string();
  const int status = app::withErrorsTold([&] { return app::check(program, choice); });
  std::fflush(nullptr);
  _exit(status);
}

std::string readAll(int fd) {
  std::string out(static_cast<std::size_t>(std::max<off_t>(lseek(fd, 0, SEEK_END), 0)), '\0');
  const ssize_t got = pread(fd, out.data(), out.size(), 0);
  out.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return out;
}

Verdict checked(app::Program& program, const fs::path& file) {
  const int messages = memfd_create("messages", 0);
  const pid_t child = fork();
  if (child == 0) checkHere(program, file, messages);
  int state = 0;
  rusage used{};
  wait4(child, &state, 0, &used);
  Verdict v;
  v.messages = readAll(messages);
  close(messages);
  const auto time = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  v.seconds = time(used.ru_utime) + time(used.ru_stime);
  v.memory = 1024.0 * static_cast<double>(used.ru_maxrss);
  v.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  if (WIFSIGNALED(state) && WTERMSIG(state) == SIGXCPU)
    v.fault = "takes more than 10 s";
  else if (WIFSIGNALED(state))
    v.fault = fmt::format("ended by signal {} ({})", WTERMSIG(state), strsignal(WTERMSIG(state)));
  else if (v.memory > static_cast<double>(kBytes))
    v.fault = fmt::format("takes {:.2g} GB", 1e-9 * v.memory);
  else if (!isAccepted(v) && v.status != app::kModel)
    v.fault = fmt::format("exit status {}: {}", v.status, v.messages.substr(0, 300));
  else if (v.status == app::kModel)
    if (const std::string line = withoutPlace(v.messages); !line.empty())
      v.fault = "an error without its place: " + line;
  return v;
}

/// All models below a folder, sorted.
std::vector<fs::path> modelsIn(const fs::path& folder) {
  std::vector<fs::path> out;
  for (fs::recursive_directory_iterator at(folder), end; at != end; ++at)
    if (at->path().extension() == ".xml") out.push_back(at->path());
  std::sort(out.begin(), out.end());
  return out;
}

/// A model that its own check refuses, or takes long over, gives no mutants.
class Campaign {
 public:
  Campaign(app::Program& program, Task task) : program_(program), task_(std::move(task)) {
    for (const fs::path& path : task_.models) {
      const Verdict v = checked(program_, path);
      if (!isAccepted(v) || v.seconds > 1.0) continue;
      sources_.push_back(path);
      texts_.push_back(readWholeFile(path));
    }
  }

  int run() {
    fmt::print("{} models, mutants {} to {} of seed {}\n", texts_.size(), task_.from,
               task_.from + task_.count - 1, task_.seed);
    if (texts_.empty()) return 1;
    Mutator mutator(texts_);
    for (std::uint64_t i = task_.from; i < task_.from + task_.count; ++i) {
      const std::size_t source = i % texts_.size();
      mutant(sources_[source], mutator.mutate(texts_[source], task_.seed, i), i);
      if ((i + 1) % 10000 == 0) fmt::print("{}\n", i + 1), std::fflush(stdout);
    }
    fmt::print(
        "{} mutants of seed {}: {} accepted, {} refused, {} broke a promise; longest {:.2f} s, "
        "largest {:.0f} MB\n",
        task_.count, task_.seed, accepted_, refused_, faults_, longest_, 1e-6 * largest_);
    return faults_ == 0 ? 0 : 1;
  }

 private:
  /// The mutant stands beside its source, so that what it includes is found.
  void mutant(const fs::path& source, const std::string& text, std::uint64_t i) {
    const fs::path file =
        source.parent_path() / fmt::format(".mutant-{}-{}.xml", getpid(), source.stem().string());
    writeWholeFile(file, text);
    const Verdict v = checked(program_, file);
    fs::remove(file);
    longest_ = std::max(longest_, v.seconds), largest_ = std::max(largest_, v.memory);
    if (v.fault.empty()) return void(isAccepted(v) ? ++accepted_ : ++refused_);
    ++faults_;
    fs::create_directories(task_.keep);
    const fs::path kept =
        task_.keep / fmt::format("{}-{}-{}.xml", source.stem().string(), task_.seed, i);
    writeWholeFile(kept, text);
    fmt::print("{}: {}\n", kept.string(), v.fault);
    std::fflush(stdout);
  }

  app::Program& program_;
  Task task_;
  std::vector<fs::path> sources_;
  std::vector<std::string> texts_;
  std::uint64_t accepted_ = 0, refused_ = 0, faults_ = 0;
  double longest_ = 0.0, largest_ = 0.0;
};

/// The models are copied, since mutants stand beside their sources.
int main(int argc, char** argv) {
  Task task;
  std::vector<std::string> models;
  CLI::App app{"Mutated models through dynamy check"};
  app.add_option("--count", task.count, "mutants")->capture_default_str();
  app.add_option("--from", task.from, "number of the first one")->capture_default_str();
  app.add_option("--seed", task.seed, "of all mutants")->capture_default_str();
  app.add_option("--keep", task.keep, "folder of the mutants that break a promise")
      ->capture_default_str();
  app.add_option("MODEL", models, "the right models; default: models/ and the scenes of bench/");
  CLI11_PARSE(app, argc, argv);
  for (const std::string& model : models) task.models.emplace_back(model);
  const fs::path copy = fs::temp_directory_path() / fmt::format("dynamy-mutants-{}", getpid());
  for (const char* folder : {"models", "bench/stability/scenes", "bench/work_precision/scenes"}) {
    if (!models.empty()) break;
    fs::create_directories(copy / folder);
    fs::copy(fs::path(DYNAMY_SOURCE_DIR) / folder, copy / folder, fs::copy_options::recursive);
    for (const fs::path& path : modelsIn(copy / folder)) task.models.push_back(path);
  }
  app::Program program;
  program.load();
  const int status = Campaign(program, std::move(task)).run();
  fs::remove_all(copy);
  return status;
}

}  // namespace
}  // namespace dynamy::fuzz

int main(int argc, char** argv) { return dynamy::fuzz::main(argc, argv); }
