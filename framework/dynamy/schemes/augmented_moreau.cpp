#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/augmented_moreau.hpp>

namespace dynamy {
namespace {

/// Up to this ωH, oscillations of stiff elements grow by at most 6e-5 per block, for any N.
constexpr double kExtrapolated = 0.5;
void add(const StepWorks& of, StepWorks& sum) {
  sum.given = true, sum.nonPotential += of.nonPotential, sum.friction += of.friction;
  sum.normal += of.normal, sum.joints += of.joints, sum.boundaries += of.boundaries;
}

}  // namespace

StepReport AugmentedMoreau::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                 double dt) {
  report_ = {};
  if (!lengths_.restore(x.scheme) || !sigma_.restore(x.scheme, BlockLengths::kSize))
    lengths_.forget(), sigma_.forget();
  lengths_.begin(x.t, dt);
  begin_ = x;
  closed_.begin(begin_);
  if (const auto plain = lengths_.plain()) {
    plainStep(s, solver, x, std::min(*plain, dt));
  } else {
    double H = std::min(lengths_.next(), dt);
    while (!block(s, solver, x, H)) {
      if (!report_.refused.empty()) {
        x = begin_;
        return report_;
      }
      ++report_.counts.rejected;
      lengths_.failed(H);
      if (H <= lengths_.shortest()) {
        switchStep(s, solver, x, H);
        break;
      }
      H = lengths_.next();
    }
  }
  x.scheme.resize(BlockLengths::kSize + sigma_.size());
  lengths_.store(x.scheme), sigma_.store(x.scheme, BlockLengths::kSize);
  return report_;
}

bool AugmentedMoreau::block(MechanicalSystem& s, InclusionSolver& solver, State& x, double H) {
  report_.solved = {}, report_.contacts = 0, report_.dt = H;
  closed_.find(s, begin_);
  sigmaBlock_ = sigma_;
  table_.begin();
  bool smooth = true;
  for (int j = 1; smooth && j <= options_.order; ++j) {  // T_{j,1}: j sub-steps of H/j
    begin(x);
    for (int i = 0; smooth && i < j; ++i) smooth = subStep(s, solver, x, H / j);
    if (j == 1 && options_.order > 1 && explicitIsUnstable(s, 0, x, H, kExtrapolated)) {
      report_.refused = lacks(Asked::stiffForces);
      smooth = false;
    }
    endOfRow(x);
  }
  if (!smooth) return false;
  extrapolated(s, x);
  x.t = begin_.t + H;
  if (!endIsFree(s, x)) return false;
  std::copy(Lambda_.begin(), Lambda_.end(), problem_->Lambda().data());
  sigma_ = sigmaBlock_;
  lengths_.accepted(x.t, H);
  return true;
}

void AugmentedMoreau::begin(State& x) {
  x = begin_;
  Lambda_.clear();
  works_ = {};
}

void AugmentedMoreau::endOfRow(const State& x) {
  z_.resize(x.q.size() + x.u.size() + 5);
  z_ << x.q, x.u, works_.nonPotential, works_.friction, works_.normal, works_.joints,
      works_.boundaries;
  table_.add(z_);
}

void AugmentedMoreau::extrapolated(const MechanicalSystem& s, State& x) {
  const Eigen::VectorXd& z = table_.result();
  x.q = z.head(x.q.size()), x.u = z.segment(x.q.size(), x.u.size());
  const double* w = z.data() + x.q.size() + x.u.size();
  report_.works = {true, w[0], w[1], w[2], w[3], w[4]};
  const Topology& topology = *s.parts().topology;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& h = topology.system(static_cast<int>(i));
    topology.systems()[i]->normalise(slice(x.q, h.q0, h.nq));
  }
}

bool AugmentedMoreau::subStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h) {
  baseStep(s, solver, x, h, Rebound::ofNew);
  sigmaNow_.read(s, x);
  if (!sigmaBlock_.known()) sigmaBlock_ = sigmaNow_;
  return sigmaNow_ == sigmaBlock_ && !closed_.anyPassed(s.slot(0).contacts, s.gTol()) &&
         endIsFree(s, x);
}

void AugmentedMoreau::plainStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h) {
  report_.solved = {}, report_.contacts = 0, report_.dt = h;
  x = begin_;
  s.move(x, h / 2);
  closed_.find(s, x);
  begin(x);
  sigma_.forget();
  baseStep(s, solver, x, h, Rebound::all);
  report_.works = works_;
  lengths_.stepped(h);
}

