/// dynamy fit MODEL DATA...: parameters from measurements.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <dynamy/io/files/output_file.hpp>
#include <memory>

#include "analysis/analysis_result.hpp"
#include "analysis/fit_text.hpp"
#include "numbers.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

struct FitTask {
  std::string model;
  std::vector<std::string> data, parameters, each, set, sigma, bounds, priors;
  double tolerance = 0.0;
  AnalysisResult result{"fit"};
};

void tellFit(Program& program, const FitTask& task) {
  FileFit wanted{.file = task.model,
                 .runs = {},
                 .parameters = task.parameters,
                 .each = task.each,
                 .tolerance = task.tolerance};
  for (const std::string& text : task.data) wanted.runs.push_back(runOfText(text));
  wanted.set = assignments(task.set);
  wanted.sigma = assignments(task.sigma, "--sigma");
  wanted.bounds = assignments(task.bounds, "--bounds");
  wanted.priors = assignments(task.priors, "--prior");
  const Fit f = fit(wanted, program.registry, program.plugins);
  const std::filesystem::path folder = task.result.folder(task.model);
  writeWholeFile(folder / "residuals.csv", residualsCsv(f));
  writeWholeFile(folder / "fit.html", fitPage(task.model, f));
  task.result.tell(
      task.model, [&](JsonWriter& j) { writeFit(j, f); }, fitText(task.model, f));
  if (!f.converged || !f.identifiable()) program.exitCode = kQualified;
}

}  // namespace

void addFit(CLI::App& app, Program& program) {
  auto t = std::make_shared<FitTask>();
  CLI::App* c = app.add_subcommand(
      "fit", "parameters of a model from measurements, with intervals of confidence");
  c->add_option("MODEL", t->model, "XML file")->required();
  c->add_option("DATA", t->data,
                "CSV files, one for each run: columns t and signals; behind a file the values of "
                "this run: throw.csv:h=1.2,ball.vx=2")
      ->type_name("FILE[:NAME=VALUE,...]")
      ->required();
  c->add_option("--parameters", t->parameters, "to be found, the same in all runs")
      ->type_name("NAME")
      ->delimiter(',');
  c->add_option("--each", t->each, "parameters to be found for each run on its own")
      ->type_name("NAME")
      ->delimiter(',');
  c->add_option("--set", t->set,
                "value of a parameter; of one to be found: where the search begins")
      ->type_name("NAME=VALUE");
  c->add_option("--sigma", t->sigma,
                "standard deviation of a signal whose file has no column sigma(SIGNAL); default: "
                "that of the residuals")
      ->type_name("SIGNAL=VALUE");
  c->add_option("--bounds", t->bounds, "between which a parameter is")->type_name("NAME=LOW:HIGH");
  c->add_option("--prior", t->priors, "what is known of a parameter beforehand")
      ->type_name("NAME=VALUE+-SIGMA");
  c->add_option("--tolerance", t->tolerance,
                "of the runs; default: that of the model, or 1e-9 if it has none")
      ->type_name("NUMBER")
      ->check(positiveNumber());
  t->result.declare(*c, program, "fit.json, fit.html and residuals.csv");
  c->callback([t, &program] {
    program.load();
    tellFit(program, *t);
  });
}

}  // namespace dynamy::app
