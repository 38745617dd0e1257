#include <dynamy/located/phase/phase_motion.hpp>
#include <utility>

namespace dynamy {

void PhaseMotion::prepare(const MechanicalSystem& s, const ButcherTableau& table,
                          const ButcherTableau* light) {
  step.prepare(s, table, light), shortStep.prepare(s, table, light);
}

void PhaseMotion::implicit(bool wanted, const MechanicalSystem& s, const ErrorNorm& norm) {
  step.implicit(wanted, s, norm), shortStep.implicit(wanted, s, norm);
}

void PhaseMotion::rekey() {
  phase.request.keys.clear();
  heldKeys(phase.held, phase.request.keys);
}

bool PhaseMotion::evaluate(MechanicalSystem& s, PhasePoint& p, bool alone) {
  s.evaluate(p.x, phase.request.holding(keys(), 0, alone));
  if (!phase.accelerate(s.slot(0), p.x.u, p.a)) return false;
  p.lambda = phase.lambda(), p.power = phase.power();
  energies(s, 0, p);
  step.rates(s, p);
  return true;
}

void PhaseMotion::energies(const MechanicalSystem& s, int slot, PhasePoint& p) {
  p.T = s.slot(slot).mass.kineticEnergy(view(std::as_const(p.x.u)));
  p.V = s.potentialEnergy(s.slot(slot).kinematics, p.x);
}

}  // namespace dynamy
