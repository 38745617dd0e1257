/// SwitchGovernor: decides when to locate switches, and when to take steps in time without locating
/// them because locating costs more than it brings (theory 50.7).
///
///   work of steps with a switch over a window  >    2 Δt/h₁ · work of a step in time,  h₁ = tol T
///   work of all steps                          >  100 Δt/h₁ · work of a step in time
///   or: several windows in turn have covered hardly any time
///   or: steps have become too short to continue                         ⇒  steps in time
///   after a while in which switches were rare                           ⇒  switches are located
///
/// Work is estimated in floating-point operations of evaluations and solves, never in seconds: a
/// run repeats bit by bit. A run that returns to locating and soon has to leave it again takes
/// steps in time for twice as long, so that such attempts cost only a share of the work. Islands
/// that do not make locating expensive continue to be located: one governor decides for the others.
#pragma once
#include <dynamy/core/number_archive.hpp>
#include <dynamy/located/governed/step_patience.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class SwitchGovernor {
 public:
  enum class Mode : std::uint8_t { locate, step, decideAnew };
  /// What is kept from step to step.
  void archive(NumberArchive& a);

  /// T: the motion's time [s].
  void scales(double tolerance, double T) { tolerance_ = tolerance, T_ = T; }

  Mode mode() const { return mode_; }
  TurnedBy turnedBy() const { return turnedBy_; }
  /// The contact that switched last before the governor turned to steps in time; kNowhere: none.
  ContactKey turnedAt() const { return turnedAt_; }
  static constexpr ContactKey kNowhere{~std::uint64_t{0}};
  void told() { turnedBy_ = TurnedBy::none; }

  // While switches are located.
  /// Notes a located step that ended at t, and turns to steps in time where these are cheaper.
  /// `stepWork`: work of one step in time; `switched`: the located step ended at a switch; `at`:
  /// the contact that switched last. True: a window is over.
  bool located(double t, double dt, long evaluations, double work, double stepWork, bool switched,
               ContactKey at);
  /// Turns to steps in time from t on because the run, which ends at `end`, has no patience left.
  void giveUp(double t, double end, ContactKey at);
  /// Right after a turn by density: work in a window that located islands may still cost. It counts
  /// all steps if the motion was too fast even without switches, else those with a switch.
  double bearable() const { return bearable_; }
  bool tooFast() const { return tooFast_; }
  /// Turns to steps in time from t on.
  void turn(double t, TurnedBy why, ContactKey at);
  /// Right after a turn: the work of a switch, were it located.
  void switchCosts(double work) { oneSwitch_ = work; }
  /// Locates switches, decides everything anew at the next step, or leaves the time to clocks of
  /// islands: nothing is stepped in time yet.
  void mode(Mode mode) { mode_ = mode; }

  // While steps are taken in time.
  double h() const { return h_; }
  Effort effort(Effort usual) const { return patience_.effort(usual); }
  double least() const { return patience_.least(tolerance_, T_); }
  /// Notes that a step of length h was too long; `error`: its error in units of the tolerance.
  void shorten(double h, double error);
  /// Notes that a step of length h was taken; `again`: after having been shortened; `evaluations`:
  /// as many as its work is worth; `end`: of the run [s].
  void stepped(double t, double h, double error, double work, bool again, double evaluations,
               double end);

 private:
  double factor(double error) const;
  double tolerance_ = 1e-6, T_ = 1.0;
  Mode mode_ = Mode::locate;
  TurnedBy turnedBy_ = TurnedBy::none;
  ContactKey turnedAt_ = kNowhere;
  double h_ = 0.0;                   // length of steps in time [s]
  double began_ = 0.0, stay_ = 0.0;  // begin of the present mode; least duration of stepping [s]
  struct Window {
    double time = 0.0, work = 0.0;  // duration [s] and work of its located steps
    double evaluations = 0.0, stepWork = 0.0;
    double switchWork = 0.0;  // work of steps with a switch
  };
  Window window_;
  double creeping_ = 0.0;   // windows in turn that have covered hardly any time
  bool crept_ = false;      // they alone were the reason of the last turn
  double oneSwitch_ = 0.0;  // work of a switch, as of the last turn
  double bearable_ = 0.0;   // not stored with a state: of use right after a turn alone
  bool tooFast_ = false;
  double switches_ = 0.0, stepWork_ = 0.0;  // shortened steps, and work, of stepping since began_
  StepPatience patience_;
};

}  // namespace dynamy
