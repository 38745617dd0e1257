/// Staggered Moreau midpoint (theory 34.1): the midpoint rule with contacts aimed at the gap of the
/// NEXT midpoint, since midpoints advance by Δt u^E:
///
///   q^M = q^A ⊕ Δt/2 u^A,   overlaps repaired in the metric of the mass
///   M(u^E − u^A) − hΔt − WΛ = 0,   ξ = γ^E + ε γ^A + s,   −ξ_i ∈ N_{C_i}(Λ_i)
///   s_N = g^M/Δt if g^M > dead, else 0       (not for a contact that will rebound)
///   s_J = γ^A  (joints hold the mean velocity)   or   s_J = κ g^M/Δt, capped  (stabilised)
///   q^E = q^M ⊕ Δt/2 u^E,   joints projected
///
/// h is taken at q^M and u^A, gyroscopic terms of free bodies at the mean velocity of their free
/// motion: at u^A they would drive a spinning body. Forces that the step does not resolve
/// (UnresolvedForces) are taken at its end: M̂ = M − Δt D − Δt² K replaces M, and they are damped. Some that it
/// resolves are taken by the implicit midpoint rule, which keeps their energy (theory 37.6).
///
/// Where the solver stops at a residual above 1e-4 (many contacts at a bounded cost), x.scheme holds
/// the places of the contacts, and the next step is rough; so is a step with an impact or an
/// overlap among so many contacts. A rough step lifts and closes no contact before its impacts, but
/// uses s_N = g^M/Δt for gaps of either sign, until no overlap is left.
///
/// Rounding cannot move a resting contact away, since the next step closes its gap again. Therefore
/// a start that fulfils the solver's tolerance is good enough. The dead band keeps rounding of gaps
/// out of the rates. It must be small, because four corners of a rigid face with different s
/// contradict each other by dead/Δt. γ^E = 0 in joints was rejected: it removes Δt ω²/2 of the
/// kinetic energy per second, which the mean velocity conserves.
#pragma once
#include <dynamy/stages/lost_impulses.hpp>
#include <dynamy/stages/one_step.hpp>
#include <dynamy/stages/projection.hpp>

namespace dynamy {

class StaggeredMoreau final : public OneStep {
 public:
  enum class Joints { mean, stabilised };
  enum class Project { none, positions, both };
  struct Options {
    Joints joints = Joints::mean;
    Project project = Project::both;
    double kappa = 1.0;  ///< share of a joint's error that one step corrects
    double cap = 1.0;    ///< bound of the speed of this correction [m/s]
  };
  StaggeredMoreau() = default;
  explicit StaggeredMoreau(const Options& options) : options_(options) {}
  explicit StaggeredMoreau(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return 1; }
  bool stepsSome() const override { return true; }
  int evaluations() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;

 private:
  const Evaluation& detect(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                           bool& apart);
  void pose(MechanicalSystem& s, const InclusionSolver& solver, State& x, double dt);
  void ask(MechanicalSystem& s, const State& x, double dt);
  SolveReport solve(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  Options options_;
  Projection projection_;
  LostImpulses lost_;
  PositionAim aim_;                   // of this step
  bool rough_ = false;                // is this step rough?
  ImpactProblem* problem_ = nullptr;  // of this step
  std::vector<ContactKey> arrived_;   // contacts lifted out of an overlap or closed in this step
  std::vector<ContactKey> arriving_;
};

}  // namespace dynamy
