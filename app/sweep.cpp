/// dynamy sweep MODEL|DIR: runs a model with many values of its parameters.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <exception>
#include <memory>
#include <thread>

#include "numbers.hpp"
#include "paths.hpp"
#include "processes.hpp"
#include "run/progress.hpp"
#include "shell_text.hpp"
#include "sweep/sweep_emit.hpp"
#include "sweep/sweep_page.hpp"
#include "sweep/sweep_row.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

struct SweepTexts {
  std::string what, until, table, out, rows, emit, accept;
  Accepted accepted;
  std::vector<std::string> set, measures;
  /// Of runs; each may vary.
  struct Methods {
    std::vector<std::string> step, tolerance, integrator, solver;
  } methods;
  int samples = 0, jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::uint64_t seed = 1;
  bool keep = false, restart = false, collect = false, quiet = false;
};

std::atomic<bool>& interruptedSweep() {
  static std::atomic<bool> flag{false};
  return flag;
}
extern "C" void onSweepInterrupt(int) { interruptedSweep() = true; }

/// Installs the handlers without SA_RESTART, so that a signal ends the wait for a process.
void catchInterrupt() {
  struct sigaction action {};
  action.sa_handler = onSweepInterrupt;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

std::string joined(const std::vector<std::string>& list) {
  std::string out;
  for (const std::string& s : list) out += (out.empty() ? "" : ",") + s;
  return out;
}

/// The sweep that the command line describes.
Sweep asked(const SweepTexts& t) {
  Sweep s;
  s.choice.model = t.what, s.measures = t.measures, s.keep = t.keep;
  if (!t.until.empty()) s.choice.until = seconds(t.until, "--until");
  std::vector<Variation> all;
  for (const auto& [name, values] : assignments(t.set))
    all.push_back(readVariation(name, values, "--set"));
  for (const Variation& v : all)
    if (!v.doubt.empty() && !t.quiet) fmt::print(stderr, "dynamy: {}\n", v.doubt);
  for (const auto& [name, list] : {std::pair("--step", &t.methods.step),
                                   {"--tolerance", &t.methods.tolerance},
                                   {"--integrator", &t.methods.integrator},
                                   {"--solver", &t.methods.solver}})
    if (!list->empty()) all.push_back(readVariation(name, joined(*list), name));
  for (const Variation& v : all)
    if (v.fixed()) choose(s.choice, v.name, v.values[0]);
  if (t.table.empty()) {
    s.plan = planOf(all, t.samples, t.seed);
    return s;
  }
  if (t.samples > 0 ||
      std::any_of(all.begin(), all.end(), [](const auto& v) { return !v.fixed(); }))
    throw CLI::ValidationError("--table", "the table says what varies; --set takes single values");
  s.plan = readTable(t.table);
  return s;
}

fs::path defaultFolder(const std::string& model) {
  return fs::path("sweeps") / fs::path(model).stem();
}

/// Verifies the models of the first and the last run. One of them may be faulty; if both are, the
/// error of the first one is thrown.
void verifyCorners(Program& program, Sweep& s) {
  std::exception_ptr fault;
  for (const std::size_t id : {std::size_t{1}, s.runs()}) {
    try {
      verify(program, s, id);
    } catch (const ModelError&) {
      if (!fault) fault = std::current_exception();
    }
  }
  if (!s.columns.empty()) return;
  if (fault) std::rethrow_exception(fault);
  throw ModelError("the model has nothing that a sweep could tell",
                   "give it a <check>, or a system whose signals can be recorded");
}

SweepFolder begin(Program& program, const SweepTexts& t) {
  Sweep s = asked(t);
  program.load();
  s.choice.loaded = program.plugins.fingerprints();
  const fs::path path = t.out.empty() ? defaultFolder(t.what) : fs::path(t.out);
  verifyCorners(program, s);
  if (t.restart) SweepFolder::clear(path);
  return {path, s};
}

std::string stateText(const Collected& c, std::size_t runs) {
  std::string out = fmt::format("{} of {} runs done", c.finished + c.failed, runs);
  if (c.failed > 0) out += fmt::format(", {} FAILED", c.failed);
  if (c.qualified > 0) out += fmt::format(", {} QUALIFIED by warnings", c.qualified);
  if (c.failedChecks > 0) out += fmt::format(", {} with failed checks", c.failedChecks);
  return out;
}

int finish(const Sweep& s, const SweepFolder& folder, const SweepTexts& t,
           const std::string& more) {
  const Collected c = collect(s, folder, t.accepted);
  if (!t.quiet) {
    fmt::print(" {}{}\n", stateText(c, s.runs()), more);
    for (const auto& [text, all] :
         {std::pair(c.firstFault, c.failed), {c.firstQualified, c.qualified}})
      if (!text.empty())
        fmt::print(" {}{}\n", text, all > 1 ? "; the others stand in results.csv" : "");
    if (c.qualified > 0 && c.failed + c.missing == 0)
      fmt::print(" (exit status {}; --accept takes kinds of warnings, doc/run_folder.md)\n",
                 kQualified);
    fmt::print(" wrote   {}/  manifest.csv results.csv sweep.html\n", folder.path().string());
    if (c.missing > 0)
      fmt::print(" {} missing: the same command, or dynamy sweep {}, goes on\n", c.missing,
                 shellWord(folder.path().string()));
  }
  if (c.failed + c.missing > 0) return kFailed;
  return c.qualified > 0 ? kQualified : kOk;  // a check may hold for other parameters only
}

/// Computes all runs without a result, each in a separate process.
int goOn(Program& program, const Sweep& s, const SweepFolder& folder, const SweepTexts& t) {
  std::vector<std::size_t> left;
  for (std::size_t id = 1; id <= s.runs(); ++id)
    if (!folder.has(id)) left.push_back(id);
  if (!t.quiet)
    fmt::print("{}   {} runs, {} of them done   {} at once\n{}", s.choice.model, s.runs(),
               s.runs() - left.size(), t.jobs, valuesText(s.plan));
  std::fflush(stdout);
  StatusLine line(t.quiet);
  std::size_t done = 0, lost = 0;
  const auto work = [&](std::size_t k) {
    const auto claim = folder.claim(left[k]);
    if (claim) computeRun(program, s, folder, left[k], *claim);
    return 0;
  };
  const auto ended = [&](std::size_t k, int status) {
    ++done;
    if (const std::string how = endText(status); !how.empty() && !interruptedSweep()) {
      ++lost;
      line.end();
      fmt::print(stderr, "dynamy: run {}: {}; no result\n", left[k], how);
    }
    const double part = static_cast<double>(done) / static_cast<double>(left.size());
    if (line.due())
      line.show(part, fmt::format("{} of {} runs{}   {:.1f} s   {} to go", done, left.size(),
                                  lost > 0 ? fmt::format(", {} lost", lost) : "", line.seconds(),
                                  durationText(line.seconds() * (1.0 / part - 1.0))));
  };
  catchInterrupt();
  inProcesses(left.size(), t.jobs, interruptedSweep(), work, ended);
  line.end();
  const std::string wall = left.empty() ? "" : fmt::format("   {:.2f} s", line.seconds());
  return finish(s, folder, t, (interruptedSweep() ? "   stopped" : "") + wall);
}

/// "7" or "3-9".
std::pair<std::size_t, std::size_t> range(const std::string& text, std::size_t runs) {
  std::size_t from = 0, to = 0, end = 0;
  try {
    from = to = std::stoul(text, &end);
    if (end < text.size() && text[end] == '-') {
      const std::string rest = text.substr(end + 1);
      to = std::stoul(rest, &end);
      end = end == rest.size() ? text.size() : 0;
    }
  } catch (const std::exception&) {
    end = 0;
  }
  if (end != text.size() || from < 1 || from > to || from > runs)
    throw CLI::ValidationError("--rows",
                               fmt::format("\"{}\": expected 1 … {}, or a range 3-9", text, runs));
  return {from, std::min(to, runs)};
}

void sweep(Program& program, const SweepTexts& t) {
  const bool folderGiven = fs::is_directory(t.what);
  if (folderGiven && (!t.set.empty() || !t.table.empty() || t.restart || !t.measures.empty()))
    throw CLI::ValidationError("sweep", t.what + " is a folder: its manifest says what is varied");
  const SweepFolder folder = folderGiven ? SweepFolder(t.what) : begin(program, t);
  const Sweep s = folder.read();
  if (!t.emit.empty()) {
    fmt::print("{}", emit(t.emit, program, s, folder));
  } else if (t.collect) {
    program.exitCode = finish(s, folder, t, "");
  } else {
    if (folderGiven) prepare(program, s);
    if (t.rows.empty()) {
      program.exitCode = goOn(program, s, folder, t);
      return;
    }
    const auto [from, to] = range(t.rows, s.runs());
    for (std::size_t id = from; id <= to; ++id)
      if (const auto claim = folder.claim(id)) computeRun(program, s, folder, id, *claim);
  }
}

}  // namespace

