#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/impact_detection.hpp>
#include <dynamy/stages/mechanical_system.hpp>
#include <limits>

namespace dynamy {

MechanicalSystem::MechanicalSystem(const SystemParts& parts, int slots) : parts_(parts) {
  const Topology& topology = *parts.topology;
  slots_.resize(static_cast<std::size_t>(std::max(1, slots)));
  for (Evaluation& e : slots_) {
    e.kinematics.resize(topology);
    e.mass.resize(topology);
    e.h.setZero(topology.nu());
    e.hNonPotential.setZero(topology.nu());
    e.contacts.clear();
  }
  uFree_.setZero(topology.nu());
  uA_.setZero(topology.nu());
  work_.setZero(topology.nu()), change_ = work_, implicitFree_.setZero(topology.nu());
  problem_.contacts = &slots_.front().contacts;
  stiff_.resize(topology, parts_.forces);
}

void MechanicalSystem::move(State& x, const Eigen::VectorXd& v, double dt) const {
  const Topology& topology = *parts_.topology;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    const PartialMechanicalSystem& system = *topology.systems()[i];
    if (s.nq > 0)
      named(system, [&] { system.move(x.t, slice(x.q, s.q0, s.nq), slice(v, s.u0, s.nu), dt); });
  }
  x.t += dt;
}

bool MechanicalSystem::renew(double tA, State& x) const {
  const Topology& topology = *parts_.topology;
  bool changed = false;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (topology.systems()[i]->renew(tA, x.t, slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu)))
      changed = true;
  }
  return changed;
}

void MechanicalSystem::moveConfiguration(State& x, double dt) { move(x, x.u, dt); }

namespace {}  // namespace

const Evaluation& MechanicalSystem::evaluate(const State& x, int slot, double reach) {
  Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  smooth(x, e);
  if (slot == 0) unresolved_ = false, forgetAside();
  detect(reach, e);
  if (request_.bias && !differenced_.empty()) tellDifferences(x, e);
  return e;
}

const Evaluation& MechanicalSystem::evaluateOf(std::span<const char> elements, const State& x,
                                               int slot) {
  Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  smooth(x, e);
  if (slot == 0) unresolved_ = false, forgetAside();
  e.contacts.clear();
  ContactSink sink(e.contacts, request_);
  reportContacts(parts_, e.kinematics, sink, elements);
  return e;
}

const Evaluation& MechanicalSystem::evaluateAhead(const State& x, double dt, int slot) {
  Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  smooth(x, e);
  if (slot == 0) unresolved_ = false, forgetAside();
  e.mass.applyInverse(view(std::as_const(e.h)), view(change_));
  detectAhead(x, dt, e);
  return e;
}

/// Finds contacts within twice the way of the fastest block in Δt, by |u| and the accelerations
/// change_; angles count as lengths.
void MechanicalSystem::detectAhead(const State& x, double dt, Evaluation& e) {
  double largest = 0.0;
  for (int b = 0; b < e.mass.blocks(); ++b) {
    double speed = 0.0;
    for (int i = e.mass.u0(b); i < e.mass.u0(b) + e.mass.nu(b); ++i)
      speed += std::abs(x.u[i]) + dt * std::abs(change_[i]);
    largest = std::max(largest, speed);
  }
  detect(2.0 * dt * largest, e);
  // If a law has a scale but no reservoir, and its set is no friction cone, the element scales the
  // pull of the contact (UnilateralAdhesion). Only closed contacts pull.
  ContactSet& c = e.contacts;
  for (std::size_t i = 0; i < c.law.size(); ++i)
    if (c.law[i]->scales() && c.law[i]->unilateral() && !c.law[i]->reservoir() &&
        !c.scale.empty() && c.position[static_cast<std::size_t>(c.row0[i])] > request_.gTol)
      c.scale[i] = 0.0;
}

