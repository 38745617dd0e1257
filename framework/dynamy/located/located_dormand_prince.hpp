/// LocatedDormandPrince: integrates to any requested tolerance, also across switches (theory 50).
///
///   smooth phases   Dormand and Prince's order 8(5,3), at tolerances from 1e-3 up 5(4), on
///                   M u̇ = h + Wλ,  Wᵀu̇ + w̄ = 0  with the status of every contact held; Radau IIA
///                   of order 5 while the motion is stiff
///   switches        where a gap, a slip or the reserve of a force reaches zero: found on the path
///                   through the step; the step is repeated up to there, and Newton's method
///                   covers the small distance left to the root
///   at a switch     impact, decision of the new status by an inclusion, projection
///   no bias         HalfExplicitGragg where an element that is held reports no bias
///   dense switches  steps of EnergyMomentum, as long as the tolerance permits (SwitchGovernor)
///
/// Gragg's extrapolation in place of Dormand and Prince needs 1.2 to 1.8 times the evaluations at
/// equal error. Taking the state at the switch from the dense output was rejected: errors grow up
/// to tenfold.
#pragma once
#include <dynamy/located/stepped_islands.hpp>
#include <dynamy/located/switch_governor.hpp>
#include <dynamy/located/switching/switch_event.hpp>
#include <dynamy/located/switching/switch_search.hpp>
#include <dynamy/stages/islands.hpp>
#include <memory>

namespace dynamy {

class LocatedDormandPrince : public OneStep {
 public:
  LocatedDormandPrince() = default;
  explicit LocatedDormandPrince(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return table_->order; }
  bool choosesSteps() const override { return true; }
  bool findsContacts() const override { return !stepped_; }
  void aim(const Accuracy& accuracy) override;
  double nextStep(const State& x) const override;
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;
  bool contactsAt(const MechanicalSystem& s, const State& at, bool after,
                  ContactInstant& out) const override;

 protected:
  /// Integrates smooth phases with the method `table`, whatever the tolerance.
  LocatedDormandPrince(const Parameters& x, const ButcherTableau& table);
  /// Integrates smooth phases with the half-explicit rule of this number of columns.
  void halfExplicit(int columns) { columns_ = columns; }
  /// Becomes the event-driven scheme of the textbooks, with the method `table`.
  void plain(const ButcherTableau& table) { given_ = table_ = &table, plain_ = true; }
  static void declareStiff(Attributes& a);

