/// Warnings that follow from the figures of a finished run, and the figures that checks may
/// request.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/run_watch.hpp>

namespace dynamy {
namespace {

// Limits above which figures are reported; doc/run_folder.md has the table.
constexpr double kEnergy = RunTrust::kWarned;  ///< of the largest kinetic energy
constexpr double kMuchOverlap = 0.01;          ///< of the scene's length
constexpr double kOverlapWays = 2.0;           ///< of the distance in a step
constexpr double kMostOfRun = 0.5;             ///< share of the time, stepped
constexpr double kSameOverlap = 1.01;          ///< of the overlap at the start
constexpr double kStart = 1e-6;                ///< of the scene's length
constexpr double kPushed = 1e-10;              ///< the same, whose energy shows where all rests
constexpr double kJoint = 1e-3;                ///< of the scene's length
constexpr double kOmegaDt = 1.0;               ///< [rad]
constexpr double kTurn = 1.0;                  ///< [rad]
constexpr double kSteppedErrors = 10.0;        ///< sum over steps in time, in tolerances
constexpr double kLeastShare = 1e-9;           ///< shares below this are not reported
/// Part of all steps that are few: what they do to energy, joints and gaps is judged anyway.
constexpr double kFew = 0.01;

double ratio(double value, double scale) { return scale > 0.0 ? value / scale : 0.0; }

using Warnings = std::vector<Warning>;

bool few(long steps, const RunReport& r) {
  return static_cast<double>(steps) <= kFew * static_cast<double>(r.steps);
}

/// What makes the figures of the run better.
std::string remedy(const RunReport& r, double length) {
  if (r.gaps.atStart.value > kPushed * length)
    return fmt::format("the model puts bodies into each other, by {:.2g} m at {}: let them touch",
                       r.gaps.atStart.value, r.gaps.atStart.name);
  return r.cost.effort.smooth > 0 ? "take a smaller tolerance" : "take a smaller step";
}

void aboutSolver(const RunReport& r, Warnings& out) {
  if (r.solver.unconverged == 0) return;
  if (r.solver.residual.value <= kSolvedResidual) {
    out.push_back({few(r.solver.unconverged, r) ? "unprojected" : "unsolved",
                   fmt::format("in {} step{} positions or velocities were not brought to what they "
                               "hold, or the scheme's own iteration did not end; their inclusions "
                               "are solved, residual {:.2g} at most",
                               r.solver.unconverged, r.solver.unconverged == 1 ? "" : "s",
                               r.solver.residual.value),
                   r.solver.unconverged, r.solver.unsolved.t, r.solver.unsolved.contact});
    return;
  }
  out.push_back({"unsolved",
                 fmt::format("{} of {} inclusions missed their tolerance, residual {:.2g} at most"
                             "; their forces and velocities are not to be trusted",
                             r.solver.unconverged, r.solver.solves, r.solver.residual.value),
                 r.solver.unconverged, r.solver.unsolved.t, r.solver.unsolved.contact});
}

void aboutEnergy(const RunReport& r, double length, Warnings& out) {
  const RunTrust& t = r.trust;
  const double fromStart = ratio(t.energyRise, t.energyScale());
  const double fromLeast = ratio(t.energyGain, t.gainScale());
  const bool after = fromLeast > fromStart;  // after losses
  const double risen = after ? t.energyGain : t.energyRise;
  const double rise = std::max(fromStart, fromLeast);
  const double error = ratio(t.energyError, t.energyScale());
  if (rise > kEnergy)
    out.push_back(
        {"energy gain",
         fmt::format("T + V rose by {:.3g} J (t = {:.6g} s), {:.3g} of the largest T, "
                     "and nothing brought it in; {}",
                     risen, after ? t.energyGainTime : t.energyRiseTime, rise, remedy(r, length)),
         1, after ? t.energyGainTime : t.energyRiseTime});
  else if (error > kEnergy)
    out.push_back({"energy",
                   fmt::format("{:.3g} J (t = {:.6g} s), {:.3g} of the largest T, went "
                               "where no force did work: the scheme's own error; {}",
                               t.energyError, t.energyErrorTime, error, remedy(r, length)),
                   1, t.energyErrorTime});
  if (ratio(t.dampedLoss, t.energyScale()) > kEnergy)
    out.push_back({"damped",
                   fmt::format("{:.3g} J, {:.3g} of the largest T, were lost in steps that damp {} "
                               "spring{} or damper{} which they do not resolve; a smaller step "
                               "resolves them, stiff=\"true\" keeps their energy",
                               t.dampedLoss, ratio(t.dampedLoss, t.energyScale()), t.damped,
                               t.damped == 1 ? "" : "s", t.damped == 1 ? "" : "s"),
                   t.damped, 0.0});
}

void aboutImpacts(const RunReport& r, Warnings& out) {
  if (ratio(r.contacts.energyGain.value, r.trust.energyScale()) < kLeastShare) return;
  // The smaller rebounds bring in no energy, so that the run is one of a law that can exist, unless
  // forces of the same step did.
  const bool risen = ratio(r.trust.regain, r.trust.energyScale()) > kEnergy;
  out.push_back({risen ? "impact law" : "restitution",
                 fmt::format("{} impacts would have gained energy, {:.2g} J at most "
                             "(t = {:.6g} s): less rebound was taken",
                             r.contacts.repairedImpacts, r.contacts.energyGain.value,
                             r.contacts.energyGain.t),
                 r.contacts.repairedImpacts, r.contacts.energyGain.t});
}

void aboutPositions(const RunReport& r, double length, Warnings& out) {
  const double overlap = r.gaps.penetration.value;
  // What the model gives may grow by what no step pushes out, and by what any step may add.
  const double given = kSameOverlap * r.gaps.atStart.value;
  if (r.gaps.atStart.value > kStart * length) {
    const double regain = ratio(r.trust.regain, r.trust.energyScale());
    const bool risen = regain > kEnergy;
    out.push_back({risen ? "start" : "start overlap",
                   fmt::format("the model puts bodies into each other: {:.2g} m at {}; pushing "
                               "them apart changes the energy{}",
                               r.gaps.atStart.value, r.gaps.atStart.name,
                               risen ? fmt::format(", and T + V rose by {:.3g} J, {:.2g} of the "
                                                   "largest T",
                                                   r.trust.regain, regain)
                                     : ""),
                   1, 0.0, r.gaps.atStart.name});
  }
  if (overlap > kMuchOverlap * length + given)
    out.push_back(
        {"overlap",
         fmt::format("bodies overlap by {:.2g} m at {} (t = {:.6g} s), {:.2g} "
                     "of the scene's length",
                     overlap, r.gaps.penetration.name, r.gaps.penetration.t, overlap / length),
         1, r.gaps.penetration.t, r.gaps.penetration.name});
  else if (r.trust.way > 0.0 &&
           overlap > std::max(kOverlapWays * r.trust.way, kLeastShare * length) + given)
    out.push_back({"overlap",
                   fmt::format("bodies overlap by {:.2g} m at {} (t = {:.6g} s), {:.2g} "
                               "times the way of the fastest in a step",
                               overlap, r.gaps.penetration.name, r.gaps.penetration.t,
                               ratio(overlap, r.trust.way)),
                   1, r.gaps.penetration.t, r.gaps.penetration.name});
  if (r.gaps.jointError.value > kJoint * length)
    out.push_back({"joints",
                   fmt::format("joint {} is off by {:.2g} m (t = {:.6g} s), {:.2g} of "
                               "the scene's length: project=\"both\" in <simulation>, or "
                               "a scheme that holds positions, keeps it",
                               r.gaps.jointError.name, r.gaps.jointError.value, r.gaps.jointError.t,
                               r.gaps.jointError.value / length),
                   1, r.gaps.jointError.t, r.gaps.jointError.name});
}

void aboutParts(const RunReport& r, Warnings& out) {
  if (r.passing.left == 0) return;
  out.push_back(
      {"passed",
       fmt::format("fast bodies hit so often in {} step{} (first at t = {:.6g} s{}) that "
                   "the rest of it was taken without looking what they pass; take a "
                   "smaller step",
                   r.passing.left, r.passing.left == 1 ? "" : "s", r.passing.firstLeft.t,
                   r.passing.firstLeft.name.empty() ? "" : ", " + r.passing.firstLeft.name),
       r.passing.left, r.passing.firstLeft.t, r.passing.firstLeft.name});
}

void aboutSimpler(const RunReport& r, Warnings& out) {
  if (r.simpler.steps == 0) return;
  out.push_back({few(r.simpler.steps, r) ? "simpler step" : "simpler",
                 fmt::format("<EnergyMomentum> found no solution with joints at their positions in "
                             "{} step{} (the first ends at t = {:.6g} s): StaggeredMoreau took "
                             "them, with joints in the mean; take a smaller step",
                             r.simpler.steps, r.simpler.steps == 1 ? "" : "s", r.simpler.firstEnd),
                 r.simpler.steps, r.simpler.firstEnd, ""});
}

std::string whySteppedInTime(const SteppingReport& s) {
  const std::string at = s.first.name.empty() ? "" : " at " + s.first.name;
  std::string dense = fmt::format(
      "switches{} came too fast to be located, or no gap follows what touches there", at);
  if (s.impatient == 0) return dense;
  return (s.impatient < s.periods ? dense + ", and " : std::string()) +
         "the work of the run was used up (<LocatedDormandPrince patience=\"10\"/> grants more)";
}

void aboutStepping(const RunReport& r, Warnings& out) {
  const SteppingReport& s = r.stepping;
  if (s.periods == 0) return;
  const std::string cause = whySteppedInTime(s);
  if (s.total <= kSteppedErrors) {
    out.push_back(
        {"stepped",
         fmt::format("{} (t = {:.6g} s): {:.4g} s in {} period{} were stepped "
                     "in time for {} system{}; the errors of these steps add up to {:.2g} "
                     "times the tolerance",
                     cause, s.first.t, s.time, s.periods, s.periods == 1 ? "" : "s", s.systems,
                     s.systems == 1 ? "" : "s", s.total),
         s.periods, s.first.t, s.first.name});
    return;
  }
  out.push_back(
      {"time stepping",
       fmt::format(
           "{} (t = {:.6g} s): {:.4g} s in {} period{} were stepped in time for {} system{} "
           "with steps up to {:.2g} s, whose errors reach {:.2g} times the tolerance each and "
           "add up to {:.2g} times; it is not promised for them, nor for what they touch, "
           "from there on{}",
           cause, s.first.t, s.time, s.periods, s.periods == 1 ? "" : "s", s.systems,
           s.systems == 1 ? "" : "s", s.longest, s.error, s.total,
           s.time > kMostOfRun * r.t ? "; that is most of the run: where many bodies stay in "
                                       "contact a step (--step 1e-3) is the better choice"
                                     : ""),
       s.periods, s.first.t, s.first.name});
}

void aboutRest(const RunReport& r, Warnings& out) {
  if (r.located.unseen.value <= 0.0) return;
  out.push_back(
      {"rest",
       fmt::format("nothing moved for {:.3g} s from t = {:.6g} s while forces changed "
                   "faster than a run to a tolerance looks at them: what switches in "
                   "between may be missed; --step {:.1g} beside the tolerance bounds "
                   "its steps",
                   r.located.unseen.value, r.located.unseen.t, 0.02 * r.located.unseen.value),
       1, r.located.unseen.t});
}

void aboutStep(const RunReport& r, double length, Warnings& out) {
  const RunTrust& t = r.trust;
  if (t.omegaDt > kOmegaDt)
    out.push_back({"resolution", fmt::format("the motion turns by {:.2g} rad in a step (omega dt); "
                                             "take a smaller step",
                                             t.omegaDt)});
  if (t.turn > kTurn)
    out.push_back({"resolution", fmt::format("a body turns by {:.2g} rad in a step; take a smaller "
                                             "step",
                                             t.turn)});
  if (t.fall > length)
    out.push_back({"resolution", fmt::format("forces alone lead {:.2g} m in a step, {:.2g} times "
                                             "the scene's length; take a smaller step",
                                             t.fall, t.fall / length)});
}

constexpr std::array<WarningKind, 21> kKinds = {{
    {"contradiction", Says::qualifies, "joints or drives contradict each other at the start"},
    {"start positions", Says::note, "joints did not fit at the start, bodies were moved onto them"},
    {"start velocities", Says::note,
     "joints do not allow the start velocities, they were projected"},
    {"unsolved", Says::qualifies, "an inclusion missed its tolerance"},
    {"unprojected", Says::note, "in a few solved steps positions or velocities were not projected"},
    {"energy gain", Says::qualifies, "T + V rose and nothing brought it in"},
    {"energy", Says::warning, "energy went where no force did work: the scheme's own error"},
    {"damped", Says::note, "energy was lost in steps that damp forces which they do not resolve"},
    {"impact law", Says::warning, "impacts would have gained energy by their law"},
    {"restitution", Says::note, "impacts would have gained energy by their law, and rebound less"},
    {"start", Says::warning, "bodies begin inside each other, and T + V rose"},
    {"start overlap", Says::note, "the model puts bodies into each other"},
    {"overlap", Says::qualifies, "bodies overlap by more than a step explains"},
    {"joints", Says::qualifies, "a joint is off at the end of a step"},
    {"passed", Says::qualifies, "fast bodies may have passed others in a step of very many hits"},
    {"simpler", Says::qualifies, "a simpler scheme took steps that the chosen one did not solve"},
    {"simpler step", Says::note, "a simpler scheme took a few such steps"},
    {"resolution", Says::warning, "steps are long for the motion"},
    {"rest", Says::warning, "forces changed unseen while nothing moved"},
    {"stepped", Says::note, "switches were stepped in time, with errors near the tolerance"},
    {"time stepping", Says::qualifies,
     "switches were stepped in time: the tolerance is not promised"},
}};

constexpr std::array<RunFigure, 11> kFigures = {{
    {"energyError", "energy that no force accounts for, over the largest T",
     [](const RunReport& r) { return ratio(r.trust.energyError, r.trust.energyScale()); }},
    {"energyRise", "rise of T + V that nothing brought in, over the largest T",
     [](const RunReport& r) { return ratio(r.trust.energyRise, r.trust.energyScale()); }},
    {"impactGain", "energy that impacts would have gained by their law [J]",
     [](const RunReport& r) { return r.contacts.energyGain.value; }},
    {"penetration", "worst overlap of a unilateral contact, at ends of steps as well [m]",
     [](const RunReport& r) { return r.gaps.penetration.value; }},
    {"solvedOverlap", "worst overlap where steps solve for their forces [m]",
     [](const RunReport& r) { return r.gaps.solvedOverlap.value; }},
    {"jointError", "worst position error of a joint [m]",
     [](const RunReport& r) { return r.gaps.jointError.value; }},
    {"unsolved", "inclusions that missed their tolerance",
     [](const RunReport& r) { return static_cast<double>(r.solver.unconverged); }},
    {"residual", "largest residual of an inclusion",
     [](const RunReport& r) { return r.solver.residual.value; }},
    {"impacts", "impacts",
     [](const RunReport& r) { return static_cast<double>(r.contacts.impacts); }},
    {"switches", "changes of a contact's status",
     [](const RunReport& r) { return static_cast<double>(r.contacts.switches); }},
    {"steps", "steps", [](const RunReport& r) { return static_cast<double>(r.steps); }},
}};

}  // namespace

std::vector<Warning> warningsOf(const RunReport& report, double sceneLength) {
  Warnings out = startWarnings(report.start, sceneLength);
  aboutSolver(report, out);
  aboutEnergy(report, sceneLength, out);
  aboutImpacts(report, out);
  aboutPositions(report, sceneLength, out);
  aboutParts(report, out);
  aboutSimpler(report, out);
  aboutStep(report, sceneLength, out);
  aboutRest(report, out);
  aboutStepping(report, out);
  return out;
}

std::span<const WarningKind> warningKinds() { return kKinds; }

const WarningKind* warningKind(std::string_view name) {
  for (const WarningKind& k : kKinds)
    if (name == k.name) return &k;
  return nullptr;
}

Says says(const Warning& w) {
  const WarningKind* kind = warningKind(w.kind);
  return kind == nullptr ? Says::warning : kind->says;
}

bool RunReport::qualified() const {
  return std::any_of(warnings.begin(), warnings.end(),
                     [](const Warning& w) { return says(w) == Says::qualifies; });
}

std::span<const RunFigure> runFigures() { return kFigures; }

const RunFigure* runFigure(std::string_view signal) {
  if (!signal.starts_with("run.")) return nullptr;
  for (const RunFigure& f : kFigures)
    if (signal.substr(4) == f.name) return &f;
  return nullptr;
}

}  // namespace dynamy
