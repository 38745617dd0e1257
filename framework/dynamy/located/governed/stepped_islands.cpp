#include <algorithm>
#include <cmath>
#include <dynamy/located/governed/stepped_islands.hpp>

namespace dynamy {
namespace {

constexpr double kSenseless = 0.1;  ///< part of the scales by which a step errs that may diverge
constexpr double kGrown = 0.1;      ///< of an allowed overlap: less growth counts as none
/// Of the change of velocities in a step: if more than this was not foreseen by the step before,
/// the change is an impact.
constexpr double kUnforeseen = 0.5;

/// The largest overlap of unilateral contacts of time-stepped systems, also of contacts that
/// rebound [m].
double deepestOverlap(const ContactSet& c, const Islands& islands,
                      const std::vector<char>& stepped) {
  double overlap = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int system = c.law[at]->unilateral() ? islands.systemOf(c, i) : -1;
    if (system >= 0 && stepped[static_cast<std::size_t>(system)] != 0)
      overlap = std::max(overlap, -c.position[static_cast<std::size_t>(c.row0[at])]);
  }
  return overlap;
}

}  // namespace

SteppedIslands::Trial SteppedIslands::attempt(MechanicalSystem& s, InclusionSolver& solver,
                                              const ErrorNorm& norm, const Islands& islands,
                                              const std::vector<char>& stepped, Effort effort,
                                              const State& from, State& x, double h) {
  Trial out;
  out.report = step(s, solver, effort, from, x, h);
  s.limits.effort = Effort::full;  // a search in vain lowers the effort for this step alone
  out.newton = 1 + out.report.solved.newton;
  out.error = error(s, norm, islands, stepped, from, x, h);
  out.bursts = out.error * norm.tolerance() > kSenseless && bursts(s, from, x);
  return out;
}

bool SteppedIslands::bursts(MechanicalSystem& s, const State& a, const State& b) const {
  double kinetic[2] = {0.0, 0.0}, potential[2] = {0.0, 0.0};
  for (const int i : {1, 0}) {
    const State& x = i == 0 ? a : b;
    const Evaluation& e = s.evaluate(x, {.slot = 1});
    kinetic[i] = e.mass.kineticEnergy(view(x.u)), potential[i] = s.potentialEnergy(e.kinematics, x);
  }
  const double gained = kinetic[1] - kinetic[0] + potential[1] - potential[0];
  return !(gained <= kinetic[0]);
}

StepReport SteppedIslands::step(MechanicalSystem& s, InclusionSolver& solver, Effort effort,
                                const State& from, State& x, double h) {
  x = from;
  s.limits.effort = effort;
  if (!projected_) {
    midpoint_.whole();
    const StepReport report = midpoint_.step(s, solver, x, h);
    if (report.solved.ok() || !midpoint_.hasJoints()) return report;
    projected_ = true, rate_.resize(0);
    x = from;
    s.limits.effort = effort;
  }
  x.scheme.resize(0);
  return projecting_.step(s, solver, x, h);
}

double SteppedIslands::error(MechanicalSystem& s, const ErrorNorm& norm, const Islands& islands,
                             const std::vector<char>& stepped, const State& a, const State& b,
                             double h) {
  // Error of positions by the trapezoidal rule: h/2 |Δu − Δu of the step before|, an impact or
  // h³ü/2; the first step gives the rate. Overlaps at the end, which the step itself does not
  // check, count as well if they grew. An overlap that stays would not be corrected by shorter
  // steps.
  double worst = 0.0;
  const bool known = rate_.size() == a.u.size();
  for (std::size_t k = 0; known && k < stepped.size(); ++k) {
    const SystemHandle& part = s.parts().topology->system(static_cast<int>(k));
    double own = 0.0;
    for (int i = part.u0; stepped[k] != 0 && i < part.u0 + part.nu; ++i)
      own = std::max(own, norm.velocity(i, b.u[i] - a.u[i] - h * rate_[i], 0.0));
    // Velocities are measured in s_i/T of their island.
    worst = std::max(worst, 0.5 * h / norm.times()[static_cast<Eigen::Index>(k)] * own);
  }
  reached_ = deepestOverlap(s.evaluate(b, {.slot = 1}).contacts, islands, stepped);
  const double allowed = norm.tolerance() * norm.length(), gained = reached_ - overlap_;
  worst = std::max(worst, (gained > kGrown * allowed ? reached_ : gained) / allowed);
  return std::isfinite(worst) && s.indefiniteMass() < 0 ? worst : 1e300;
}

