/// MechanicalSystem: the stages of a step on flat arrays. Schemes see M, h, F, W, χ and never an
/// element.
///
/// A slot (Evaluation) holds everything evaluated at one (t, q, u). Data are produced by a stage in
/// fixed order and const afterwards; "is up to date" flags were rejected.
#pragma once
#include <algorithm>
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/solver/impact/impact_law.hpp>
#include <dynamy/stages/closing_contacts.hpp>
#include <dynamy/stages/stiff_part.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

/// One slot: frames, M, h and contacts at one (t, q, u).
struct Evaluation {
  double t = 0.0;
  Kinematics kinematics;
  MassMatrix mass;
  Eigen::VectorXd h, hNonPotential;
  ContactSet contacts;
};

/// The parts of a model in the order of their indices; borrowed.
struct SystemParts {
  Topology* topology = nullptr;
  std::vector<const ExternalForce*> forces;
  std::vector<const NonSmoothElement*> contacts;
  const ImpactLaw* impactLaw = nullptr;
};

/// Reports the contacts of all elements, without those between systems that are left out.
/// `only`: restricts this to the elements with a 1, by their index; empty: all elements.
void reportContacts(const SystemParts& parts, const Kinematics& k, ContactSink& sink,
                    std::span<const char> only = {});

/// Aims γ^E at positions instead of velocities. Unilateral contacts get the gap term g/Δt, for g >
/// dead, and an impact waits until the contact is closed. Joints get γ^E + γ^A = 0 (the mean
/// velocity of the step vanishes), or are stabilised.
struct PositionAim {
  double dead = 0.0;        ///< gaps up to this count as closed [m]
  bool meanJoints = false;  ///< γ^E + γ^A = 0 in the rows of joints
  double kappa = 0.0;       ///< without meanJoints: γ^E = −κ g/Δt in the rows of joints,
  double cap = 0.0;         ///< limited to this speed [m/s]
  double noise = 0.0;  ///< rounding of gaps [m]: solvers need not resolve rates below noise/Δt
  std::span<const ContactKey> arrived{};  ///< sorted; these contacts are closed, whatever their gap
  /// Impacts without restitution do not wait: this step closes the gap, the next one does the rest.
  bool divide = false;
};

class MechanicalSystem {
 public:
  explicit MechanicalSystem(const SystemParts& parts, int slots = 1);

