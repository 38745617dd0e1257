/// ImpactProblem: the inclusion of one step, as MechanicalSystem::impactProblem has posed it, with
/// the percussions Λ from their start to what follows from them:
///
///   γ_free = Wᵀu_free + χ,   u_free = u^A + M⁻¹hΔt,   u^E = u_free + M⁻¹WΛ
#pragma once
#include <dynamy/stages/closing_contacts.hpp>
#include <dynamy/stages/implicit_forces.hpp>
#include <dynamy/stages/impulse_start.hpp>
#include <dynamy/stages/position_aim.hpp>
#include <limits>

namespace dynamy {

/// What a scheme does where it can take a step in shorter parts alone.
enum class Halving : std::uint8_t {
  within,  ///< takes them all: who sees the step sees its end
  ends,    ///< ends the step after the first part (StepReport::dt): the caller takes the others
  none     ///< takes the step as it can: it is such a part
};

/// What the caller of a scheme grants to an attempt at a step.
struct StepLimits {
  /// Effort that solvers may spend on the problems that are posed from now on. A scheme lowers it
  /// after a search in vain.
  Effort effort = Effort::full;
  /// Time [s] in which overlaps are pushed out, if the step is shorter: the short parts of a step
  /// would throw bodies apart with g/Δt, whatever deep overlaps an unsolved step has left.
  double pushOut = 0.0;
  /// Forces that the step resolves and takes by a neutral rule all the same, which keeps their energy.
  Keeping keeping = Keeping::none;
  Halving halving = Halving::within;
  /// Length of the scene [m]; infinity: not known.
  double length = std::numeric_limits<double>::infinity();
  /// End of the run [s]; infinity: not known.
  double end = std::numeric_limits<double>::infinity();
  Workers* workers = nullptr;               ///< threads; null: the caller's alone. Borrowed.
  const std::atomic<bool>* stop = nullptr;  ///< solvers stop once it is set; null: never. Borrowed.
  SolverWork* work = nullptr;  ///< counts what solvers do; null: nobody does. Borrowed.
  Delassus::Form form = Delassus::Form::automatic;  ///< of G; tests compare all of them
  /// How often solvers have visited a contact so far.
  double visits() const { return work != nullptr ? static_cast<double>(work->visits) : 0.0; }
};

class ImpactProblem : public InclusionProblem {
 public:
  /// A problem without contacts, which `none` is to be.
  explicit ImpactProblem(const ContactSet& none) { contacts = &none; }

  /// What a problem is posed from; borrowed until the next one.
  struct Posing {
    const SystemParts& parts;
    Evaluation& at;            ///< M, h and contacts
    ImplicitForces& implicit;  ///< with forces unresolved in `at`: their M̂ instead of M
    const StepLimits& limits;
    double gTol;  ///< closed: g ≤ gTol [m]
    /// `at` is slot 0, the place of the step: its unresolved forces are in M̂, and with an aim
    /// contacts that do not seem to close are put aside.
    bool main;
  };
  /// Poses ξ = GΛ + c for the step Δt [s] from x. With an aim, γ_free contains its terms as well.
  void pose(const Posing& from, const State& x, double step, const PositionAim* aim);
  /// Forgets what was put aside and the last solution, since slot 0 is evaluated anew.
  void forget() { closing_.clear(), start_.forget(); }

  /// Solves it by the model's impact law, from Λ on.
  SolveReport solve(InclusionSolver& solver);
  /// Called after the solution of a problem with an aim, which has left out contacts that did not
  /// seem to close (ClosingContacts). True: the solution closes some of them. They now are contacts
  /// of the slot, and the problem has to be posed and solved again; it starts from Λ.
  bool bringIn();
  /// Contacts whose impact falls into this step and waits; sorted, without those that rebound.
  const std::vector<ContactKey>& arriving() const { return arriving_; }
  /// True: contact i pressed in the step before.
  bool pressedBefore(int i) const { return start_.pressedBefore(i); }

  /// Replaces u_free; γ_free changes with it, its other terms stay.
  void freeVelocity(const Eigen::VectorXd& uFree);
  /// Takes stiff forces linearly implicitly, with their derivatives at x, where it was posed:
  ///   M̂ (u^E − u^A) = Δt (h + Δt s K u^A) + WΛ,   M̂ = M − b Δt D − a Δt² K
  /// Has no effect in models without stiff elements.
  void linearlyImplicit(const State& x, const ImplicitWeights& weights);
  /// Forms the operator M̂ alone, with the derivatives in `at`, evaluated at x, for a step Δt [s].
  void implicitMass(const Evaluation& at, const State& x, double step,
                    const ImplicitWeights& weights);
  /// out = M̂⁻¹ in; M⁻¹ in models without stiff elements.
  void applyInverseMass(const Eigen::VectorXd& in, Eigen::VectorXd& out) const;

  /// Percussions, rows() entries [N s].
  Vec Lambda() { return {Lambda_.data(), static_cast<Eigen::Index>(rows())}; }
  ConstVec Lambda() const { return {Lambda_.data(), static_cast<Eigen::Index>(rows())}; }
  double Lambda(int row) const { return Lambda_[static_cast<std::size_t>(row)]; }
  /// u^E = u_free + M⁻¹ W Λ; remembers Λ by key in x for the next start.
  void velocityFromImpulses(State& x);
  /// Remembers Λ by key in x; for schemes that compute velocities themselves.
  void keepImpulses(State& x) const;

 private:
  void freeMotion(const Posing& from, const State& x);
  void gammaOf(const Eigen::VectorXd& u, std::vector<double>& out) const;
  void scale();
  const SystemParts* parts_ = nullptr;
  Evaluation* from_ = nullptr;
  ImplicitForces* implicitForces_ = nullptr;
  double gTol_ = 0.0, gapNoise_ = 0.0;  // gapNoise_: of rates that aim at gaps
  bool implicit_ = false;               // M̂ instead of M
  Delassus delassus_;
  Eigen::VectorXd uFree_, uA_, work_;
  std::vector<double> gammaWork_, Lambda_;
  ClosingContacts closing_;  // of slot 0
  ImpulseStart start_;
  std::vector<ContactKey> arriving_;
};

}  // namespace dynamy
