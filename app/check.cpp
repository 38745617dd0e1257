/// dynamy check MODEL: reads, builds and verifies a model, and prints the size of the scene.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <dynamy/io/run_files/run_sizes.hpp>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/start_overlap.hpp>
#include <dynamy/simulation/run/run_faults.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/testing/check_element.hpp>
#include <memory>
#include <optional>

#include "check.hpp"
#include "run/model_notes.hpp"
#include "run/run_text.hpp"

namespace dynamy::app {
namespace {

/// An initial overlap above this share of the size of the bodies is reported as an error.
constexpr double kDeepStart = 0.1;

/// Size of the scene and cost of an evaluation, at the initial state.
struct Sizes {
  std::size_t systems = 0, contactElements = 0, forces = 0, signals = 0, checks = 0;
  int nq = 0, nu = 0, blocks = 0, constantBlocks = 0;
  std::size_t gaps = 0;          ///< reported by the contact elements
  int closed = 0, unknowns = 0;  ///< closed contacts, and their rows
  bool bodies = false;           ///< gravity would act on some
  double energy = 0.0;           ///< T + V [J]
  Worst penetration;
  StartOverlap overlap;        ///< the deepest relative to the size of the bodies
  std::string weightless;      ///< systems that <Gravity> does not act on
  std::vector<Warning> start;  ///< warnings about violated joints
  double evaluation = 0.0;     ///< M, h and all contacts at the start, measured [s], about
  double memory = 0.0;         ///< memory of this program with the model [bytes], about
};

/// Shortest time of several evaluations [s]; after the first one they take at most 0.1 s.
double evaluationTime(MechanicalSystem& system, const State& x) {
  using Clock = std::chrono::steady_clock;
  constexpr int kMost = 20;
  constexpr double kLong = 0.1;
  double least = std::numeric_limits<double>::infinity(), all = 0.0;
  for (int i = 0; i < kMost && all < kLong; ++i) {
    const auto begin = Clock::now();
    system.evaluate(x);
    const double took = std::chrono::duration<double>(Clock::now() - begin).count();
    least = std::min(least, took), all += took;
  }
  return least;
}

double usedMemory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return 1024.0 * static_cast<double>(used.ru_maxrss);
}

/// Is the system the state of a force: of a block, a tyre, a rope?
bool ownedByForce(const Model& model, const PartialMechanicalSystem& system) {
  return std::any_of(model.forces().begin(), model.forces().end(), [&](const auto& force) {
    return !force->name().empty() && force->name() == system.name();
  });
}

/// If the model has <Gravity>: names of the moving systems on which it does not act.
std::string weightless(const Model& model, const State& x) {
  std::string out;
  for (const auto& force : model.forces()) {
    if (force->type() != "Gravity") continue;
    for (std::size_t i = 0; i < model.systems().size(); ++i) {
      const SystemHandle& s = model.topology().system(static_cast<int>(i));
      const PartialMechanicalSystem& system = *model.systems()[i];
      if (s.nu == 0 || ownedByForce(model, system)) continue;
      if (system.feelsGravity({x.q.data() + s.q0, s.nq})) continue;
      out += (out.empty() ? "" : ", ") + (system.name().empty() ? system.type() : system.name());
    }
    return out;
  }
  return out;
}

[[noreturn]] void fail(const Element& wrong, std::string text) {
  Diagnostic d;
  d.place = wrong.place();
  d.element = wrong.type() + (wrong.name().empty() ? "" : " name=\"" + wrong.name() + "\"");
  d.text = std::move(text);
  throw ModelError(std::move(d));
}

[[noreturn]] void fail(const Model& model, int system, std::string text) {
  fail(*model.systems()[static_cast<std::size_t>(system)], std::move(text));
}

/// Throws ModelError for a system with entries in `all` that are not finite; `part` gives the first
/// entry and the count of a system.
template <class Part>
void requireFinite(const Model& model, const std::string& what, const Eigen::VectorXd& all,
                   const Part& part) {
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const auto [first, count] = part(model.topology().system(i));
    for (int k = 0; k < count; ++k)
      if (!std::isfinite(all[first + k]))
        fail(model, i, "its " + what + " are not finite at the start");
  }
}

