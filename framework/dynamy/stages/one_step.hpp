/// OneStep: one step of one scheme.
#pragma once
#include <array>
#include <dynamy/stages/mechanical_system.hpp>
#include <span>

namespace dynamy {

/// Evaluations of M, h and contacts by what they were for.
struct StepEffort {
  long smooth = 0;    ///< steps within phases
  long rejected = 0;  ///< steps that were too long
  long switches = 0;  ///< finding instants, and steps to them
  long events = 0;    ///< impacts, decisions, projections
  long stepping = 0;  ///< steps in time, past switches that were not located
};

/// Why a scheme that locates switches turns to steps in time.
enum class TurnedBy : std::uint8_t { none, stall, density };

/// What a scheme that chooses its steps did to take one of them.
struct StepCounts {
  StepEffort effort{};
  int rejected = 0;              ///< tries that were too long
  int switches = 0;              ///< located
  int impacts = 0;               ///< instants with an impact
  int accumulations = 0;         ///< infinite sequences of impacts that were passed
  int undecided = 0;             ///< switches at which no status was consistent, or several were
  double accumulationEnd = 0.0;  ///< when the last of these sequences comes to rest [s]
  /// Length of a step in which nothing moved and forces changed faster than it looks at them [s].
  double unseen = 0.0;
  bool stepped = false;                ///< a step in time: switches in it were not located
  int steppedSystems = 0;              ///< of so many systems; of the others they were
  double stepError = 0.0;              ///< of such a step, in units of the tolerance
  TurnedBy turnedBy = TurnedBy::none;  ///< the step is the first of such steps
  ContactKey turnedAt;                 ///< the contact that switched too often
};

/// Works of a step, for the energy ledger, of schemes that integrate them better than the ledger
/// can from the two ends [J].
struct StepWorks {
  bool given = false;
  double nonPotential = 0.0, friction = 0.0, normal = 0.0, joints = 0.0, boundaries = 0.0;

