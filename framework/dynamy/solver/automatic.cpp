#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/solver/automatic.hpp>

namespace dynamy {
namespace {

constexpr double kColdResidual = 1e-2;  ///< above, a start is not near the solution
constexpr int kMostRestarted = 400;     ///< contacts; above, restarts cost seconds
/// Contacts up to which forces that keep bodies at rest are looked for first, and velocity of bodies
/// at rest [u_ref].
constexpr int kMostRested = 100;
constexpr double kAtRest = 1e-6;
/// Contacts from which on they may share a load in so many ways that shares go astray from step to step.
constexpr int kShared = 4;
/// Residual up to which forces that hold bodies are a solution, in tolerances of the solver that finds
/// them.
constexpr double kHeld = 10.0;
/// Rows that are pivoted if nothing else helps: above, the tableau of the polygons costs seconds.
constexpr int kMostPivoted = 100;
/// Rows of a given problem above which every further start costs seconds; starts for every
/// schedule; Newton steps from each start. No earlier stage solves 14 random problems with masses
/// over up to sixteen decades; for 10 of them one of sixty starts leads to a solution. Which start
/// does so is chance, so that many short attempts are worth more than a few long ones.
constexpr int kMostOthers = 200, kOtherStarts = 9, kOtherSteps = 400;
/// Limits of bounded solves: kBoundedFrom contacts or more; kCorrecting Newton steps from a start
/// with a residual up to kCorrectable; kMostSweeps sweeps to reach kEnough, kLastSweeps more to
/// reach kAccepted; kFewSweeps sweeps to a third of the residual of a start that is good enough.
constexpr int kBoundedFrom = 200, kCorrecting = 12, kMostSweeps = 100, kLastSweeps = 1000,
              kFewSweeps = 40;
/// Fewer contacts of bodies, from kSettledFrom on, are settled if kQuick Newton steps do not solve
/// them: kSettlingSweeps sweeps to kSettling. More than kSettled is left to the longer stages, of
/// whose result kTolerable is accepted. The gaps of the next step correct both. Solves of walls of 25 and 49 bricks used to end in 6600 steps of further methods,
/// often at 1.2 times the tolerance.
constexpr int kSettledFrom = 24, kSettlingSweeps = 500;
/// Newton's method begins for them where kLeadingSweeps packed sweeps end, or with kLeading. Heaps and
/// walls take 0.6 to 0.85 of the time from where accelerated sweeps end, which cost ten times as much
/// each. 5 sweeps leave twice the unsolved steps in a heap of polyhedra, 20 to 100 cost more.
constexpr int kLeadingSweeps = 10;
constexpr double kLeading = 1e-3;
constexpr double kSettling = 1e-6, kSettled = 2e-6, kTolerable = 1e-4;
/// Newton steps to kEnough where sweeps do not reach kAccepted; 17 of 17 such steps of walls took
/// 88 to 159 of them.
constexpr int kLastNewton = 300;
constexpr double kCorrectable = 1e-3, kEnough = 1e-2, kAccepted = 3e-2;
/// Newton steps of bounded solves after a step that was exact.
constexpr int kAfterExact = 100;
/// Newton steps for problems with bodies that deserve little effort: 364 of 379 solved ones need
/// less than 60.
constexpr int kQuick = 100, kHurried = 25;
/// Newton steps from Λ = 0 where those from the last forces lead nowhere: a heap of polyhedra left 19
/// steps unsolved, each of which 52 to 168 of them solve.
constexpr int kAfresh = 200;
/// Products that the Newton steps of one attempt at a problem without bodies may take in a time
/// step (some tenths of a second), and the least number of Newton steps.
constexpr double kMostProducts = 1e9;
constexpr int kFewestSteps = 25;
/// Sweeps after Newton steps in vain at such a problem.
constexpr int kSweepsInVain = 300;
/// Products and least Newton steps if the time step is tried again. Of 7952 such problems of
/// jointed scenes 7873 are solved by sweeps and at most 453 Newton steps in 15 s, and 5 by longer
/// searches in 2 s; 74 are not solved by any, in 37 s.
constexpr double kMostTried = 2e8;
constexpr int kFewestTried = 4;
/// Largest velocity [u_ref] that a contact force may cause alone. Sums of larger forces are only
/// rounding; they are no answer to a problem without a solution.
constexpr double kDrowned = 1e12;
constexpr double kGolden = 0.6180339887498949;
/// Newton steps of a restart, and contacts of a step whose errors gaps correct above which they are
/// fewer.
constexpr int kRestartSweeps = 10, kRestartSteps = 1500, kRestartedFully = 24;
/// Iterations of ADMM, two factorisations at most, before Newton steps whose factors are large.
constexpr int kAlternations = 20;

/// Products of an elimination of G in which every island is a filled block: the rows of a contact
/// are coupled only with those of its neighbours.
double productsOf(const InclusionProblem& p) {
  const BlockRows& G = p.G->blockRows();
  double products = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    double coupled = 0.0;
    for (int k = G.first[static_cast<std::size_t>(i)]; k < G.first[static_cast<std::size_t>(i) + 1];
         ++k)
      coupled += p.dim(G.column[static_cast<std::size_t>(k)]);
    products += p.dim(i) * coupled * coupled / 3.0;
  }
  return products;
}

bool drowns(const InclusionProblem& p, ConstVec Lambda) {
  for (int i = 0; i < p.size(); ++i) {
    const double own = contactLambda(p.G->diagonalBlock(i), p.dim(i)) *
                       Lambda.segment(p.row0(i), p.dim(i)).cwiseAbs().maxCoeff();
    if (own > kDrowned * p.uRef) return true;
  }
  return false;
}

/// Λ ← normal forces that each alone give their own contact the velocity `velocity` · u_ref.
/// `spread` numbers a pattern of factors from 1 to 1e4 on these forces; 0: no factors.
void press(const InclusionProblem& p, double velocity, int spread, Eigen::VectorXd& Lambda) {
  Lambda.setZero();
  for (int i = 0; i < p.size(); ++i) {
    const double lambda = contactLambda(p.G->diagonalBlock(i), p.dim(i));
    if (!(lambda > 0.0) || p.law(i).rowKind(0) != RowKind::normal) continue;
    // Factors spread over four decades, different for every start.
    const double decades = spread == 0 ? 0.0 : 4.0 * std::fmod(kGolden * spread * (i + 1), 1.0);
    Lambda[p.row0(i)] = velocity * std::pow(10.0, decades) * p.uRef / lambda;
  }
}

/// Sets the status of a bounded solve by the residual that is enough for the scheme.
SolveReport judged(SolveReport report, double enough) {
  if (report.residuals.largest() <= enough)
    report.status = SolveStatus::solved;
  else if (report.ok())
    report.status = SolveStatus::maxIterations;
  return report;
}

/// No joints, drives or friction in joints?
bool onlyContacts(const InclusionProblem& p) {
  for (int i = 0; i < p.size(); ++i)
    if (!p.law(i).unilateral()) return false;
  return true;
}

/// Is this a problem of few contacts with friction of which none moves, as of bodies that rest or roll?
/// With forces of a step before only if there is nothing but contacts: friction of joints is not to
/// lock what they let go.
bool mayRest(const InclusionProblem& p, ConstVec Lambda) {
  if (!(p.dt > 0.0) || p.rule || p.size() > kMostRested) return false;
  if (!Lambda.isZero(0.0) && (p.size() < kShared || !onlyContacts(p))) return false;
  double fastest = 0.0;
  for (const double gamma : p.gammaA) fastest = std::max(fastest, std::abs(gamma));
  if (!(fastest <= kAtRest * p.uRef)) return false;
  for (int i = 0; i < p.size(); ++i)
    if (p.law(i).unilateral() && p.dim(i) > 1) return true;
  return false;
}

/// True: some contact has a velocity that its law lets it have, ξ ≠ 0.
bool moves(const InclusionProblem& p, Vec Lambda) {
  Eigen::VectorXd xi(p.rows());
  p.G->apply(Lambda.data(), xi.data());
  xi += Eigen::Map<const Eigen::VectorXd>(p.c.data(), p.rows());
  return xi.lpNorm<Eigen::Infinity>() > kAtRest * p.uRef;
}

}  // namespace

