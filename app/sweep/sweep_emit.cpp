#include "sweep/sweep_emit.hpp"

#include <fmt/format.h>

#include <dynamy/io/files/output_file.hpp>

#include "page.hpp"
#include "shell_text.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

/// Slurm's usual MaxArraySize is 1001; in larger sweeps each task computes several runs.
constexpr std::size_t kMostTasks = 1000;

/// The user's options --plugin and --trust. The script repeats them, because a folder itself may
/// not grant trust.
std::string options(const Program& program) {
  std::string out;
  for (const std::string& library : program.libraries) {
    const bool path = library.find('/') != std::string::npos;
    out += " --plugin " +
           shellQuoted(path ? fs::absolute(library).lexically_normal().string() : library);
  }
  return out + (program.trust ? " --trust" : "");
}

}  // namespace

std::string emit(const std::string& engine, const Program& program, const Sweep& sweep,
                 const SweepFolder& folder) {
  const std::string path = fs::absolute(folder.path()).lexically_normal().string();
  const std::size_t each = (sweep.runs() + kMostTasks - 1) / kMostTasks;
  const std::string name = engine + ".sh";
  const std::string text =
      filled(pageFile("sweep_" + name),
             {{"program", shellQuoted(fs::read_symlink("/proc/self/exe").string())},
              {"folder", shellQuoted(path)},
              {"options", options(program)},
              {"runs", std::to_string(sweep.runs())},
              {"each", std::to_string(each)},
              {"tasks", std::to_string((sweep.runs() + each - 1) / each)}});
  writeWholeFile(folder.path() / name, text);
  fs::permissions(folder.path() / name, fs::perms::owner_exec | fs::perms::group_exec,
                  fs::perm_options::add);
  const std::string script = shellWord((folder.path() / name).string());
  return engine == "parallel"
             ? fmt::format(" wrote   {}\n run it: sh {}\n", script, script)
             : fmt::format(
                   " wrote   {}\n submit it: sbatch {}\n then:      dynamy sweep {} --collect\n",
                   script, script, shellWord(folder.path().string()));
}

}  // namespace dynamy::app