void MechanicalSystem::smooth(const State& x, Evaluation& e) {
  const Topology& topology = *parts_.topology;
  e.t = x.t;
  ++evaluations_;
  e.kinematics.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory));
  indefinite_ = e.mass.evaluate(topology, x.t, view(x.q));
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (s.nu == 0) continue;
    const PartialMechanicalSystem& system = *topology.systems()[i];
    named(system, [&] {
      const ConstVec q = slice(x.q, s.q0, s.nq), u = slice(x.u, s.u0, s.nu);
      system.h(x.t, q, u, slice(e.h, s.u0, s.nu));
      system.nonPotentialForce(x.t, q, u, slice(e.hNonPotential, s.u0, s.nu));
    });
  }
  ForceSink forces(view(e.h), view(e.hNonPotential));
  for (std::size_t i = 0; i < parts_.forces.size(); ++i) {
    const ExternalForce* f = parts_.forces[i];
    if (!withheld_.empty() && withheld_[i] != 0) continue;
    forces.hasPotential(f->hasPotential());
    named(*f, [&] { f->addTo(e.kinematics, forces); });
  }
  for (std::size_t i = 0; topology.leavesOut() && i < topology.systems().size(); ++i)
    if (const SystemHandle& s = topology.system(static_cast<int>(i)); topology.leftOut(s.index))
      e.h.segment(s.u0, s.nu).setZero(), e.hNonPotential.segment(s.u0, s.nu).setZero();
}

void MechanicalSystem::detect(double reach, Evaluation& e) const {
  e.contacts.clear();
  ContactRequest request = request_;
  request.gTol += reach;
  ContactSink sink(e.contacts, request);
  reportContacts(parts_, e.kinematics, sink);
}

void reportContacts(const SystemParts& parts, const Kinematics& k, ContactSink& sink,
                    std::span<const char> only) {
  for (std::size_t i = 0; i < parts.contacts.size(); ++i) {
    const NonSmoothElement& element = *parts.contacts[i];
    if (parts.topology->leftOut(element) || (!only.empty() && only[i] == 0)) continue;
    sink.element(static_cast<int>(i));
    named(element, [&] { element.contacts(k, sink); });
  }
}

double MechanicalSystem::largestChange(double dt) const {
  const Evaluation& e = slots_.front();
  if (!unresolved_) e.mass.applyInverse(view(e.h), view(change_));
  return change_.size() == 0 ? 0.0 : dt * change_.cwiseAbs().maxCoeff();
}

InclusionProblem& MechanicalSystem::impactProblem(const State& x, double dt, int slot,
                                                  const PositionAim* aim) {
  const Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  uA_ = x.u;
  slot_ = slot, implicit_ = unresolved_ && slot == 0;
  if (implicit_) {
    implicitChange(e, uA_, dt);
    uFree_ = uA_ + implicitFree_;
  } else {
    e.mass.applyInverse(view(e.h), view(uFree_));
    uFree_ = uA_ + dt * uFree_;  // u_free = u^A + M⁻¹hΔt
  }
  problem_.G = &delassus_;
  problem_.contacts = &e.contacts;
  problem_.dt = dt, problem_.corrected = Corrected::never, problem_.effort = effort_;
  const auto gamma = [&](const Eigen::VectorXd& u, std::vector<double>& out) {
    const Eigen::Index rows = e.contacts.rows();
    out.resize(static_cast<std::size_t>(rows));
    if (rows > 0) e.contacts.gamma({u.data(), u.size()}, {out.data(), rows});
  };
  gamma(uFree_, problem_.gammaFree);
  if (aim && slot == 0 &&
      closing_.reduce(slots_.front().contacts, view(std::as_const(uFree_)), dt, request_.gTol,
                      x.impulses))
    gamma(uFree_, problem_.gammaFree);
  gamma(uA_, problem_.gammaA);
  problem_.c.resize(problem_.gammaA.size());
  if (implicit_ && e.contacts.rows() > 0)
    stiff_.delassus(e.contacts, e.mass, delassus_);
  else if (e.contacts.rows() > 0)
    delassus_.assemble(e.contacts, e.mass, form_);
  gapNoise_ = aim ? aim->noise / dt : 0.0;
  if (aim) addAim(*aim, dt);
  startImpulses(x);
  scales();
  return problem_;
}