Automatic::Automatic(const AutomaticOptions& options)
    : options_(options),
      newton_(
          {options.tolerance, options.maxNewton, options.maxIterations, 64, options.maxPatient}),
      lemke_({.tolerance = options.tolerance, .polish = false}),
      admm_({.tolerance = options.tolerance, .maxIterations = kAlternations}) {}

Automatic::Automatic(const Parameters& x)
    : InclusionSolver(x),
      options_{
          x["tolerance"],
          x["maxNewton"].integer(),
          4 * x["maxNewton"].integer(),
          x["maxIterations"].integer(),
          x["minimalNorm"].flag(),
          x["work"].text == "bounded" || (x["work"].text == "automatic" && !x["tolerance"].given)},
      newton_({options_.tolerance, options_.maxNewton, options_.maxIterations, 64,
               options_.maxPatient}),
      coarse_({std::max(kEnough, options_.tolerance), options_.maxNewton, options_.maxIterations,
               64, options_.maxPatient}),
      lemke_({.tolerance = options_.tolerance, .polish = false}),
      admm_({.tolerance = options_.tolerance, .maxIterations = kAlternations}) {}

SolveReport Automatic::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report = chain(p, Lambda);
  if (options_.minimalNorm && p.rows() > 0) minimalNorm_.apply(p, newton_, Lambda, report);
  return report;
}

