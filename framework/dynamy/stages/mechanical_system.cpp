#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/stages/bias_differences.hpp>
#include <dynamy/stages/mechanical_system.hpp>
#include <dynamy/system/renewable.hpp>

namespace dynamy {
namespace {

/// Twice the way of the fastest block in Δt, by |u| and the accelerations; angles count as lengths.
double reachOf(const MassMatrix& mass, const Eigen::VectorXd& u,
               const Eigen::VectorXd& acceleration, double dt) {
  double largest = 0.0;
  for (int b = 0; b < mass.blocks(); ++b) {
    double speed = 0.0;
    for (int i = mass.u0(b); i < mass.u0(b) + mass.nu(b); ++i)
      speed += std::abs(u[i]) + dt * std::abs(acceleration[i]);
    largest = std::max(largest, speed);
  }
  return 2.0 * dt * largest;
}

/// If a law has a scale but no reservoir, and its set is no friction cone, the element scales the
/// pull of the contact (UnilateralAdhesion). Only closed contacts pull.
void pullOnlyClosed(ContactSet& c, double gTol) {
  for (std::size_t i = 0; i < c.law.size(); ++i)
    if (c.law[i]->scales() && c.law[i]->unilateral() && !c.law[i]->reservoir() &&
        !c.scale.empty() && c.position[static_cast<std::size_t>(c.row0[i])] > gTol)
      c.scale[i] = 0.0;
}

std::vector<Evaluation> emptySlots(const Topology& topology, int slots) {
  std::vector<Evaluation> out(static_cast<std::size_t>(std::max(1, slots)));
  for (Evaluation& e : out) {
    e.kinematics.resize(topology);
    e.mass.resize(topology);
    e.h.setZero(topology.nu());
    e.hNonPotential.setZero(topology.nu());
    e.contacts.clear();
  }
  return out;
}

void clearForces(const SystemHandle& s, Evaluation& e) {
  e.h.segment(s.u0, s.nu).setZero(), e.hNonPotential.segment(s.u0, s.nu).setZero();
}

/// Evaluates frames, M and h at x, without the forces that are withheld. Returns the index of a
/// system whose M is not positive definite, or −1.
int evaluateSmooth(const SystemParts& parts, const State& x, std::span<const char> withheld,
                   Evaluation& e) {
  const Topology& topology = *parts.topology;
  e.t = x.t;
  e.kinematics.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory), parts.subset);
  // Without room for others there are none to tell apart.
  const bool omits = parts.subset != nullptr && parts.subset->own() != nullptr;
  const int indefinite = e.mass.evaluate(topology, x.t, view(x.q), omits ? nullptr : parts.subset);
  parts.forSystems([&](std::size_t i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (s.nu == 0) return;
    const PartialMechanicalSystem& system = *topology.systems()[i];
    named(system, [&] {
      const ConstVec q = slice(x.q, s.q0, s.nq), u = slice(x.u, s.u0, s.nu);
      system.h(x.t, q, u, slice(e.h, s.u0, s.nu));
      system.nonPotentialForce(x.t, q, u, slice(e.hNonPotential, s.u0, s.nu));
    });
  });
  const bool rests = parts.subset != nullptr && parts.subset->outsideRests();
  ForceSink forces(view(e.h), view(e.hNonPotential), rests || omits ? parts.subset : nullptr);
  parts.forForces([&](std::size_t i) {
    const ExternalForce* f = parts.forces[i];
    if (!withheld.empty() && withheld[i] != 0) return;
    forces.hasPotential(f->hasPotential());
    named(*f, [&] { f->addTo(e.kinematics, forces); });
  });
  if (omits) return indefinite;
  if (parts.subset && e.subset != parts.subset->stamp()) {
    e.subset = parts.subset->stamp();
    for (int i = 0; i < static_cast<int>(topology.systems().size()); ++i)
      if (parts.subset->leavesOut(i)) clearForces(topology.system(i), e);
  } else if (parts.subset && !rests) {
    for (const int i : parts.subset->beside()) clearForces(topology.system(i), e);
  }
  return indefinite;
}

}  // namespace

MechanicalSystem::MechanicalSystem(const SystemParts& parts, int slots)
    : parts_(parts),
      slots_(emptySlots(*parts.topology, slots)),
      implicit_(parts_),
      problem_(slots_.front().contacts) {}

