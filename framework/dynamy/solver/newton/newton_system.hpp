/// NewtonSystem: the linear equations of one Newton step, in one of two forms (theory 7).
///
///   percussions:  (A + B (G + diag(a))) ΔΛ = −F                  rows of G, block by block
///   velocities:   (M + W C Wᵀ) Δv = −W f,   ΔΛ = −f − C WᵀΔv     G is never formed
///                 C = (A + aB)⁻¹ B,   f = (A + aB)⁻¹ F   per contact
///
/// Both forms give the same step. The form in velocities has 6 unknowns per body, the form in
/// percussions up to 3 per contact. With four contacts under every box of a stack percussions are
/// twice as many unknowns, and G is dense where bodies share many contacts. Open contacts (B = 0)
/// have A = I, so that ΔΛ_i = −F_i is known.
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>
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
  /// Takes the numbers of G, or of W and M. False: this form cannot represent the problem.
  virtual bool prepare(const InclusionProblem& problem) = 0;
  /// y = G x. \pre prepare() of the same problem, as for the functions below
  virtual void multiply(const InclusionProblem& problem, const double* x, double* y) = 0;
  /// Solves for ΔΛ (rows() entries); false: singular or not finite.
  virtual bool solve(const InclusionProblem& problem, const NewtonBlocks& n,
                     std::vector<double>& dLambda) = 0;
  /// Factors G + diag(a) with one a > 0 per contact, for any number of right-hand sides; false:
  /// singular. In velocities, a may be infinite: that contact then carries no force.
  virtual bool factorShifted(const InclusionProblem& problem, const std::vector<double>& a) = 0;
  /// x = (G + diag(a))⁻¹ r; false: not finite. \pre factorShifted(), no solve() since
  virtual bool solveShifted(const InclusionProblem& problem, const double* r,
                            std::vector<double>& x) = 0;
  /// True: the last solve failed because the factors would exceed their size limit; another solver
  /// is needed.
  virtual bool tooLarge() const = 0;
  /// Numbers in the factors of the last solve; symbolic analyses so far.
  virtual long entries() const = 0;
  virtual long analyses() const = 0;

  /// System in percussions, for contacts of at most `dim` ≤ 6 rows; null for larger `dim`.
  static std::unique_ptr<NewtonSystem> inPercussions(int dim);
  /// System in velocities, for mass blocks of at most `nu` velocities: sparse up to 6, dense above.
  static std::unique_ptr<NewtonSystem> inVelocities(int nu);
};

/// Keeps one system of each form and picks the smaller one for a problem.
class NewtonSystemChoice {
 public:
  /// Returns a prepared system: in velocities if the touched bodies have fewer velocities than the
  /// problem has rows, otherwise in percussions. Null: neither form can represent the problem (a
  /// contact of more than 6 rows).
  NewtonSystem* prepare(const InclusionProblem& problem);
  bool inVelocities() const { return velocities_; }

 private:
  std::unique_ptr<NewtonSystem> percussions_, inVelocities_[3];  // blocks of 3, of 6, dense
  bool velocities_ = false;
  int percussionDim_ = 0;
  std::vector<char> seen_;
};

/// Number of velocities of all mass blocks on which contacts act, and of the largest such block.
struct TouchedVelocities {
  int count = 0, largest = 0;
};
/// `seen` keeps its memory. \pre problem.G->hasBodies()
TouchedVelocities touchedVelocities(const InclusionProblem& problem, std::vector<char>& seen);

}  // namespace dynamy
