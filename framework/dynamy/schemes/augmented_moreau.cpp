#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/augmented_moreau.hpp>
#include <dynamy/stages/displacement_level.hpp>
#include <limits>

namespace dynamy {
namespace {

/// More switches than this within Δt_max are not located: plain steps of Δt_max/kPlain follow.
constexpr int kMostSwitches = 32;
constexpr double kPlain = 32.0;
/// A contact slower than this multiple of the change by forces in a step has the rest of a rebound.
constexpr double kSettles = 4.0;
/// Up to this ωH, oscillations of stiff elements grow by at most 6e-5 per block, for any N.
constexpr double kExtrapolated = 0.5;
/// Shortest Δt_min, as a multiple of the time.
constexpr double kPostImpactNoise = 64.0 * std::numeric_limits<double>::epsilon();

constexpr Eigen::Index kPlanSize = 7;

void add(const StepWorks& of, StepWorks& sum) {
  sum.given = true, sum.nonPotential += of.nonPotential, sum.friction += of.friction;
  sum.normal += of.normal, sum.joints += of.joints, sum.boundaries += of.boundaries;
}

}  // namespace

StepReport AugmentedMoreau::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                 double dt) {
  restore(x, dt);
  begin_ = x;
  pressed_.clear();
  addPressed(begin_.impulses, pressed_);
  double H = std::min(plan_.next, dt);
  if (begin_.t < plan_.plainUntil) {
    plainStep(s, solver, x, std::min(plan_.dtMax / kPlain, dt));
  } else {
    while (!block(s, solver, x, H)) {
      if (!report_.refused.empty()) {
        x = begin_;
        return report_;
      }
      ++report_.counts.rejected;
      const double end = begin_.t + H;
      plan_.failedEnd = plan_.bisecting ? std::min(plan_.failedEnd, end) : end;
      plan_.bisecting = true;
      if (H <= dtMin()) {
        plainStep(s, solver, x, H);  // the switch
        countSwitch();
        break;
      }
      plan_.next = H = std::max(H / 2, dtMin());
    }
  }
  store(x);
  return report_;
}

bool AugmentedMoreau::block(MechanicalSystem& s, InclusionSolver& solver, State& x, double H) {
  report_.solved = {}, report_.contacts = 0, report_.dt = H;
  closedAt(s, begin_);
  sigmaBlock_ = sigma_;
  table_.begin();
  s.freeze(closed_);
  bool smooth = true;
  for (int j = 1; smooth && j <= options_.order; ++j) {  // T_{j,1}: j sub-steps of H/j
    begin(x);
    for (int i = 0; smooth && i < j; ++i) smooth = subStep(s, solver, x, H / j);
    if (j == 1 && options_.order > 1 && s.explicitIsUnstable(x, H, kExtrapolated, 0)) {
      report_.refused = lacks(Asked::stiffForces);
      smooth = false;
    }
    endOfRow(x);
  }
  s.thaw();
  if (!smooth) return false;
  extrapolated(s, x);
  x.t = begin_.t + H;
  if (!endIsFree(s, x)) return false;
  std::copy(Lambda_.begin(), Lambda_.end(), s.Lambda().data());
  accepted(x.t, H);
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
  return sigmaNow_ == sigmaBlock_ && !anyPassed(s.slot(0).contacts, s.gTol()) && endIsFree(s, x);
}

void AugmentedMoreau::plainStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h) {
  report_.solved = {}, report_.contacts = 0, report_.dt = h;
  x = begin_;
  s.moveConfiguration(x, h / 2);
  closedAt(s, x);
  s.freeze(closed_);
  begin(x);
  sigma_.forget();
  baseStep(s, solver, x, h, Rebound::all);
  s.thaw();
  report_.works = works_;
  plan_.bisecting = false, plan_.next = 2 * h;
}

void AugmentedMoreau::countSwitch() {
  ++report_.counts.switches;
  if (begin_.t - plan_.windowStart > plan_.dtMax) plan_.windowStart = begin_.t, plan_.switches = 0;
  if (++plan_.switches <= kMostSwitches) return;
  ++report_.counts.accumulations;
  report_.counts.accumulationEnd = begin_.t + plan_.dtMax;
  plan_.plainUntil = begin_.t + plan_.dtMax, plan_.switches = 0;
}

void AugmentedMoreau::baseStep(MechanicalSystem& s, InclusionSolver& solver, State& x, double h,
                               Rebound rebound) {
  uA_ = x.u;
  s.moveConfiguration(x, h / 2);  // q^M = q^A + Δt/2 (F u^A + β)
  s.evaluate(x);
  auto& problem = s.impactProblem(x, h);
  s.linearlyImplicit(x, kImplicitMidpoint);
  // In a contact that stays closed, γ_N is an error and not an approach.
  if (rebound == Rebound::ofNew) restOfClosed(problem, h);
  const auto solved = s.impactLaw().solve(problem, solver, s.Lambda());
  s.velocityFromImpulses(x);
  s.moveConfiguration(x, h / 2);  // q^E = q^M + Δt/2 (F u^E + β)

  const Residuals worst = report_.solved.residuals;
  addSolve(report_.solved, solved);
  if (worst.largest() > solved.residuals.largest()) report_.solved.residuals = worst;
  report_.contacts = std::max(report_.contacts, problem.size());
  const Vec Lambda = s.Lambda();
  add(meter_.of(s, uA_, x.u, h, view(Lambda)), works_);
  Lambda_.resize(static_cast<std::size_t>(Lambda.size()));
  for (std::size_t i = 0; i < Lambda_.size(); ++i)
    Lambda_[i] += Lambda[static_cast<Eigen::Index>(i)];
}

