/// NewtonSystem: the linear equations of one Newton step, by block rows of G.
///
///   (A + B (G + diag(a))) ΔΛ = −F
///
/// Contacts with B = 0 (open) have A = I, so that ΔΛ_i = −F_i is known; the equations are solved
/// for the others only. Most contacts of a heap that is still falling are open.
#pragma once
#include <dynamy/solver/inclusion_problem.hpp>
#include <memory>

namespace dynamy {

/// Blocks of contact i begin at block0[i], dim × dim, row after row; rows at row0[i].
struct NewtonBlocks {
  std::vector<std::ptrdiff_t> block0;
  std::vector<double> A, B;
  std::vector<double> F;
  std::vector<double> a;  ///< proximal parameter of every contact [1/kg]
};

class NewtonSystem {
 public:
  virtual ~NewtonSystem() = default;
  /// Solves for ΔΛ (rows() entries); false: singular or not finite.
  virtual bool solve(const InclusionProblem& problem, const BlockRows& G, const NewtonBlocks& n,
                     std::vector<double>& dLambda) = 0;
  /// The last solve failed because the factors would not fit: another solver has to do it.
  virtual bool tooLarge() const = 0;
  /// Numbers in the factors of the last solve; symbolic analyses so far.
  virtual long entries() const = 0;
  virtual long analyses() const = 0;

  /// For contacts of at most `dim` ≤ 6 rows; null above.
  static std::unique_ptr<NewtonSystem> make(int dim);
};

}  // namespace dynamy
