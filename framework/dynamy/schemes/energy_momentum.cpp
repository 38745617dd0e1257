#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/energy_momentum.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr int kMostNewtonTurns = 40;
/// Most turns whose contacts found no solution. Mostly forces or velocities are then far from those
/// of the tangent, and half the step is near enough.
constexpr int kMostUnsolved = 2;
/// A correction of kLast lengths is the last one with a new tangent, which is accurate to 1e-6.
/// With an old tangent it is the last one if the rest after another turn would be below kLeftOfWay.
constexpr double kLast = 1e-10, kLeftOfWay = 1e-15;
/// Last correction with a new tangent in closed form or of masses, which take forces of elements as
/// constant. It leaves at most kSlow of a correction, otherwise differences replace it.
constexpr double kLastClosed = 1e-13;
/// A correction of this many lengths shows that the iteration diverges.
constexpr double kLost = 1e3;
/// If joints and forces alone would move bodies by more than kFar lengths further than in the turn
/// before, their tangent does not hold there: contacts are not solved to the end then. By more than
/// kTooFar lengths after the first turn, the iteration diverges: of 650 that converged in jointed
/// random scenes two had such a turn, and those that fail spend nearly all their time in contacts
/// at such places.
constexpr double kFar = 0.1, kTooFar = 1.0;
/// A correction above kSlow times the one before requires a new tangent. A tangent in closed form,
/// which costs less than a turn, is renewed above kFresh already.
constexpr double kSlow = 0.1, kFresh = 1e-3;
/// Contacts with alternating features keep the iteration from ending. After kPatience turns a
/// correction of kLast lengths is the last one, after kLastPatience turns one of kNearEnough
/// lengths. The iteration fails where the smallest correction has not halved for kMostIdle turns.
constexpr int kPatience = 10, kLastPatience = 15, kMostIdle = 6;
constexpr double kNearEnough = 1e-8;
/// Most steps at a time that a simpler scheme takes.
constexpr double kMostSimpler = 15.0;

/// Correction that ends the iteration after this turn [lengths].
double enoughAfter(int turn) {
  return turn >= kLastPatience ? kNearEnough : turn >= kPatience ? kLast : 0.0;
}

/// The tangent of each turn of Newton's iteration.
struct TangentChoice {
  JointNewton::Tangent tangent = JointNewton::Tangent::closedForm;
  bool fresh = true;  ///< the next turn takes a new one

  /// True: a correction of `way` lengths, `rate` times the one before, is the last one.
  bool isLast(JointNewton::Tangent used, int turn, double way, double rate) const {
    const bool differences = used == JointNewton::Tangent::differences;
    return (fresh && way <= (differences ? kLast : kLastClosed)) || way <= enoughAfter(turn) ||
           (way <= kLast && rate * way <= kLeftOfWay);
  }
  /// The present correction shows how good the tangent of the turn before was. If differences are no
  /// better, the turning of contacts is missing in it.
  void follow(JointNewton::Tangent used, int turn, double rate) {
    using Tangent = JointNewton::Tangent;
    const bool slow = turn > 0 && rate > kSlow;
    if (slow && (wasFresh_ || used == Tangent::masses)) {
      differencesHelp_ = differencesHelp_ && used != Tangent::differences;
      tangent = differencesHelp_ ? Tangent::differences : Tangent::closedForm;
    }
    wasFresh_ = fresh;
    fresh = slow || (used == Tangent::closedForm && rate > kFresh);
  }
  void startAgain() {
    tangent = JointNewton::Tangent::differences, fresh = true, wasFresh_ = false;
  }

 private:
  bool wasFresh_ = false, differencesHelp_ = true;
};

/// Takes over what a turn found whose correction was `way` lengths.
void takeOver(const SolveReport& turn, double way, SolveReport& report) {
  report.residuals = turn.residuals;
  report.residuals.Eu = std::max(turn.residuals.Eu, way);
  report.status = turn.status;
  report.energyGain = turn.energyGain, report.repaired = turn.repaired;
}

