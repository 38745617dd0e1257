#include <algorithm>
#include <cmath>
#include <dynamy/simulation/run/rest_trial.hpp>

namespace dynamy {
namespace {

/// Accelerations at rest, and gaps that count as closed, over what free motion makes in a step.
constexpr double kBalance = 1e-8, kClosed = 1e-3;
/// Islands are tried together up to so many contacts, whose inclusion is solved at once.
constexpr int kTogether = 64;

}  // namespace

void RestTrial::find(MechanicalSystem& s, InclusionSolver& solver, const State& x, double dt,
                     const std::vector<char>& still, std::vector<QuietIsland>& islands) {
  keys_.clear(), first_.assign(1, 0), forces_.clear();
  std::size_t begin = 0;
  while (begin < islands.size()) {
    std::size_t end = begin;
    int contacts = 0;
    do contacts += islands[end++].contacts;
    while (end < islands.size() && contacts + islands[end].contacts <= kTogether);
    tryAll({s, solver, x, dt, still}, Group(islands).subspan(begin, end - begin));
    begin = end;
  }
  index_.build(keys_);
}

void RestTrial::tryAll(const Step& step, Group islands) {
  MechanicalSystem& s = step.s;
  viewOf(step, islands);
  const long evaluations = view_->evaluations();
  double change = 0.0;
  for (const QuietIsland& island : islands)
    change =
        std::max(change, step.dt * largest(island, s.implicitForces().acceleration(s.slot(0))));
  reach_ = kClosed * step.dt * change;

  x_ = step.x;
  for (QuietIsland& island : islands) island.rests = true;
  bool solved = solve(step);  // do they stop?
  judge(step, solved, islands);
  if (std::any_of(islands.begin(), islands.end(), [](const auto& i) { return i.rests; })) {
    x_.u.setZero();
    solved = solve(step);  // do they stay?
    judge(step, solved, islands);
    if (solved) keepForces(step.dt);
  }
  s.count(view_->evaluations() - evaluations);
  if (!solved && islands.size() > 1)  // one of them may spoil the others
    for (std::size_t i = 0; i < islands.size(); ++i) tryAll(step, islands.subspan(i, 1));
}

/// One step of the view's velocities from x_. False: its inclusion was not solved to kBalance.
bool RestTrial::solve(const Step& step) {
  view_->evaluate(x_, {.reach = reach_});
  ImpactProblem& problem = view_->impactProblem(x_, step.dt);
  const SolveReport report = problem.solve(step.solver);
  problem.velocityFromImpulses(x_);
  return report.ok() && report.residuals.largest() <= kBalance;
}

/// Makes the view one on some islands and on all that stands still.
void RestTrial::viewOf(const Step& step, Group islands) {
  const SystemParts& all = step.s.parts();
  if (!view_) {
    SystemParts parts = all;
    parts.subset = &subset_;
    view_ = std::make_unique<MechanicalSystem>(parts);
  }
  std::vector<char> without(step.still.size());
  for (std::size_t i = 0; i < without.size(); ++i) without[i] = step.still[i] != 0 ? 0 : 1;
  for (const QuietIsland& island : islands)
    for (const int i : island.systems) without[static_cast<std::size_t>(i)] = 0;
  subset_.assign(*all.topology, std::move(without), all.forces, all.contacts);
  view_->gTol(step.s.gTol());
  view_->limits.workers = step.s.limits.workers, view_->limits.effort = Effort::retried;
}

/// Keeps those islands at rest that the step in x_ has left there.
void RestTrial::judge(const Step& step, bool solved, Group islands) const {
  const Evaluation& e = view_->slot(0);
  const Eigen::VectorXd& acceleration = view_->implicitForces().acceleration(e);
  const std::vector<double>& chi = e.contacts.chi;
  const bool stands = std::all_of(chi.begin(), chi.end(), [](double v) { return v == 0.0; });
  for (QuietIsland& island : islands) {
    const double free = step.dt * largest(island, acceleration);
    island.rests = island.rests && solved && stands && largest(island, x_.u) <= kBalance * free;
  }
}

double RestTrial::largest(const QuietIsland& island, const Eigen::VectorXd& u) const {
  double out = 0.0;
  for (const int i : island.systems) {
    const SystemHandle& s = view_->parts().topology->system(i);
    for (int k = s.u0; k < s.u0 + s.nu; ++k) out = std::max(out, std::abs(u[k]) * perUnit_[k]);
  }
  return out;
}

void RestTrial::keepForces(double dt) {
  const ContactSet& c = view_->slot(0).contacts;
  const ConstVec Lambda = std::as_const(*view_).problem().Lambda();
  for (int i = 0; i < c.size(); ++i) {
    keys_.push_back(c.key[static_cast<std::size_t>(i)]);
    for (int r = 0; r < c.dim(i); ++r)
      forces_.push_back(Lambda[c.row0[static_cast<std::size_t>(i)] + r] / dt);
    first_.push_back(static_cast<int>(forces_.size()));
  }
}

const double* RestTrial::force(ContactKey key, int dim) const {
  const int found = index_.find(key);
  if (found < 0) return nullptr;
  const auto at = static_cast<std::size_t>(found);
  return first_[at + 1] - first_[at] == dim ? forces_.data() + first_[at] : nullptr;
}

}  // namespace dynamy