/// Steps over a switch, and counts it.
void AugmentedMoreau::switchStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h) {
  plainStep(s, solver, x, h);
  ++report_.counts.switches;
  const auto plainUntil = lengths_.countSwitch();
  if (!plainUntil) return;
  ++report_.counts.accumulations;
  report_.counts.accumulationEnd = *plainUntil;
}

bool AugmentedMoreau::endIsFree(const MechanicalSystem& s, const State& x) {
  return !options_.checkEnds || closed_.othersAreOpen(s, x);
}

void AugmentedMoreau::baseStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h,
                               Rebound rebound) {
  uA_ = x.u;
  s.move(x, h / 2);  // q^M = q^A + Δt/2 (F u^A + β)
  s.evaluate(x, {.held = HeldContacts{closed_.keys()}});
  ImpactProblem& problem = s.impactProblem(x, h);
  problem_ = &problem;
  problem.linearlyImplicit(x, kImplicitMidpoint);
  if (rebound == Rebound::ofNew) closed_.settle(sigma_, h, problem);
  const auto solved = problem.solve(solver);
  problem.velocityFromImpulses(x);
  s.move(x, h / 2);  // q^E = q^M + Δt/2 (F u^E + β)

  const Residuals worst = report_.solved.residuals;
  addSolve(report_.solved, solved);
  if (worst.largest() > solved.residuals.largest()) report_.solved.residuals = worst;
  report_.contacts = std::max(report_.contacts, problem.size());
  const Vec Lambda = problem.Lambda();
  add(meter_.of(s, uA_, x.u, h, view(Lambda)), works_);
  Lambda_.resize(static_cast<std::size_t>(Lambda.size()));
  for (std::size_t i = 0; i < Lambda_.size(); ++i)
    Lambda_[i] += Lambda[static_cast<Eigen::Index>(i)];
}

double AugmentedMoreau::nextStep(const State& x) const {
  return x.scheme.size() == 0 ? 0.0 : x.scheme[1];
}

void AugmentedMoreau::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                  double theta, State& out) const {
  // Hermite's cubic through q, q̇ of both ends; u linear where q̇ is not u.
  const double H = b.t - a.t, z = 1.0 - theta;
  out.t = a.t + theta * H;
  out.q.resize(a.q.size()), out.u = z * a.u + theta * b.u;
  Eigen::VectorXd vA, vB;
  const Topology& topology = *s.parts().topology;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& h = topology.system(static_cast<int>(i));
    const PartialMechanicalSystem& system = *topology.systems()[i];
    vA.setZero(h.nq), vB.setZero(h.nq);
    if (h.nq == 0) continue;
    system.qdot(a.t, slice(a.q, h.q0, h.nq), slice(a.u, h.u0, h.nu), view(vA));
    system.qdot(b.t, slice(b.q, h.q0, h.nq), slice(b.u, h.u0, h.nu), view(vB));
    const auto qA = a.q.segment(h.q0, h.nq), qB = b.q.segment(h.q0, h.nq);
    out.q.segment(h.q0, h.nq) = z * z * (1.0 + 2.0 * theta) * qA +
                                theta * theta * (3.0 - 2.0 * theta) * qB +
                                H * theta * z * (z * vA - theta * vB);
    system.normalise(slice(out.q, h.q0, h.nq));
  }
}

AugmentedMoreau::AugmentedMoreau(const Parameters& x)
    : OneStep(x), options_{x["order"].integer(), x["dtMin"], x["checkEnds"].flag()} {}

void AugmentedMoreau::declare(Attributes& a) {
  a.about(
      "Augmented time-stepping: Moreau's midpoint rule extrapolated to order N where no contact "
      "changes its state, steps halved down to dtMin where one does. `step` is the largest step.");
  a.add(AttributeType::integer, "order", "4", "N, rows of the extrapolation; 1: none")
      .between(1, 8);
  a.optional("dtMin", Unit::time, 0.0,
             "length of the step across a switch; 0: a quarter of step^N, in seconds")
      .nonNegative();
  a.add(AttributeType::flag, "checkEnds", "true",
        "a step is too long if an open contact is closed at the end of a sub-step");
  a.example("<simulation until=\"1\" step=\"0.02\"><AugmentedMoreau order=\"4\"/></simulation>");
}

}  // namespace dynamy