/// A force that is not finite ends the run, with an error that names its system.
void passOnFaults(const Eigen::VectorXd& h, Eigen::VectorXd& v) {
  for (Eigen::Index k = 0; k < h.size(); ++k)
    if (!std::isfinite(h[k])) v[k] = h[k];
}

/// Effort for contacts where joints and forces alone move bodies by `ahead` lengths.
Effort worth(double ahead) { return ahead > kFar ? Effort::little : Effort::retried; }

}  // namespace

StepReport EnergyMomentum::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  findJoints(s, x, dt);
  if (joints_ == Joints::none) return staggered_.step(s, solver, x, dt);
  if (s.limits.effort == Effort::little && most_ > 0) return cheap(s, solver, x, dt);
  halvingHelps_ = true;
  return halve(s, solver, x, dt, 0);
}

void EnergyMomentum::findJoints(MechanicalSystem& s, const State& x, double dt) {
  if (joints_ != Joints::unknown) return;  // joints are always closed
  joints_ = newton_.equations.begin(s, x, dt) ? Joints::some : Joints::none;
}

/// Takes one step, or two of half the length if Newton's iteration fails (Halving). Once a smallest part has
/// failed, the simpler scheme takes it and the rest of the step.
StepReport EnergyMomentum::halve(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                                 int depth) {
  if (simplerAhead(x)) return simpler(s, solver, x, dt);
  State& start = start_[depth];
  start = x;
  const StepReport whole = joined(s, solver, x, dt);
  if (whole.solved.ok() || !whole.refused.empty() || most_ == 0) return whole;
  x = start;
  halvingHelps_ = halvingHelps_ && depth < most_ && s.limits.halving != Halving::none;
  StepReport report;
  if (halvingHelps_ && s.limits.halving == Halving::ends) {
    report = halve(s, solver, x, 0.5 * dt, depth + 1);
  } else if (halvingHelps_) {
    const StepReport first = halve(s, solver, x, 0.5 * dt, depth + 1);
    report = halve(s, solver, x, 0.5 * dt, depth + 1);
    report.dt = dt;
    report.simpler |= first.simpler;
    report.dampedWork += first.dampedWork;
    report.solved.iterations += first.solved.iterations;
    report.solved.newton += first.solved.newton;
    report.solved.energyGain += first.solved.energyGain;
    report.solved.repaired += first.solved.repaired;
    if (!first.solved.ok()) report.solved.status = first.solved.status;
  } else {
    report = simpler(s, solver, x, dt);
  }
  report.solved.iterations += whole.solved.iterations, report.solved.newton += whole.solved.newton;
  return report;
}

/// Takes a step by StaggeredMoreau because it is to cost little.
StepReport EnergyMomentum::cheap(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                 double dt) {
  x.scheme.resize(0);
  StepReport report = staggered_.step(s, solver, x, dt);
  report.simpler = true;
  x.scheme.resize(0);
  return report;
}

bool EnergyMomentum::simplerAhead(const State& x) {
  return x.scheme.size() == 2 && x.scheme[0] >= 1.0;
}

/// Takes a step by StaggeredMoreau, which needs no iteration for joints. x.scheme then holds how
/// many more such steps follow at once, and the number of steps of this series: 1, 3, 7, … with
/// repeated failures.
StepReport EnergyMomentum::simpler(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                   double dt) {
  double ahead = 0.0, inAll = 0.0;
  if (x.scheme.size() == 2) ahead = x.scheme[0], inAll = x.scheme[1];
  if (ahead < 1.0) ahead = inAll = std::min(2.0 * inAll + 1.0, kMostSimpler);
  x.scheme.resize(0);
  StepReport report = staggered_.step(s, solver, x, dt);
  report.simpler = true;
  x.scheme.resize(2);
  x.scheme << ahead - 1.0, inAll;
  return report;
}