  /// Books the work of a row's percussion Λ at the relative velocity γ = Wᵀu + χ (theory 6): Λγ to
  /// the kind of the row, −Λχ to what moves by itself. A drive brings in all of it, ΛWᵀu.
  void book(RowKind kind, double Lambda, double gamma, double chi) {
    if (kind == RowKind::drive) {
      nonPotential += Lambda * (gamma - chi);
      return;
    }
    (kind == RowKind::normal     ? normal
     : kind == RowKind::friction ? friction
                                 : joints) += Lambda * gamma;
    boundaries -= Lambda * chi;
  }
};

/// The same in the order nonPotential, friction, normal, joints, boundaries; λ gives powers [W].
inline void bookWork(std::array<double, 5>& works, RowKind kind, double Lambda, double gamma,
                     double chi) {
  StepWorks w;
  w.book(kind, Lambda, gamma, chi);
  works[0] += w.nonPotential, works[1] += w.friction, works[2] += w.normal;
  works[3] += w.joints, works[4] += w.boundaries;
}

/// An impact that a scheme takes as a jump before its step, at q^A.
struct Jump {
  Eigen::VectorXd u;           ///< velocities after it: the step starts with them
  std::vector<double> Lambda;  ///< its share of the step's percussions, row by row [N s]
  StepWorks works;             ///< of its percussions
};

/// Status of a contact from the end of a step on, of schemes that hold it themselves.
struct HeldStatus {
  ContactKey key;
  Status status = Status::open;
};

/// Impact of a contact within a step, of schemes that find its instant.
struct LocatedImpact {
  ContactKey key;
  double t = 0.0;               ///< [s]
  Status after = Status::open;  ///< right after it
  double speed = 0.0;           ///< of approach, −γ_N⁻ [m/s]
  double Lambda = 0.0;          ///< normal percussion [N s]
};

struct StepReport {
  double dt = 0.0;  ///< length of the step that was taken [s]
  SolveReport solved;
  int contacts = 0;  ///< in the inclusion problem
  /// Why the scheme cannot take this step, whatever Δt is (it knows no impact, …); empty: it can.
  std::string_view refused{};
  /// The scheme found no solution of its own equations, and a simpler one took the step or a part.
  bool simpler = false;
  StepCounts counts{};
  StepWorks works{};
  bool ownStatuses = false;                ///< statuses are those below, all others are open
  std::span<const HeldStatus> statuses{};  ///< valid until the next step
  /// With own statuses: all impacts of the step, also of contacts that are far away at its end.
  std::span<const LocatedImpact> impacts{};
  /// Velocities right before an impact at the end of the step, the scheme's own until its next
  /// step; null: there is none.
  const Eigen::VectorXd* uBeforeImpact = nullptr;
  /// Not 0: the system moved otherwise than by the equations of the step, and `works` are of those
  /// systems alone; empty: none did. Valid until the next step.
  std::span<const char> apart{};
  const Jump* jump = nullptr;  ///< the scheme's own, until its next step; null: there was none
};

/// What a scheme that chooses its steps works to.
struct Accuracy {
  double tolerance = 1e-6;  ///< of positions over `length`, angles, and velocities over U
  double length = 1.0;      ///< of the scene [m]
};

/// What a model may ask of a scheme that not every scheme is defined for.
enum class Asked : std::uint8_t {
  contact,           ///< a unilateral contact closes
  rebound,           ///< an impact with ε_N > 0
  frictionAtImpact,  ///< an impact with friction
  impactLaw,         ///< a law of several inclusions: Poisson's, the energetic, the sequential one
  stiffForces        ///< stiff elements whose period or decay Δt does not resolve
};

/// Contacts at an instant of a step.
struct ContactInstant {
  const ContactSet* contacts = nullptr;  ///< valid until the next evaluation
  Eigen::VectorXd lambda;                ///< forces, rows of contacts [N]
  Eigen::VectorXd gamma;                 ///< relative velocities Wᵀu + χ of the same rows [m/s]
};

class OneStep : public Element {
 public:
  static constexpr Kind kKind = Kind::scheme;
  using Element::Element;
  virtual int order() const = 0;
  /// Slots of evaluated data the scheme needs at once.
  virtual int evaluations() const { return 1; }
  /// Why the definition of the scheme leaves this out; empty: it does not. A step that is asked for
  /// it is refused with these words.
  virtual std::string_view lacks(Asked /*what*/) const { return {}; }
  /// True: the scheme chooses the lengths of its steps. step() then goes on by at most dt, sets x.t
  /// and reports the length it took; what it keeps from step to step is in x.scheme.
  virtual bool choosesSteps() const { return false; }
  /// True: a run has to say its step, which bounds those that the scheme chooses.
  virtual bool needsStep() const { return !choosesSteps(); }
  /// True: it finds the contacts that its path comes to by itself, however fast bodies are.
  virtual bool findsContacts() const { return false; }
  /// Before a run, to schemes that choose their steps.
  virtual void aim(const Accuracy&) {}
  /// The length it would try next from x, if nothing bounds it [s]; 0: not known.
  virtual double nextStep(const State& /*x*/) const { return 0.0; }
  /// Advances x by dt. Neither prints nor throws.
  virtual StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) = 0;
  /// Positions and velocities at fraction θ ∈ [0,1] of the step from `a` to `b`; default: linear in
  /// q, u of the end.
  virtual void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                           State& out) const;
  /// What contacts do at the instant `at` of the last step, which interpolate() gave: with the
  /// statuses of the step, or `after` it with those that follow. False: the scheme knows the
  /// percussions of the whole step alone.
  virtual bool contactsAt(const MechanicalSystem& /*s*/, const State& /*at*/, bool /*after*/,
                          ContactInstant& /*out*/) const {
    return false;
  }

 protected:
  /// For schemes with laws of their own: what an impact in the problem just solved asks of them and
  /// they lack; empty: nothing.
  std::string_view lackingAtImpact(const MechanicalSystem& s) const;
};

}  // namespace dynamy
