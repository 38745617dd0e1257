/// OneStep: one step of one scheme.
#pragma once
#include <array>
#include <dynamy/stages/mechanical_system.hpp>
#include <span>

namespace dynamy {

/// Numbers of evaluations of M, h and contacts, by their purpose, and of looks at gaps alone.
struct StepEffort {
  long smooth = 0;    ///< steps within phases
  long rejected = 0;  ///< steps that were too long
  long switches = 0;  ///< finding instants, and steps to them
  long events = 0;    ///< impacts, decisions, projections
  long stepping = 0;  ///< steps in time, past switches that were not located
  long looks = 0;     ///< looks at all contacts that may close, without masses and forces
  long gaps = 0;      ///< gaps that these looks, and looks at single contacts, evaluated
};

/// Why a scheme that locates switches turns to steps in time.
enum class TurnedBy : std::uint8_t { none, stall, density, patience };

/// Counts of one step of a scheme that chooses its steps.
struct StepCounts {
  StepEffort effort{};
  int rejected = 0;       ///< tries that were too long
  int switches = 0;       ///< switches that were located
  int islands = 0;        ///< with steps of their own, at the end of the step; 0: all had one
  int impacts = 0;        ///< instants with an impact
  int accumulations = 0;  ///< infinite sequences of impacts that were passed
  int undecided = 0;      ///< switches at which no status was consistent, or several were
  double accumulationEnd = 0.0;  ///< when the last of these sequences comes to rest [s]
  /// Length of a step in which nothing moved and forces changed faster than it samples them [s].
  double unseen = 0.0;
  bool stepped = false;                ///< a step in time: switches in it were not located
  int steppedSystems = 0;              ///< number of systems stepped in time; others were located
  double stepError = 0.0;              ///< error of a step in time, in units of the tolerance
  TurnedBy turnedBy = TurnedBy::none;  ///< if not none: the first of steps in time, and why
  ContactKey turnedAt;                 ///< the contact that switched too often
};

/// Works of a step for the energy ledger [J], from schemes that integrate them more accurately than
/// the ledger can from the two ends.
struct StepWorks {
  bool given = false;
  double nonPotential = 0.0, friction = 0.0, normal = 0.0, joints = 0.0, boundaries = 0.0;

  /// Books the work of a row's percussion Λ at the relative velocity γ = Wᵀu + χ (theory 6): Λγ for
  /// the kind of the row, −Λχ for boundaries with a prescribed motion. A drive adds all of ΛWᵀu.
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

/// Books works like StepWorks::book, in the order nonPotential, friction, normal, joints,
/// boundaries. With a force λ in place of Λ the results are powers [W].
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
  StepWorks works;             ///< works of its percussions
};

/// Status of a contact from the end of a step on, for schemes that hold statuses themselves.
struct HeldStatus {
  ContactKey key;
  Status status = Status::open;
};

/// Impact of a contact within a step, for schemes that find its instant.
struct LocatedImpact {
  ContactKey key;
  double t = 0.0;               ///< instant [s]
  Status after = Status::open;  ///< right after the impact
  double speed = 0.0;           ///< speed of approach, −γ_N⁻ [m/s]
  double Lambda = 0.0;          ///< normal percussion [N s]
};

struct StepReport {
  /// Length of the step that was taken [s]: that which was asked for, with Halving::ends a half, a quarter, …
  /// of it as well, and any shorter one where the scheme chooses.
  double dt = 0.0;
  SolveReport solved;
  int contacts = 0;  ///< in the inclusion problem
  /// Why the scheme cannot take this step, whatever Δt is (it knows no impact, …); empty: it can.
  std::string_view refused{};
  /// True: the scheme found no solution of its own equations, and a simpler scheme took the step or
  /// a part of it.
  bool simpler = false;
  /// Work of forces with potential that the step damped, as it used them [J].
  double dampedWork = 0.0;
  StepCounts counts{};
  StepWorks works{};
  bool ownStatuses = false;  ///< the scheme gives the statuses of all contacts
  /// Of contacts of systems in `apart`, or with own statuses of all; others are open. Valid until the
  /// next step.
  std::span<const HeldStatus> statuses{};
  /// All impacts of the same contacts, also of those that are far away at the end of the step.
  std::span<const LocatedImpact> impacts{};
  /// Velocities right before an impact at the end of the step, the scheme's own until its next
  /// step; null: there is none.
  const Eigen::VectorXd* uBeforeImpact = nullptr;
  /// Per system, not 0: the system did not move by the equations of the step, and `works` are those
  /// of such systems alone. Empty: no such system. Valid until the next step.
  std::span<const char> apart{};
  bool resting = false;        ///< nothing moved: q and u are those before
  const Jump* jump = nullptr;  ///< the scheme's own, until its next step; null: there was none
};

/// Accuracy required of a scheme that chooses its steps.
struct Accuracy {
  double tolerance = 1e-6;  ///< of positions over `length`, angles, and velocities over U
  double length = 1.0;      ///< length of the scene [m]
};

/// Features that a model may require of a scheme and that not every scheme defines.
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
  /// Number of slots of evaluated data that the scheme needs at once.
  virtual int evaluations() const { return 1; }
  /// Why the definition of the scheme does not cover a feature; empty: it does. A step that
  /// requires the feature is refused with these words.
  virtual std::string_view lacks(Asked /*what*/) const { return {}; }
  /// True: the scheme chooses the lengths of its steps. step() then advances by at most dt, sets
  /// x.t and reports the length it took; data kept from step to step are in x.scheme.
  virtual bool choosesSteps() const { return false; }
  /// True: a run has to give its step, which bounds the steps that the scheme chooses.
  virtual bool needsStep() const { return !choosesSteps(); }
  /// True: the scheme itself finds all contacts on its path, however fast bodies are.
  virtual bool findsContacts() const { return false; }
  /// True: it steps a view as well, beside which all other systems rest and which may change from
  /// step to step.
  virtual bool stepsSome() const { return false; }
  /// Sets the accuracy, before a run, of schemes that choose their steps.
  virtual void aim(const Accuracy&) {}
  /// The length that the scheme would try next from x without an outer bound [s]; 0: not known.
  virtual double nextStep(const State& /*x*/) const { return 0.0; }
  /// Advances x by dt. Neither prints nor throws.
  virtual StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) = 0;
  /// Positions and velocities at fraction θ ∈ [0,1] of the step from `a` to `b`; default: linear in
  /// q, u of the end.
  virtual void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                           State& out) const;
  /// Forces and relative velocities of contacts at `at`, a state of the last step by interpolate():
  /// with the statuses of the step, or with those `after` it. False: the scheme knows only the
  /// percussions of the whole step.
  virtual bool contactsAt(const MechanicalSystem& /*s*/, const State& /*at*/, bool /*after*/,
                          ContactInstant& /*out*/) const {
    return false;
  }

 protected:
  /// For schemes with laws of their own: the feature that an impact in the problem just solved
  /// requires and the scheme lacks; empty: none.
  std::string_view lackingAtImpact(const MechanicalSystem& s) const;
};

}  // namespace dynamy
