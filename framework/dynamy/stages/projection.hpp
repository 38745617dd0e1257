/// Projection on the constraints in the metric of the mass, after a step (theory 34.3):
///
///   positions    min ½ δᵀMδ  with  g + Wᵀδ = 0 (joints),  g + Wᵀδ ≥ 0 (contacts);   q ← q ⊕ δ
///   velocities   M(u⁺ − u) = WΛ,  −γ⁺ ∈ N_C(Λ),  ε = 0:  joints and the contacts that carried
///
/// Both are inclusions that every solver can solve. Joints and closed contacts share one inclusion,
/// so that correcting a joint does not violate a contact. Positions are repeated with W at the new
/// place, which is Newton's iteration. The projection of velocities removes kinetic energy and
/// never adds any (theory 1.4). Projecting without the metric was rejected: it moves a heavy body
/// as far as a light one and changes the momentum.
#pragma once
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/stages/one_step.hpp>
#include <limits>
#include <optional>

namespace dynamy {

/// Time τ [s] for which a displacement δ is applied as the velocity δ/τ. It is so short that
/// q̇ = Fu + β moves by Fδ alone.
inline constexpr double kDisplacementTime = 1e-9;

class Projection {
 public:
  /// Corrects x.q until no error of a joint and no overlap is larger than `tolerance` [m, –];
  /// evaluates into `slot`. True: it succeeded, or nothing had to be corrected.
  bool positions(MechanicalSystem& s, InclusionSolver& solver, State& x, double tolerance,
                 int slot = 1);
  /// Corrects x.q for overlaps alone, with the rates of joints held. Contacts with restitution stay
  /// as they are: they rebound, and lifting them would add to the energy.
  bool overlaps(MechanicalSystem& s, InclusionSolver& solver, State& x, double tolerance,
                int slot = 1);
  /// Closes the contacts `keys` (sorted), which are about to be reached, without opening a contact
  /// that carries. Rates of joints are held. False: the contacts contradict each other or are too many,
  /// and x is unchanged.
  bool touch(MechanicalSystem& s, State& x, const std::vector<ContactKey>& keys, double tolerance,
             int slot = 1);
  /// Removes from x.u the velocities that violate the constraints at x.q; evaluates into `slot`.
  bool velocities(MechanicalSystem& s, InclusionSolver& solver, State& x, int slot = 1);

  /// Computes an impact at fixed x.q of the joints and contacts in slot 0, if a contact closes
  /// within Δt faster than the forces of four steps explain:  M(u⁺ − u) = WΛ,  ξ = γ⁺ + εγ⁻ + s.
  /// Slot 0 has been evaluated before. Empty: there was no impact. Fills u and the works of `jump`.
  std::optional<SolveReport> impact(const MechanicalSystem& s, InclusionSolver& solver, State& x,
                                    double dt, Jump& jump);
  /// Percussions of contact `key` in the last impact, or null.
  const double* percussions(ContactKey key) const;

 private:
  enum class Level { position, overlap, touch, velocity };
  /// `solver` may be null for Level::touch.
  bool repair(MechanicalSystem& s, InclusionSolver* solver, State& x, double tolerance, int slot,
              Level level);
  bool close(const Evaluation& e);
  bool isTouched(ContactKey key) const;
  double largestGap(const ContactSet& c) const;
  void select(const MechanicalSystem& s, const ContactSet& all, const State& x, Level level);
  bool solve(const Evaluation& e, InclusionSolver& solver);
  /// Approach speed of contact i above that which brings it to g = 0 in Δt [m/s].
  static double closing(const ContactSet& all, int i, double gamma, double dt);
  /// True if the velocity of any row of `contacts_` is above rounding; fills c of the problem.
  bool offVelocities(const State& x);
  void works(const State& x, Jump& jump);
  ContactSet contacts_;
  Delassus delassus_;
  InclusionProblem problem_;
  std::vector<double> Lambda_;
  Eigen::VectorXd delta_, change_;
  Eigen::MatrixXd W_, MInvW_;        // of the contacts to be closed, nu × rows
  std::vector<ContactKey> touched_;  // contacts to be closed
  State untouched_, start_;
  KeyIndex remembered_;  // index of the impulses of the last step
  Unilateral unilateral_;
  Bilateral bilateral_;
};

/// Largest overlap at x of a contact that does not remove it by a rebound [m]. `length`: of the scene;
/// infinity: of contacts without restitution alone.
double largestOverlap(const ContactSet& contacts, const State& x,
                      double length = std::numeric_limits<double>::infinity());
/// Largest error of a joint, or largestOverlap() [m, –].
double largestViolation(const ContactSet& contacts, const State& x,
                        double length = std::numeric_limits<double>::infinity());

}  // namespace dynamy