Sizes measured(Model& model) {
  const auto velocities = [](const SystemHandle& h) { return std::pair(h.u0, h.nu); };
  Sizes s;
  const Topology& t = model.topology();
  s.systems = model.systems().size(), s.contactElements = model.contacts().size();
  s.forces = model.forces().size(), s.signals = model.signals().size();
  s.checks = model.checks.size();
  s.nq = t.nq(), s.nu = t.nu(), s.blocks = t.blocks();
  for (std::size_t i = 0; i < model.systems().size(); ++i)
    if (model.systems()[i]->blocks().constantMass)
      s.constantBlocks += t.system(static_cast<int>(i)).blocks;
  MechanicalSystem system = model.mechanicalSystem();
  State x = model.initialState();
  requireFinite(model, "coordinates", x.q,
                [](const SystemHandle& h) { return std::pair(h.q0, h.nq); });
  requireFinite(model, "velocities", x.u, velocities);
  const Evaluation& start = system.evaluate(x);
  const ContactSet& c = start.contacts;
  if (const int i = system.indefiniteMass(); i >= 0)
    fail(model, i, "the mass matrix is not positive definite at the start");
  if (!start.h.allFinite())
    if (const ExternalForce* force = forceWithoutNumber(model, x, x.t))
      fail(*force, "the force has no finite value at the start");
  requireFinite(model, "forces", start.h, velocities);
  for (std::size_t i = 0; i < c.g.size(); ++i)
    if (std::isnan(c.g[i]))
      throw ModelError(Diagnostic{
          .place = Place(model.file.name, 1, 1),
          .text = "the gap of " + contactText(model, c.candidateKey[i]) +
                  " is not a number at the start",
          .hint = "dynamy check --elements compares all that it computes with differences"});
  s.start = startWarnings(makeConsistent(model, system, x), model.length());
  s.gaps = c.g.size(), s.closed = c.size(), s.unknowns = c.rows();
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    const int k = c.closedIndex[i];
    if (k >= 0 && !c.law[static_cast<std::size_t>(k)]->unilateral()) continue;
    if (-c.g[i] > s.penetration.value)
      s.penetration.value = -c.g[i], s.penetration.name = contactName(model, c.candidateKey[i]);
  }
  s.overlap = startOverlap(model, c);
  EnergyMeter meter(model);
  s.energy = meter.kinetic(x) + meter.potential(x);
  s.weightless = weightless(model, x);
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const SystemHandle& h = model.topology().system(static_cast<int>(i));
    s.bodies =
        s.bodies || (h.nu > 0 && model.systems()[i]->feelsGravity({x.q.data() + h.q0, h.nq}));
  }
  s.evaluation = evaluationTime(system, x);
  s.memory = usedMemory();
  return s;
}

/// Scenes with more systems are not built a second time in the other kind of joint coordinates,
/// which would double time and memory of the check.
constexpr std::size_t kMostInOthers = 10'000;

/// Measures the scene. Errors without a place of their own get the place of the model.
Sizes sizesOf(Model& model) {
  try {
    return measured(model);
  } catch (const ModelError& e) {
    std::vector<Diagnostic> faults = e.diagnostics();
    for (Diagnostic& d : faults)
      if (d.place.line <= 0) d.place = Place(model.file.name, 1, 1);
    throw ModelError(std::move(faults));
  }
}

/// Cost of the scene in the other kind of joint coordinates (minimal or absolute). Missing if the
/// model permits no other kind or has more than kMostInOthers systems.
struct Alternative {
  std::string coordinates;
  Sizes sizes;
};

std::optional<Alternative> otherCoordinates(const Model& model, const std::string& file,
                                            LoadOptions options, Program& program) {
  if (model.systems().size() > kMostInOthers) return {};
  const bool minimal = model.composed.coordinates > 0;
  options.coordinates = minimal ? JointCoordinates::absolute : JointCoordinates::minimal;
  options.build = false;
  try {
    Model other = loadModel(file, program.registry, program.plugins, options);
    other.build();
    return Alternative{minimal ? "absolute" : "minimal", sizesOf(other)};
  } catch (const ModelError&) {
    return {};  // no joint forms a tree
  }
}

/// Lists the law of each pair of materials and the place of its rule, as in "wood and steel:
/// UnilateralCoulomb (bench.xml:12)".
std::string lawsText(const PairLaws& laws) {
  const auto where = [](const MaterialRule& rule) {
    return Place(rule.place().file, rule.place().line).format();
  };
  std::string out;
  for (const auto& [materials, answer] : laws.found()) {
    const bool mixed = answer.from->type() == "Contacts";
    out += fmt::format(" {} and {}: {}{} ({})\n", materials.first, materials.second, answer.text,
                       mixed ? ", mixed" : "", where(*answer.from));
  }
  return out;
}

/// Number of steps of fixed length in the run; 0 if the program chooses the steps.
double stepCount(const Model& model) {
  const SimulationSettings& s = model.simulation;
  return s.step > 0.0 ? std::ceil(s.until / s.step * (1.0 - 1e-12)) : 0.0;
}

