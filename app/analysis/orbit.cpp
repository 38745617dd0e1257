/// dynamy orbit MODEL: a periodic orbit, its shift and its multipliers, or a branch of them.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/model/file_branch.hpp>
#include <memory>

#include "analysis/analysis_result.hpp"
#include "analysis/branch_page.hpp"
#include "numbers.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

struct OrbitTask {
  std::string model, section, over, show;
  std::vector<std::string> set, start, mirror;
  double tolerance = 0.0, period = 0.0;
  int returns = 0, brute = 0;
  AnalysisResult result{"orbit"};
};

constexpr double kReal = 1e-12;  ///< smaller imaginary parts are rounding

std::string multiplierText(std::complex<double> m) {
  if (std::abs(m.imag()) <= kReal) return fmt::format("{:.12g}", m.real());
  return fmt::format("{:.12g} {} {:.12g} i", m.real(), m.imag() < 0.0 ? '-' : '+',
                     std::abs(m.imag()));
}

std::string stabilityText(const Orbit& o) {
  const double most = o.largest();
  if (o.multipliers.size() == 0) return "stable: every small disturbance is gone after a period";
  if (most > 1.0 + o.multiplierError)
    return fmt::format("unstable: small disturbances grow by a factor of {:.6g} a period", most);
  if (most > 1.0 - std::max(o.multiplierError, 1e-9))
    return "neither stable nor unstable to first order: some small disturbance lasts";
  return fmt::format("stable: small disturbances shrink to {:.6g} of their size a period", most);
}

std::string orbitText(const std::string& model, const Orbit& o) {
  std::string out = fmt::format(
      "{}: a periodic orbit, {} switches, {} with impacts\n"
      " period {:.13g} s ± {:.1g}\n"
      " found in {} steps of Newton's method from {:.2g} away, residual {:.1g}; tolerance {:g}\n"
      " at the section ({}):\n",
      model, o.switches, o.impacts, o.period, o.periodError, o.newton, o.away, o.residual,
      o.tolerance, o.section.text());
  std::size_t width = 0;
  for (const auto& [name, value] : o.state) width = std::max(width, name.size());
  for (const auto& [name, value] : o.state)
    out += fmt::format("   {:<{}} {:>20.13g}\n", name, width, value);
  if (!o.shift.empty()) out += " changes a period, on which nothing depends:\n";
  for (const auto& [name, value] : o.shift)
    out += fmt::format("   {:<{}} {:>20.13g}\n", name, width, value);
  out += fmt::format(" {}\n", stabilityText(o));
  if (o.multipliers.size() > 0) out += fmt::format(" multipliers, ± {:.1g}:\n", o.multiplierError);
  for (const std::complex<double>& m : o.multipliers)
    out += fmt::format("   {}   modulus {:.6g}\n", multiplierText(m), std::abs(m));
  if (o.zeros > 0)
    out += fmt::format(" {} of the multipliers {} exactly zero: impacts or sticking end {}\n",
                       o.zeros, o.zeros == 1 ? "is" : "are",
                       o.zeros == 1 ? "this disturbance" : "these disturbances");
  return out;
}

std::string branchText(const std::string& model, const NamedBranch& b) {
  const auto& points = b.branch.points;
  const auto stable =
      std::count_if(points.begin(), points.end(), [](const BranchPoint& p) { return p.stable; });
  std::string out = fmt::format(
      "{}: {} periodic orbits over {}, {} of them stable; {} runs over one period\n"
      " at the section ({})\n",
      model, points.size(), b.parameter, stable, b.branch.cycles, b.branch.section.text());
  for (const BranchPoint& p : points)
    if (!p.kind.empty()) out += fmt::format(" {:<16.12g} {:<14} {}\n", p.p, p.kind, p.text);
  if (!b.brute.empty())
    out += fmt::format(" {} passes of the section by plain runs in brute.csv\n", b.brute.size());
  return out;
}

