#include "sweep_emit.hpp"

#include <fmt/format.h>

#include <dynamy/io/output_file.hpp>

#include "page.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

/// Slurm's usual MaxArraySize is 1001: larger sweeps take several runs a task.
constexpr std::size_t kMostTasks = 1000;

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string emit(const std::string& engine, const Sweep& sweep, const SweepFolder& folder) {
  const std::string path = fs::absolute(folder.path()).lexically_normal().string();
  const std::size_t each = (sweep.runs() + kMostTasks - 1) / kMostTasks;
  const std::string name = engine + ".sh";
  std::string text(pageFile("sweep_" + name));
  fill(text, "program", quoted(fs::read_symlink("/proc/self/exe").string()));
  fill(text, "folder", quoted(path));
  fill(text, "output", path + "/slurm-%A_%a.txt");
  fill(text, "runs", std::to_string(sweep.runs()));
  fill(text, "each", std::to_string(each));
  fill(text, "tasks", std::to_string((sweep.runs() + each - 1) / each));
  writeWholeFile(folder.path() / name, text);
  fs::permissions(folder.path() / name, fs::perms::owner_exec | fs::perms::group_exec,
                  fs::perm_options::add);
  const std::string script = (folder.path() / name).string();
  return engine == "parallel"
             ? fmt::format(" wrote   {}\n run it: sh {}\n", script, script)
             : fmt::format(
                   " wrote   {}\n submit it: sbatch {}\n then:      dynamy sweep {} --collect\n",
                   script, script, folder.path().string());
}

}  // namespace dynamy::app