std::string costText(double seconds) {
  if (seconds < 1e-4) return fmt::format("{:.2g} us", 1e6 * seconds);
  if (seconds < 0.1) return fmt::format("{:.2g} ms", 1e3 * seconds);
  if (seconds < 100.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.2g} min", seconds / 60.0);
  if (seconds < 100.0 * 3600.0) return fmt::format("{:.2g} h", seconds / 3600.0);
  return fmt::format("{:.2g} days", seconds / 86400.0);
}

/// Estimate of the memory, disk space and time of the run.
std::string needsText(const Model& model, const Sizes& s, const RunSizes& run) {
  std::string out = fmt::format(
      " a run: memory about {}   disk about {}: {:.6g} rows of {:g} numbers, {:.6g} pictures of "
      "{:g} "
      "poses\n",
      bytesText(s.memory), bytesText(run.bytes), run.rows, run.columns, run.pictures, run.poses);
  out += fmt::format(" an evaluation at the start takes about {}", costText(s.evaluation));
  const double steps = stepCount(model);
  if (steps > 0.0)
    out +=
        fmt::format(": {:.6g} steps take about {} or more", steps, costText(steps * s.evaluation));
  out += "\n";
  std::error_code error;
  const auto space = std::filesystem::space(".", error);
  if (!error && run.bytes > static_cast<double>(space.available))
    out += fmt::format(" warning: the disk of this folder has {} left: a run into it is refused\n",
                       bytesText(static_cast<double>(space.available)));
  return out;
}

std::string text(const Model& model, const Sizes& s, const RunSizes& run,
                 const std::optional<Alternative>& other) {
  const bool deep = s.overlap.share() > kDeepStart;
  std::string out =
      fmt::format("{}: {}\n", model.file.name, deep ? "bodies start inside each other" : "ok");
  out += fmt::format(" systems {}   forces {}   contact elements {}   signals {}   checks {}\n",
                     s.systems, s.forces, s.contactElements, s.signals, s.checks);
  out += fmt::format(" q {}   u {}   mass blocks {}, of them constant {}\n", s.nq, s.nu, s.blocks,
                     s.constantBlocks);
  out +=
      fmt::format(" at the start: gaps {}   closed contacts {}   unknowns {}   energy {:.6g} J\n",
                  s.gaps, s.closed, s.unknowns, s.energy);
  out += fmt::format(" {}   {}   {}   to t = {:g} s   length of the scene {:.3g} m\n",
                     model.scheme().type(), model.solver().type(), stepText(model),
                     model.simulation.until, model.length());
  out += needsText(model, s, run);
  out += coordinatesText(model.composed) + reasonsText(model);
  out += lawsText(model.pairLaws()) + modelNotes(model);
  if (other)
    out += fmt::format(" in {} coordinates of the joints: q {}   u {}   unknowns {}\n",
                       other->coordinates, other->sizes.nq, other->sizes.nu, other->sizes.unknowns);
  if (!s.weightless.empty())
    out += fmt::format(" note: <Gravity> does not act on {}; their own formulas say their weight\n",
                       s.weightless);
  const auto isGravity = [](const auto& force) { return force->type() == "Gravity"; };
  if (s.bodies && std::none_of(model.forces().begin(), model.forces().end(), isGravity))
    out += " no <Gravity>: bodies have no weight\n";
  for (const Warning& w : s.start)
    out += fmt::format(" {}: {}: {}\n", says(w) == Says::note ? "note" : "warning", w.kind, w.text);
  // Contacts that are closed at the start may have a gap of the size of rounding.
  if (deep)
    out += fmt::format(
        " failed: {} begins with a penetration of {:.3g} m, {:.3g} of the size of the smaller body "
        "({:.3g} m) — {}; a run goes on and reports it\n",
        contactName(model, s.overlap.contact), s.overlap.depth, s.overlap.share(), s.overlap.size,
        s.overlap.joint == kNoContact
            ? "move one of the two, or take the material of a shape away"
            : '"' + contactName(model, s.overlap.joint) +
                  "\" joins these two, and bodies that a joint connects touch as any others: take "
                  "the material of one away, or give it a material of its own and add <NoContact> "
                  "with that of the other");
  else if (s.penetration.value > 1e-9 * model.length())
    out += fmt::format(" warning: {} begins with a penetration of {:.3g} m\n", s.penetration.name,
                       s.penetration.value);
  return out;
}