void tellBranch(Program& program, const OrbitTask& task, const FileOrbit& wanted) {
  const NamedBranch b = branch({.orbit = wanted, .over = task.over, .brute = task.brute},
                               program.registry, program.plugins);
  const std::filesystem::path folder = task.result.folder(task.model);
  const std::string show = task.show.empty() ? shownSignal(b) : task.show;
  const auto& known = b.branch.signals;
  if (show != "period" && show != "multiplier" &&
      std::find(known.begin(), known.end(), show) == known.end())
    throw ModelError("nothing named \"" + show + "\" on the branch", unknownNameHint(show, known));
  writeWholeFile(folder / "branch.csv", branchCsv(b));
  if (task.brute > 0) writeWholeFile(folder / "brute.csv", bruteCsv(b));
  writeWholeFile(folder / "branch.svg", branchSvg(b, show));
  writeWholeFile(folder / "branch.html", branchPage(task.model, b));
  task.result.tell(
      task.model, [&](JsonWriter& j) { writeBranch(j, b); }, branchText(task.model, b), "branch");
}

void tellOrbit(Program& program, const OrbitTask& task) {
  FileOrbit wanted{.file = task.model,
                   .section = task.section,
                   .period = task.period,
                   .returns = task.returns,
                   .mirror = task.mirror,
                   .tolerance = task.tolerance};
  wanted.set = assignments(task.set);
  for (const std::string& s : task.start) wanted.start.push_back(numberAssignment("--start", s));
  if (!task.over.empty()) {
    tellBranch(program, task, wanted);
    return;
  }
  const Orbit o = orbit(wanted, program.registry, program.plugins);
  task.result.tell(
      task.model, [&](JsonWriter& j) { writeOrbit(j, o); }, orbitText(task.model, o));
}

}  // namespace

void addOrbit(CLI::App& app, Program& program) {
  auto t = std::make_shared<OrbitTask>();
  CLI::App* c = app.add_subcommand(
      "orbit", "a periodic orbit of a run to a tolerance, stable or not, and its multipliers");
  c->add_option("MODEL", t->model, "XML file")->required();
  c->add_option(
       "--section", t->section,
       "where the orbit is cut: a signal passes a value, rising (+) or falling (-); default: "
       "<orbit> of the model")
      ->type_name("SIGNAL=VALUE[+|-]");
  c->add_option("--period", t->period, "of a forcing [s], in place of a section")
      ->type_name("NUMBER")
      ->check(positiveNumber())
      ->excludes("--section");
  c->add_option("--returns", t->returns, "passes, or periods of the forcing, in one orbit")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1000));
  c->add_option("--mirror", t->mirror,
                "the motion repeats itself mirrored after half a period: coordinates that change "
                "their signs, or are exchanged")
      ->type_name("SIGNAL[=[-]SIGNAL]");
  c->add_option("--start", t->start,
                "coordinate or velocity from which the search begins; default: the model's")
      ->type_name("SIGNAL=VALUE");
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  CLI::Option* over =
      c->add_option("--over", t->over,
                    "follow the orbit over a parameter, through folds; COUNT: about how many "
                    "orbits between the bounds, default 100")
          ->type_name("NAME=FROM:TO[:COUNT]");
  c->add_option("--brute", t->brute,
                "with --over: values of the parameter at which plain runs show, after a transient, "
                "where the motion itself goes")
      ->type_name("NUMBER")
      ->check(CLI::Range(2, 100000))
      ->needs(over);
  c->add_option("--show", t->show,
                "with --over: what branch.svg shows; default: the signal that changes most")
      ->type_name("SIGNAL|period|multiplier")
      ->needs(over);
  c->add_option("--tolerance", t->tolerance, "of the runs; default: 1e-12")
      ->type_name("NUMBER")
      ->check(positiveNumber());
  t->result.declare(*c, program, "orbit.json, or of branch.csv, branch.svg and branch.html");
  c->callback([t, &program] {
    program.load();
    tellOrbit(program, *t);
  });
}

}  // namespace dynamy::app
