/// All sub-commands, in the order of `dynamy --help`.
#include <CLI/CLI.hpp>

#include "commands.hpp"

namespace dynamy::app {

void addCommands(CLI::App& app, Program& program) {
  app.set_version_flag("--version", versionText());
  app.require_subcommand(1);
  addRun(app, program);
  addResume(app, program);
  addVerify(app, program);
  addCheck(app, program);
  addEigen(app, program);
  addList(app, program);
  addDescribe(app, program);
  addSchema(app, program);
  addCompare(app, program);
  addView(app, program);
  addSolve(app, program);
  addSweep(app, program);
  addReport(app, program);
  addNewPlugin(app, program);
  addBench(app, program);
  addCompletion(app, program);
  addManual(app, program);
}

}  // namespace dynamy::app
