/// TimeLoop: how accepted steps follow each other. Simulation drives observers and reports; a loop
/// only proposes steps, so that fixed steps, augmented stepping and event location are one file
/// each.
#pragma once
#include <algorithm>
#include <dynamy/core/archive.hpp>
#include <dynamy/simulation/model/settings.hpp>
#include <dynamy/simulation/model/time_grid.hpp>
#include <dynamy/stages/sweep.hpp>

namespace dynamy {

/// What a loop works with.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// One step of the scheme from the current state, of length dt to the instant tEnd (= t + dt but
  /// for rounding). Schemes that choose their steps may stop earlier. The state before stays at
  /// hand until accept() or reject().
  virtual StepReport attempt(double tEnd, double dt) = 0;
  /// Takes the attempted step; observers see it. False: the run is to end (failed or stopped).
  virtual bool accept() = 0;
  /// Goes back to the state before the attempt.
  virtual void reject() = 0;
  /// Ends the run as failed: an inclusion missed its tolerance. Always false.
  virtual bool fail(const StepReport& report) = 0;
  /// True if the attempted state holds no NaN and no infinity, and no mass was indefinite.
  virtual bool sound() const = 0;
  /// The first contact that the attempted step went through, if any (theory 37).
  virtual Passing passing() = 0;
  /// The rest of the present full step is taken without looking for passings: `p` is the last of
  /// too many. The run goes on, and reports it.
  virtual void leave(const Passing& p) = 0;
  virtual double t() const = 0;
  /// Length that the scheme would try next [s]; 0: it has no say, or does not know.
  virtual double nextStep() const = 0;
  /// Of M, h and contacts, in all attempts up to now.
  virtual long evaluations() const = 0;
  /// Between two full steps of the loop: what is archived here can be resumed. `asked`: keep it in
  /// any case, because the next step is shortened by the end time. False: the run is to end.
  virtual bool pause(bool asked) = 0;
};

/// What the next step of a loop came to.
enum class Advance {
  taken,   ///< there is a new state
  atEnd,   ///< nothing was left to take: `until` is reached
  stopped  ///< the run is to end earlier
};

class TimeLoop {
 public:
  virtual ~TimeLoop() = default;
  /// One step towards `until`, with all its tries, halves and parts.
  virtual Advance next(Stepper& stepper, double until) = 0;
  virtual void archive(Archive& a) = 0;
};

/// How many tries of one kind a step may take: all of them after steps that got along with what
/// they had, else fewer. A run of steps that try in vain costs about one try a step.
class Allowance {
 public:
  explicit Allowance(int most) : most_(most), now_(most) {}
  /// A step begins. It has a quarter of what the last one had, one at least, if that did not get
  /// along; else twice as many.
  void begin();
  /// Takes one; false: there is none left.
  bool take();
  /// The present step has n at most.
  void atMost(int n) { now_ = std::min(now_, n); }
  /// The present step has none left, whatever it took.
  void exhaust() { taken_ = now_ + 1; }
  bool exhausted() const { return taken_ > now_; }
  void archive(Archive& a);

 private:
  int most_, now_, taken_ = 0;
};

/// Most parts that one step of a model of nu velocities is cut into for fast bodies, if each costs
/// so many evaluations of all bodies: 14400 of evaluations times velocities, but 8 to 200 parts.
int mostParts(int nu, long evaluations);

/// Steps of length Δt from a counter: t = iΔt, the last one shortened to end at `until`. A step
/// that would pass a contact is taken in parts: up to it, across it in a moment, and the rest; one
/// whose inclusion is not solved in halves. Both have an end, after which the rest of the step is
/// taken as it is: a part of the smallest length that is not solved, or what the allowances say.
class FixedStep final : public TimeLoop {
 public:
  /// `nu`: velocities of the model, which bound the parts of a step, see mostParts().
  FixedStep(double dt, NonConvergence policy, int nu) : grid_(dt), policy_(policy), nu_(nu) {}
  Advance next(Stepper& stepper, double until) override;
  void archive(Archive& a) override;

 private:
  /// One step with the policy for missed tolerances; `depth` halvings so far.
  bool advance(Stepper& stepper, double tEnd, double dt, int depth);
  /// The same in parts, with the closing of `p` in one that is too short to matter.
  bool inParts(Stepper& stepper, const Passing& p, double tEnd, double dt, int depth);
  TimeGrid grid_;
  NonConvergence policy_;
  long i_ = 0;  // full steps done
  int nu_;
  Allowance parts_{200}, halves_{24};
  bool rest_ = false;  // the last, shortened step is taken
};

}  // namespace dynamy