SolveReport Automatic::chain(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  report.method = "start";
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  if (!Lambda.allFinite()) {
    Lambda.setZero();
    report.residuals = residuals(p, view(Lambda), scratch_);
  }
  const double E = report.residuals.largest();
  if (E <= acceptedStart(p, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!std::isfinite(E)) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  kept_ = report.residuals;
  keptLambda_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  const bool rests = mayRest(p, view(std::as_const(Lambda)));
  report = rungs(p, Lambda, report);
  if (rests && moves(p, Lambda)) {
    // With joints the solution at the end of the path has to be one of Newton's method, too.
    const double held = settles(p) ? kSettled : kHeld * options_.tolerance;
    minimalNorm_.rest(p, newton_, onlyContacts(p) ? held : 0.0, Lambda, report);
  }
  keep(p, {Lambda.data(), Lambda.size()}, report.residuals);
  const bool many = bounds(p), judges = many || settles(p);
  const double enough = std::max(many ? kAccepted : kTolerable, options_.tolerance);
  const bool better = kept_.largest() < report.residuals.largest() ||
                      !std::isfinite(report.residuals.largest()) ||
                      (!report.ok() && drowns(p, view(Lambda)));
  if ((report.ok() && !many) || !better) return judges ? judged(report, enough) : report;
  std::copy(keptLambda_.begin(), keptLambda_.end(), Lambda.data());
  report.residuals = kept_;
  if (kept_.largest() <= options_.tolerance) report.status = SolveStatus::solved;
  return judges ? judged(report, enough) : report;
}

void Automatic::keep(const InclusionProblem& p, ConstVec Lambda, const Residuals& residuals) {
  if (!(residuals.largest() < kept_.largest()) || drowns(p, Lambda)) return;
  kept_ = residuals;
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), keptLambda_.begin());
}

