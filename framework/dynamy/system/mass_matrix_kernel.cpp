#include <cmath>
#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/system/mass_matrix.hpp>

namespace dynamy {
namespace {

/// inverse ← M⁻¹ by Cholesky, in place and without allocation; false if M is not positive definite.
bool invert(const double* M, int n, double* inverse) {
  // L in the lower triangle of `inverse`.
  for (int j = 0; j < n; ++j) {
    double d = M[j * n + j];
    for (int k = 0; k < j; ++k) d -= inverse[j * n + k] * inverse[j * n + k];
    if (!(d > 0.0)) return false;
    const double l = std::sqrt(d);
    inverse[j * n + j] = l;
    for (int i = j + 1; i < n; ++i) {
      double s = M[i * n + j];
      for (int k = 0; k < j; ++k) s -= inverse[i * n + k] * inverse[j * n + k];
      inverse[i * n + j] = s / l;
    }
  }
  // L ← L⁻¹, row after row.
  for (int i = 0; i < n; ++i) {
    const double l = 1.0 / inverse[i * n + i];
    for (int j = 0; j < i; ++j) {
      double s = 0.0;
      for (int k = j; k < i; ++k) s -= inverse[i * n + k] * inverse[k * n + j];
      inverse[i * n + j] = s * l;
    }
    inverse[i * n + i] = l;
  }
  // M⁻¹ = L⁻ᵀ L⁻¹: entry (i, j) needs rows k ≥ max(i, j) only, so going down the columns overwrites
  // nothing still needed.
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double s = 0.0;
      for (int k = i; k < n; ++k) s += inverse[k * n + i] * inverse[k * n + j];
      inverse[i * n + j] = s;
    }
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) inverse[i * n + j] = inverse[j * n + i];
  return true;
}

}  // namespace

bool MassMatrix::invertBlock(int b) const {
  const int n = nu(b);
  const double* M = data_.data() + offset(b);
  bool diagonal = true;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) diagonal = diagonal && M[i * n + j] == 0.0 && M[j * n + i] == 0.0;
  diagonal_[static_cast<std::size_t>(b)] = diagonal ? 1 : 0;
  double* inverse = inverse_.data() + offset(b);
  has_[static_cast<std::size_t>(b)] = Has::inverse;
  if (!invert(M, n, inverse)) return false;
  for (int i = 0; i < n; ++i)
    inverseDiagonal_[static_cast<std::size_t>(u0(b) + i)] = inverse[i * n + i];
  return true;
}

void MassMatrix::make(int b) const {
  if (has_[static_cast<std::size_t>(b)] != Has::nothing) return;
  const Deferred& d = deferred_[static_cast<std::size_t>(b)];
  d.system->M(d.t, view(d.q), {data_.data() + offset(b), nu(b), 1});
  has_[static_cast<std::size_t>(b)] = Has::mass;
}

void MassMatrix::resize(const Topology& topology) {
  nu_.clear(), u0_.clear(), offset_.clear();
  std::ptrdiff_t size = 0;
  for (std::size_t s = 0; s < topology.systems().size(); ++s) {
    const SystemHandle& h = topology.system(static_cast<int>(s));
    for (int b = 0; b < h.blocks; ++b) {
      nu_.push_back(h.blockNu);
      u0_.push_back(h.u0 + b * h.blockNu);
      offset_.push_back(size);
      size += static_cast<std::ptrdiff_t>(h.blockNu) * h.blockNu;
    }
  }
  data_.assign(static_cast<std::size_t>(size), 0.0);
  inverse_.assign(static_cast<std::size_t>(size), 0.0);
  inverseDiagonal_.assign(static_cast<std::size_t>(topology.nu()), 0.0);
  diagonal_.assign(nu_.size(), 0);
  has_.assign(nu_.size(), Has::inverse);
  deferred_.assign(nu_.size(), {});
  for (std::size_t s = 0; s < topology.systems().size(); ++s) {
    const SystemHandle& h = topology.system(static_cast<int>(s));
    const Blocks blocks = topology.systems()[s]->blocks();
    const OwnInverse* inverse = topology.systems()[s]->abilities().ownInverse;
    if (!inverse || blocks.constantMass || h.blocks != 1) continue;
    Deferred& d = deferred_[static_cast<std::size_t>(h.block0)];
    d.system = topology.systems()[s], d.inverse = inverse;
  }
  constant_.clear();
  for (const PartialMechanicalSystem* s : topology.systems())
    constant_.push_back(s->blocks().constantMass);
  subset_ = 0, findMoving(topology, nullptr);
  first_ = true;
}