void addSweep(CLI::App& app, Program& program) {
  auto t = std::make_shared<SweepTexts>();
  CLI::App* c = app.add_subcommand("sweep", "run a model with many values of its parameters");
  c->add_option("MODEL", t->what, "XML file; or the folder of a sweep that is to be continued")
      ->required();
  c->add_option("--set", t->set,
                "what varies: NAME=FROM:TO:COUNT[:log], NAME=A,B,C, NAME=uniform(A,B), "
                "NAME=normal(MEAN,DEVIATION); one value holds for all runs")
      ->type_name("NAME=VALUES");
  c->add_option("--samples", t->samples, "draws of uniform and normal for each combination")
      ->check(wholeNumber(1));
  c->add_option("--seed", t->seed, "of the draws")->capture_default_str()->type_name("N");
  c->add_option("--table", t->table, "CSV file with a line of names and a line of values a run")
      ->type_name("FILE");
  c->add_option("--measure", t->measures,
                "what is kept of a run: [value|mean|min|max|period|count] SIGNAL[@TIME|@FROM..TO]; "
                "default: the model's checks, else the recorded signals at the end")
      ->type_name("TEXT");
  c->add_option("--step", t->methods.step, "step lengths, may vary like a parameter")
      ->type_name("TIMES");
  c->add_option("--tolerance", t->methods.tolerance, "tolerances of the runs, may vary")
      ->type_name("NUMBERS");
  c->add_option("--integrator", t->methods.integrator, "schemes, may vary")->type_name("SCHEMES");
  c->add_option("--solver", t->methods.solver, "inclusion solvers, may vary")->type_name("SOLVER");
  c->add_option("--until", t->until, "end time")->type_name("TIME");
  c->add_option("-j,--jobs", t->jobs, "runs at once")->capture_default_str()->check(wholeNumber(1));
  c->add_option("--out", t->out, "folder of the sweep; default: sweeps/MODEL")
      ->type_name("DIR")
      ->check(someName());
  c->add_flag("--keep", t->keep, "keep the folder of every run, with its replay");
  c->add_flag("--restart", t->restart, "throw the results in the folder away");
  c->add_option("--emit", t->emit, "write a script for another engine instead of running")
      ->check(CLI::IsMember({"parallel", "slurm"}));
  c->add_option("--rows", t->rows, "only these runs, here and now: 7 or 3-9; nothing is collected")
      ->type_name("RANGE");
  c->add_flag("--collect", t->collect, "only write results.csv and sweep.html from what is there");
  c->add_flag("--quiet", t->quiet, "print errors only");
  addPlugins(*c, program);
  addAccept(*c, t->accept);
  c->callback([t, &program] {
    t->accepted = accepted(t->accept);
    sweep(program, *t);
  });
}

}  // namespace dynamy::app
