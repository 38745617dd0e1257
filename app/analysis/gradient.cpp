/// dynamy gradient MODEL: derivatives of signals, checks and instants of events with respect to
/// parameters and initial values.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <dynamy/io/model/file_gradient.hpp>
#include <memory>
#include <utility>

#include "analysis/analysis_result.hpp"
#include "numbers.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

struct GradientTask {
  std::string model;
  std::vector<std::string> of, by, set;
  double tolerance = 0.0;
  bool checks = false;
  AnalysisResult result{"gradient"};
};

/// "left 0.5 ± 1e-9, right none".
std::string sidesText(const GradientValue& v, std::size_t i) {
  std::string out;
  for (const auto& [name, s] : {std::pair("left", v.left[i]), {"right", v.right[i]}}) {
    out += (out.empty() ? "" : ", ") + std::string(name);
    out += std::isnan(s.d) ? " none" : fmt::format(" {:.12g} ± {:.1g}", s.d, s.error);
    if (s.jumps) out += fmt::format(" (the value jumps to {:.12g})", s.limit);
  }
  return out;
}

std::string gradientText(const std::string& model, const Gradient& g) {
  std::string out = fmt::format("{}: tolerance {:g}, {} switches, {} with impacts\n", model,
                                g.tolerance, g.switches, g.impacts);
  std::size_t width = 0;
  for (const std::string& name : g.by) width = std::max(width, name.size());
  for (const GradientValue& v : g.values) {
    const std::string where = v.measure.empty()        ? fmt::format(" at {:g} s", v.at)
                              : v.measure == "instant" ? ""
                                                       : " " + v.measure;
    out += fmt::format(" {}{} = {:.12g} ± {:.1g}\n", v.of, where, v.value, v.error);
    for (std::size_t i = 0; i < g.by.size(); ++i)
      if (g.refused[i].empty() && std::isnan(v.d[i]))
        out += fmt::format("   by {:<{}} none: another event takes its place\n", g.by[i], width);
      else if (g.refused[i].empty())
        out +=
            fmt::format("   by {:<{}} {:>20.12g} ± {:.1g}\n", g.by[i], width, v.d[i], v.dError[i]);
      else
        out += fmt::format("   by {:<{}} {}\n", g.by[i], width, sidesText(v, i));
  }
  return out;
}

void tellGradient(Program& program, const GradientTask& task) {
  FileGradient wanted{.file = task.model,
                      .of = task.of,
                      .by = task.by,
                      .checks = task.checks,
                      .tolerance = task.tolerance};
  wanted.set = assignments(task.set);
  const Gradient g = gradient(wanted, program.registry, program.plugins);
  task.result.tell(
      task.model, [&](JsonWriter& j) { writeGradient(j, g); }, gradientText(task.model, g));
  for (std::size_t i = 0; i < g.by.size(); ++i) {
    if (g.refused[i].empty()) continue;
    fmt::print(stderr, "dynamy: by {}: {}\n", g.by[i], g.refused[i]);
    program.exitCode = kQualified;
  }
}

}  // namespace

void addGradient(CLI::App& app, Program& program) {
  auto t = std::make_shared<GradientTask>();
  CLI::App* c = app.add_subcommand("gradient",
                                   "derivatives of signals and instants with respect to "
                                   "parameters and initial values, exact through impacts, stick "
                                   "and slip");
  c->add_option("MODEL", t->model, "XML file")->required();
  c->add_option(
       "--of", t->of,
       "signals, each at a time or at the end; default: all of systems at the end. Instants: "
       "t:CONTACT=impact#2, t:CONTACT=slip, t:SIGNAL=VALUE+")
      ->type_name("SIGNAL[@TIME]");
  c->add_option("--by", t->by, "parameters, or coordinates and velocities: their initial values")
      ->type_name("NAME")
      ->required();
  c->add_flag("--checks", t->checks, "also the values that the checks of the model measure");
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--tolerance", t->tolerance,
                "of the run; default: that of the model, or 1e-9 if it has none")
      ->type_name("NUMBER")
      ->check(positiveNumber());
  t->result.declare(*c, program, "gradient.json");
  c->callback([t, &program] {
    program.load();
    tellGradient(program, *t);
  });
}

}  // namespace dynamy::app
