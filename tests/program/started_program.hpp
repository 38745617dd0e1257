/// The program in a process of its own, to be waited for, limited and killed.
#pragma once
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <build_paths.hpp>

#include <chrono>
#include <csignal>
#include <optional>
#include <program/program_fixture.hpp>
#include <thread>
#include <utility>
#include <vector>

namespace dynamy {

/// A ball in the x–z plane with e = 0.8 and friction, as formulas.
inline std::string bouncingBallXml(double until, const std::string& step) {
  return R"(<dynamy version="1">
  <parameter name="e" value="0.8" min="0" max="0.999"/>
  <systems><Coordinates name="ball" q="x z" units="m m" q0="0 1" u0="1 0" M="1; 0; 0; 1"
    potential="9.81*z"/></systems>
  <elements><CoordinateContact name="floor" on="ball" gap="z" slip="1; 0">
    <UnilateralCoulomb epsilonN="{e}" mu="0.1"/></CoordinateContact></elements>
  <simulation until=")" +
         std::to_string(until) + "\" step=\"" + step + R"("/>
  <record signals="ball.* floor.*" every="10ms"/>
</dynamy>
)";
}

class StartedProgramTest : public ProgramTest {
 protected:
  using Limit = std::optional<std::pair<int, rlim_t>>;  ///< RLIMIT_… and its value
  /// Starts the program in the folder and leaves it running; its words go to the files out and err.
  pid_t start(const std::vector<std::string>& arguments, const Limit& limit = {}) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    std::vector<std::string> words = {std::string(DYNAMY_BINARY_DIR) + "/bin/dynamy"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& w : words) argv.push_back(w.data());
    argv.push_back(nullptr);
    if (::chdir(folder_.c_str()) != 0 || std::freopen("out", "w", stdout) == nullptr ||
        std::freopen("err", "w", stderr) == nullptr)
      ::_exit(126);
    if (limit) {
      const struct rlimit both { limit->second, limit->second };
      ::setrlimit(static_cast<__rlimit_resource>(limit->first), &both);
    }
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  /// Exit status, or −N if signal N killed it.
  static int ended(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// Waits until the file has more than `bytes`, at most 20 s.
  void waitFor(const std::string& file, std::uintmax_t bytes) const {
    std::error_code none;
    for (int i = 0; i < 2000; ++i) {
      const auto size = std::filesystem::file_size(path(file), none);
      if (!none && size > bytes) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL() << file << " stays small";
  }
};

}  // namespace dynamy