SolveReport Automatic::rungs(const InclusionProblem& p, Vec Lambda, SolveReport report) {
  const double E = report.residuals.largest();
  if (p.size() == 1 && easy_.oneContact(p, options_.tolerance, Lambda, report)) return report;
  const bool good = E <= options_.tolerance;  // but still worth a step
  const bool first = Lambda.isZero(0.0);
  const bool cold = !good && (E > kColdResidual || first);
  const bool many = bounds(p), loose = p.corrected == Corrected::byGapsLoosely;
  // Without bodies a Newton step eliminates all rows, which for so many costs more than all sweeps.
  if (many && (!p.G->hasBodies() || (!first && loose && E > kCorrectable)))
    return boundedSweeps(p, Lambda, report);
  if (cold && LemkeSolver::pays(p)) {
    report = lemke_.solve(p, Lambda);
    if (report.ok() || lemke_.proven()) return report;
    keep(p, {Lambda.data(), Lambda.size()}, report.residuals);
  }
  const bool hurried = options_.bounded && p.effort != Effort::full;
  if (cold && !hurried && Admm::pays(p) && alternate(p, Lambda, report)) return report;
  if (cold && settles(p)) {
    const int before = report.iterations;
    packed_.sweeps(p, std::max(kLeading, options_.tolerance), kLeadingSweeps, Lambda, report);
    report.note(report.method, before);
    if (report.residuals.largest() <= options_.tolerance) return report;
  } else if (cold) {
    const int before = report.iterations;
    const bool solved = easy_.sweeps(p, options_.tolerance, Lambda, report);
    report.note("sweeps", before);
    if (solved) return report;
    keep(p, {easy_.best().data(), Lambda.size()}, easy_.bestResiduals());
  }
  // After exactly solved steps Newton's method is tried once: a scene at rest stays exact, and so
  // does one that begins to slide.
  NewtonLimits most = limits(p, first ? options_.maxNewton : (loose ? kCorrecting : kAfterExact));
  // With many contacts the later stages cost more than a second start.
  const bool twice = !first && !many && !hurried && !condensed(p) && p.size() > kMostRestarted;
  if (twice) most.maxPatient = most.maxIterations = 0;
  report = newton_.refine(p, Lambda, report, cold, scratch_.data(), &most);
  if (report.ok()) return report;
  keep(p, {Lambda.data(), Lambda.size()}, report.residuals);
  if (many) return boundedSweeps(p, Lambda, report);
  if (twice)
    return afresh(p, Lambda, report,
                  {options_.maxNewton, options_.maxPatient, options_.maxIterations});
  if (settles(p)) {
    settle(p, Lambda, report);
    if (!first && !report.ok() && p.effort != Effort::little) {
      keep(p, {Lambda.data(), Lambda.size()}, report.residuals);
      report = afresh(p, Lambda, report, {kAfresh, 0, 0});
    }
  } else if (most.maxNewton < options_.maxNewton) {
    return report;
  }
  if (hurried || report.ok()) return report;
  report.inVain =
      !restarts(p, Lambda, report) && !pivot(p, Lambda, report) && !others(p, Lambda, report);
  return report;
}

SolveReport Automatic::afresh(const InclusionProblem& p, Vec Lambda, SolveReport report,
                              const NewtonLimits& most) {
  Lambda.setZero();
  report.residuals = residuals(p, view(std::as_const(Lambda)), scratch_);
  const int before = report.iterations;
  const bool solved = easy_.sweeps(p, options_.tolerance, Lambda, report);
  report.note("sweeps from zero", before);
  if (solved) {
    report.status = SolveStatus::solved;
    return report;
  }
  return newton_.refine(p, Lambda, report, true, scratch_.data(), &most);
}

bool Automatic::boundsWork(int contacts) const {
  return options_.bounded && contacts >= kBoundedFrom;
}

bool Automatic::bounds(const InclusionProblem& p) const {
  // Problems without bodies are bounded only if the gaps of the next step correct their errors,
  // which excludes joints, which hold velocities.
  const bool askedBack = p.corrected == Corrected::byGaps ||
                         p.corrected == Corrected::byGapsLoosely ||
                         (p.corrected == Corrected::inIteration && p.G->hasBodies());
  return askedBack && boundsWork(p.size()) && !p.rule;
}

bool Automatic::settles(const InclusionProblem& p) const {
  const bool askedBack =
      p.corrected == Corrected::byGaps || p.corrected == Corrected::byGapsLoosely;
  return options_.bounded && askedBack && p.G->hasBodies() && p.size() >= kSettledFrom && !p.rule &&
         !bounds(p);
}

void Automatic::settle(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  const double settling = std::max(kSettling, options_.tolerance);
  const double settled = std::max(kSettled, options_.tolerance);
  if (report.residuals.largest() > settling) {
    const int before = report.iterations;
    const Residuals reached = report.residuals;
    packed_.sweeps(p, settling, kSettlingSweeps, Lambda, report);
    report.note(report.method, before);
    if (!(report.residuals.largest() < reached.largest())) {
      std::copy(keptLambda_.begin(), keptLambda_.end(), Lambda.data());
      report.residuals = kept_;
    }
  }
  if (report.residuals.largest() <= settled) report.status = SolveStatus::solved;
}