void MechanicalSystem::addAim(const PositionAim& aim, double dt) {
  const ContactSet& c = *problem_.contacts;
  arriving_.clear();
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto first = static_cast<std::size_t>(c.row0[at]);
    const SetValuedForceLaw& law = *c.law[at];
    if (law.unilateral()) {
      const double g = c.position[first];
      const bool rough = std::isinf(aim.dead);  // overlaps are corrected, impacts do not wait
      if (!rough && g <= aim.dead) continue;
      // A rebound, and any impact, waits until the contact is closed. In two parts, each with its
      // own slip, an impact with friction would depend on its place in the step.
      double epsilon[kMostRows] = {};
      law.epsilon(c.dim(i), epsilon);
      const bool fast = -problem_.gammaA[first] > kImpactSteps * changeByForces(i);
      if (rough && (epsilon[0] == 0.0 || (g <= request_.gTol && !fast))) {
        problem_.gammaFree[first] += g / dt;
        continue;
      }
      if (rough && g <= request_.gTol) continue;  // its rebound removes the overlap
      const bool impact = (epsilon[0] > 0.0 && problem_.gammaA[first] < 0.0) || fast;
      const bool arrived = g <= request_.gTol ||
                           std::binary_search(aim.arrived.begin(), aim.arrived.end(), c.key[at]);
      if (impact && arrived) continue;
      if (impact && aim.divide && epsilon[0] == 0.0) {
        problem_.gammaFree[first] += g / dt;
        continue;
      }
      if (impact && epsilon[0] == 0.0 && g + dt * problem_.gammaFree[first] < 0.0)
        arriving_.push_back(c.key[at]);
      const double away = std::abs(problem_.gammaFree[first]) + std::abs(problem_.gammaA[first]);
      problem_.gammaFree[first] += impact ? g / dt + 4.0 * away : g / dt;
      continue;
    }
    for (int r = 0; r < c.dim(i); ++r) {
      if (!holds(law.rowKind(r))) continue;
      const auto row = first + static_cast<std::size_t>(r);
      const double back = std::clamp(aim.kappa * c.position[row] / dt, -aim.cap, aim.cap);
      problem_.gammaFree[row] += aim.meanJoints ? problem_.gammaA[row] : back;
    }
  }
  std::sort(arriving_.begin(), arriving_.end());
}

double MechanicalSystem::changeByForces(int i) const {
  const ContactSet& c = *problem_.contacts;
  const auto at = static_cast<std::size_t>(i);
  double sum = 0.0;
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w;
    for (int j = 0; j < s.nu; ++j)
      sum += std::abs(w[j]) * std::abs(uFree_[s.u0 + j] - uA_[s.u0 + j]);
  }
  return sum;
}

void MechanicalSystem::roundingOfC() {
  // Rounding of γ = Wᵀu + χ: a few ε of the sum of absolute values.
  constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
  const ContactSet& c = *problem_.contacts;
  work_ = uA_.cwiseAbs().cwiseMax(uFree_.cwiseAbs());
  problem_.cNoise.resize(static_cast<std::size_t>(c.rows()));
  for (std::size_t row = 0; row < problem_.cNoise.size(); ++row)
    problem_.cNoise[row] = std::abs(c.chi[row]);
  c.addAbsolute(view(std::as_const(work_)), problem_.cNoise.data());
  for (double& noise : problem_.cNoise) noise *= kRounding;
  if (gapNoise_ == 0.0) return;
  for (int i = 0; i < c.size(); ++i)
    if (const auto at = static_cast<std::size_t>(i); c.law[at]->unilateral())
      problem_.cNoise[static_cast<std::size_t>(c.row0[at])] += gapNoise_;
}

double MechanicalSystem::velocityAskedOf(int i) const {
  // Unilateral contacts: the closing speed, and the change of γ by forces. A contact that leaves
  // requires no velocity, and a slip velocity exists without being required.
  const InclusionProblem& p = problem_;
  const auto first = static_cast<std::size_t>(p.row0(i));
  const bool unilateral = p.law(i).unilateral();
  double asked = 0.0;
  if (unilateral) {
    const double noise = p.cNoise[first];
    const bool open = p.contacts->position[first] > request_.gTol;  // present by its gap term
    const double closing =
        open ? -p.gammaFree[first] : std::max(-p.gammaFree[first], -p.gammaA[first]);
    if (closing <= noise) return 0.0;
    asked = closing;
  }
  for (std::size_t k = first; k < first + static_cast<std::size_t>(p.dim(i)); ++k) {
    const double change = std::abs(p.gammaFree[k] - p.gammaA[k]);
    const double value = unilateral ? change : std::max(change, std::abs(p.gammaFree[k]));
    if (value > p.cNoise[k]) asked = std::max(asked, value);
  }
  return asked;
}

