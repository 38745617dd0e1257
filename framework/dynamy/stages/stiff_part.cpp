#include <cmath>
#include <dynamy/stages/stiff_part.hpp>

namespace dynamy {

void StiffPart::resize(const Topology& topology, const std::vector<const ExternalForce*>& forces) {
  nu_ = topology.nu();
  for (const PartialMechanicalSystem* s : topology.systems()) any_ = any_ || s->stiff();
  for (const ExternalForce* f : forces) any_ = any_ || f->stiff();
}

void StiffPart::evaluate(const Topology& topology, const std::vector<const ExternalForce*>& forces,
                         const Kinematics& k, const State& x) {
  entries_.clear();
  StiffnessSink sink(entries_);
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
}

void StiffPart::touch(const MassMatrix& mass) {
  if (blockOf_.empty()) {
    blockOf_.assign(static_cast<std::size_t>(nu_), -1);
    for (int b = 0; b < mass.blocks(); ++b)
      for (int j = 0; j < mass.nu(b); ++j) blockOf_[static_cast<std::size_t>(mass.u0(b) + j)] = b;
  }
  local_.assign(static_cast<std::size_t>(nu_), -1);
  touched_.clear();
  for (const StiffEntry& e : entries_)
    for (const int u : {e.i, e.j}) {
      if (local_[static_cast<std::size_t>(u)] >= 0) continue;
      const int b = blockOf_[static_cast<std::size_t>(u)];
      for (int j = mass.u0(b); j < mass.u0(b) + mass.nu(b); ++j) {
        local_[static_cast<std::size_t>(j)] = static_cast<int>(touched_.size());
        touched_.push_back(j);
      }
    }
}

void StiffPart::factor(const MassMatrix& mass, double dt, const ImplicitWeights& weights) {
  weights_ = weights;
  touch(mass);
  const auto n = static_cast<Eigen::Index>(touched_.size());
  Mhat_.setZero(n, n);
  for (int b = 0; b < mass.blocks(); ++b) {
    const int at = mass.nu(b) > 0 ? local_[static_cast<std::size_t>(mass.u0(b))] : -1;
    if (at >= 0) Mhat_.block(at, at, mass.nu(b), mass.nu(b)) = mass.M(b);
  }
  for (const StiffEntry& e : entries_)
    Mhat_(local_[static_cast<std::size_t>(e.i)], local_[static_cast<std::size_t>(e.j)]) -=
        weights.b * dt * e.D + weights.a * dt * dt * e.K;
  if (n > 0) lu_.compute(Mhat_);
  part_.resize(n);
}

void StiffPart::applyInverse(const MassMatrix& mass, const Eigen::VectorXd& in,
                             Eigen::VectorXd& out) const {
  mass.applyInverse(view(in), view(out));
  if (touched_.empty()) return;
  for (std::size_t k = 0; k < touched_.size(); ++k)
    part_[static_cast<Eigen::Index>(k)] = in[touched_[k]];
  lu_.solve(part_, part_);
  for (std::size_t k = 0; k < touched_.size(); ++k)
    out[touched_[k]] = part_[static_cast<Eigen::Index>(k)];
}

bool StiffPart::explicitIsUnstable(const MassMatrix& mass, double dt, double limit) {
  // Power iteration for M⁻¹K and M⁻¹D. Quotients of Rayleigh never exceed the largest eigenvalue:
  // a step that is stable is not taken for one that is not.
  constexpr int kIterations = 12;
  for (const bool damping : {false, true}) {
    const double most = damping ? 2.0 / dt : limit * limit / (dt * dt);
    probe_.resize(nu_), column_.resize(nu_);
    for (int j = 0; j < nu_; ++j) probe_[j] = std::sin(1.0 + j);
    for (int i = 0; i < kIterations; ++i) {
      force_.setZero(nu_);
      for (const StiffEntry& e : entries_) force_[e.i] -= (damping ? e.D : e.K) * probe_[e.j];
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

void StiffPart::addK(double scale, const Eigen::VectorXd& v, Eigen::VectorXd& out) const {
  if (scale == 0.0) return;
  for (const StiffEntry& e : entries_) out[e.i] += scale * e.K * v[e.j];
}

namespace {

/// f += W_row of contact i.
void addRow(const ContactSet& c, int i, int row, double factor, Eigen::VectorXd& f) {
  const auto at = static_cast<std::size_t>(i);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(row) * s.nu;
    for (int j = 0; j < s.nu; ++j) f[s.u0 + j] += factor * w[j];
  }
}

}  // namespace

void StiffPart::delassus(const ContactSet& contacts, const MassMatrix& mass, Delassus& delassus) {
  const int n = contacts.size(), rows = contacts.rows();
  BlockRows G = delassus.release();
  G.clear();
  G.first.resize(static_cast<std::size_t>(n) + 1, 0);
  std::ptrdiff_t size = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      G.column.push_back(j), G.value0.push_back(size);
      size += static_cast<std::ptrdiff_t>(contacts.dim(i)) * contacts.dim(j);
    }
    G.first[static_cast<std::size_t>(i) + 1] = (i + 1) * n;
  }
  G.value.resize(static_cast<std::size_t>(size));
  row_.resize(static_cast<std::size_t>(rows));
  force_.resize(nu_), column_.resize(nu_);
  for (int j = 0; j < n; ++j)
    for (int c = 0; c < contacts.dim(j); ++c) {
      force_.setZero();
      addRow(contacts, j, c, 1.0, force_);
      applyInverse(mass, force_, column_);  // M̂⁻¹ w
      contacts.gamma(view(std::as_const(column_)), {row_.data(), rows});
      for (int i = 0; i < n; ++i) {
        double* block = G.value.data() + G.value0[static_cast<std::size_t>(i * n + j)];
        for (int r = 0; r < contacts.dim(i); ++r) {
          const auto k = static_cast<std::size_t>(contacts.row0[static_cast<std::size_t>(i)] + r);
          block[r * contacts.dim(j) + c] = row_[k] - contacts.chi[k];
        }
      }
    }
  delassus.given(contacts, std::move(G));
}

void StiffPart::addVelocity(const ContactSet& contacts, const MassMatrix& mass,
                            const double* Lambda, Eigen::VectorXd& u) {
  force_.setZero(nu_), column_.resize(nu_);
  for (int i = 0; i < contacts.size(); ++i)
    for (int r = 0; r < contacts.dim(i); ++r)
      addRow(contacts, i, r, Lambda[contacts.row0[static_cast<std::size_t>(i)] + r], force_);
  applyInverse(mass, force_, column_);
  u += column_;
}

void StiffPart::addUsedForce(double dt, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE,
                             Eigen::VectorXd& h, Eigen::VectorXd& hNonPotential) const {
  for (const StiffEntry& e : entries_) {
    const double change = uE[e.j] - uA[e.j], damping = weights_.b * e.D * change;
    h[e.i] += dt * e.K * (weights_.s * uA[e.j] + weights_.a * change) + damping;
    hNonPotential[e.i] += damping;
  }
}

}  // namespace dynamy