bool Automatic::condensed(const InclusionProblem& p) const {
  return options_.bounded && p.corrected != Corrected::never && !p.G->hasBodies() && !p.rule;
}

NewtonLimits Automatic::limits(const InclusionProblem& p, int steps) const {
  const NewtonLimits all{options_.maxNewton, options_.maxPatient, options_.maxIterations};
  if (bounds(p)) return {steps, 0, 0};
  // With bodies, kQuick steps find nearly all solutions if little effort is wanted.
  if (settles(p)) return {p.effort == Effort::full ? kQuick : kHurried, 0, 0};
  if (!condensed(p))
    return options_.bounded && p.effort != Effort::full ? NewtonLimits{kHurried, 0, 0} : all;
  const double products = productsOf(p);
  const auto affordable = [&](double most) {
    return static_cast<int>(std::min(most / products, 1.0 * all.maxNewton));
  };
  if (p.effort == Effort::little) return {kFewestTried, 0, 0};
  if (p.effort == Effort::retried) return {std::max(kFewestTried, affordable(kMostTried)), 0, 0};
  const int most = std::max(kFewestSteps, affordable(kMostProducts));
  return most < all.maxNewton ? NewtonLimits{most, most, kSweepsInVain} : all;
}

SolveReport Automatic::boundedSweeps(const InclusionProblem& p, Vec Lambda, SolveReport report) {
  // If the forces are near already, some more sweeps keep the errors of many steps from adding up.
  const double now = report.residuals.largest();
  const bool near = now <= kEnough;
  const double aim = near ? std::max(now / 3.0, options_.tolerance) : kEnough;
  const int before = report.iterations;
  packed_.sweeps(p, aim, near ? kFewSweeps : kMostSweeps, Lambda, report);
  // Where nearly all steps fail, more sweeps only cost more.
  const bool goesOn = p.effort != Effort::little;
  if (report.residuals.largest() > kAccepted && goesOn)
    packed_.sweeps(p, kAccepted, kLastSweeps, Lambda, report);
  report.note(report.method, before);
  // Without bodies a Newton step eliminates all rows.
  if (report.residuals.largest() <= kAccepted || !p.G->hasBodies() || !goesOn) return report;
  // Sweeps may end in a cycle of single contacts.
  keep(p, {Lambda.data(), Lambda.size()}, report.residuals);
  const NewtonLimits most{kLastNewton, 0, 0};
  return coarse_.refine(p, Lambda, report, false, nullptr, &most);
}

bool Automatic::pivot(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  if (report.status == SolveStatus::notFinite || p.rows() > kMostPivoted || p.enough())
    return false;
  keep(p, {Lambda.data(), Lambda.size()}, report.residuals);
  Eigen::VectorXd trial = Eigen::VectorXd::Zero(p.rows());
  SolveReport found = lemke_.solve(p, view(trial));
  report.iterations += found.iterations;
  if (!found.ok() && lemke_.outcome() == LcpOutcome::solved && !p.enough()) {
    found = newton_.refine(p, view(trial), found, false);
    report.iterations += found.iterations, report.newton += found.newton;
  }
  if (!(found.residuals.largest() < report.residuals.largest())) return false;
  Lambda = trial;
  report.residuals = found.residuals;
  report.method = "Lemke";
  report.note(report.method, report.iterations - found.iterations);
  if (found.ok()) report.status = SolveStatus::solved;
  return found.ok();
}

bool Automatic::tryFrom(const InclusionProblem& p, const NewtonSchedule& schedule,
                        Eigen::VectorXd& trial, Vec Lambda, SolveReport& report) {
  SolveReport again;
  again.residuals = residuals(p, view(std::as_const(trial)), scratch_);
  rescue_.solve(p, schedule, options_.tolerance, view(trial), again);
  report.iterations += again.iterations, report.newton += again.newton;
  report.rejected += again.rejected;
  if (again.residuals.largest() < report.residuals.largest())
    Lambda = trial, report.residuals = again.residuals;
  if (again.ok()) report.status = SolveStatus::solved;
  return again.ok();
}

