/// MassMatrix: block-diagonal M and its inverse. Constant blocks are inverted once, the others in
/// every evaluation.
///
/// The inverse of each (small) block is stored: M⁻¹w is then one small product, which is what
/// contacts need many times a step. Keeping Cholesky factors was rejected for small blocks: two
/// triangular solves with divisions are slower, and equally accurate here. For systems that apply
/// M⁻¹ themselves (OwnInverse), M and M⁻¹ are computed at the first request after an
/// evaluation.
#pragma once
#include <dynamy/system/own_inverse.hpp>
#include <dynamy/system/system_subset.hpp>

namespace dynamy {

class MassMatrix {
 public:
  void resize(const Topology& topology);
  /// Evaluates M of systems whose mass is not constant (all on the first call) and inverts; with a
  /// subset only those of its systems. Returns the index of the first system whose M is not positive
  /// definite, or −1.
  int evaluate(const Topology& topology, double t, ConstVec q,
               const SystemSubset* subset = nullptr);

  ConstBlock M(int block) const {
    if (has_[static_cast<std::size_t>(block)] == Has::nothing) make(block);
    return {data_.data() + offset(block), nu(block), nu(block)};
  }
  ConstBlock inverse(int block) const {
    if (has_[static_cast<std::size_t>(block)] != Has::inverse) make(block), invertBlock(block);
    return {inverse_.data() + offset(block), nu(block), nu(block)};
  }
  /// Diagonal of M⁻¹ if M⁻¹ is diagonal (free bodies in principal axes), else null.
  const double* inverseDiagonal(int block) const {
    const auto b = static_cast<std::size_t>(block);
    return diagonal_[b] ? inverseDiagonal_.data() + u0_[b] : nullptr;
  }
  int nu(int block) const { return nu_[static_cast<std::size_t>(block)]; }
  int u0(int block) const { return u0_[static_cast<std::size_t>(block)]; }
  int blocks() const { return static_cast<int>(nu_.size()); }
  /// out = M⁻¹ in;  out = M in. Both are zero in systems that rest outside of the subset.
  void applyInverse(ConstVec in, Vec out) const;
  void apply(ConstVec in, Vec out) const;
  /// T = ½ uᵀ M u [J].
  double kineticEnergy(ConstVec u) const;

 private:
  enum class Has : char { nothing, mass, inverse };
  /// A system that applies M⁻¹ itself, with the t and q at which M and M⁻¹ are computed on demand.
  struct Deferred {
    const PartialMechanicalSystem* system = nullptr;
    const OwnInverse* inverse = nullptr;
    double t = 0.0;
    Eigen::VectorXd q;
  };
  void findMoving(const Topology& topology, const SystemSubset* subset);
  void clearResting(Vec out) const {
    if (static_cast<int>(moving_.size()) < blocks()) out.setZero();
  }
  bool evaluateSystem(const Topology& topology, std::size_t s, double t, ConstVec q);
  bool invertBlock(int block) const;
  void make(int block) const;
  std::ptrdiff_t offset(int block) const { return offset_[static_cast<std::size_t>(block)]; }
  std::vector<int> nu_, u0_;
  std::vector<std::ptrdiff_t> offset_;
  mutable std::vector<double> data_, inverse_, inverseDiagonal_;
  mutable std::vector<char> diagonal_;  // per block: M is diagonal
  mutable std::vector<Has> has_;
  std::vector<Deferred> deferred_;  // per block; no system: M is computed in every evaluation
  std::vector<bool> constant_;
  std::vector<int> moving_;   // blocks that do not rest
  std::uint64_t subset_ = 0;  // stamp of the subset that these follow from
  bool first_ = true;
};

}  // namespace dynamy
