/// Reads the catalogue of scenes, and runs many cells in separate processes.
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <dynamy/io/files/output_file.hpp>
#include <filesystem>
#include <sstream>

#include "stability/stability_cell.hpp"
#include "stability/stability_files.hpp"

namespace dynamy::app {
namespace {

/// Text of the first comment of a model, without line ends.
std::string firstComment(std::string_view text) {
  const auto begin = text.find("<!--"), end = text.find("-->");
  if (begin == std::string_view::npos || end == std::string_view::npos) return "";
  std::istringstream in{std::string(text.substr(begin + 4, end - begin - 4))};
  std::string out;
  for (std::string word; in >> word;) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::string titleOf(std::string_view text) {
  const auto at = text.find("title=\"");
  if (at == std::string_view::npos) return "";
  const auto begin = at + 7;
  return std::string(text.substr(begin, text.find('"', begin) - begin));
}

/// A cell that runs in a child process.
struct Child {
  pid_t id = -1;
  int pipe = -1;
  std::size_t task = 0;
  std::string bytes;
};

void work(Program& program, const StabilityScene& scene, const StabilityTask& task, double limit,
          int pipe) {
  rlimit cpu{static_cast<rlim_t>(limit), static_cast<rlim_t>(limit) + 2};
  setrlimit(RLIMIT_CPU, &cpu);
  StabilityResult result;
  try {
    result = runCell(program, scene, task);
  } catch (const std::exception& e) {
    result.words = std::string("error: ") + e.what() + '\n';
  }
  Archive a;
  a(result);
  const std::string& bytes = a.bytes();
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = ::write(pipe, bytes.data() + at, bytes.size() - at);
    if (n <= 0) break;
    at += static_cast<std::size_t>(n);
  }
}

StabilityResult resultOf(const Child& child, int status, double limit) {
  StabilityResult out;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && !child.bytes.empty()) {
    Archive a(child.bytes);
    a(out);
    return out;
  }
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  out.figure = std::nan("");
  out.verdict = Verdict::fail;
  out.words = signal == SIGXCPU || signal == SIGKILL
                  ? fmt::format("cost: not done after {:g} s of CPU time\n", limit)
                  : fmt::format("crash: the run ended by signal {}\n", signal);
  return out;
}

Child start(Program& program, const std::vector<StabilityScene>& scenes, const StabilityTask& task,
            std::size_t index, double limit) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe for a cell");
  std::fflush(nullptr);
  const pid_t id = fork();
  if (id < 0) throw std::runtime_error("no process for a cell");
  if (id == 0) {
    close(ends[0]);
    work(program, scenes[static_cast<std::size_t>(task.scene)], task, limit, ends[1]);
    close(ends[1]);
    std::_Exit(0);  // leaves the files and plug-ins of the parent alone
  }
  close(ends[1]);
  return {id, ends[0], index, {}};
}

/// Waits for output of the children; returns the index of one that has ended, else their count.
std::size_t listen(std::vector<Child>& children) {
  std::vector<pollfd> all;
  for (const Child& c : children) all.push_back({c.pipe, POLLIN, 0});
  poll(all.data(), all.size(), -1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].revents == 0) continue;
    char buffer[4096];
    const ssize_t n = read(children[i].pipe, buffer, sizeof(buffer));
    if (n <= 0) return i;
    children[i].bytes.append(buffer, static_cast<std::size_t>(n));
  }
  return children.size();
}

}  // namespace

std::vector<StabilityScene> stabilityScenes(const std::string& folder) {
  const auto file = [&](const std::string& name) {
    if (!folder.empty()) return readWholeFile(std::filesystem::path(folder) / name);
    return std::string(stabilityFile(name));
  };
  std::vector<StabilityScene> out;
  std::istringstream catalogue{file("catalogue.txt")};
  for (std::string line; std::getline(catalogue, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    StabilityScene s;
    if (!(words >> s.name)) continue;
    for (std::string word; words >> word;) {
      const bool quick = word.back() == '*';
      if (quick) word.pop_back();
      s.steps.push_back(seconds(word, "catalogue.txt"));
      if (quick) s.quickStep = s.steps.back();
    }
    s.text = file(s.name + ".xml");
    s.title = titleOf(s.text), s.about = firstComment(s.text);
    out.push_back(std::move(s));
  }
  return out;
}

std::vector<StabilityResult> runCells(Program& program, const std::vector<StabilityScene>& scenes,
                                      const std::vector<StabilityTask>& tasks, int jobs,
                                      double limit, const std::function<void(std::size_t)>& done) {
  std::vector<StabilityResult> out(tasks.size());
  std::vector<Child> running;
  std::size_t next = 0, ended = 0;
  while (ended < tasks.size()) {
    while (next < tasks.size() && running.size() < static_cast<std::size_t>(jobs)) {
      running.push_back(start(program, scenes, tasks[next], next, limit));
      ++next;
    }
    const std::size_t i = listen(running);
    if (i == running.size()) continue;
    int status = 0;
    close(running[i].pipe);
    waitpid(running[i].id, &status, 0);
    out[running[i].task] = resultOf(running[i], status, limit);
    running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    done(++ended);
  }
  return out;
}

}  // namespace dynamy::app