void MassMatrix::findMoving(const Topology& topology, const SystemSubset* subset) {
  moving_.clear();
  for (std::size_t s = 0; s < topology.systems().size(); ++s) {
    const SystemHandle& h = topology.system(static_cast<int>(s));
    if (subset && subset->anyRests() && subset->leavesOut(h.index)) continue;
    for (int b = h.block0; b < h.block0 + h.blocks; ++b) moving_.push_back(b);
  }
}

/// False: M of this system is not positive definite.
bool MassMatrix::evaluateSystem(const Topology& topology, std::size_t s, double t, ConstVec q) {
  const SystemHandle& h = topology.system(static_cast<int>(s));
  if ((constant_[s] && !first_) || h.blocks == 0) return true;
  bool good = true;
  Deferred& d = deferred_[static_cast<std::size_t>(h.block0)];
  if (!d.system || first_) {
    const PartialMechanicalSystem& system = *topology.systems()[s];
    named(system, [&] {
      system.M(t, {q.data() + h.q0, h.nq}, {data_.data() + offset(h.block0), h.blockNu, h.blocks});
    });
    for (int b = h.block0; b < h.block0 + h.blocks; ++b) good = invertBlock(b) && good;
  }
  if (!d.system) return good;
  // M and M⁻¹ are discarded also the first time: a resumed run has to give the same bits.
  d.t = t, d.q = q.segment(h.q0, h.nq);
  has_[static_cast<std::size_t>(h.block0)] = Has::nothing;
  diagonal_[static_cast<std::size_t>(h.block0)] = 0;
  return good;
}

int MassMatrix::evaluate(const Topology& topology, double t, ConstVec q,
                         const SystemSubset* subset) {
  int failed = -1;
  if (const std::uint64_t stamp = subset ? subset->stamp() : 0; stamp != subset_)
    subset_ = stamp, findMoving(topology, subset);
  const auto evaluated = [&](int s) {
    if (!evaluateSystem(topology, static_cast<std::size_t>(s), t, q) && failed < 0) failed = s;
  };
  if (subset && !first_)
    for (const int s : subset->systems()) evaluated(s);
  else
    for (int s = 0; s < static_cast<int>(constant_.size()); ++s) evaluated(s);
  first_ = false;
  return failed;
}

void MassMatrix::applyInverse(ConstVec in, Vec out) const {
  clearResting(out);
  for (const int b : moving_) {
    const int n = nu(b);
    const double* A = inverse_.data() + offset(b);
    const double* x = in.data() + u0(b);
    double* y = out.data() + u0(b);
    if (has_[static_cast<std::size_t>(b)] != Has::inverse) {
      const Deferred& d = deferred_[static_cast<std::size_t>(b)];
      d.inverse->applyInverseMass(d.t, view(d.q), {x, n}, {y, n});
      continue;
    }
    if (const double* d = inverseDiagonal(b)) {
      for (int i = 0; i < n; ++i) y[i] = d[i] * x[i];
      continue;
    }
    for (int i = 0; i < n; ++i) {
      double s = 0.0;
      for (int j = 0; j < n; ++j) s += A[i * n + j] * x[j];
      y[i] = s;
    }
  }
}

void MassMatrix::apply(ConstVec in, Vec out) const {
  // Products are evaluated by coefficient: a temporary would allocate memory in every step.
  clearResting(out);
  for (const int b : moving_) {
    const int n = nu(b);
    const ConstVec x(in.data() + u0(b), n);
    Vec y(out.data() + u0(b), n);
    if (!inverseDiagonal(b)) {
      y = M(b).lazyProduct(x);
      continue;
    }
    const double* A = data_.data() + offset(b);
    for (int i = 0; i < n; ++i) y[i] = A[i * (n + 1)] * x[i];
  }
}

double MassMatrix::kineticEnergy(ConstVec u) const {
  double T = 0.0;
  for (const int b : moving_) {
    const int n = nu(b);
    const double* A = M(b).data();
    const double* x = u.data() + u0(b);
    const bool diagonal = inverseDiagonal(b) != nullptr;
    for (int i = 0; i < n; ++i) {
      double s = diagonal ? A[i * (n + 1)] * x[i] : 0.0;
      for (int j = 0; !diagonal && j < n; ++j) s += A[i * n + j] * x[j];
      T += 0.5 * x[i] * s;
    }
  }
  return T;
}

}  // namespace dynamy