  /// q ← q ⊕ Δt (F u + β), t ← t + Δt.
  void moveConfiguration(State& x, double dt);
  /// q ← q ⊕ Δt (F v + β), t ← t + Δt, with velocities v that need not be x.u.
  void move(State& x, const Eigen::VectorXd& v, double dt) const;
  /// Evaluates M, h and the contacts with g ≤ g_tol + reach at (x.t, x.q, x.u), into slot `slot`.
  const Evaluation& evaluate(const State& x, int slot = 0, double reach = 0.0);
  /// Evaluates M, h and the closed contacts of the elements with a 1, by their index. Contacts of
  /// the other elements are not searched.
  const Evaluation& evaluateOf(std::span<const char> elements, const State& x, int slot);
  /// Evaluates like evaluate(), with the contacts that may close within Δt: reach is twice the way
  /// that the fastest block goes with |u| + Δt|M⁻¹h|, angles as lengths.
  const Evaluation& evaluateAhead(const State& x, double dt, int slot = 0);
  /// Evaluates like evaluateAhead() into slot 0. Forces with derivatives that the step does not
  /// resolve (UnresolvedForces) are taken at the end of the step by the implicit Euler rule, in the
  /// reach and in the next impactProblem. Oscillations faster than steps can resolve then come to
  /// rest instead of growing. If there are such forces, declared stiff ones get weights `declared`.
  const Evaluation& evaluateDamped(const State& x, double dt, const ImplicitWeights& declared);
  /// Number of forces that the present step takes at its end, or that are withheld.
  int damped() const { return damped_; }
  /// Takes gyroscopic terms in h of slot 0 at the mean velocity of the coming step, see
  /// PartialMechanicalSystem::gyroscopicAtMean. x: the state at which the slot was evaluated.
  void gyroscopicAtMean(const State& x, double dt);
  /// Poses ξ = GΛ + c: u_free = u^A + M⁻¹hΔt, γ's, G, start of Λ by contact key. With an aim,
  /// γ_free contains its terms as well.
  InclusionProblem& impactProblem(const State& x, double dt, int slot = 0,
                                  const PositionAim* aim = nullptr);
  /// Called after the solution of a problem with an aim, which has left out contacts that did not
  /// seem to close (ClosingContacts). True: the solution closes some of them. They now are contacts
  /// of the slot, and the problem has to be posed and solved again; it starts from Λ.
  bool bringIn();
  /// Contacts whose impact falls into this step and waits, by the last impactProblem with an aim;
  /// sorted, without those that rebound.
  const std::vector<ContactKey>& arriving() const { return arriving_; }
  /// Largest change of a velocity by the forces of slot 0: max |Δt M⁻¹h| [m/s].
  double largestChange(double dt) const;
  /// Replaces u_free of the problem just posed; γ_free changes with it, its other terms stay.
  void freeVelocity(const Eigen::VectorXd& uFree);
  /// Takes stiff forces linearly implicitly in the problem just posed from slot `slot`:
  ///   M̂ (u^E − u^A) = Δt (h + Δt s K u^A) + WΛ,   M̂ = M − b Δt D − a Δt² K
  /// Has no effect in models without stiff elements.
  void linearlyImplicit(const State& x, const ImplicitWeights& weights, int slot = 0);
  /// True: a rule that is explicit in h and stable up to ωΔt = `limit` is not so for the stiff
  /// elements at x, which is evaluated in slot `slot`.
  bool explicitIsUnstable(const State& x, double dt, double limit, int slot);
  /// Forms the operator M̂ alone, with the derivatives at x, which is evaluated in slot `slot`.
  void implicitMass(const State& x, double dt, const ImplicitWeights& weights, int slot);
  /// out = M̂⁻¹ in; M⁻¹ of the problem's slot in models without stiff elements.
  void applyInverseMass(const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  /// Leaves forces with a 1 out of h until release() (by their index, borrowed; empty: none is left
  /// out). A scheme takes them in another way, and reports by usedForce() the h that it used.
  void withhold(std::span<const char> forces) {
    withheld_ = forces;
    damped_ = static_cast<int>(std::count(forces.begin(), forces.end(), 1));
  }
  void release() { withheld_ = {}; }
  /// Replaces h of slot 0 by what the step really used, for the energy ledger.
  void usedForce(const Eigen::VectorXd& h, const Eigen::VectorXd& hNonPotential);
  const ImpactLaw& impactLaw() const { return *parts_.impactLaw; }
  /// Percussions of the current problem, rows() entries.
  Vec Lambda() { return {Lambda_.data(), static_cast<Eigen::Index>(problem_.rows())}; }
  double Lambda(int row) const { return Lambda_[static_cast<std::size_t>(row)]; }
  /// u^E = u_free + M⁻¹ W Λ; remembers Λ by key in x for the next start.
  void velocityFromImpulses(State& x);
  /// Remembers Λ by key in x; for schemes that compute velocities themselves.
  void keepImpulses(State& x) const;

  /// True: contact i of the problem just posed pressed in the step before.
  bool pressedBefore(int i) const { return pressedBefore_[static_cast<std::size_t>(i)] != 0; }
  /// Lets systems remove blocks and add others, after the step that began at tA. True: some did.
  bool renew(double tA, State& x) const;
  /// Threads that work on a step; null: the caller's alone. Borrowed.
  void workers(Workers* w) { problem_.workers = w; }
  /// Solvers stop once `stop` is set; null: they are never stopped. Borrowed.
  void stopWhen(const std::atomic<bool>* stop) { problem_.stop = stop; }
  /// Effort that solvers may spend on the problems that are posed from now on. A scheme lowers it
  /// after a search in vain; the caller of a scheme sets it for each step.
  void effort(Effort e) { effort_ = e; }
  Effort effort() const { return effort_; }

  /// Lets elements change the memory that they reserved; the time loop calls it after every step.
  void remember(State& x);

  /// Closed: g ≤ gTol [m]; default 1e-12 of the scene's length.
  void gTol(double value) { request_.gTol = value; }
  double gTol() const { return request_.gTol; }
  /// Evaluations fill the bias γ̇ − Wᵀu̇ of the closed contacts.
  void bias(bool wanted) { request_.bias = wanted; }
  /// Computes the bias of these elements (indices, ascending; borrowed), which report none, as the
  /// difference of γ along the motion with u held. Its length is 1e-3 of the time in which x passes
  /// through `scales` (of velocities, borrowed), at most 1e-3 of `time` [s].
  void differences(std::span<const int> elements, const Eigen::VectorXd& scales, double time) {
    differenced_ = elements, differenceScales_ = &scales, differenceTime_ = time;
  }
  /// Computes the bias of all rows of the requested contacts by that difference, taken `aside` of
  /// its lengths ahead of x along the motion. False: the contacts change within the difference.
  bool differenceBias(const State& x, Eigen::VectorXd& out, double aside = 0.0);
  /// Contacts alone at x, as evaluate() would report them, without their bias. It does not count as
  /// an evaluation, and is valid until the next look.
  const ContactSet& look(const State& x);
  /// Makes exactly the contacts with these keys (ascending) count as closed, until thaw().
  void freeze(std::span<const ContactKey> keys) { request_.frozen = keys, request_.refresh = true; }
  void thaw() { request_.frozen = {}, request_.refresh = request_.follow = false; }
  /// Like freeze(), with pairs of features one by one (ContactRequest::follow).
  void hold(std::span<const ContactKey> keys) { freeze(keys), request_.follow = true; }
  void delassusForm(Delassus::Form form) { form_ = form; }
  const Evaluation& slot(int i) const { return slots_[static_cast<std::size_t>(i)]; }
  /// Contacts of slot i, for schemes that change the laws of a stage.
  ContactSet& contactsOf(int i) { return slots_[static_cast<std::size_t>(i)].contacts; }
  const InclusionProblem& problem() const { return problem_; }
  const SystemParts& parts() const { return parts_; }

  /// Index of a system whose M is not positive definite in the last evaluation, or −1.
  int indefiniteMass() const { return indefinite_; }
  /// Calls of evaluate() so far: the cost of a run without the solver.
  long evaluations() const { return evaluations_; }
  /// V(q,t) of all systems and forces [J].
  double potentialEnergy(const State& x);

 private:
  void smooth(const State& x, Evaluation& e);
  void detect(double reach, Evaluation& e) const;
  void tellDifferences(const State& x, Evaluation& e);
  void startImpulses(const State& x);
  void startFrom(const RememberedImpulses& old, double scale);
  void addAim(const PositionAim& aim, double dt);
  /// How much the smooth forces of this step can change γ_N of contact i, without cancellation
  /// [m/s].
  double changeByForces(int i) const;
  std::vector<ContactKey> arriving_;
  void addImplicitVelocity(State& x);
  void forgetAside() { closing_.clear(), again_.key.clear(); }
  void detectAhead(const State& x, double dt, Evaluation& e);
  void implicitChange(const Evaluation& e, const Eigen::VectorXd& uA, double dt);
  void roundingOfC();
  double velocityAskedOf(int i) const;
  void scales();
  SystemParts parts_;
  std::vector<Evaluation> slots_;
  ContactRequest request_;
  Delassus delassus_;
  StiffPart stiff_;
  bool implicit_ = false;  // the present problem uses M̂ instead of M
  std::span<const char> withheld_;
  int damped_ = 0;
  Effort effort_ = Effort::full;
  bool unresolved_ = false;  // M̂ of slot 0 contains forces that the step does not resolve
  Delassus::Form form_ = Delassus::Form::automatic;
  InclusionProblem problem_;
  Eigen::VectorXd uFree_, uA_, work_, implicitFree_;
  mutable Eigen::VectorXd change_;  // M⁻¹h
  std::vector<double> gammaWork_;
  std::vector<double> Lambda_;
  ClosingContacts closing_;   // of slot 0
  RememberedImpulses again_;  // last solution, without the contacts that bringIn() added after it
  KeyIndex remembered_;       // of the impulses that the problem starts from
  std::vector<char> pressedBefore_;
  int indefinite_ = -1;
  double gapNoise_ = 0.0;  // noise of rates that aim at gaps
  int slot_ = 0;           // slot of the present problem
  long evaluations_ = 0;
  Kinematics energyKinematics_;
  // Result of look(): contacts alone.
  struct {
    Kinematics kinematics;
    ContactSet contacts;
  } look_;
  State lookState_;
  Eigen::VectorXd gammaLook_, biasLook_;
  std::span<const int> differenced_;
  const Eigen::VectorXd* differenceScales_ = nullptr;
  double differenceTime_ = 1.0;
};

}  // namespace dynamy
