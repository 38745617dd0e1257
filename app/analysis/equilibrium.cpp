/// dynamy equilibrium MODEL: rest with forces that the laws permit, or a steady motion; and where in
/// the range of a parameter there is one.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/io/model/driving_forces.hpp>
#include <dynamy/io/model/file_equilibrium.hpp>
#include <memory>
#include <optional>

#include "analysis/analysis_result.hpp"
#include "analysis/eigen_text.hpp"
#include "numbers.hpp"
#include "program.hpp"
#include "sweep/sweep_plan.hpp"

namespace dynamy::app {
namespace {

struct EquilibriumTask {
  FileEquilibrium wanted;
  std::string model, range;
  std::vector<std::string> set, start;
  bool asItIs = false;
  AnalysisResult result{"equilibrium"};
};

constexpr int kRangeIntervals = 20;  ///< of a range that are searched for an end of the rest
constexpr int kMostContacts = 30;    ///< that the text lists

std::string contactText(const CarryingContact& c) {
  std::string out = fmt::format("   {} {}, force", c.name, c.status);
  for (const double x : c.lambda) out += fmt::format(" {:.10g}", std::abs(x) < 1e-9 ? 0.0 : x);
  out += " N";
  if (std::isfinite(c.margin)) out += fmt::format(", {:.4g} N from the bound of its law", c.margin);
  return out + "\n";
}

std::string equilibriumText(const std::string& model, const Equilibrium& e) {
  std::string out = fmt::format("{}: {}, u' = 0 up to {:.1e}\n", model,
                                e.rest ? "rest" : "steady motion", e.residual);
  if (e.relaxations > 0)
    out += fmt::format(
        " at the start {}; found on the way from there, in {} steps of motion that was "
        "stopped {} times\n",
        e.start, e.steps, e.relaxations);
  else if (e.moved > 1e-9)
    out += fmt::format(" found {:.3g} from the start of the model\n", e.moved);
  else
    out += " at the start of the model\n";
  out += sampledText(e.sampled);
  if (e.growing == 0) out += " stable: no small disturbance grows\n";
  if (e.growing > 0)
    out += fmt::format(" unstable: {} small disturbance{} grow{}\n", e.growing,
                       e.growing == 1 ? "" : "s", e.growing == 1 ? "s" : "");
  std::size_t width = 0;
  for (const auto& [name, value] : e.state) width = std::max(width, name.size());
  for (const auto& [name, value] : e.state)
    out += fmt::format("   {:<{}} {:>20.13g}\n", name, width, value);
  std::vector<CarryingContact> sorted = e.contacts;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.margin < b.margin; });
  if (!sorted.empty()) out += " joints and contacts, nearest to their bounds first:\n";
  for (std::size_t i = 0; i < sorted.size() && i < kMostContacts; ++i)
    out += contactText(sorted[i]);
  if (sorted.size() > kMostContacts)
    out += fmt::format("   and {} more, in equilibrium.json\n", sorted.size() - kMostContacts);
  return out;
}

std::string rangesText(const std::string& parameter, double a, double b,
                       const std::vector<RestRange>& ranges) {
  if (ranges.empty())
    return fmt::format(" no rest at the start of the model for {} from {:g} to {:g}\n", parameter,
                       a, b);
  std::string out;
  for (const RestRange& r : ranges) {
    out += fmt::format(" rests for {} from {:.12g} to {:.12g}\n", parameter, r.from, r.to);
    if (!r.endsFrom.empty()) out += fmt::format("   below: {}\n", r.endsFrom);
    if (!r.endsTo.empty()) out += fmt::format("   above: {}\n", r.endsTo);
  }
  return out;
}

void tellEquilibrium(Program& program, EquilibriumTask& task) {
  FileEquilibrium& wanted = task.wanted;
  wanted.file = task.model, wanted.options.relax = !task.asItIs;
  wanted.set.clear(), wanted.start.clear();
  wanted.set = assignments(task.set);
  for (const std::string& s : task.start) wanted.start.push_back(numberAssignment("--start", s));
  std::string name;
  double a = 0.0, b = 0.0;
  std::vector<RestRange> ranges;
  if (!task.range.empty()) {
    const auto [parameter, text] = assignment(task.range);
    const Variation values = readBounds(parameter, text, kRangeIntervals + 1, "--range");
    name = parameter, a = std::stod(values.values.front()), b = std::stod(values.values.back());
    ranges = restRanges(wanted, name, a, b, kRangeIntervals + 1, program.registry, program.plugins);
  }
  std::optional<Equilibrium> found;
  try {
    found = equilibrium(wanted, program.registry, program.plugins);
  } catch (const ModelError& error) {
    if (ranges.empty())  // else they are the answer
      throw namingDrivingForces(error, wanted.file, wanted.set, program.registry, program.plugins);
  }
  task.result.tell(
      task.model,
      [&](JsonWriter& j) {
        if (found) writeEquilibrium(j, *found);
        if (!task.range.empty()) writeRanges(j, name, ranges);
      },
      (found ? equilibriumText(task.model, *found)
             : fmt::format("{}: no rest with the model's own values\n", task.model)) +
          (task.range.empty() ? "" : rangesText(name, a, b, ranges)));
}

}  // namespace

void addEquilibrium(CLI::App& app, Program& program) {
  auto t = std::make_shared<EquilibriumTask>();
  CLI::App* c = app.add_subcommand(
      "equilibrium",
      "rest with forces that contacts and friction permit, or a steady motion, near the start");
  c->add_option("MODEL", t->model, "XML file")->required();
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--start", t->start, "where the search begins, instead of the model's start")
      ->type_name("SYSTEM.COORDINATE=VALUE");
  c->add_flag("--rest", t->wanted.atRest, "look for rest, although the model starts with motion");
  c->add_flag("--as-it-is", t->asItIs,
              "near the start only; the motion from there is not followed");
  c->add_option("--near", t->wanted.options.near,
                "gaps up to this part of the scene's length count as closed, slips up to this part "
                "of the fastest velocity as sticking; default: 1e-6")
      ->type_name("NUMBER")
      ->check(positiveNumber());
  c->add_option("--range", t->range,
                "also where the model rests at its start while a parameter goes from A to B")
      ->type_name("NAME=A:B");
  t->result.declare(*c, program, "equilibrium.json");
  c->callback([t, &program] {
    program.load();
    tellEquilibrium(program, *t);
  });
}

}  // namespace dynamy::app
