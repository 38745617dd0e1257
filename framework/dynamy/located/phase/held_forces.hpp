/// HeldForces: forces of the held contacts, and the accelerations with them (theory 50.1):
///
///   u̇ = M⁻¹(h + W λ),   λ = P π + p₀,   Sᵀ(Rᵀ u̇ + r) = 0
///     ⇒  (Sᵀ Rᵀ M⁻¹W P) d = −Sᵀ(Rᵀ M⁻¹(h + W(p₀ + P π₀)) + r),   π = π₀ + d
///
/// R = W for constraints at the present position, π₀: forces of the last decision. Where rows are
/// redundant d is the smallest solution, in units of what each contact carries, so that forces
/// differ little from those of the decision. The accelerations do not depend on that choice.
#pragma once
#include <dynamy/located/phase/block_pseudo_inverse.hpp>
#include <dynamy/located/phase/held_rows.hpp>

namespace dynamy {

/// Forces that the statuses of contacts leave open, λ = P π + p₀, and the rows S that they hold.
struct ForceDirections {
  /// An entry of P beside those of 1 at (kept[k], k), in a row of the same contact.
  struct Entry {
    int row;
    Eigen::Index unknown;
    double value;
  };
  std::vector<int> kept;       ///< S: the row of each unknown
  std::vector<Entry> entries;  ///< of slips
  Eigen::VectorXd p0;          ///< rows [N]
  Eigen::Index normal = 0;     ///< unknown λ_N of the contact whose parts come next

  Eigen::Index unknowns() const { return static_cast<Eigen::Index>(kept.size()); }
  /// The directions of all contacts `held`.
  void find(const std::vector<Held>& held, const HeldRows& rows);
  /// P, rows × unknowns.
  Eigen::MatrixXd P() const;
  /// λ ← λ + P π.
  void addForces(const Eigen::VectorXd& pi, Eigen::VectorXd& lambda) const;

 private:
  void add(const Held& h, const HeldRows& rows, std::size_t i);
};

class HeldForces {
 public:
  /// Solves for forces with which the kept rows of `constraint` have Rᵀu̇ + r = 0.
  void solve(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e,
             const AccelerationRows& constraint);
  /// λ of all rows [N].
  const Eigen::VectorXd& lambda() const { return lambda_; }
  /// u̇ [m/s²].
  const Eigen::VectorXd& a() const { return a_; }
  /// True: rows are redundant, so that λ is one of many solutions.
  bool redundant() const { return redundant_; }
  /// Σ n³ over the blocks of n forces that have been decomposed, since it was set to 0.
  double cubes = 0.0;
  /// Changes of λ, rows × any number, after which u̇ still keeps all rows that solve() has kept.
  Eigen::MatrixXd open() const;
  /// Notes in `held`, those of the last solve(), which rows follow from others (Held::implied).
  void findImplied(std::vector<Held>& held, const HeldRows& rows);

 private:
  void begin(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e);
  void multiplyByP(const HeldRows& rows);
  void findRightSide(const std::vector<Held>& held, const HeldRows& rows,
                     const AccelerationRows& constraint);
  void decompose(const HeldRows& rows);
  void decomposeElsewhere(const HeldRows& rows, const AccelerationRows& constraint);
  ForceDirections directions_;
  Eigen::VectorXd lambda_, a_;
  Eigen::MatrixXd A_;       // Sᵀ Rᵀ M⁻¹W P where R ≠ W
  Eigen::MatrixXd MInvWP_;  // M⁻¹W P; an unknown's column only where its row acts
  RowsOfBlocks touching_;
  std::vector<int> group_;  // of each unknown: those of bodies that rows connect
  Eigen::VectorXd rhs_, pi_, scale_;
  std::vector<char> implied_;  // of the kept rows
  BlockPseudoInverse inverse_{
      1e-10};  // of A with its columns by scale_; pivots below this share belong to redundant rows
  ProductPseudoInverse product_{1e-10};
  bool redundant_ = false;
};

}  // namespace dynamy
