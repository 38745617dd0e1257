/// Delassus: the operator G = Wᵀ M⁻¹ W in three storages: assembled (dense, small problems),
/// matrix-free (FactoredDelassus, in velocities v = M⁻¹WΛ), or given by block rows (BlockRows,
/// problems without bodies, read from a file; G need not be symmetric).
///
/// All storages offer the same functions and must give the same numbers, which a test checks.
/// Solvers see this class, never W of an element. One class with three storages was preferred to
/// virtual operators: the dense path of a problem with 1 to 20 contacts takes a few hundred
/// nanoseconds in all.
#pragma once
#include <dynamy/solver/problem/block_rows.hpp>
#include <dynamy/solver/problem/factored_delassus.hpp>
#include <utility>

namespace dynamy {

class Delassus {
 public:
  enum class Form { automatic, assembled, matrixFree };
  /// Computes M⁻¹W and, in assembled form, G. `contacts` and `mass` must outlive the use. Nothing
  /// is allocated once the arrays are large enough.
  void assemble(const ContactSet& contacts, const MassMatrix& mass, Form form = Form::automatic);

  /// Takes a given G; `contacts` must outlive the use and needs no segments. A small G, for which
  /// dense storage pays, is stored densely as well.
  void given(const ContactSet& contacts, BlockRows G);

  /// Hands out the memory of the block rows, to be filled and passed to given() again.
  BlockRows release() { return std::move(blockRows_); }

  int rows() const { return n_; }
  /// G as rows() × rows() numbers, row after row; null unless it is stored densely.
  const double* dense() const { return assembled_ ? G_.data() : nullptr; }
  /// y = G x.
  void apply(const double* x, double* y);
  /// y ≥ |G| |x|, entry by entry: 4ε y bounds the rounding of apply(). The velocities of a sweep
  /// are not changed.
  void applyAbsolute(const double* x, double* y);
  /// dim × dim diagonal block of contact i, row after row.
  const double* diagonalBlock(int i) const { return diagonal_.block(i); }
  /// Σ_j |G_kj| of every row.
  void rowSums(double* sums);
  /// Block of contacts (i, j), dim_i × dim_j, row after row.
  void block(int i, int j, double* out) const;
  /// Contacts that share a mass block with contact i, i included, ascending.
  void neighbours(int i, std::vector<int>& out) const;
  /// G by block rows; computed at every call unless given. Valid until the next assembly.
  const BlockRows& blockRows();

  // Sweeps: ξ_i = (GΛ + c)_i for the current Λ, changed block after block. In matrix-free form a
  // sweep holds v, in the other forms nothing.
  /// Starts a sweep from Λ: v = M⁻¹WΛ in matrix-free form.
  void begin(const double* Lambda);
  /// (GΛ)_i into `out` (dim_i entries).
  void row(int i, const double* Lambda, double* out) const;
  /// Updates the sweep after block i of Λ has changed by `delta`.
  void changed(int i, const double* delta);

  /// v of a sweep in matrix-free form, for sweeps with kernels of their own; null in other forms.
  double* sweepVelocities() { return assembled_ || given_ ? nullptr : bodies_.velocities(); }

  const ContactSet& contacts() const { return *contacts_; }
  /// False: G was given, there are no bodies, mass() and addVelocity() must not be called.
  bool hasBodies() const { return !given_; }
  const MassMatrix& mass() const { return bodies_.mass(); }
  /// Adds v = M⁻¹ W Λ to u.
  void addVelocity(const double* Lambda, Vec u) const { bodies_.addVelocity(Lambda, u); }

 private:
  const ContactSet* contacts_ = nullptr;
  int n_ = 0;
  bool assembled_ = true, given_ = false;
  bool sparse_ = false;    // block rows of a given G are the cheaper form
  std::vector<double> G_;  // n × n, assembled form
  FactoredDelassus bodies_;
  BlockRows blockRows_;
  DiagonalBlocks diagonal_;
  std::vector<int> near_;
  std::vector<double> scratch_;
};

}  // namespace dynamy
