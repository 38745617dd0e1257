/// DisplacementLevel: the inclusion of a step whose laws hold for positions at the end,
///
///   ξ_N = g(q^E)/Δt + offset,   q^E = q^A ⊕ Δt F u^E,   u^E = u_free + M⁻¹WΛ,   −ξ ∈ N_C(Λ)
///
/// by a simplified Newton iteration: W and M stay those of the posed problem. The error of the
/// linear prediction g + Δt γ is measured at each q^E and added to c until it no longer changes.
/// Tangential rows keep their velocities. Rejected: W at every trial position, which costs an
/// assembly per iteration and saves one or two iterations, since W changes by O(Δt).
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class DisplacementLevel {
 public:
  /// Solves the problem that s.impactProblem has just posed from x (its q not moved yet). Leaves
  /// q^E, u^E in x and the evaluation there, with the contacts of the problem, in slot `end`.
  /// `offset`: one number per row, or empty. A failed iteration shows in the status.
  SolveReport solve(MechanicalSystem& s, ImpactProblem& problem, InclusionSolver& solver, State& x,
                    double dt, int end, const std::vector<double>& offset = {});

 private:
  void pose(InclusionProblem& problem, double dt, const std::vector<double>& offset) const;
  double errors(const ImpactProblem& problem, const ContactSet& end, const Eigen::VectorXd& u,
                double dt);
  State base_;
  std::vector<ContactKey> keys_;
  std::vector<double> error_, gamma_;  // of the linear prediction, per row [m/s]
};

/// True: the constraint of the row is one of positions (a normal or a joint).
inline bool isPositionRow(const SetValuedForceLaw& law, int row) {
  return law.unilateral() ? row == 0 : law.rowKind(row) == RowKind::joint;
}
/// c = γ_free + g/Δt in position rows, γ_free in the others: the gap at the end, linearised.
void aimAtPositions(InclusionProblem& problem, double dt);

/// f += W Λ.
void addForce(const ContactSet& contacts, const double* Lambda, Eigen::VectorXd& f);
/// Writes the percussions of `from` into the rows of `to`, by contact key; 0 for new contacts.
void carry(const RememberedImpulses& from, const ContactSet& to, std::vector<double>& Lambda);
/// Adds the keys of the closed contacts of `set` to `keys`, which stay ascending.
void addKeys(const ContactSet& set, std::vector<ContactKey>& keys);
/// Adds the keys of contacts that pressed in the last step to `keys`, which stay ascending.
void addPressed(const RememberedImpulses& last, std::vector<ContactKey>& keys);

}  // namespace dynamy
