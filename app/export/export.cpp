/// dynamy export fmu MODEL, dynamy export vtk DIR: a model, or the film of a run, for other programs.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "export/fmu_package.hpp"
#include "export/vtk_series.hpp"
#include "paths.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

void exportFmu(Program& program, const FmuTask& task) {
  requireOtherFile(task.out, task.model);
  const FmuResult result = fmuPackage(program, task);
  const std::filesystem::path out = task.out.empty() ? result.identifier + ".fmu" : task.out;
  result.zip.write(out);
  fmt::print("{}: FMI 3.0 co-simulation, {} parameters, {} inputs, {} outputs\n", out.string(),
             result.parameters, result.inputs, result.outputs);
}

void exportVtk(const VtkTask& task) {
  const VtkResult result = writeVtkSeries(task);
  fmt::print("{}: bodies.pvd and contacts.pvd, {} frames\n", result.folder.string(), result.frames);
}

void addVtk(CLI::App& all) {
  auto t = std::make_shared<VtkTask>();
  CLI::App* c = all.add_subcommand("vtk", "the film of a run, bodies and contacts, for ParaView");
  c->add_option("DIR", t->run, "run folder, e.g. runs/ball")->required();
  c->add_option("-o,--out", t->out, "folder to write; default: vtk in the run's")->type_name("DIR");
  c->add_option("--sides", t->sides, "sides of round shapes; default: 24")
      ->type_name("NUMBER")
      ->check(CLI::Range(3, 1000));
  c->callback([t] { exportVtk(*t); });
}

}  // namespace

void addExport(CLI::App& app, Program& program) {
  auto t = std::make_shared<FmuTask>();
  CLI::App* all = app.add_subcommand("export", "packages for other programs");
  all->require_subcommand(1);
  CLI::App* c = all->add_subcommand(
      "fmu", "a model as an FMU (FMI 3.0, co-simulation), with its files and plug-ins");
  c->add_option("MODEL", t->model, "XML file")->required();
  c->add_option("-o,--out", t->out, "file to write; default: MODEL.fmu")->type_name("FILE");
  c->add_option("--set", t->set, "start value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--signals", t->signals,
                "outputs, instead of the recorded signals: names, or beginnings with a *")
      ->type_name("NAME");
  c->add_flag("--all-libraries", t->allLibraries,
              "also the libraries that dynamY needs of the system, but for those of C and C++");
  addPlugins(*c, program);
  c->callback([t, &program] {
    program.load();
    exportFmu(program, *t);
  });
  addVtk(*all);
}

}  // namespace dynamy::app
