#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/staggered_moreau.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Share of the solver's default tolerance that a resting gap may leave behind, see the header.
constexpr double kDead = 1e-10;
/// 4 ε of the scene's length, of which g_tol is 1e-12.
constexpr double kPositionShare = 1e-3;

/// Factor on the noise of gaps in the step after a correction: four corners of a face contradict
/// each other by a quarter of the dead band.
constexpr double kStricter = 1.0 / 3.0;
/// Most Newton steps of a solve that corrects a stack at rest. A solve that takes more has a body
/// that lands, and rates may differ by the whole noise of gaps.
constexpr int kCorrection = 4;

/// Residual above which positions are too inaccurate for those of a solved step.
constexpr double kLooseResidual = 1e-4;
/// Number of contacts from which an unsolved step is not repaired by exact solves either, and an
/// exact solver's impacts are not divided: of walls that were hit at seven speeds two had a step
/// unsolved to 1e-8.
constexpr int kManyContacts = 200;

/// True: the last step ended with a residual above kLooseResidual, or overlaps since such a step
/// are still left.
bool isRough(const State& x) { return x.scheme.size() > 0; }

bool hasJoints(const ContactSet& contacts) {
  for (int i = 0; i < contacts.size(); ++i)
    if (holds(contacts.law[static_cast<std::size_t>(i)]->rowKind(0))) return true;
  return false;
}

/// Evaluates M, h, contacts at q^M, with gyroscopic terms at the mean velocity, where they do no
/// work. Forces that the step does not resolve are damped.
const Evaluation& ahead(MechanicalSystem& s, const State& x, double dt) {
  return s.evaluate(x, {.ahead = dt, .damped = &kImplicitMidpoint, .gyroscopicAtMean = true});
}

}  // namespace

StepReport StaggeredMoreau::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                 double dt) {
  s.move(x, dt / 2);  // q^M = q^A + Δt/2 (F u^A + β)
  bool apart = true;
  const Evaluation& e = detect(s, solver, x, dt, apart);  // M, h, and W, χ where a gap can close
  pose(s, solver, x, dt);                                 // ξ = G Λ + c
  const SolveReport solved = solve(s, solver, x, dt);     // Λ = prox_C(Λ − r ξ)
  problem_->velocityFromImpulses(x);                      // u^E = u^A + M⁻¹(h Δt + W Λ)
  x.impulses.corrected = !solved.warmAccepted && solved.newton <= kCorrection;
  const bool loose = solved.residuals.largest() > kLooseResidual &&
                     (solved.ok() || rough_ || problem_->size() >= kManyContacts);
  if (loose || (rough_ && largestOverlap(e.contacts, x, s.limits.length) > s.gTol()))
    LostImpulses::remember(e.contacts, view(problem_->Lambda()), x.scheme);
  else
    x.scheme.resize(0);
  s.move(x, dt / 2);  // q^E = q^M + Δt/2 (F u^E + β)
  StepReport report{dt, solved, problem_->size()};
  report.dampedWork = s.implicitForces().dampedWork();
  if (!apart) report.solved.status = SolveStatus::stalled, s.limits.effort = Effort::retried;
  if (options_.project == Project::none || !hasJoints(e.contacts)) return report;
  if (!projection_.positions(s, solver, x, 0.1 * s.gTol()))
    report.solved.status = SolveStatus::stalled;
  if (options_.project == Project::both && !projection_.velocities(s, solver, x))
    report.solved.status = SolveStatus::stalled;
  return report;
}

/// Solves the inclusion, and solves it again as long as a solution closes contacts left out before.
SolveReport StaggeredMoreau::solve(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                   double dt) {
  SolveReport report;
  const bool hurried = s.limits.effort == Effort::little;
  for (;;) {  // the loop ends, since contacts are only added
    problem_->linearlyImplicit(x, kImplicitMidpoint);
    const int iterations = report.iterations, newton = report.newton;
    const bool inVain = report.inVain;
    report = problem_->solve(solver);
    report.iterations += iterations, report.newton += newton, report.inVain |= inVain;
    if (!report.ok() || report.inVain) s.limits.effort = Effort::retried;
    if (!report.ok() && hurried) return report;
    if (!problem_->bringIn()) {
      if (report.ok() || !aim_.divide) return report;
      aim_.divide = false;  // the impact waits for an overlap: another problem, once
    }
    ask(s, x, dt);
  }
}

/// Poses the inclusion for the aim of this step.
void StaggeredMoreau::ask(MechanicalSystem& s, const State& x, double dt) {
  problem_ = &s.impactProblem(x, dt, 0, &aim_);
  problem_->corrected = Corrected::byGaps;
  if (!rough_) return;
  // A step at a bounded cost leaves overlaps and forces, which the next step corrects.
  lost_.handOn(x.impulses, view(std::as_const(x.scheme)), s.slot(0).contacts, dt / x.impulses.dt,
               problem_->Lambda());
  problem_->corrected = Corrected::byGapsLoosely;
}

