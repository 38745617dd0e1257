/// dynamy verify DIR: checks whether the files of a run are complete and belong together.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <dynamy/io/run_files/folder_check.hpp>
#include <memory>

#include "program.hpp"

namespace dynamy::app {

void addVerify(CLI::App& app, Program& program) {
  auto folder = std::make_shared<std::string>();
  CLI::App* c = app.add_subcommand(
      "verify", "check that the files of a run folder are complete and belong together");
  c->add_option("DIR", *folder, "folder of the run")->required();
  c->callback([folder, &program] {
    int faults = 0;
    for (const FileVerdict& v : checkFolder(*folder)) {
      fmt::print(" {:<14}{}  {}\n", v.file, v.good ? "ok    " : "FAULT ", v.text);
      faults += v.good ? 0 : 1;
    }
    if (faults > 0) program.exitCode = kModel;
  });
}

}  // namespace dynamy::app