void MechanicalSystem::move(State& x, const Eigen::VectorXd& v, double dt) const {
  const Topology& topology = *parts_.topology;
  parts_.forSystems([&](std::size_t i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    const PartialMechanicalSystem& system = *topology.systems()[i];
    if (s.nq > 0)
      named(system, [&] { system.move(x.t, slice(x.q, s.q0, s.nq), slice(v, s.u0, s.nu), dt); });
  });
  x.t += dt;
}

bool renewSystems(const Topology& topology, double tA, State& x) {
  bool changed = false;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    const Renewable* r = topology.systems()[i]->abilities().renewable;
    if (r && r->renew(tA, x.t, slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu))) changed = true;
  }
  return changed;
}

const Evaluation& MechanicalSystem::evaluate(const State& x, const EvaluationRequest& request) {
  expects(!parts_.subset || parts_.subset->outsideRests() ||
              (!request.damped && !request.gyroscopicAtMean),
          "forces are taken at the end of a step by a whole system, not by a view");
  Evaluation& e = slots_[static_cast<std::size_t>(request.slot)];
  ++evaluations_;
  indefinite_ = evaluateSmooth(parts_, x, request.withheld, e);
  if (request.slot == 0) implicit_.forget(), problem_.forget();
  if (request.ahead > 0.0 && request.damped)
    implicit_.resolve(parts_, e, x, request.ahead, *request.damped, limits.keeping);
  detect(x, request, e);
  if (request.gyroscopicAtMean) implicit_.gyroscopicAtMean(parts_, e, x, request.ahead);
  return e;
}

void MechanicalSystem::detect(const State& x, const EvaluationRequest& request, Evaluation& e) {
  ContactRequest contacts = contactRequest(request, gTol_);
  if (request.ahead > 0.0)
    contacts.gTol += reachOf(e.mass, x.u, implicit_.acceleration(e), request.ahead);
  e.contacts.clear();
  ContactSink sink(e.contacts, contacts, parts_.subset);
  reportContacts(parts_, e.kinematics, sink, request.elements);
  if (request.ahead > 0.0) pullOnlyClosed(e.contacts, gTol_);
  if (request.bias && request.differences)
    request.differences->fill(*this, x, request.held, e.contacts);
}

double largestChange(const MechanicalSystem& s, double dt) {
  const Eigen::VectorXd& a = s.implicitForces().acceleration(s.slot(0));
  return a.size() == 0 ? 0.0 : dt * a.cwiseAbs().maxCoeff();
}

ImpactProblem& MechanicalSystem::impactProblem(const State& x, double dt, int slot,
                                               const PositionAim* aim) {
  problem_.pose(
      {parts_, slots_[static_cast<std::size_t>(slot)], implicit_, limits, gTol_, slot == 0}, x, dt,
      aim);
  return problem_;
}

void MechanicalSystem::remember(State& x) {
  if (x.memory.size() == 0) return;
  const Topology& topology = *parts_.topology;
  const State& end = x;
  ownKinematics_.evaluate(topology, x.t, view(end.q), view(end.u), view(end.memory));
  const auto ask = [&](const auto& elements) {
    for (const auto* e : elements)
      if (const MemoryHandle m = topology.memories().of(*e); m.size > 0)
        e->remember(ownKinematics_, slice(x.memory, m.first, m.size));
  };
  ask(parts_.forces);
  ask(parts_.contacts);
}

double MechanicalSystem::potentialEnergy(const State& x) {
  if (!parts_.forces.empty())
    ownKinematics_.evaluate(*parts_.topology, x.t, view(x.q), view(x.u), view(x.memory),
                            parts_.subset);
  return potentialEnergy(ownKinematics_, x);
}

double MechanicalSystem::potentialEnergy(const Kinematics& k, const State& x) const {
  const Topology& topology = *parts_.topology;
  double V = 0.0;
  parts_.forSystems([&](std::size_t i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    V += topology.systems()[i]->potentialEnergy(x.t, slice(x.q, s.q0, s.nq));
  });
  parts_.forForces([&](std::size_t i) { V += parts_.forces[i]->potentialEnergy(k); });
  return V;
}

}  // namespace dynamy