void writeLaws(JsonWriter& j, const Model& model) {
  j.key("laws").beginArray();
  for (const auto& [materials, answer] : model.pairLaws().found())
    j.beginObject()
        .member("materials", materials.first + " " + materials.second)
        .member("law", answer.text)
        .member("from", answer.from->place().format())
        .endObject();
  j.endArray();
}

void writeNeeds(JsonWriter& j, const Model& model, const Sizes& s, const RunSizes& run) {
  j.key("run").beginObject();
  j.member("steps", stepCount(model)).member("evaluation", s.evaluation);
  j.member("memory", s.memory).member("disk", run.bytes);
  j.member("rows", run.rows).member("columns", run.columns);
  j.member("pictures", run.pictures).member("poses", run.poses);
  j.endObject();
}

std::string json(const Model& model, const Sizes& s, const RunSizes& run,
                 const std::optional<Alternative>& other) {
  std::string out;
  JsonWriter j(out, 2);
  j.beginObject().member("model", model.file.name);
  j.member("ok", !(s.overlap.share() > kDeepStart));
  j.member("systems", s.systems).member("forces", s.forces);
  j.member("contactElements", s.contactElements).member("signals", s.signals);
  j.member("checks", s.checks).member("q", s.nq).member("u", s.nu).member("blocks", s.blocks);
  j.member("constantBlocks", s.constantBlocks).member("gaps", s.gaps).member("closed", s.closed);
  j.member("unknowns", s.unknowns).member("energy", s.energy);
  j.member("penetration", s.penetration.value).member("overlapOfSize", s.overlap.share());
  j.member("withoutGravity", s.weightless);
  j.member("integrator", model.scheme().type()).member("solver", model.solver().type());
  j.member("step", model.simulation.step).member("tolerance", model.simulation.tolerance);
  j.member("until", model.simulation.until);
  j.member("length", model.length());
  writeNeeds(j, model, s, run);
  writeWarnings(j, s.start);
  writeLaws(j, model);
  if (other)
    j.key("otherCoordinates")
        .beginObject()
        .member("coordinates", other->coordinates)
        .member("q", other->sizes.nq)
        .member("u", other->sizes.nu)
        .member("unknowns", other->sizes.unknowns)
        .endObject();
  j.endObject();
  return out + "\n";
}

/// Faults go to stderr; with JSON, what was left out goes there, too.
void printVerdict(const dynamy::Verdict& verdict, bool json) {
  const std::vector<std::string>& leftOut = verdict.uncompared();
  for (const std::string& fault : verdict.faults()) fmt::print(stderr, "{}\n", fault);
  if (!json && verdict)
    fmt::print(" every entry of its elements {}agrees with differences\n",
               leftOut.empty() ? "" : "that is compared ");
  for (const std::string& text : leftOut)
    fmt::print(json ? stderr : stdout, " not compared: {}\n", text);
}

}  // namespace

int check(Program& program, const CheckChoice& choice) {
  LoadOptions options;
  options.set = choice.set, options.reduce = true;
  Model model = loadModel(choice.model, program.registry, program.plugins, options);
  { const Simulation verified(model); }  // verifies step and signals of checks; frees its arrays
  if (choice.strict) refuseInconsistentStart(model);
  const Sizes sizes = sizesOf(model);
  const RunSizes run = runSizes(model);
  const auto other = otherCoordinates(model, choice.model, options, program);
  fmt::print("{}", choice.json ? json(model, sizes, run, other) : text(model, sizes, run, other));
  RunReport atStart;
  atStart.warnings = sizes.start;
  const bool deep = sizes.overlap.share() > kDeepStart;
  const int status = deep ? kFailed : atStart.qualified() ? kQualified : kOk;
  if (!choice.elements) return status;
  const dynamy::Verdict verdict = checkModel(model);
  printVerdict(verdict, choice.json);
  return verdict ? status : kFailed;
}

void addCheck(CLI::App& app, Program& program) {
  struct Texts {
    CheckChoice choice;
    std::vector<std::string> set;
  };
  auto t = std::make_shared<Texts>();
  CLI::App* c = app.add_subcommand("check", "read, build and verify a model; report its size");
  c->add_option("MODEL", t->choice.model, "XML file")->required();
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  addPlugins(*c, program);
  c->add_flag("--json", t->choice.json, "print JSON");
  c->add_flag("--strict", t->choice.strict, "refuse a start that joints do not allow");
  c->add_flag(
      "--elements", t->choice.elements,
      "also compare M, h, frames, W, chi and prox of every element with differences and name "
      "each wrong entry");
  c->callback([t, &program] {
    program.load();
    t->choice.set = assignments(t->set);
    program.exitCode = check(program, t->choice);
  });
}

}  // namespace dynamy::app