StepReport EnergyMomentum::joined(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                  double dt) {
  JointEquations& equations = newton_.equations;
  xA_ = x;
  equations.begin(s, xA_, dt);  // M, h, contacts at q^A
  startMean(xA_, dt);           // v
  // An impact must not act on turning links during a whole step: it is taken as a jump at q^A.
  const auto jump = projection_.impact(s, solver, xA_, dt, jump_);
  if (jump) equations.v = xA_.u;
  contacts_.forgetMeanSlip();
  SolveReport solved = solve(s, solver, xA_, dt);  // v, Λ_J, Λ_c
  if (solved.ok() && contacts_.frictionDrives(equations.v, xA_)) {
    const SolveReport first = solved;
    equations.begin(s, xA_, dt);
    solved = solve(s, solver, xA_, dt);
    solved.iterations += first.iterations, solved.newton += first.newton;
  }
  if (jump) {
    solved.energyGain += jump->energyGain, solved.repaired += jump->repaired;
    solved.iterations += jump->iterations, solved.newton += jump->newton;
    if (!jump->ok()) solved.status = jump->status, solved.residuals = jump->residuals;
  }
  hand(s, x, dt, jump.has_value());
  s.move(x, equations.v, dt);       // q^E = q^A ⊕ Δt v
  x.u = 2.0 * equations.v - xA_.u;  // u^E = 2v − u^A
  if (project_ && !projection_.velocities(s, solver, x)) solved.status = SolveStatus::stalled;
  jump ? x.scheme.resize(0) : keepMean(x, dt);
  StepReport report{dt, solved, s.problem().size()};
  report.dampedWork = s.implicitForces().dampedWork();
  if (jump) report.jump = &jump_;
  report.refused = newton_.fault();
  return report;
}

/// Extrapolates v from the mean velocities of the last two steps. These are smooth, while
/// velocities at the ends of steps, which satisfy joints in the mean only, oscillate. x.scheme
/// holds both mean velocities and their Δt.
void EnergyMomentum::startMean(const State& x, double dt) {
  const Eigen::Index nu = x.u.size();
  if (x.scheme.size() != 2 * nu + 2) return;  // v = u^A
  const double last = x.scheme[2 * nu], earlier = x.scheme[2 * nu + 1];
  newton_.equations.v = x.scheme.head(nu);
  if (earlier > 0.0)
    newton_.equations.v +=
        (dt + last) / (last + earlier) * (x.scheme.head(nu) - x.scheme.segment(nu, nu));
}

void EnergyMomentum::keepMean(State& x, double dt) const {
  const Eigen::Index nu = x.u.size();
  if (x.scheme.size() != 2 * nu + 2) x.scheme.setZero(2 * nu + 2);
  x.scheme.segment(nu, nu) = x.scheme.head(nu);
  x.scheme[2 * nu + 1] = x.scheme[2 * nu];
  x.scheme.head(nu) = newton_.equations.v, x.scheme[2 * nu] = dt;
}