 private:
  static constexpr double kFirstStep = 0.02;  ///< of T
  struct Impulse {
    ContactKey key;
    int first, row, dim;
  };
  enum class Tried : std::uint8_t { accepted, rejected, turned, located, again, failed };
  bool restore(MechanicalSystem& s, InclusionSolver& solver, const State& x, StepReport& report);
  void store(State& x);
  /// True: x is the end of the last step, so that nothing has to be evaluated anew.
  bool goesOn(const State& x) const;
  void begin(MechanicalSystem& s, InclusionSolver& solver, const State& x, StepReport& report);
  bool proceed(MechanicalSystem& s, InclusionSolver& solver, const State& x, double dt,
               StepReport& report);
  // Steps in time.
  bool stepsInTime(const State& x);
  void beginStepping(const State& x);
  void resumeStepping(const MechanicalSystem& s, const State& x);
  void storeStepping(State& x) const;
  StepReport stepInTime(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  /// After a located step: lets the governor decide whether to turn to steps in time.
  void govern(const MechanicalSystem& s, long evaluations, const StepReport& report);
  double locatedWork(const MechanicalSystem& s, double evaluations) const;
  double steppedWork(const MechanicalSystem& s, double evaluations, double newton) const;
  // Islands whose switches are located while others are stepped in time (located_islands.cpp).
  /// Charges the work of a step to the system of its switch, or to that with the largest error.
  void owe(const MechanicalSystem& s, double work, bool switched);
  /// Chooses the systems that are stepped in time from x on, into timed_.
  void chooseStepped(const State& x);
  void chooseDear(std::vector<char>& chosen) const;
  bool anyQuiet() const;
  int steppedSystems() const;
  Eigen::VectorXd decidedAnew() const;
  void startQuiet(const MechanicalSystem& s, double end);
  bool quietStep(MechanicalSystem& s, InclusionSolver& solver, bool again, StepCounts& counts);
  /// Integrates the located islands beyond steppedFrom_, at most to `end`; returns the time up to
  /// which their motion is known.
  double followQuiet(MechanicalSystem& s, InclusionSolver& solver, double end, StepCounts& counts);
  /// Writes the state of the located islands at t into quiet_.at.
  void placeQuiet(MechanicalSystem& s, double t);
  /// Copies the located islands into x, the end of the step in time, except those touched in it.
  void joinQuiet(MechanicalSystem& s, State& x, StepReport& report);
  double nextStepped(double t) const;
  void showQuiet(double t, State& out) const;
  // Instants that elements announce, and elements that switch (located_instants.cpp).
  /// Time until right before the next instant at which an element jumps as a function of time [s].
  double untilInstant();
  /// Moves p from right before the announced instant to right after it, at most to `end`, and
  /// decides the statuses there.
  bool passInstant(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p, double end,
                   StepReport& report);
  /// True: a step of length h at rest is too long to see forces change within it. A step of the
  /// least length for rest is accepted all the same, and the report says so.
  bool tooLongAtRest(MechanicalSystem& s, double h, const Switch& found, StepReport& report);
  /// Moves p from the root of a latch to right after it, where its element switches.
  bool throwLatch(MechanicalSystem& s, PhasePoint& p);
  /// Follows the contacts that are reported at x from now on. True: a held contact is gone, or a
  /// contact that always acts is not held.
  bool relist(const State& x);
  bool evaluateEnd(MechanicalSystem& s, PhasePoint& p);
  bool event(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p, StepReport& report,
             const std::vector<HeldKey>& stopped);
  bool enter(MechanicalSystem& s, InclusionSolver& solver, const State& x, StepReport& report);
  bool goOn(MechanicalSystem& s, InclusionSolver& solver, double most, StepReport& report,
            bool& done);
  /// Length of a trial of length h after contacts have limited it [s].
  double shortened(double h) const;
  Tried attempt(MechanicalSystem& s, double h, bool looked, StepReport& report, Switch& found);
  /// Calls attempt() for a step of length h, and again up to the place where a gap comes near zero;
  /// h becomes the length that was tried.
  Tried tryStep(MechanicalSystem& s, double& h, StepReport& report, Switch& found);
  /// Decides the statuses after switch w at p.
  bool decide(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p, const Switch& w,
              StepReport& report);
  // The step to a switch, and the distance left to its root (located_polish.cpp).
  bool repeat(MechanicalSystem& s, double h, const Switch& w);
  bool polish(MechanicalSystem& s, double h, const Switch& w);
  /// Moves to_ by the time d; `known`: the forces there are evaluated already.
  bool moveOn(MechanicalSystem& s, double h, double d, bool& known);
  void moveByTaylor(MechanicalSystem& s, double d);
  bool moveByDense(MechanicalSystem& s, double t);
  bool moveByStep(MechanicalSystem& s, double d);
  /// Evaluates the forces at to_ and adds their impulse from known_ to to_.
  bool settle(MechanicalSystem& s);
  /// True: an open contact penetrates at from_.
  bool closesOpen();
  /// Finds the open contacts at from_ that joints bear, and has them watched as such. False: contacts
  /// changed.
  bool leaveToJoints(MechanicalSystem& s);
  /// Adds the contacts that bodies may meet with along path_.
  bool widen();
  /// True: bodies whose contacts come and go overlap more at x than at from_.
  bool sinks(const State& x);
  /// A trial of length h has reached two bodies whose contact cannot be followed: requires a
  /// shorter trial that ends right before they meet, or gives up the step.
  Tried shortOfMeeting(double h, StepReport& report);
  double leftOverlap() const;  ///< overlaps up to this are left as they are [m]
  /// Requires the step again, shorter than h. Returns true.
  bool takeShorter(const MechanicalSystem& s, double h, const std::array<double, 5>& works,
                   StepReport& report);
  double turn();
  bool endStarts();
  /// True: the slip of held[i] has a clear direction of its own, for steps of length h.
  bool slipIsClear(std::size_t i, double h) const;
  /// Ends the starting phase of slips that have a clear direction at from_, for a step of length h.
  bool endClearStarts(MechanicalSystem& s, double h);
  bool project(MechanicalSystem& s, PhasePoint& p);
  /// Finds the parts whose slip ends within the tolerance, after at most `last`; steps may continue
  /// by at most `bound`.
  bool findStopping(double most, double& bound, double& last);
  bool stop(MechanicalSystem& s, InclusionSolver& solver, double& most, StepReport& report,
            bool& stopped);
  void release(const Switch& w);
  /// Time that instants are compared with [s]: H, at most T, since steps at rest grow beyond T.
  double span() const { return std::min(H_, norm_.time()); }
  void noteNull(const SwitchEvent::Result& r, const PhasePoint& p);
  void keepImpulses();
  void keepPercussions(double t);
  Status status(std::size_t i) const;  ///< of held[i]
  void tell(MechanicalSystem& s, State& x, StepReport& report);
  bool refuse(std::string_view why);
  bool refuse(const FrozenPhase& phase);
  /// Stalls because contact `at` comes or goes in a way that cannot be followed.
  bool lose(ContactKey at);
  /// Stalls because the set of contact `at` becomes another one (FrozenPhase::kOtherSet).
  bool stall(ContactKey at);
  bool stall();
  void book(const MechanicalSystem& s, long StepEffort::*what, StepReport& report);
  bool checkBias(MechanicalSystem& s, const PhasePoint& p);
  // Elements without a bias (located_untold.cpp).
  void useDifferences(MechanicalSystem& s);
  bool untold(int element) const;
  bool findUntold(MechanicalSystem& s, const State& x, bool held);
  bool decideUntold(MechanicalSystem& s, InclusionSolver& solver, StepReport& report);
  void chooseMethod();
  /// First row at p whose γ̇ is not `found`, −1: none; toldDot_: γ̇ of all rows as elements report
  /// it.
  int firstWrongBias(const MechanicalSystem& s, const PhasePoint& p, const Eigen::VectorXd& found);
  bool refuseBias(const MechanicalSystem& s, int row, double told, double found);

  enum class Stiff : std::uint8_t { automatic, never, always } stiff_ = Stiff::automatic;
  /// Numbers at the front of State::scheme, see located_memory.cpp.
  static constexpr int kHead = 14, kBehind = kHead + SwitchGovernor::kNumbers;
  /// Index in State::scheme after the numbers of each system, which follow those of the governor: T
  /// of its island, and its work in the governor's window or whether it is stepped in time.
  Eigen::Index behindTimes() const { return kBehind + 3 * norm_.times().size(); }
  void resumeNorm(const MechanicalSystem& s, const State& x);
  /// True: by its counts and indices, x.scheme can be one that this scheme has stored.
  bool knows(const MechanicalSystem& s, const State& x) const;
  bool knows(const MechanicalSystem& s, const Eigen::VectorXd& kept, bool quiet) const;
  Accuracy accuracy_;
  const ButcherTableau* given_ = nullptr;  // prescribed method; null: one that fits the tolerance
  const ButcherTableau* table_ = &dormandPrince8();
  ErrorNorm norm_;
  FrozenPhase phase_, oldPhase_;
  mutable FrozenPhase stepPhase_;   // phase of the last step, for its dense output
  mutable FrozenPhase afterPhase_;  // phase after the last step, for signals
  mutable Eigen::VectorXd shownA_;
  mutable SmoothStep smooth_;
  SmoothStep smoothOwn_;  // for short steps to a switch
  QuinticPath path_;
  ContactProbe probe_;
  SwitchSearch search_;
  SwitchEvent event_;
  PhasePoint from_, to_, trial_, stepFrom_, stepTo_;
  PhasePoint known_;           // last point on the way to a root with evaluated forces
  Eigen::VectorXd enteredAt_;  // q at the start of the step, which a decision there may correct
  std::vector<ContactKey> phaseKeys_, stepPhaseKeys_;
  std::vector<HeldKey> stopping_;
  std::vector<Impulse> stepKeys_;
  std::vector<Held> startHeld_;  // at the start of the step
  std::vector<Percussion> told_;
  std::vector<LocatedImpact> impacts_;
  std::vector<HeldStatus> statuses_;
  Eigen::VectorXd delta_, impulse_, stored_;
  std::array<double, 5> works_{};
  double H_ = 0.0;  // the next trial [s]
  double lookAhead_ = 1e-5, lastEvent_ = -1e300;
  int nulls_ = 0;
  bool ready_ = false;
  int columns_ = 0;          // of the half-explicit rule where the model requires it, else 0
  std::vector<int> untold_;  // elements without a bias, ascending
  bool foundUntold_ = false;
  std::vector<ContactKey> asked_;
  std::vector<ContactKey> borne_;                   // contacts that joints bear in this step
  double instant_ = -1e300, instantAfter_ = 1e300;  // announced instant, the first after a time [s]
  std::string_view why_;
  std::string whyOwn_;  // what why_ points to, if it names an element
  Eigen::VectorXd uBeforeImpact_, gammaDot_, toldDot_, rates_;
  std::vector<double> sums_;
  double tImpact_ = -1e300;
  long booked_ = 0;
  MechanicalSystem* system_ = nullptr;
  mutable bool denseReady_ = false;
  bool plain_ = false;  // the event-driven scheme of the textbooks, without any extension
  bool stalled_ = false, stepped_ = false;
  bool otherSet_ = false;  // stalled because a law's set becomes another one
  bool lost_ = false;      // stalled because a contact comes or goes that cannot be followed
  SwitchGovernor governor_;
  SteppedIslands steps_;
  ContactKey lastSwitched_;
  Eigen::Matrix<double, kHead, 1> head_;
  double clear_ = 1.0;  // part of the path before two bodies meet whose contact cannot be followed
  // Of contacts that come and go: first part of the path with too deep an overlap; overlap [m] at
  // its start.
  double passing_ = 1.0, startOverlap_ = 0.0;
  State steppedFrom_;
  Islands islands_;
  /// Work in the governor's window charged to each system: of steps with its switches; of steps
  /// whose length its error bounded.
  Eigen::Matrix<double, Eigen::Dynamic, 2> owed_;
  std::vector<char> timed_;  // not 0: the system is stepped in time
  bool quietOnly_ = false;   // integrates located islands alone: it takes no steps in time itself
  /// Located islands: their present step, which reaches beyond the end of the last step in time.
  struct Quiet {
    std::unique_ptr<LocatedDormandPrince> scheme;
    State from, to, at;
    mutable State shown;
    double end = 0.0;      // time up to which the step might have gone [s]
    Eigen::VectorXd kept;  // `from` and `end` as numbers
    StepWorks works;
    bool known = false;
  } quiet_;
  Eigen::VectorXd quietKept_;
  std::vector<char> apart_;  // not 0: switches of the system are located
};

}  // namespace dynamy
