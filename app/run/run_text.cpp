#include "run/run_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include <dynamy/core/utf8.hpp>
#include <dynamy/core/version.hpp>
#include <dynamy/io/run_files/run_facts.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <dynamy/simulation/run/rest_rules.hpp>

#include "run/endings.hpp"
#include "run/model_notes.hpp"

namespace dynamy::app {
namespace {

std::string counted(long n, const std::string& what, const std::string& many = {}) {
  return fmt::format("{} {}", n, n == 1 ? what : many.empty() ? what + 's' : many);
}

std::string checkLine(const CheckResult& c, int width) {
  const std::string what = checkText(c);
  const int blanks = width - characterCount(what);
  return fmt::format(" check  {}{}  {:<14} expected {}   {}{}\n", what,
                     std::string(static_cast<std::size_t>(blanks), ' '),
                     c.note.empty() ? fmt::format("{:.9g}", c.got) : c.note, c.expected,
                     c.pass ? "PASS" : "FAIL", c.pass ? "" : " " + c.place.format());
}

}  // namespace

std::string stateText(const RunReport& r) {
  switch (r.ended) {
    case RunReport::Ended::finished:
      return "finished";
    case RunReport::Ended::stopped:
      return stopText(EndingSignals::signal());
    case RunReport::Ended::failed:
      return "failed";
  }
  return "";
}

void writeFiles(JsonWriter& json, const std::vector<RecordedFile>& files) {
  json.key("files").beginArray();
  for (const RecordedFile& f : files)
    json.beginObject()
        .member("name", f.name)
        .member("bytes", f.place.bytes)
        .member("crc", fmt::format("{:08x}", f.place.crc))
        .endObject();
  json.endArray();
}

std::string checkText(const CheckResult& c) {
  return (c.measure == "value" ? c.signal : c.measure + " " + c.signal) +
         (c.over.empty() ? "" : " " + c.over);
}

std::string failedChecks(const std::vector<CheckResult>& checks) {
  std::string out;
  for (const CheckResult& c : checks)
    if (!c.pass) out += checkLine(c, characterCount(checkText(c)));
  return out;
}

std::string unsolvedText(const RunReport& r) {
  if (r.solver.unsolved.step == 0) return "";
  const Unsolved& u = r.solver.unsolved;
  std::string out = fmt::format(
      " NOT SOLVED  step {} (t = {:.6g} s) is the worst: {} after {} iterations, residual "
      "{:.2g}{}\n",
      u.step, u.t, u.status, u.iterations, u.residual, u.contact.empty() ? "" : " at " + u.contact);
  out += fmt::format("   tried: {}\n", u.tried);
  for (std::size_t from = 0; from < u.findings.size();) {
    const std::size_t end = u.findings.find('\n', from);
    out += "   " + u.findings.substr(from, end - from) + '\n';
    from = end + 1;
  }
  out +=
      u.residual <= kSolvedResidual
          ? "   The inclusion is solved: a projection, or the scheme's own iteration, did not end."
          : "   The forces and velocities of such a step are not to be trusted.";
  out +=
      " Try a smaller --step, or\n"
      "   onNonConvergence=\"retry\" in <simulation>, which halves the steps that fail;\n"
      "   --dump-problems 0 writes these problems for dynamy solve.\n";
  return out;
}

std::string problemsText(const ProblemDump& d, const std::filesystem::path& folder) {
  std::string out = fmt::format(" wrote   {}/  {}\n", folder.string(),
                                counted(static_cast<long>(d.files().size()), "problem"));
  if (d.refused() > 0)
    out += fmt::format(" left out {}: {}\n", counted(d.refused(), "problem"), d.refusedBecause());
  return out;
}

void writeProblems(JsonWriter& json, const ProblemDump& d) {
  json.key("problems").beginArray();
  for (const ProblemDump::File& f : d.files())
    json.beginObject()
        .member("file", "problems/" + f.name)
        .member("step", f.step)
        .member("t", f.t)
        .member("iterations", f.iterations)
        .member("contacts", f.contacts)
        .member("solved", f.solved)
        .endObject();
  json.endArray().member("problemsLeftOut", d.refused());
  if (d.refused() > 0) json.member("problemsLeftOutBecause", d.refusedBecause());
}

std::string warningsText(const RunReport& r, const Accepted* accepted) {
  std::string out;
  for (const Warning& w : r.warnings) {
    if (accepted != nullptr && (says(w) == Says::note || accepted->takes(w.kind))) continue;
    if (w.kind != "unsolved")
      out += fmt::format(" {}  {}: {}\n", says(w) == Says::note ? "note   " : "WARNING", w.kind,
                         w.text);
  }
  return out;
}

std::string qualifiedText(const RunReport& r, const std::vector<CheckResult>& checks,
                          const Accepted& accepted) {
  if (exitStatus(r, checks, accepted) != kQualified) return {};
  return fmt::format(
      " finished, but: {}   (exit status {}; --accept makes it 0, doc/run_folder.md)\n",
      qualifyingKinds(r, accepted), kQualified);
}

std::string stepText(const Model& model) {
  const SimulationSettings& s = model.simulation;
  if (!model.scheme().choosesSteps()) return fmt::format("step {:g} s", s.step);
  if (model.scheme().needsStep()) return fmt::format("steps up to {:g} s", s.step);
  return fmt::format("tolerance {:g}", s.tolerance) +
         (s.step > 0.0 ? fmt::format("   steps up to {:g} s", s.step) : "");
}

std::string coordinatesText(const Composition& c) {
  std::string out;
  if (c.flat > 0)
    out = fmt::format(" motion in the plane {}: {} with 3 instead of 6 velocities each\n", c.plane,
                      counted(c.flat, "body", "bodies"));
  if (c.coordinates == 0) return out;
  const std::string of = c.coordinates < c.joints ? fmt::format(" of {}", c.joints) : "";
  return out +
         fmt::format(
             " joints as coordinates: {}{}, with {} instead of {} and {} fewer to solve for\n",
             c.coordinates, of, c.velocitiesAfter,
             counted(c.velocitiesBefore, "velocity", "velocities"), counted(c.rowsSaved, "row"));
}

std::string reasonsText(const Model& model) {
  std::string out;
  for (const std::string& line : model.composed.notes) out += " " + line + "\n";
  if (!(model.simulation.sleep > 0.0)) return out;
  const RestRules rules(model);
  if (!rules.any()) return out + fmt::format(" no body sleeps: {}\n", rules.reason());
  return out +
         fmt::format(
             " {} of {} systems may sleep, slower than {:g} m/s and at rest by their forces\n",
             rules.resting(), rules.moving(), model.simulation.sleep);
}

std::string headText(const Model& model, const RunChoice& choice) {
  const Topology& t = model.topology();
  std::string out =
      fmt::format("dynamY {}   {}   {}, {} positions, {} velocities, {}\n", versionString(),
                  model.file.name.empty() ? choice.model : model.file.name,
                  counted(static_cast<long>(model.systems().size()), "system"), t.nq(), t.nu(),
                  counted(static_cast<long>(model.contacts().size()), "contact element"));
  out += fmt::format(" {}   {}   {}   to t = {:g} s\n", model.scheme().type(),
                     model.solver().type(), stepText(model), model.simulation.until);
  return out + coordinatesText(model.composed) + modelNotes(model);
}

/// Warns if the scheme itself changes the energy by more than rounding and by more than 1 % of the
/// energy that is exchanged in the run. What damped forces lose is told by itself.
std::string discretisationText(const RunReport& r) {
  const EnergyReport& e = r.energy;
  // Add the absolute works: the work of drives and that of friction may cancel.
  const double moves =
      std::max({e.kineticStart, std::abs(e.potentialEnd - e.potentialStart),
                std::abs(e.nonPotential) + std::abs(e.friction) + std::abs(e.normal) +
                    std::abs(e.joints) + std::abs(e.boundaries)});
  const double change = std::abs(e.discretisation + r.trust.dampedLoss);
  if (!(change > 0.01 * moves && change > r.trust.rounding)) return {};
  return fmt::format(
      " THE DISCRETISATION CHANGED THE ENERGY by {:.2g} of what moves: take a smaller {}\n",
      change / moves, r.cost.effort.smooth > 0 ? "tolerance" : "step");
}

/// Purposes of the evaluations in a run to a tolerance.
std::string effortText(const RunReport& r) {
  const StepEffort& e = r.cost.effort;
  const long told = e.smooth + e.rejected + e.switches + e.events + e.stepping;
  if (told == 0) return {};
  return fmt::format(
      " {}{}: smooth motion {}, too long steps {}, finding switches {}, switches {}{}{}\n",
      counted(r.cost.evaluations, "evaluation"),
      r.located.islands > 1 ? fmt::format(" (most of one of up to {} islands, which have steps of "
                                          "their own)",
                                          r.located.islands)
                            : "",
      e.smooth, e.rejected, e.switches, e.events,
      e.stepping > 0 ? fmt::format(", steps in time {}", e.stepping) : "",
      r.cost.evaluations > told ? fmt::format(", output {}", r.cost.evaluations - told) : "");
}

/// Counts of steps that were divided and of forces that were damped.
std::string stepsText(const RunReport& r) {
  std::string out;
  if (r.passing.divided > 0)
    out += fmt::format(
        " {} taken in up to {} equal parts: bodies or forces were too fast for them (a named "
        "scheme "
        "takes steps as they are)\n",
        counted(r.passing.divided, "step"), r.passing.finest);
  if (r.passing.parted > 0)
    out += fmt::format(" {} taken in parts: a fast body would have passed a contact\n",
                       counted(r.passing.parted, "step"));
  if (r.passing.bounded > 0)
    out += fmt::format(
        " {} used up the work that a step may take: the rest of it was taken at a small cost (a "
        "smaller step has as much work for less time)\n",
        counted(r.passing.bounded, "step"));
  if (r.trust.slowed.steps > 0)
    out += fmt::format(
        " {} gained energy, at most {:.2g} J (t = {:.6g} s), unsolved or with forces too stiff for "
        "them: velocities reduced by it\n",
        counted(r.trust.slowed.steps, "step"), r.trust.slowed.most, r.trust.slowed.t);
  if (r.trust.damped > 0)
    out += fmt::format(
        " {} faster than steps follow: taken at the end of steps, which damps them (a smaller step "
        "resolves them, stiff=\"true\" keeps their energy)\n",
        r.trust.damped == 1 ? "1 spring or damper is"
                            : fmt::format("{} springs and dampers are", r.trust.damped));
  return out;
}

std::string steppingText(const SteppingReport& s) {
  if (s.periods == 0) return {};
  return fmt::format(
      " {} in time over {:.4g} s in {} ({}): switches too dense to be located, or of what no gap "
      "follows{}\n",
      counted(s.steps, "step"), s.time, counted(s.periods, "period"), counted(s.stalls, "stall"),
      s.impatient > 0 ? fmt::format(", or too dear ({} of them)", s.impatient) : "");
}

std::string sleepText(const Model& model, const SleepReport& s) {
  if (!(model.simulation.sleep > 0.0)) return {};
  if (s.slept == 0)
    return fmt::format(" asleep  nothing: {}\n",
                       s.reason.empty() ? "no body that may sleep came to rest" : s.reason);
  return fmt::format(
      " asleep  {} at the end, at most {}; {} fell asleep, {} woke; {:.3g} % of the steps of "
      "bodies left out; {:.2g} J taken\n",
      counted(s.asleep, "system"), s.most, s.slept, s.woken,
      100.0 * static_cast<double>(s.saved) / static_cast<double>(s.all), s.energy);
}

std::string resultText(const Model& model, const RunReport& r,
                       const std::vector<CheckResult>& checks,
                       const std::filesystem::path& folder) {
  std::string out = fmt::format(" {} at t = {:g} s   {} ({} rejected)   {}   {:.3g} s wall",
                                stateText(r), r.t, counted(r.steps, "step"), r.rejected,
                                counted(r.contacts.impacts, "impact"), r.cost.wall);
  if (r.cost.wall > 0.0) out += fmt::format(" (x{:.3g})", r.t / r.cost.wall);
  const EnergyReport& e = r.energy;
  out += fmt::format("\n energy  {:.6g} -> {:.6g} J   normal forces {:.4g}   friction {:.4g}",
                     e.start(), e.end(), e.normal, e.friction);
  if (e.nonPotential != 0.0) out += fmt::format("   drives and dampers {:.4g}", e.nonPotential);
  if (e.joints != 0.0) out += fmt::format("   joints {:.2g}", e.joints);
  if (e.boundaries != 0.0) out += fmt::format("   moving boundaries {:.4g}", e.boundaries);
  out += fmt::format("   discretisation {:.2g} J\n", e.discretisation);
  out += discretisationText(r);
  if (r.located.switches > 0 || r.located.accumulations > 0)
    out += fmt::format(
        " {} located, {} passed{}\n", counted(r.located.switches, "switch", "switches"),
        counted(r.located.accumulations, "accumulation"),
        r.located.undecided > 0 ? fmt::format(", {} UNDECIDED", r.located.undecided) : "");
  out += steppingText(r.stepping);
  out += effortText(r);
  out += stepsText(r) + sleepText(model, r.cost.sleep);
  if (r.contacts.repairedImpacts > 0)
    out += fmt::format(
        " {} would have gained energy by the impact law, at most {:.2g} J (t = {:.6g} s): less "
        "rebound taken\n",
        counted(r.contacts.repairedImpacts, "impact"), r.contacts.energyGain.value,
        r.contacts.energyGain.t);
  if (r.gaps.penetration.value > 0.0)
    out += fmt::format(" worst penetration {:.2g} m at {} (t = {:.6g} s)\n",
                       r.gaps.penetration.value, r.gaps.penetration.name, r.gaps.penetration.t);
  if (r.gaps.jointError.value > 0.0)
    out += fmt::format(" worst joint error {:.2g} m at {} (t = {:.6g} s)\n",
                       r.gaps.jointError.value, r.gaps.jointError.name, r.gaps.jointError.t);
  if (r.solver.solves > 0 || r.solver.unconverged > 0) {
    out += fmt::format(" solver  {}, {:.3g} iterations on average, at most {}, ",
                       counted(r.solver.solves, "solve"), r.solver.iterationsMean(),
                       r.solver.iterationsMax);
    out += r.solver.unconverged == 0
               ? (r.solver.residual.value > kSolvedResidual
                      ? fmt::format(
                            "all converged, to residual {:.2g} at most; a tolerance of the solver "
                            "asks for less: <Automatic tolerance=\"1e-10\"/>\n",
                            r.solver.residual.value)
                      : "all converged\n")
               : fmt::format("{} NOT CONVERGED, worst residual {:.2g} at {} (t = {:.6g} s)\n",
                             r.solver.unconverged, r.solver.residual.value, r.solver.residual.name,
                             r.solver.residual.t);
  }
  out += unsolvedText(r) + warningsText(r);
  int width = 0;
  for (const CheckResult& c : checks) width = std::max(width, characterCount(checkText(c)));
  for (const CheckResult& c : checks) out += checkLine(c, width);
  out += fmt::format(
      " wrote   {}/  run.json signals.{} events.csv ledger.csv signals.svg frames.bin "
      "replay.html\n",
      folder.string(), std::filesystem::exists(folder / "signals.h5") ? "h5" : "csv");
  out += fmt::format(" hash    {}\n", hashText(r.hash));
  return out;
}

std::string thinningText(const ReplaySize& size) {
  std::string out;
  if (size.contacts < size.contactsRecorded)
    out = fmt::format("dynamy: replay.html shows the {} strongest of up to {} contacts\n",
                      size.contacts, size.contactsRecorded);
  if (!size.thinned()) return out;
  return out + fmt::format(
                   "dynamy: replay.html shows {} of {} frames: all would take {:.0f} MB; <record "
                   "frames=…> sets "
                   "how many are recorded\n",
                   size.frames, size.recorded, static_cast<double>(size.wholeBytes) * 1e-6);
}

}  // namespace dynamy::app
