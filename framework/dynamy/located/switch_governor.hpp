/// SwitchGovernor: where locating every switch costs more than it brings, steps are taken in time
/// without locating anything, and back (theory 50.7).
///
///   work of steps with a switch over a window  >    2 Δt/h₁ · work of a step in time,  h₁ = tol T
///   work of all steps                          >  100 Δt/h₁ · work of a step in time
///   or: steps have become too short at all                              ⇒  steps in time
///   after a while in which switches were rare                           ⇒  switches are located
///
/// Work is counted in floating-point operations that evaluations and solves stand for, never in
/// seconds: a run repeats bit by bit. Whoever comes back and has to leave again soon stays away
/// twice as long, so that the attempts cost no more than a share. Islands whose switches are not
/// what makes it dear go on being located: one governor decides for those that are.
#pragma once
#include <array>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class SwitchGovernor {
 public:
  enum class Mode : std::uint8_t { locate, step, decideAnew };
  /// All that is kept from step to step, to be stored with a state.
  static constexpr int kNumbers = 17;
  std::array<double, kNumbers> numbers() const;
  void numbers(const double* from);

  /// T: the motion's time [s].
  void scales(double tolerance, double T) { tolerance_ = tolerance, T_ = T; }
  void reset() { *this = SwitchGovernor(tolerance_, T_); }
  SwitchGovernor() = default;

  Mode mode() const { return mode_; }
  TurnedBy turnedBy() const { return turnedBy_; }
  /// The contact that switched last when it turned; kNowhere: none had.
  ContactKey turnedAt() const { return turnedAt_; }
  static constexpr ContactKey kNowhere{~std::uint64_t{0}};
  void told() { turnedBy_ = TurnedBy::none; }

  // While switches are located.
  /// A step that ended at t: turns to steps in time where that is cheaper. `stepWork`: of one
  /// of those; `switched`: it ended at a switch; `at`: the contact that switched last.
  /// True: a window is over.
  bool located(double t, double dt, long evaluations, double work, double stepWork, bool switched,
               ContactKey at);
  /// Right after it turned by density: work in a window that may go on being located, all of it if
  /// it was too fast even without switches, else that of steps with a switch.
  double bearable() const { return bearable_; }
  bool tooFast() const { return tooFast_; }
  /// Steps in time from t on.
  void turn(double t, TurnedBy why, ContactKey at);
  /// From now on switches are located again.
  void locate() { mode_ = Mode::locate; }

  // While steps are taken in time.
  double h() const { return h_; }
  double least() const;
  /// The step was too long by its error, in units of the tolerance.
  void shorten(double h, double error);
  /// It was taken; `again`: after having been shortened. Where so many evaluations have led next to
  /// nowhere, the least step becomes longer: what the tolerance asks for is not to be had.
  void stepped(double t, double h, double error, double work, bool again, double switchWork,
               long evaluations);

 private:
  SwitchGovernor(double tolerance, double T) : tolerance_(tolerance), T_(T) {}
  double factor(double error) const;
  double tolerance_ = 1e-6, T_ = 1.0;
  Mode mode_ = Mode::locate;
  TurnedBy turnedBy_ = TurnedBy::none;
  ContactKey turnedAt_ = kNowhere;
  double h_ = 0.0;                   // of steps in time [s]
  double began_ = 0.0, stay_ = 0.0;  // the present mode; how long steps are taken in time [s]
  double window_ = 0.0, windowWork_ = 0.0;  // of located switches: time and work
  double windowEvaluations_ = 0.0, windowStepWork_ = 0.0;
  double switchWork_ = 0.0;  // that of steps with a switch
  double bearable_ = 0.0;    // not kept: of use right after a turn
  bool tooFast_ = false;
  double switches_ = 0.0, stepWork_ = 0.0;  // while stepping, since began_
  void watchProgress(double h, long evaluations);
  double longer_ = 1.0;                 // times the least step of the tolerance
  double spent_ = 0.0, covered_ = 0.0;  // since it changed: evaluations, time [s]
};

}  // namespace dynamy