void MechanicalSystem::scales() {
  roundingOfC();
  double uRef = 0.0;
  for (int i = 0; i < problem_.size(); ++i) uRef = std::max(uRef, velocityAskedOf(i));
  if (!(uRef > 0.0)) {
    // No contact requires a velocity beyond rounding: Λ = 0 solves the problem.
    std::fill(Lambda_.begin(), Lambda_.end(), 0.0);
    for (const double gamma : problem_.gammaFree) uRef = std::max(uRef, std::abs(gamma));
  }
  problem_.uRef = uRef > 0.0 ? uRef : std::numeric_limits<double>::min();
}

void MechanicalSystem::startImpulses(const State& x) {
  const ContactSet& c = *problem_.contacts;
  Lambda_.assign(static_cast<std::size_t>(c.rows()), 0.0);
  pressedBefore_.assign(static_cast<std::size_t>(c.size()), 0);
  const RememberedImpulses& old = x.impulses;
  if (!old.key.empty() && old.dt > 0.0) {
    startFrom(old, problem_.dt / old.dt);
    for (int i = 0; i < c.size(); ++i) {
      const int found = remembered_.find(c.key[static_cast<std::size_t>(i)]);
      if (found < 0) continue;
      const auto at = static_cast<std::size_t>(found);
      const int first = old.first[at];
      pressedBefore_[static_cast<std::size_t>(i)] =
          old.first[at + 1] > first && old.Lambda[static_cast<std::size_t>(first)] > 0.0 ? 1 : 0;
    }
  }
  if (!again_.key.empty()) startFrom(again_, 1.0);
}

/// Sets Λ of the contacts that are in `old`.
void MechanicalSystem::startFrom(const RememberedImpulses& old, double scale) {
  const ContactSet& c = *problem_.contacts;
  remembered_.build(old.key);
  for (int i = 0; i < c.size(); ++i) {
    const int found = remembered_.find(c.key[static_cast<std::size_t>(i)]);
    if (found < 0) continue;
    const auto at = static_cast<std::size_t>(found);
    const int first = old.first[at], dim = old.first[at + 1] - first;
    if (dim != c.dim(i)) continue;
    for (int r = 0; r < dim; ++r)
      Lambda_[static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)] + r)] =
          scale * old.Lambda[static_cast<std::size_t>(first + r)];
  }
}

bool MechanicalSystem::bringIn() {
  if (!closing_.any()) return false;
  Evaluation& e = slots_.front();
  work_ = uFree_;
  if (problem_.rows() > 0 && implicit_)
    stiff_.addVelocity(e.contacts, e.mass, Lambda_.data(), work_);
  else if (problem_.rows() > 0)
    delassus_.addVelocity(Lambda_.data(), view(work_));
  again_.key = e.contacts.key, again_.first = e.contacts.row0, again_.Lambda = Lambda_;
  return closing_.bringIn(e.contacts, work_, problem_.dt);
}

void MechanicalSystem::velocityFromImpulses(State& x) {
  x.u = uFree_;
  if (implicit_)
    addImplicitVelocity(x);
  else if (problem_.rows() > 0)
    delassus_.addVelocity(Lambda_.data(), view(x.u));  // u^E = u_free + M⁻¹WΛ
  keepImpulses(x);
}

void MechanicalSystem::keepImpulses(State& x) const {
  x.impulses.key = problem_.contacts->key;
  x.impulses.first = problem_.contacts->row0;
  x.impulses.Lambda = Lambda_;
  x.impulses.dt = problem_.dt;
}

void MechanicalSystem::remember(State& x) {
  if (x.memory.size() == 0) return;
  const Topology& topology = *parts_.topology;
  const State& end = x;
  energyKinematics_.evaluate(topology, x.t, view(end.q), view(end.u), view(end.memory));
  const auto ask = [&](const auto& elements) {
    for (const auto* e : elements)
      if (const MemoryHandle m = topology.memoryOf(*e); m.size > 0)
        e->remember(energyKinematics_, slice(x.memory, m.first, m.size));
  };
  ask(parts_.forces);
  ask(parts_.contacts);
}

double MechanicalSystem::potentialEnergy(const State& x) {
  const Topology& topology = *parts_.topology;
  double V = 0.0;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    V += topology.systems()[i]->potentialEnergy(x.t, slice(x.q, s.q0, s.nq));
  }
  if (parts_.forces.empty()) return V;
  energyKinematics_.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory));
  for (const ExternalForce* f : parts_.forces) V += f->potentialEnergy(energyKinematics_);
  return V;
}

}  // namespace dynamy