bool Automatic::restarts(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  if (report.status == SolveStatus::notFinite || p.size() > kMostRestarted || p.enough() ||
      !rescue_.prepare(p))
    return false;
  relaxation(p, Relaxation::exact, 1.0, r_);
  Eigen::VectorXd trial(p.rows());
  for (const bool pressed : {false, true}) {
    NewtonSchedule schedule = NewtonSchedule::gentle();
    schedule.maxNewton = options_.bounded && p.G->hasBodies() && p.size() > kRestartedFully
                             ? kRestartSteps * kRestartedFully / p.size()
                             : kRestartSteps;
    if (pressed) {
      press(p, 10.0, 0, trial);
    } else {
      trial.setZero();
      schedule.separateNormal = true, schedule.rho = 10.0;
      p.G->begin(trial.data());
      for (int k = 0; k < kRestartSweeps; ++k) gaussSeidel_.sweep(p, r_.data(), trial.data());
    }
    const int before = report.iterations;
    const bool solved = tryFrom(p, schedule, trial, Lambda, report);
    report.method = pressed ? "proximal Newton, pressed" : "proximal Newton, restarted";
    report.note(report.method, before);
    if (solved) return true;
  }
  return false;
}

bool Automatic::others(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  // In a time step, hundreds of attempts cost more than halving the step.
  if (p.G->hasBodies() || condensed(p) || p.rows() > kMostOthers ||
      report.status == SolveStatus::notFinite || !rescue_.prepare(p))
    return false;
  constexpr double kPressed[] = {10.0, 0.0, 0.1, 100.0, 1.0};
  constexpr int kAlike = 5, kSchedules = 12;
  Eigen::VectorXd trial(p.rows());
  const int before = report.iterations;
  bool solved = false;
  for (int k = 0; k < kSchedules * kOtherStarts && !solved; ++k) {
    if (p.enough()) break;
    const int start = k % kOtherStarts, way = k / kOtherStarts;
    NewtonSchedule schedule = way % 2 == 0 ? NewtonSchedule() : NewtonSchedule::gentle();
    schedule.velocities = way / 2 % 2 == 1;
    schedule.rho = way < 4 ? 2.0 : (way < 8 ? 10.0 : 1.0);
    schedule.separateNormal = start % 2 == 1;
    schedule.maxNewton = kOtherSteps;
    if (start < kAlike)
      press(p, kPressed[start], 0, trial);
    else
      press(p, 1e-2, start, trial);
    solved = tryFrom(p, schedule, trial, Lambda, report);
  }
  report.method = "proximal Newton, other starts";
  report.note(report.method, before);
  return solved;
}

bool Automatic::alternate(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  start_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  const SolveReport tried = admm_.solve(p, Lambda);
  report.iterations += tried.iterations;
  report.note(tried.method, report.iterations - tried.iterations);
  if (tried.ok()) {
    report.residuals = tried.residuals, report.method = tried.method;
    return true;
  }
  std::copy(start_.begin(), start_.end(), Lambda.data());
  return false;
}

void Automatic::declare(Attributes& a) {
  a.about(
      "Chooses: accepts a good start, one contact in closed form, sweeps while they pay, then the "
      "proximal Newton method, the same with other steps, Gauss-Seidel, other starts, pivoting. "
      "The best of all is the result.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxNewton", "500",
        "Newton steps; four times as many of the second try")
      .min = 1;
  a.add(AttributeType::integer, "maxIterations", "10000", "sweeps of the last stage").min = 1;
  a.choice(
      "work", {"automatic", "bounded", "unbounded"}, "automatic",
      "bounded: 200 contacts and more are solved to what is enough for the scheme (1e-2) by sweeps "
      "where few Newton steps do not reach the tolerance, 24 and more to 2e-6; automatic: bounded "
      "if no tolerance is given");
  a.add(AttributeType::flag, "minimalNorm", "false",
        "of forces that are not unique, the smallest: equal shares; about five times the work");
  a.example("<simulation until=\"1\" step=\"1e-3\"><Automatic tolerance=\"1e-12\"/></simulation>");
}

}  // namespace dynamy