void SteppedIslands::take(const MechanicalSystem& s, const State& from, const State& x, double h) {
  findHits(s, from, x, h);
  rate_ = (x.u - from.u) / h, overlap_ = reached_;
}

/// Finds the systems that were hit on the way from a to b, and when:
///
///   b.q ⊖ a.q ≈ h (θ u^A + (1 − θ) u^E)
void SteppedIslands::findHits(const MechanicalSystem& s, const State& a, const State& b, double h) {
  const Topology& topology = *s.parts().topology;
  const bool known = rate_.size() == b.u.size();
  hitAt_.assign(topology.systems().size(), -1.0);
  State before, after;  // where the velocities at the ends alone would have led
  for (std::size_t k = 0; known && k < hitAt_.size(); ++k) {
    const SystemHandle& part = topology.system(static_cast<int>(k));
    const Eigen::VectorXd change = b.u.segment(part.u0, part.nu) - a.u.segment(part.u0, part.nu);
    const double unforeseen = (change - h * rate_.segment(part.u0, part.nu)).norm();
    if (!(unforeseen > kUnforeseen * change.norm())) continue;
    if (before.q.size() == 0) {
      before.t = after.t = a.t, before.q = after.q = a.q;
      s.move(before, a.u, h), s.move(after, b.u, h);
    }
    const auto of = [&](const State& x) { return x.q.segment(part.q0, part.nq); };
    const Eigen::VectorXd apart = of(before) - of(after);
    const double theta = (of(b) - of(after)).dot(apart) / apart.squaredNorm();
    hitAt_[k] = std::isfinite(theta) ? std::clamp(theta, 0.0, 1.0) : 0.5;
  }
}

void SteppedIslands::between(const MechanicalSystem& s, const State& a, const State& b,
                             double theta, State& out) const {
  move(s, a, b, theta, hitAt_, out);
}

void SteppedIslands::linear(const MechanicalSystem& s, const State& a, const State& b, double theta,
                            State& out) {
  move(s, a, b, theta, {}, out);
}

/// `hitAt`: as hitAt_; empty: no system was hit.
void SteppedIslands::move(const MechanicalSystem& s, const State& a, const State& b, double theta,
                          const std::vector<double>& hitAt, State& out) {
  // Positions of these steps advance by the mean velocity, from the nearer end.
  const Eigen::VectorXd change = b.u - a.u;
  const auto part = [&](bool first) { return first ? theta : theta - 1.0; };
  const bool first = theta < 0.5;
  out.q = first ? a.q : b.q;
  out.u = (first ? a.u : b.u) + part(first) * change;
  Eigen::VectorXd way = part(first) * ((first ? a.u : b.u) + 0.5 * part(first) * change);
  for (std::size_t k = 0; k < hitAt.size(); ++k) {
    if (hitAt[k] < 0.0) continue;
    const SystemHandle& h = s.parts().topology->system(static_cast<int>(k));
    const bool yet = theta < hitAt[k];
    const State& from = yet ? a : b;
    out.q.segment(h.q0, h.nq) = from.q.segment(h.q0, h.nq);
    out.u.segment(h.u0, h.nu) = from.u.segment(h.u0, h.nu);
    way.segment(h.u0, h.nu) = part(yet) * from.u.segment(h.u0, h.nu);
  }
  s.move(out, way, b.t - a.t);
  out.t = (first ? a.t : b.t) + part(first) * (b.t - a.t);
}

}  // namespace dynamy
