/// dynamy bench stability: runs every scheme and every solver on scenes that make such methods
/// fail.
#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <map>
#include <memory>

#include "chosen_scenes.hpp"
#include "numbers.hpp"
#include "paths.hpp"
#include "stability/stability_page.hpp"

namespace dynamy::app {
namespace {

/// Schemes with attributes that make them separate methods; all others run with their defaults.
constexpr std::array kVariants = {"ConstraintIndex index=1", "ConstraintIndex index=3",
                                  "StaggeredMoreau joints=stabilised", "ThetaMethod theta=1"};

struct StabilityChoice {
  std::string out = "runs/stability", folder;
  std::vector<std::string> scenes, schemes, solvers;
  std::vector<std::string> steps;
  bool quick = false, all = false;
  int jobs = 1;
  double limit = 10.0;
};

std::vector<std::string> namesOf(const Registry& registry, Kind kind) {
  std::vector<std::string> out;
  for (const RegisteredType* t : registry.types())
    if (t->kind == kind) out.push_back(t->name);
  return out;
}

std::vector<std::string> allSchemes(const Registry& registry) {
  std::vector<std::string> out = namesOf(registry, Kind::scheme);
  out.insert(out.end(), kVariants.begin(), kVariants.end());
  std::sort(out.begin(), out.end());
  return out;
}

/// Default scheme and solver of the program for a scene that names none.
std::pair<std::string, std::string> ownMethods(Program& program, const StabilityScene& scene) {
  const Model model =
      loadModelText(scene.text, scene.name + ".xml", program.registry, program.plugins);
  return {model.scheme().type(), model.solver().type()};
}

std::vector<StabilityScene> scenesWithSteps(const StabilityChoice& c) {
  std::vector<StabilityScene> out;
  for (StabilityScene& s : chosenScenes(stabilityScenes(c.folder), c.scenes)) {
    if (c.quick && s.quickStep <= 0.0 && c.scenes.empty()) continue;
    if (c.quick && s.quickStep > 0.0) s.steps = {s.quickStep};
    if (!c.steps.empty()) s.steps.clear();
    for (const std::string& step : c.steps) s.steps.push_back(seconds(step, "--step"));
    out.push_back(std::move(s));
  }
  return out;
}

/// All schemes with the default solver, and the default scheme with all solvers; on request all
/// schemes with all solvers.
std::vector<StabilityTask> chosenTasks(const Registry& registry, const StabilityChoice& c,
                                       const StabilityMatrix& m) {
  const std::vector<std::string> schemes = c.schemes.empty() ? allSchemes(registry) : c.schemes;
  const std::vector<std::string> solvers =
      c.solvers.empty() ? namesOf(registry, Kind::solver) : c.solvers;
  const bool product = c.all || (!c.schemes.empty() && !c.solvers.empty());
  const std::string ownScheme = c.schemes.size() == 1 ? c.schemes.front() : m.scheme;
  const std::string ownSolver = c.solvers.size() == 1 ? c.solvers.front() : m.solver;
  std::vector<StabilityTask> out;
  for (std::size_t i = 0; i < m.scenes.size(); ++i)
    for (const double step : m.scenes[i].steps)
      for (const std::string& scheme : schemes)
        for (const std::string& solver : solvers) {
          StabilityTask t{static_cast<int>(i), scheme, solver, step, false, false};
          t.ofSchemes = solver == ownSolver, t.ofSolvers = scheme == ownScheme;
          if (product || t.ofSchemes || t.ofSolvers) out.push_back(std::move(t));
        }
  return out;
}

void say(const StabilityMatrix& m, double wall) {
  std::array<long, 4> count{};
  for (const StabilityResult& r : m.results) ++count[static_cast<std::size_t>(r.verdict)];
  fmt::print(" {} cells: {} pass, {} refused, {} fail and say so, {} fail silently   {:.3g} s\n",
             m.results.size(), count[0], count[1], count[2], count[3], wall);
  for (std::size_t i = 0; i < m.results.size(); ++i) {
    const StabilityTask& t = m.tasks[i];
    const StabilityResult& r = m.results[i];
    const bool own = t.scheme == m.scheme && t.solver == m.solver;
    if (r.verdict == Verdict::silent || (own && r.verdict != Verdict::pass))
      fmt::print(" {:<7} {} {} {} dt = {:g}: {:.6g}, pass mark {}\n{}", verdictText(r.verdict),
                 m.scenes[static_cast<std::size_t>(t.scene)].name, t.scheme, t.solver, t.step,
                 r.figure, r.passMark, own && !r.words.empty() ? "   " + r.words : "");
  }
}

void writeMatrix(const StabilityMatrix& m, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "scenes");
  for (const StabilityScene& s : m.scenes)
    writeWholeFile(folder / "scenes" / (s.name + ".xml"), s.text);
  writeWholeFile(folder / "stability.csv", stabilityCsv(m));
  writeWholeFile(folder / "stability.svg", stabilitySvg(m));
  writeWholeFile(folder / "stability.html", stabilityPage(m, (folder / "scenes").string()));
  fmt::print(" wrote   {}/  stability.html stability.svg stability.csv scenes/\n", folder.string());
}

void benchStability(Program& program, const StabilityChoice& c) {
  program.load();
  StabilityMatrix m;
  m.scenes = scenesWithSteps(c);
  if (m.scenes.empty()) throw CLI::ValidationError("--scene", "no scene is left");
  for (const StabilityScene& s : m.scenes)
    std::tie(m.scheme, m.solver) = ownMethods(program, s);  // throws where a scene is at fault
  m.tasks = chosenTasks(program.registry, c, m);
  for (const StabilityTask& t : m.tasks) {
    methodElement(program.registry, t.scheme, Kind::scheme);
    methodElement(program.registry, t.solver, Kind::solver);
  }
  const auto begin = std::chrono::steady_clock::now();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  m.results = runCells(program, m.scenes, m.tasks, c.jobs, c.limit, [&](std::size_t n) {
    if (terminal) fmt::print(stderr, "\r {} of {} cells", n, m.tasks.size());
  });
  if (terminal) fmt::print(stderr, "\r{:30}\r", "");
  say(m, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  writeMatrix(m, c.out);
  for (const StabilityResult& r : m.results)
    if (r.verdict == Verdict::silent) program.exitCode = kFailed;
}

}  // namespace

void addBench(CLI::App& app, Program& program) {
  auto t = std::make_shared<StabilityChoice>();
  CLI::App* bench = app.add_subcommand("bench", "charts of what the methods can do");
  bench->require_subcommand(1);
  CLI::App* c = bench->add_subcommand(
      "stability",
      "schemes and solvers on scenes where such methods fail; exit 1: one fails "
      "without saying so");
  c->add_option("--out", t->out, "folder of page, picture and table")
      ->type_name("DIR")
      ->check(someName());
  c->add_flag("--quick", t->quick, "a part that takes a minute");
  c->add_flag("--all", t->all, "all schemes with all solvers, not only with the default one");
  c->add_option("--scenes", t->folder, "folder of other scenes: catalogue.txt and models")
      ->type_name("DIR");
  c->add_option("--scene", t->scenes, "these scenes only")->delimiter(',');
  c->add_option("--scheme", t->schemes,
                "these schemes only; with attributes: \"ThetaMethod theta=1\"")
      ->delimiter(',');
  c->add_option("--solver", t->solvers, "these solvers only")->delimiter(',');
  c->add_option("--step", t->steps, "these steps instead of the scenes' own")->delimiter(',');
  c->add_option("-j,--jobs", t->jobs, "cells at the same time")->check(wholeNumber(1));
  c->add_option("--limit", t->limit, "CPU time of a cell [s]")->check(numberBetween(1.0, 3600.0));
  addPlugins(*c, program);
  c->callback([t, &program] { benchStability(program, *t); });
  addBenchPrecision(*bench, program);
}

}  // namespace dynamy::app