/// Poses the inclusion at q^M. Contacts whose impact falls into this step are closed before. If they
/// cannot be closed, their impacts are divided between this step and the next one. Among many
/// contacts they wait for an overlap, or the step becomes a rough one if the solver bounds its
/// work.
void StaggeredMoreau::pose(MechanicalSystem& s, const InclusionSolver& solver, State& x,
                           double dt) {
  const bool mean = options_.joints == Joints::mean;
  const double rounding = kPositionShare * s.gTol();
  aim_ = {rough_ ? -std::numeric_limits<double>::infinity()
                 : kDead * dt * largestChange(s, dt) + rounding,
          mean,
          mean ? 0.0 : options_.kappa,
          options_.cap,
          x.impulses.corrected ? kStricter * rounding : rounding,
          arrived_,
          false};
  ask(s, x, dt);
  if (rough_ || problem_->arriving().empty()) return;
  if (solver.boundsWork(problem_->size())) {
    rough_ = true, aim_.dead = -std::numeric_limits<double>::infinity();
    return ask(s, x, dt);
  }
  arriving_ = problem_->arriving();
  if (!projection_.touch(s, x, arriving_, 0.5 * s.gTol())) {
    aim_.divide = problem_->size() < kManyContacts;
    if (aim_.divide) ask(s, x, dt);
    return;
  }
  ahead(s, x, dt);
  arrived_.insert(arrived_.end(), arriving_.begin(), arriving_.end());
  std::sort(arrived_.begin(), arrived_.end());
  aim_.arrived = arrived_;
  ask(s, x, dt);
}

/// Evaluates at q^M after repairing overlaps, unless the step is a rough one. apart: false if they
/// could not be repaired.
const Evaluation& StaggeredMoreau::detect(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                          double dt, bool& apart) {
  const Evaluation& e = ahead(s, x, dt);
  arrived_.clear();
  rough_ = isRough(x) || (largestOverlap(e.contacts, x, s.limits.length) > s.gTol() &&
                          solver.boundsWork(e.contacts.size()));
  if (rough_ || largestOverlap(e.contacts, x, s.limits.length) <= s.gTol()) return e;
  for (int i = 0; i < e.contacts.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double g = e.contacts.position[static_cast<std::size_t>(e.contacts.row0[at])];
    if (e.contacts.law[at]->unilateral() && g < -s.gTol()) arrived_.push_back(e.contacts.key[at]);
  }
  std::sort(arrived_.begin(), arrived_.end());
  apart = projection_.overlaps(s, solver, x, 0.5 * s.gTol());
  return ahead(s, x, dt);
}

void StaggeredMoreau::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                  double theta, State& out) const {
  // The scheme's own trajectory: with u^A up to the midpoint, after it with u^E back from the end.
  const double dt = b.t - a.t;
  out.t = theta < 0.5 ? a.t : b.t;
  out.q = theta < 0.5 ? a.q : b.q, out.u = theta < 0.5 ? a.u : b.u;
  s.move(out, out.u, theta < 0.5 ? theta * dt : (theta - 1.0) * dt);
}

StaggeredMoreau::StaggeredMoreau(const Parameters& x) : OneStep(x) {
  options_.joints = x["joints"].text == "mean" ? Joints::mean : Joints::stabilised;
  const std::string& project = x["project"].text;
  options_.project = project == "none"        ? Project::none
                     : project == "positions" ? Project::positions
                                              : Project::both;
  options_.kappa = x["kappa"], options_.cap = x["cap"];
}

void StaggeredMoreau::declare(Attributes& a) {
  a.about(
      "Moreau's midpoint rule aimed at the gaps of the next midpoint: resting contacts stay, "
      "overlaps are repaired, joints keep their mean velocity and are projected.");
  a.choice("joints", {"mean", "stabilised"}, "mean",
           "mean: gammaE + gammaA = 0, keeps the energy; stabilised: the error is asked back");
  a.choice("project", {"none", "positions", "both"}, "both",
           "what of the joints is projected in the metric of the mass after a step");
  a.optional("kappa", Unit::none, 1.0, "stabilised: share of the error asked back per step")
      .between(0.0, 1.0);
  a.optional("cap", Unit::velocity, 1.0, "stabilised: largest speed asked for").positive();
  a.example("<simulation until=\"1\" step=\"1e-3\"><StaggeredMoreau/></simulation>");
}

}  // namespace dynamy
