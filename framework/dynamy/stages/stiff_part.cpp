#include <algorithm>
#include <cmath>
#include <dynamy/stages/stiff_part.hpp>

namespace dynamy {

void StiffPart::resize(const Topology& topology, const std::vector<const ExternalForce*>& forces) {
  nu_ = topology.nu(), Mhat_.resize(nu_);
  for (const PartialMechanicalSystem* s : topology.systems()) any_ = any_ || s->stiff();
  for (const ExternalForce* f : forces) any_ = any_ || f->stiff();
}

void StiffPart::evaluate(const Topology& topology, const std::vector<const ExternalForce*>& forces,
                         const Kinematics& k, const State& x) {
  stiffness_.entries.clear();
  StiffnessSink sink(stiffness_.entries);
  for (const ExternalForce* f : forces)
    if (f->stiff()) f->addStiffness(k, sink);
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const PartialMechanicalSystem& system = *topology.systems()[i];
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (!system.stiff() || s.nu == 0) continue;
    const int n = s.blockNu;
    K_.resize(static_cast<std::size_t>(n * n)), D_.resize(K_.size());
    for (int b = 0; b < s.blocks; ++b) {
      const Block K(K_.data(), n, n), D(D_.data(), n, n);
      if (!system.dh(x.t, slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu), b, K, D)) continue;
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c)
          if (K(r, c) != 0.0 || D(r, c) != 0.0)
            sink.entry(s, b * n + r, b * n + c, K(r, c), D(r, c));
    }
  }
  stiffness_.declared = stiffness_.kept = stiffness_.entries.size();
}

bool StiffPart::evaluateUnresolved(const Topology& topology,
                                   const std::vector<const ExternalForce*>& forces,
                                   const Kinematics& k, const State& x, const MassMatrix& mass,
                                   double dt, Keeping keeping) {
  if (!found_.find(forces, k, mass, dt, keeping)) return false;
  evaluate(topology, forces, k, x);
  stiffness_.kept = stiffness_.declared + found_.dampedEntries();
  stiffness_.entries.insert(stiffness_.entries.end(), found_.entries().begin(),
                            found_.entries().end());
  return true;
}

bool StiffPart::explicitIsUnstable(const MassMatrix& mass, double dt, double limit) {
  // Power iteration for M⁻¹K and M⁻¹D. Rayleigh quotients never exceed the largest eigenvalue: a
  // stable step is never classified as unstable.
  constexpr int kIterations = 12;
  for (const bool damping : {false, true}) {
    const double most = damping ? 2.0 / dt : limit * limit / (dt * dt);
    probe_.resize(nu_), column_.resize(nu_);
    for (int j = 0; j < nu_; ++j) probe_[j] = std::sin(1.0 + j);
    for (int i = 0; i < kIterations; ++i) {
      force_.setZero(nu_);
      for (const StiffEntry& e : stiffness_.entries)
        force_[e.i] -= (damping ? e.D : e.K) * probe_[e.j];
      mass.apply(view(std::as_const(probe_)), view(column_));
      if (probe_.dot(force_) > most * probe_.dot(column_)) return true;
      mass.applyInverse(view(std::as_const(force_)), view(probe_));
      const double size = probe_.norm();
      if (size == 0.0) break;
      probe_ /= size;
    }
  }
  return false;
}

}  // namespace dynamy
