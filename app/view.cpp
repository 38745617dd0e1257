/// dynamy view DIR: writes replay.html of a run folder anew and opens it in the browser.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <filesystem>
#include <memory>

#include "program.hpp"
#include "run/run_text.hpp"
#include "shell_text.hpp"

namespace dynamy::app {
namespace {

struct ViewOptions {
  std::string folder;
  bool noBrowser = false;
};

int view(const ViewOptions& options) {
  const RunFolder folder = RunFolder::existing(options.folder);
  const ReplaySize size = writeReplay(folder.path());
  const std::string page = std::filesystem::absolute(folder.replay()).lexically_normal().string();
  fmt::print("{}\n", page);
  fmt::print(stderr, "{}", thinningText(size));
  if (options.noBrowser) return kOk;
  const std::string command = "xdg-open " + shellQuoted(page) + " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0)
    fmt::print(stderr, "dynamy: no browser was found; open the page by hand\n");
  return kOk;
}

}  // namespace

void addView(CLI::App& app, Program& program) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* sub = app.add_subcommand("view", "write replay.html of a run anew and open it");
  sub->add_option("DIR", options->folder, "run folder, e.g. runs/ball")->required();
  sub->add_flag("--no-browser", options->noBrowser, "only write the page");
  sub->callback([options, &program] { program.exitCode = view(*options); });
}

}  // namespace dynamy::app
