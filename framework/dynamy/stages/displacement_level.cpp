#include <algorithm>
#include <cmath>
#include <dynamy/stages/displacement_level.hpp>

namespace dynamy {
namespace {

constexpr int kMostDisplacements = 40;

}  // namespace

void aimAtPositions(InclusionProblem& p, double dt) {
  const std::vector<double>& position = p.contacts->position;
  for (int i = 0; i < p.size(); ++i)
    for (int r = 0; r < p.dim(i); ++r) {
      const auto k = static_cast<std::size_t>(p.row0(i) + r);
      p.c[k] = p.gammaFree[k] + (isPositionRow(p.law(i), r) ? position[k] / dt : 0.0);
    }
}

void DisplacementLevel::pose(InclusionProblem& p, double dt,
                             const std::vector<double>& offset) const {
  aimAtPositions(p, dt);
  for (std::size_t k = 0; k < error_.size(); ++k)
    p.c[k] += error_[k] + (offset.empty() ? 0.0 : offset[k]);
}

double DisplacementLevel::errors(const ImpactProblem& p, const ContactSet& end,
                                 const Eigen::VectorXd& u, double dt) {
  const ContactSet& c = *p.contacts;
  gamma_.resize(error_.size());
  c.gamma(view(u), {gamma_.data(), static_cast<Eigen::Index>(gamma_.size())});
  double change = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const ContactKey key = c.key[static_cast<std::size_t>(i)];
    int j = i < end.size() && end.key[static_cast<std::size_t>(i)] == key ? i : -1;
    for (int m = 0; j < 0 && m < end.size(); ++m)
      if (end.key[static_cast<std::size_t>(m)] == key) j = m;
    if (j < 0) continue;
    const bool open = p.law(i).unilateral() && p.Lambda(c.row0[static_cast<std::size_t>(i)]) <= 0.0;
    for (int r = 0; r < c.dim(i); ++r) {
      if (!isPositionRow(p.law(i), r)) continue;
      const auto k = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)] + r);
      const double reached =
          end.position[static_cast<std::size_t>(end.row0[static_cast<std::size_t>(j)] + r)];
      const double error = reached / dt - (c.position[k] / dt + gamma_[k]);
      // The error of an open contact matters only if its gap is negative after all.
      if (!open || reached < 0.0) change = std::max(change, std::abs(error - error_[k]) * dt);
      error_[k] = error;
    }
  }
  return change;
}

SolveReport DisplacementLevel::solve(MechanicalSystem& s, ImpactProblem& problem,
                                     InclusionSolver& solver, State& x, double dt, int end,
                                     const std::vector<double>& offset) {
  base_ = x;
  keys_.clear();
  addKeys(*problem.contacts, keys_);
  error_.assign(static_cast<std::size_t>(problem.rows()), 0.0);
  SolveReport report;
  double before = 0.0;
  for (int i = 0; i < kMostDisplacements; ++i) {
    pose(problem, dt, offset);
    const SolveReport last = solver.solve(problem, problem.Lambda());
    addSolve(report, last);
    report.status = last.status;
    x.t = base_.t, x.q = base_.q;
    problem.velocityFromImpulses(x);
    s.move(x, dt);  // q^E = q^A ⊕ Δt F u^E
    s.evaluate(x, {.slot = end, .held = HeldContacts{keys_}});
    const double change = errors(problem, s.slot(end).contacts, x.u, dt);
    const double enough = 0.1 * s.gTol();
    if (change <= enough) break;
    // Rounding of the positions may be above the required accuracy: no better result is possible.
    if (i > 2 && change > 0.5 * before && change <= 10.0 * s.gTol()) break;
    if (i + 1 == kMostDisplacements) report.status = SolveStatus::stalled;
    before = change;
  }
  return report;
}

void addForce(const ContactSet& c, const double* Lambda, Eigen::VectorXd& f) {
  for (std::size_t i = 0; i < c.law.size(); ++i)
    for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
      const Segment& s = c.segment[static_cast<std::size_t>(k)];
      const double* w = c.W.data() + s.w;
      for (int r = c.row0[i]; r < c.row0[i + 1]; ++r, w += s.nu)
        for (int j = 0; j < s.nu; ++j) f[s.u0 + j] += w[j] * Lambda[r];
    }
}

void carry(const RememberedImpulses& from, const ContactSet& to, std::vector<double>& Lambda) {
  Lambda.assign(static_cast<std::size_t>(to.rows()), 0.0);
  for (std::size_t i = 0; i < to.key.size(); ++i)
    for (std::size_t j = 0; j < from.key.size(); ++j) {
      if (from.key[j] != to.key[i]) continue;
      for (int r = 0; r < to.dim(static_cast<int>(i)) && from.first[j] + r < from.first[j + 1]; ++r)
        Lambda[static_cast<std::size_t>(to.row0[i] + r)] =
            from.Lambda[static_cast<std::size_t>(from.first[j] + r)];
      break;
    }
}

void addKeys(const ContactSet& set, std::vector<ContactKey>& keys) {
  keys.insert(keys.end(), set.key.begin(), set.key.end());
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

void addPressed(const RememberedImpulses& last, std::vector<ContactKey>& keys) {
  for (std::size_t i = 0; i < last.key.size(); ++i)
    if (last.first[i] < last.first[i + 1] &&
        last.Lambda[static_cast<std::size_t>(last.first[i])] > 0.0)
      keys.push_back(last.key[i]);
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

}  // namespace dynamy
