/// LocatedDormandPrince: any accuracy that is asked for, across switches too (theory 50).
///
///   smooth phases   Dormand and Prince's order 8(5,3), at tolerances from 1e-3 up 5(4), on
///                   M u̇ = h + Wλ,  Wᵀu̇ + w̄ = 0  with the status of every contact held; Radau IIA
///                   of order 5 while it is stiff
///   switches        where a gap, a slip or the reserve of a force reaches zero: found on the path
///                   through the step, the step repeated to there, the rest taken away by Newton
///   at a switch     impact, decision of the new status by an inclusion, projection
///   no bias         HalfExplicitGragg where an element that is held tells no bias
///   dense switches  steps of EnergyMomentum, as long as the tolerance permits (SwitchGovernor)
///
/// Extrapolated Gragg in place of Dormand and Prince needs 1.2 to 1.8 times the evaluations at
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
  /// Smooth phases by `table`, whatever the tolerance.
  LocatedDormandPrince(const Parameters& x, const ButcherTableau& table);
  /// Smooth phases by the half-explicit rule with so many columns.
  void halfExplicit(int columns) { columns_ = columns; }
  /// Event-driven as in the book, by `table`.
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
  /// x is where the last step ended: nothing has to be evaluated anew.
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
  /// After a located step: the governor may turn to steps in time.
  void govern(const MechanicalSystem& s, long evaluations, const StepReport& report);
  double locatedWork(const MechanicalSystem& s, double evaluations) const;
  double steppedWork(const MechanicalSystem& s, double evaluations, double newton) const;
  // Islands that are not, meanwhile (located_islands.cpp).
  /// A step took so much work, one with a switch or another: of whom.
  void owe(const MechanicalSystem& s, double work, bool switched);
  /// Which systems are stepped in time from x on, into timed_.
  void chooseStepped(const State& x);
  void chooseDear(std::vector<char>& chosen) const;
  bool anyQuiet() const;
  int steppedSystems() const;
  Eigen::VectorXd decidedAnew() const;
  void startQuiet(const MechanicalSystem& s, double end);
  bool quietStep(MechanicalSystem& s, InclusionSolver& solver, bool again, StepCounts& counts);
  /// Takes the quiet islands beyond steppedFrom_, at most to `end`: how far they are known.
  double followQuiet(MechanicalSystem& s, InclusionSolver& solver, double end, StepCounts& counts);
  /// Where they are at t, into quiet_.at.
  void placeQuiet(MechanicalSystem& s, double t);
  /// They go into x, the end of the step in time, unless they were touched in it.
  void joinQuiet(MechanicalSystem& s, State& x, StepReport& report);
  double nextStepped(double t) const;
  void showQuiet(double t, State& out) const;
  // What happens when it is told, and what elements switch (located_instants.cpp).
  /// How long until right before the next instant at which an element jumps by the time alone.
  double untilInstant();
  /// From right before that instant to right behind it, at most to `end`, with a decision.
  bool passInstant(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p, double end,
                   StepReport& report);
  /// A step of length h at rest says nothing about what happens in it; where it is as short as such
  /// steps become, it stands, and the report tells of it.
  bool tooLongAtRest(MechanicalSystem& s, double h, const Switch& found, StepReport& report);
  /// From a latch's root to right behind it, where its element switches.
  bool throwLatch(MechanicalSystem& s, PhasePoint& p);
  /// Takes the contacts that are reported at x for those to follow. True: what is held is gone, or
  /// what always acts is not held.
  bool relist(const State& x);
  bool evaluateEnd(MechanicalSystem& s, PhasePoint& p);
  bool event(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p, StepReport& report,
             const std::vector<HeldKey>& stopped);
  bool enter(MechanicalSystem& s, InclusionSolver& solver, const State& x, StepReport& report);
  bool goOn(MechanicalSystem& s, InclusionSolver& solver, double most, StepReport& report,
            bool& done);
  /// A trial of length h, as far as contacts let it go.
  double shortened(double h) const;
  Tried attempt(MechanicalSystem& s, double h, bool looked, StepReport& report, Switch& found);
  /// attempt() of a step of h, again up to where a gap comes near; h: the step that was tried.
  Tried tryStep(MechanicalSystem& s, double& h, StepReport& report, Switch& found);
  /// The status behind switch w at p.
  bool decide(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p, const Switch& w,
              StepReport& report);
  // The step to a switch, and what is left to its root (located_polish.cpp).
  bool repeat(MechanicalSystem& s, double h, const Switch& w);
  bool polish(MechanicalSystem& s, double h, const Switch& w);
  /// From to_ on by d: `known`, with the forces there; else they have to be evaluated.
  bool moveOn(MechanicalSystem& s, double h, double d, bool& known);
  void moveByTaylor(MechanicalSystem& s, double d);
  bool moveByDense(MechanicalSystem& s, double t);
  bool moveByStep(MechanicalSystem& s, double d);
  /// Forces at to_, and their impulse from known_ to there.
  bool settle(MechanicalSystem& s);
  /// True: an open contact penetrates at from_.
  bool closesOpen();
  /// Finds the open contacts at from_ that joints bear, and has them watched as such. False: contacts
  /// changed.
  bool leaveToJoints(MechanicalSystem& s);
  /// Adds the contacts that bodies may meet with along path_.
  bool widen();
  /// Contacts that come and go have bodies overlap at x that did not at from_.
  bool sinks(const State& x);
  /// A trial of length h comes to bodies that cannot be followed where they touch: again up to
  /// right before, or no step at all.
  Tried shortOfMeeting(double h, StepReport& report);
  double leftOverlap() const;  ///< one that is left as it is [m]
  /// The step is taken again, shorter than h. True.
  bool takeShorter(const MechanicalSystem& s, double h, const std::array<double, 5>& works,
                   StepReport& report);
  double turn();
  bool endStarts();
  /// The slip of held[i] has begun for good, for steps of length h.
  bool slipIsClear(std::size_t i, double h) const;
  /// Ends starts of slip that are none any more at from_, for a step of length h.
  bool endClearStarts(MechanicalSystem& s, double h);
  bool project(MechanicalSystem& s, PhasePoint& p);
  /// Parts whose slip ends within the tolerance, after at most `last`; steps may go on by `bound`.
  bool findStopping(double most, double& bound, double& last);
  bool stop(MechanicalSystem& s, InclusionSolver& solver, double& most, StepReport& report,
            bool& stopped);
  void release(const Switch& w);
  /// What an instant is measured by: steps at rest grow beyond any time of the motion [s].
  double span() const { return std::min(H_, norm_.time()); }
  void noteNull(const SwitchEvent::Result& r, const PhasePoint& p);
  void keepImpulses();
  void keepPercussions(double t);
  Status status(std::size_t i) const;  ///< of held[i]
  void tell(MechanicalSystem& s, State& x, StepReport& report);
  bool refuse(std::string_view why);
  bool refuse(const FrozenPhase& phase);
  /// Stalls where contact `at` comes or goes in a way that cannot be followed.
  bool lose(ContactKey at);
  /// Stalls where the set of contact `at` becomes another one (FrozenPhase::kOtherSet).
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
  /// First row at p whose γ̇ is not `found`, −1: none; toldDot_: what elements tell of all.
  int firstWrongBias(const MechanicalSystem& s, const PhasePoint& p, const Eigen::VectorXd& found);
  bool refuseBias(const MechanicalSystem& s, int row, double told, double found);

  enum class Stiff : std::uint8_t { automatic, never, always } stiff_ = Stiff::automatic;
  /// Numbers at the front of State::scheme, see located_memory.cpp.
  static constexpr int kHead = 14, kBehind = kHead + SwitchGovernor::kNumbers;
  /// Behind them and those of the governor, for each system: T of its island; what it cost in the
  /// governor's window, or whether it is stepped in time.
  Eigen::Index behindTimes() const { return kBehind + 3 * norm_.times().size(); }
  void resumeNorm(const MechanicalSystem& s, const State& x);
  /// Can x.scheme be what it left itself, as far as counts and indices go?
  bool knows(const MechanicalSystem& s, const State& x) const;
  bool knows(const MechanicalSystem& s, const Eigen::VectorXd& kept, bool quiet) const;
  Accuracy accuracy_;
  const ButcherTableau* given_ = nullptr;  // the one to take, else one that fits the tolerance
  const ButcherTableau* table_ = &dormandPrince8();
  ErrorNorm norm_;
  FrozenPhase phase_, oldPhase_;
  mutable FrozenPhase stepPhase_;   // of the last step, for its dense output
  mutable FrozenPhase afterPhase_;  // that follows it, for signals
  mutable Eigen::VectorXd shownA_;
  mutable SmoothStep smooth_;
  SmoothStep smoothOwn_;  // of short steps to a switch
  QuinticPath path_;
  ContactProbe probe_;
  SwitchSearch search_;
  SwitchEvent event_;
  PhasePoint from_, to_, trial_, stepFrom_, stepTo_;
  PhasePoint known_;           // where the forces were evaluated last on the way to a root
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
  int columns_ = 0;          // of the half-explicit rule, if it is asked for by name
  std::vector<int> untold_;  // elements without a bias, ascending
  bool foundUntold_ = false;
  std::vector<ContactKey> asked_;
  std::vector<ContactKey> borne_;                   // by joints, in this step
  double instant_ = -1e300, instantAfter_ = 1e300;  // the next one after that time [s]
  std::string_view why_;
  std::string whyOwn_;  // what why_ points to, if it names an element
  Eigen::VectorXd uBeforeImpact_, gammaDot_, toldDot_, rates_;
  std::vector<double> sums_;
  double tImpact_ = -1e300;
  long booked_ = 0;
  MechanicalSystem* system_ = nullptr;
  mutable bool denseReady_ = false;
  bool plain_ = false;  // nothing that goes beyond the book
  bool stalled_ = false, stepped_ = false;
  bool otherSet_ = false;  // stalled_ where a law's set becomes another one
  bool lost_ = false;      // stalled_ where a contact comes or goes that cannot be followed
  SwitchGovernor governor_;
  SteppedIslands steps_;
  ContactKey lastSwitched_;
  Eigen::Matrix<double, kHead, 1> head_;
  double clear_ = 1.0;  // part of the path on which no bodies meet that cannot be followed
  double passing_ = 1.0, startOverlap_ = 0.0;  // of contacts that come and go [m]
  State steppedFrom_;
  Islands islands_;
  /// Work in the governor's window that is owed to each system: of steps with its switches, of
  /// steps that its error bounded.
  Eigen::Matrix<double, Eigen::Dynamic, 2> owed_;
  std::vector<char> timed_;  // not 0: the system is stepped in time
  bool quietOnly_ = false;   // a scheme for quiet islands: it takes no steps in time itself
  /// Quiet islands: their step that goes on beyond the end of the last step in time.
  struct Quiet {
    std::unique_ptr<LocatedDormandPrince> scheme;
    State from, to, at;
    mutable State shown;
    double end = 0.0;      // as far as it might have gone
    Eigen::VectorXd kept;  // `from` and `end` as numbers
    StepWorks works;
    bool known = false;
  } quiet_;
  Eigen::VectorXd quietKept_;
  std::vector<char> apart_;  // not 0: the system is quiet
};

}  // namespace dynamy
