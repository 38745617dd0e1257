/// All sub-commands, in the order of `dynamy --help`.
#include <CLI/CLI.hpp>

#include "commands.hpp"

namespace dynamy::app {

// One function for each sub-command, in the file of the command: declares it; its callback sets
// program.exitCode.
using AddCommand = void(CLI::App& app, Program& program);
AddCommand addRun, addResume, addVerify, addCheck, addEigen, addEquilibrium, addGradient, addOrbit,
    addFit, addImport, addList, addDescribe, addSchema, addCompare, addView, addSolve, addSweep,
    addReport, addNewPlugin, addExport, addBench, addCompletion, addManual;

void addCommands(CLI::App& app, Program& program) {
  app.set_version_flag("--version", versionText());
  app.require_subcommand(1);
  for (AddCommand* add :
       {addRun,       addResume,  addVerify, addCheck,      addEigen, addEquilibrium,
        addGradient,  addOrbit,   addFit,    addImport,     addList,  addDescribe,
        addSchema,    addCompare, addView,   addSolve,      addSweep, addReport,
        addNewPlugin, addExport,  addBench,  addCompletion, addManual})
    add(app, program);
}

}  // namespace dynamy::app