SolveReport EnergyMomentum::solve(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                                  double dt) {
  SolveReport report;
  JointEquations& equations = newton_.equations;
  // Angles of joints may all be zero: a correction of g_tol is the last one in any case.
  const double length = std::max({1e-6, x.q.cwiseAbs().maxCoeff(), s.gTol() / kLast});
  contacts_.begin(s, x, dt);
  contacts_.select(s, x, equations.v, dt);
  double before = 0.0, least = std::numeric_limits<double>::infinity();
  int unsolved = 0, idle = 0;
  TangentChoice choice;
  vStart_ = equations.v, LambdaStart_ = equations.Lambda;
  for (int turn = 0; turn < kMostNewtonTurns; ++turn) {
    equations.evaluate(s, contacts_.impulse());
    contacts_.select(s, x, equations.v, dt);
    ++report.iterations;
    if (choice.fresh) {
      ++report.newton;
      if (!newton_.linearise(s, contacts_.impulse(), choice.tangent)) {
        passOnFaults(s.slot(0).h, equations.v);
        break;
      }
    }
    newton_.newtonStep();
    const double ahead = dt * newton_.dv.cwiseAbs().maxCoeff() / length;
    bool lost = turn > 0 && !(ahead <= kTooFar);
    double way = 0.0, rate = 1.0;
    if (!lost) {
      const SolveReport inner = contacts_.solve(s, solver, x, newton_, worth(ahead));
      newton_.take();
      way = dt * newton_.dv.cwiseAbs().maxCoeff();
      if (turn > 0) rate = way / before;
      takeOver(inner, way / length, report);
      unsolved += inner.ok() ? 0 : 1;
      lost = unsolved == kMostUnsolved || !std::isfinite(way) || way > kLost * length;
    }
    // Masses alone lead nowhere where forces of joints turn fast: differences start from the beginning.
    if (newton_.tangent() == JointNewton::Tangent::masses && (lost || rate > 1.0)) {
      equations.v = vStart_, equations.Lambda = LambdaStart_;
      choice.startAgain(), unsolved = 0, turn = -1;
      continue;
    }
    if (lost) break;
    if (choice.isLast(newton_.tangent(), turn, way / length, rate)) {
      equations.evaluate(s, contacts_.impulse());
      if (!contacts_.misses(s, x, equations.v)) return report;
    }
    idle = way < 0.5 * least ? 0 : idle + 1;
    if (idle == 0) least = way;
    if (idle == kMostIdle) break;
    choice.follow(newton_.tangent(), turn, rate), before = way;
  }
  if (report.status == SolveStatus::solved) report.status = SolveStatus::maxIterations;
  equations.evaluate(s, contacts_.impulse());
  return report;
}

/// Passes the impulses to the system and the state, where observers and the next step read them.
void EnergyMomentum::hand(MechanicalSystem& s, State& x, double dt, bool jump) {
  x.t = xA_.t + dt / 2;
  ImpactProblem& problem = s.impactProblem(x, dt);
  const ContactSet& c = s.slot(0).contacts;
  Vec Lambda = problem.Lambda();
  const std::vector<int>& joints = newton_.equations.joints();
  std::size_t joint = 0;
  int row = 0;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool isJoint = joint < joints.size() && joints[joint] == i;
    const double* from = isJoint ? newton_.equations.Lambda.data() + row : contacts_.of(c.key[at]);
    for (int r = 0; r < c.dim(i); ++r) Lambda[c.row0[at] + r] = from ? from[r] : 0.0;
    if (isJoint) ++joint, row += c.dim(i);
  }
  problem.keepImpulses(x);  // without those of a jump, which does not repeat
  newton_.equations.finish(s);
  x.t = xA_.t;
  if (!jump) return;
  jump_.Lambda.assign(static_cast<std::size_t>(c.rows()), 0.0);
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double* percussions = projection_.percussions(c.key[at]);
    for (int r = 0; percussions && r < c.dim(i); ++r)
      Lambda[c.row0[at] + r] += jump_.Lambda[static_cast<std::size_t>(c.row0[at] + r)] =
          percussions[r];
  }
}

void EnergyMomentum::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                 double theta, State& out) const {
  if (joints_ != Joints::some) return staggered_.interpolate(s, a, b, theta, out);
  // The mean velocity leads from the beginning to the end.
  out.t = a.t, out.q = a.q;
  out.u = 0.5 * (a.u + b.u);
  s.move(out, out.u, theta * (b.t - a.t));
  out.u = a.u + theta * (b.u - a.u);
}

EnergyMomentum::EnergyMomentum(const Parameters& x) : OneStep(x) {
  project_ = x["project"].text == "velocities";
}

void EnergyMomentum::declare(Attributes& a) {
  a.about(
      "Implicit midpoint with joints at position level and their discrete gradient: joints hold to "
      "rounding and do no work; contacts as in StaggeredMoreau.");
  a.choice("project", {"none", "velocities"}, "none",
           "velocities: the end of a step is brought onto the joints' velocities, which takes a "
           "little energy");
  a.example("<simulation until=\"1\" step=\"1e-3\"><EnergyMomentum/></simulation>");
}

}  // namespace dynamy
