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

/// Contacts of all elements, less those between systems that are left out.
/// `only`: of the elements with a 1, by their index; empty: of all.
void reportContacts(const SystemParts& parts, const Kinematics& k, ContactSink& sink,
                    std::span<const char> only = {});

/// Aims γ^E at positions instead of velocities. Unilateral: the gap term g/Δt, for g > dead; an
/// impact waits until the contact is closed; joints: γ^E + γ^A = 0, the mean velocity of the step,
/// or stabilised.
struct PositionAim {
  double dead = 0.0;        ///< gaps up to this count as closed [m]
  bool meanJoints = false;  ///< γ^E + γ^A = 0 in the rows of joints
  double kappa = 0.0;       ///< else γ^E = −κ g/Δt there,
  double cap = 0.0;         ///< up to this speed [m/s]
  double noise = 0.0;       ///< rounding of gaps [m]: no solver has to meet rates that differ by it
  std::span<const ContactKey> arrived{};  ///< sorted; these are closed, whatever their gap
  /// Impacts without restitution do not wait: one part closes the gap, the next step has the rest.
  bool divide = false;
};

class MechanicalSystem {
 public:
  explicit MechanicalSystem(const SystemParts& parts, int slots = 1);

  /// q ← q ⊕ Δt (F u + β), t ← t + Δt.
  void moveConfiguration(State& x, double dt);
  /// The same with velocities v that need not be x.u.
  void move(State& x, const Eigen::VectorXd& v, double dt) const;
  /// M, h and the contacts with g ≤ g_tol + reach, at (x.t, x.q, x.u), into slot `slot`.
  const Evaluation& evaluate(const State& x, int slot = 0, double reach = 0.0);
  /// M, h and the closed contacts of the elements with a 1, by their index: nothing is searched for
  /// the others.
  const Evaluation& evaluateOf(std::span<const char> elements, const State& x, int slot);
  /// The same as evaluate() with the contacts that may close within Δt: reach is twice the way that the fastest
  /// block goes with |u| + Δt|M⁻¹h|, angles as lengths.
  const Evaluation& evaluateAhead(const State& x, double dt, int slot = 0);
  /// The same into slot 0; forces with derivatives that the step does not resolve
  /// (UnresolvedForces) are taken at its end, in the reach and in the next impactProblem, by
  /// the implicit Euler rule: what oscillates faster than steps can follow comes to rest instead of
  /// growing. Where there are some, forces that declare themselves stiff have the weights `declared`.
  const Evaluation& evaluateDamped(const State& x, double dt, const ImplicitWeights& declared);
  /// Forces that the present step takes in this way, or that are withheld.
  int damped() const { return damped_; }
  /// Gyroscopic terms in h of slot 0 at the mean velocity of the coming step, see
  /// PartialMechanicalSystem::gyroscopicAtMean. x: what the slot was evaluated at.
  void gyroscopicAtMean(const State& x, double dt);
  /// u_free = u^A + M⁻¹hΔt,  γ's, G, start of Λ by contact key:   ξ = GΛ + c. With an aim, γ_free
  /// holds its terms as well.
  InclusionProblem& impactProblem(const State& x, double dt, int slot = 0,
                                  const PositionAim* aim = nullptr);
  /// After a solution of the problem posed with an aim, which has left out contacts that nothing
  /// seemed to close (ClosingContacts): true if it closes some of them. They are contacts of the slot
  /// now, and the problem is to be posed and solved again; it starts from Λ.
  bool bringIn();
  /// Contacts whose impact falls into this step and waits, by the last impactProblem with an aim;
  /// sorted. Those that rebound are not among them.
  const std::vector<ContactKey>& arriving() const { return arriving_; }
  /// Largest change of a velocity by the forces of slot 0: max |Δt M⁻¹h| [m/s].
  double largestChange(double dt) const;
  /// Replaces u_free of the problem just posed; γ_free changes with it, its other terms stay.
  void freeVelocity(const Eigen::VectorXd& uFree);
  /// Takes stiff forces of slot `slot` linearly implicitly in the problem just posed from it:
  ///   M̂ (u^E − u^A) = Δt (h + Δt s K u^A) + WΛ,   M̂ = M − b Δt D − a Δt² K
  /// Nothing happens in models without stiff elements.
  void linearlyImplicit(const State& x, const ImplicitWeights& weights, int slot = 0);
  /// True: a rule that is explicit in h and stable up to ωΔt = `limit` is not so for the stiff
  /// elements at x, which is evaluated in slot `slot`.
  bool explicitIsUnstable(const State& x, double dt, double limit, int slot);
  /// The operator M̂ alone, with the derivatives at x, which is evaluated in slot `slot`.
  void implicitMass(const State& x, double dt, const ImplicitWeights& weights, int slot);
  /// out = M̂⁻¹ in; M⁻¹ of the problem's slot in models without stiff elements.
  void applyInverseMass(const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  /// Forces with a 1 here are left out of h until release() (by their index, borrowed; empty: none
  /// is): a scheme takes them in another way, and tells by usedForce() what it took.
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
  /// Remembers Λ by key in x; for schemes that find velocities themselves.
  void keepImpulses(State& x) const;

  /// Contact i of the problem just posed pressed in the step before.
  bool pressedBefore(int i) const { return pressedBefore_[static_cast<std::size_t>(i)] != 0; }
  /// Lets systems take blocks away and bring others, after the step that began at tA. True: they
  /// did.
  bool renew(double tA, State& x) const;
  /// Threads that work on a step; null: the caller's alone. Borrowed.
  void workers(Workers* w) { problem_.workers = w; }
  /// Once it is set, solvers leave off; null: nobody asks. Borrowed.
  void stopWhen(const std::atomic<bool>* stop) { problem_.stop = stop; }
  /// What solvers may spend on the problems that are posed from now on. Schemes lower it once a search
  /// was in vain; whoever calls them sets it for each step.
  void effort(Effort e) { effort_ = e; }
  Effort effort() const { return effort_; }

  /// Lets elements that reserved memory change it; the time loop calls it after every step.
  void remember(State& x);

  /// Closed: g ≤ gTol [m]; default 1e-12 of the scene's length.
  void gTol(double value) { request_.gTol = value; }
  double gTol() const { return request_.gTol; }
  /// Evaluations fill the bias γ̇ − Wᵀu̇ of the closed contacts.
  void bias(bool wanted) { request_.bias = wanted; }
  /// The bias of these elements (indices, ascending; borrowed), which tell none, is the difference
  /// of γ along the motion with u held, over 1e-3 of the time that x takes to go through `scales`
  /// (of velocities, borrowed), at most of `time` [s].
  void differences(std::span<const int> elements, const Eigen::VectorXd& scales, double time) {
    differenced_ = elements, differenceScales_ = &scales, differenceTime_ = time;
  }
  /// That difference for all rows of the contacts that are asked for; false: they change. Where it
  /// is taken: `aside` of its lengths ahead of x along the motion.
  bool differenceBias(const State& x, Eigen::VectorXd& out, double aside = 0.0);
  /// Contacts alone at x, as evaluate() would report them without their bias; it is no evaluation.
  /// Valid until the next look.
  const ContactSet& look(const State& x);
  /// Exactly the contacts with these keys (ascending) count as closed, until thaw().
  void freeze(std::span<const ContactKey> keys) { request_.frozen = keys, request_.refresh = true; }
  void thaw() { request_.frozen = {}, request_.refresh = request_.follow = false; }
  /// The same, with pairs of features one by one (ContactRequest::follow).
  void hold(std::span<const ContactKey> keys) { freeze(keys), request_.follow = true; }
  void delassusForm(Delassus::Form form) { form_ = form; }
  const Evaluation& slot(int i) const { return slots_[static_cast<std::size_t>(i)]; }
  /// For schemes that change the laws of a stage.
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
  bool implicit_ = false;  // the present problem has M̂ instead of M
  std::span<const char> withheld_;
  int damped_ = 0;
  Effort effort_ = Effort::full;
  bool unresolved_ = false;  // M̂ of slot 0 has forces that the step does not resolve
  Delassus::Form form_ = Delassus::Form::automatic;
  InclusionProblem problem_;
  Eigen::VectorXd uFree_, uA_, work_, implicitFree_;
  mutable Eigen::VectorXd change_;  // M⁻¹h
  std::vector<double> gammaWork_;
  std::vector<double> Lambda_;
  ClosingContacts closing_;   // of slot 0
  RememberedImpulses again_;  // solution without those that it closes
  KeyIndex remembered_;       // of the impulses that the problem starts from
  std::vector<char> pressedBefore_;
  int indefinite_ = -1;
  double gapNoise_ = 0.0;  // of rates that aim at gaps
  int slot_ = 0;           // of the present problem
  long evaluations_ = 0;
  Kinematics energyKinematics_;
  // Looks at contacts alone.
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
