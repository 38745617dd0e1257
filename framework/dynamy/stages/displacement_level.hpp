/// DisplacementLevel: the inclusion of a step whose laws hold for positions at the end,
///
///   ξ_N = g(q^E)/Δt + offset,   q^E = q^A ⊕ Δt F u^E,   u^E = u_free + M⁻¹WΛ,   −ξ ∈ N_C(Λ)
///
/// by a simplified Newton iteration: W and M stay those of the posed problem, the error of the
/// linear forecast g + Δt γ is measured at the q^E reached and put into c until it changes no more.
/// Tangential rows keep their velocities. Rejected: W at every trial position, which costs an
/// assembly per iteration and saves one iteration or two, since W changes by O(Δt).
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class DisplacementLevel {
 public:
  /// Solves the problem that s.impactProblem has just posed from x (its q not moved yet). Leaves
  /// q^E, u^E in x and what is evaluated there in slot `end`, with the contacts of the problem.
  /// `offset`: one per row, or empty. A failed iteration shows in the status.
  SolveReport solve(MechanicalSystem& s, InclusionProblem& problem, InclusionSolver& solver,
                    State& x, double dt, int end, const std::vector<double>& offset = {});

 private:
  void pose(InclusionProblem& problem, double dt, const std::vector<double>& offset) const;
  double errors(const MechanicalSystem& s, const InclusionProblem& problem, const ContactSet& end,
                const Eigen::VectorXd& u, double dt);
  State base_;
  std::vector<ContactKey> keys_;
  std::vector<double> error_, gamma_;  // of the forecast, per row [m/s]
};

/// Rows whose constraint is one of positions: normals and joints.
inline bool isPositionRow(const SetValuedForceLaw& law, int row) {
  return law.unilateral() ? row == 0 : law.rowKind(row) == RowKind::joint;
}
/// c = γ_free + g/Δt in these rows, γ_free in the others: the gap at the end, linearised.
void aimAtPositions(InclusionProblem& problem, double dt);

/// f += W Λ.
void addForce(const ContactSet& contacts, const double* Lambda, Eigen::VectorXd& f);
/// Percussions of `from` in the rows of `to`, by contact key; 0 for contacts that are new.
void carry(const RememberedImpulses& from, const ContactSet& to, std::vector<double>& Lambda);
/// Keys of the closed contacts of `set` added to `keys`, which stay ascending.
void addKeys(const ContactSet& set, std::vector<ContactKey>& keys);
/// Keys of contacts that pressed in the last step, added likewise.
void addPressed(const RememberedImpulses& last, std::vector<ContactKey>& keys);

}  // namespace dynamy
