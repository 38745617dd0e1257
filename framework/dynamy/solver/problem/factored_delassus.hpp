/// FactoredDelassus: G = Wᵀ (M⁻¹W) of bodies, kept as its two factors W and M⁻¹W. Products with G
/// go through the velocities v = M⁻¹WΛ, so that they cost as much as there are segments, whatever
/// the number of coupled contacts.
///
/// Blocks of G are formed on request. A sweep holds v of its current Λ and updates it block after
/// block.
#pragma once
#include <dynamy/solver/problem/contacts_of_blocks.hpp>
#include <dynamy/solver/problem/diagonal_blocks.hpp>
#include <dynamy/system/mass_matrix.hpp>

namespace dynamy {

class FactoredDelassus {
 public:
  /// Computes M⁻¹W, and the blocks G_ii into `diagonal`. `contacts` and `mass` must outlive the
  /// use. Nothing is allocated once the arrays are large enough.
  void factor(const ContactSet& contacts, const MassMatrix& mass, DiagonalBlocks& diagonal);
  const MassMatrix& mass() const { return *mass_; }
  /// Number of the velocities on which contacts act.
  int touchedVelocities() const;

  /// Block of contacts (i, j), dim_i × dim_j, row after row.
  void block(int i, int j, double* out) const;
  /// Contacts that share a mass block with contact i, i included, ascending.
  void neighbours(int i, std::vector<int>& out) const { links_.neighbours(*contacts_, i, out); }
  /// Adds all blocks to the dense matrix G, rows × rows numbers, row after row.
  void addTo(double* G) const;

  /// y = G x. The velocities of a sweep are lost.
  void apply(const double* x, double* y);
  /// y ≥ |G| |x|, entry by entry.
  void applyAbsolute(const double* x, double* y);
  /// u += M⁻¹ W Λ.
  void addVelocity(const double* Lambda, Vec u) const;

  /// Starts a sweep: v = M⁻¹WΛ.
  void begin(const double* Lambda);
  /// (GΛ)_i = W_iᵀ v into `out`, dim_i entries.
  void row(int i, double* out) const;
  /// v += M⁻¹W_i δ.
  void changed(int i, const double* delta) { addVelocity(i, delta, v_.data()); }
  /// v of the sweep.
  double* velocities() { return v_.data(); }

 private:
  void diagonalBlock(int i, double* out) const;
  void addVelocity(int i, const double* delta, double* u) const;
  const ContactSet* contacts_ = nullptr;
  const MassMatrix* mass_ = nullptr;
  ContactsOfBlocks links_;
  std::vector<double> minvW_;  // parallel to ContactSet::W
  std::vector<double> v_, absolute_;
};

}  // namespace dynamy