void AugmentedMoreau::restOfClosed(InclusionProblem& p, double h) const {
  const double longer = std::max(1.0, begin_.impulses.dt / h);
  const auto isIn = [](const std::vector<ContactKey>& keys, ContactKey key) {
    return std::binary_search(keys.begin(), keys.end(), key);
  };
  for (int i = 0; i < p.size(); ++i) {
    if (!p.law(i).unilateral()) continue;
    const ContactKey key = p.contacts->key[static_cast<std::size_t>(i)];
    const auto row = static_cast<std::size_t>(p.row0(i));
    // Right after a switch: the contact is no faster than forces made it in the step before.
    const double byForces = std::abs(p.gammaFree[row] - p.gammaA[row]) * longer;
    const bool settles = isIn(pressed_, key) && std::abs(p.gammaA[row]) <= kSettles * byForces;
    if (sigma_.known() ? isIn(sigma_.carrying(), key) : settles) p.gammaA[row] = 0.0;
  }
}

void AugmentedMoreau::accepted(double t, double H) {
  sigma_ = sigmaBlock_;
  // After the end of the block that failed no switch is left to be found: there was none.
  if (plan_.bisecting && t > plan_.failedEnd - 0.5 * dtMin()) plan_.bisecting = false;
  if (plan_.bisecting)
    plan_.next = std::max(H / 2, dtMin());
  else if (H >= plan_.next)
    plan_.next = std::min(2 * H, plan_.dtMax);
}

const ContactSet& AugmentedMoreau::evaluatedContacts(const MechanicalSystem& s, const State& x,
                                                     const ContactRequest& request) {
  const Topology& topology = *s.parts().topology;
  if (!ready_) kinematics_.resize(topology), ready_ = true;
  kinematics_.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory));
  contacts_.clear();
  ContactSink sink(contacts_, request);
  for (std::size_t i = 0; i < s.parts().contacts.size(); ++i) {
    sink.element(static_cast<int>(i));
    s.parts().contacts[i]->contacts(kinematics_, sink);
  }
  return contacts_;
}

void AugmentedMoreau::closedAt(const MechanicalSystem& s, const State& x) {
  ContactRequest request;
  request.gTol = s.gTol();
  closed_ = pressed_;
  addKeys(evaluatedContacts(s, x, request), closed_);
}

bool AugmentedMoreau::endIsFree(const MechanicalSystem& s, const State& x) {
  if (!options_.checkEnds) return true;
  ContactRequest gapsAlone;
  gapsAlone.refresh = true;
  return !anyPassed(evaluatedContacts(s, x, gapsAlone), 0.0);
}

bool AugmentedMoreau::anyPassed(const ContactSet& c, double least) const {
  for (std::size_t i = 0; i < c.g.size(); ++i)
    if (c.g[i] <= least && !std::binary_search(closed_.begin(), closed_.end(), c.candidateKey[i]))
      return true;
  return false;
}

double AugmentedMoreau::dtMin() const {
  const double dtMax = plan_.dtMax;
  const double given = options_.dtMin > 0.0 ? options_.dtMin : std::pow(dtMax, options_.order) / 4;
  return std::clamp(given, kPostImpactNoise * std::max(dtMax, std::abs(begin_.t)), dtMax);
}

void AugmentedMoreau::restore(const State& x, double dt) {
  report_ = {};
  const bool kept = x.scheme.size() > kPlanSize && x.scheme.head(kPlanSize).allFinite() &&
                    std::abs(x.scheme[5]) < kMostSwitches;  // else from another scheme: start anew
  if (!kept || !sigma_.restore(x.scheme, kPlanSize)) {
    plan_ = {}, sigma_.forget();
  } else {
    plan_ = {x.scheme[0],       x.scheme[1], x.scheme[2],
             x.scheme[3] > 0.0, x.scheme[4], static_cast<int>(x.scheme[5]),
             x.scheme[6]};
  }
  plan_.dtMax = std::max(plan_.dtMax, dt);
  if (!(plan_.next > 0.0)) plan_.next = plan_.dtMax;
}

void AugmentedMoreau::store(State& x) const {
  x.scheme.resize(kPlanSize + sigma_.size());
  x.scheme.head(kPlanSize) << plan_.dtMax, plan_.next, plan_.failedEnd, plan_.bisecting,
      plan_.windowStart, plan_.switches, plan_.plainUntil;
  sigma_.store(x.scheme, kPlanSize);
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
