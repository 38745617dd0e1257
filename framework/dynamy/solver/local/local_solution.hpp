/// LocalSolutions: solves single contacts, −(DΛ + b) ∈ N_C(Λ), in closed form if C is simple.
/// (theory 4.12)
///
///   interval, ℝ^dim:  Λ = clamp(−b/D),  Λ = −D⁻¹b
///   friction:  take-off  Λ = 0                     if b_N ≥ 0
///              stick     Λ = −D⁻¹b                 if it lies in the cone
///              slip      ξ_N = 0, ξ_T = −a Λ_T, |Λ_T| = μΛ_N        (SlipEquation)
///
/// D need not be symmetric. A few numbers per contact are prepared once, so that a solution costs a
/// dozen products and, for slip, two or three Newton steps in one unknown. A local Newton method in
/// Λ was rejected: it needs a start, and it does not say whether there are more solutions or none.
#pragma once
#include <dynamy/solver/local/local_friction.hpp>
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class LocalSolutions {
 public:
  static constexpr int kMaxSolutions = 6;  ///< take-off, stick, four of slip
  void clear();
  /// Adds a contact; D: dim × dim, row after row. Nothing is allocated once the arrays are large
  /// enough.
  void add(const double* D, int dim, const SimpleSet& set);
  /// Replaces all contacts by the diagonal blocks of G with the laws of a problem.
  void prepare(const InclusionProblem& problem);
  int size() const { return static_cast<int>(contacts_.size()); }
  /// False: solve() returns notSimple for contact i.
  bool simple(int i) const { return contacts_[static_cast<std::size_t>(i)].simple; }
  /// Solves for Λ of contact i. Of several solutions take-off is preferred to stick, and stick to
  /// slip; of several slips the one with the smallest a.
  LocalReport solve(int i, const double* b, double* Lambda) const;
  /// Finds all isolated solutions of a contact with friction, in the order of preference of
  /// solve(), with one report and dim rows of Λ each. Returns their number.
  int all(int i, const double* b, LocalReport* reports, double* Lambda) const;

 private:
  struct Contact {
    SimpleSet::Shape shape;
    int dim;
    bool simple;
    std::size_t at;  ///< where its data begin
  };
  std::vector<Contact> contacts_;
  std::vector<FrictionBlock<1>> planar_;
  std::vector<FrictionBlock<2>> spatial_;
  std::vector<double> numbers_;  ///< D⁻¹; D and both ends of an interval, D and a ball's radius
};

}  // namespace dynamy
