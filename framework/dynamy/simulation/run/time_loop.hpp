/// TimeLoop: determines the sequence of accepted steps. Simulation drives observers and reports; a
/// loop only proposes steps: of a fixed length (FixedStep), or those that the scheme chooses itself
/// (OwnSteps).
#pragma once
#include <algorithm>
#include <dynamy/core/archive.hpp>
#include <dynamy/simulation/model/settings.hpp>
#include <dynamy/simulation/model/time_grid.hpp>
#include <dynamy/simulation/run/sample_instants.hpp>
#include <dynamy/simulation/run/step_budget.hpp>
#include <dynamy/simulation/run/step_division.hpp>
#include <dynamy/stages/sweep.hpp>
#include <utility>

namespace dynamy {

/// What all attempts and searches of a run have cost so far.
struct Spent {
  long evaluations = 0;   ///< of M, h and contacts
  double work = 0.0;      ///< in evaluations of one velocity (theory 37.7)
  double implicit = 0.0;  ///< of it the work of forces that are taken implicitly
};

/// How an attempt is made.
enum class StepTry : std::uint8_t {
  whole,  ///< where the scheme solves shorter parts alone, it ends after the first one
  part,   ///< one of these parts that is not to be divided any more
  cheap   ///< at a small cost, because the full step has used up its work; the run reports this
};

/// The interface through which a loop takes steps.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Takes one step of the scheme from the current state, of length dt to the instant tEnd (t + dt
  /// up to rounding). Schemes that choose their steps may stop earlier, others after a part. The state
  /// before the step is kept until accept() or reject().
  virtual StepReport attempt(double tEnd, double dt, StepTry how) = 0;
  /// Accepts the attempted step; observers see it. False: the run is to end (failed or stopped).
  virtual bool accept() = 0;
  /// Goes back to the state before the attempt.
  virtual void reject() = 0;
  /// Ends the run as failed: an inclusion missed its tolerance. Always false.
  virtual bool fail(const StepReport& report) = 0;
  /// True if the attempted state holds no NaN and no infinity, and no mass was indefinite.
  virtual bool sound() const = 0;
  /// How coarse the attempted step is for the motion.
  virtual Coarseness coarseness() = 0;
  /// The last full step was taken in up to `parts` equal parts, because it was too coarse.
  virtual void divided(int parts) = 0;
  /// The first contact that the attempted step went through, if any (theory 37). With `ahead` > 0
  /// [s]: that a step of this length would go through, if velocities remained.
  virtual Passing passing(double ahead = 0.0) = 0;
  /// The rest of the present full step is taken without a search for passed contacts, because there
  /// were too many; `p` is the last one. The run continues and reports this.
  virtual void leave(const Passing& p) = 0;
  virtual double t() const = 0;
  /// Length that the scheme would try next [s]; 0: it does not choose its steps, or does not know
  /// yet.
  virtual double nextStep() const = 0;
  virtual Spent spent() const = 0;
  /// Called between two full steps of the loop: a run can be resumed from a state archived here.
  /// `asked`: archive it in any case, because the next step is shortened by the end time. False:
  /// the run is to end.
  virtual bool pause(bool asked) = 0;
};

/// True: a run at time t has reached this instant, up to rounding.
bool isPassed(double instant, double t);

/// Result of TimeLoop::next().
enum class Advance {
  taken,   ///< there is a new state
  atEnd,   ///< nothing was left to take: `until` is reached
  stopped  ///< the run is to end earlier
};

class TimeLoop {
 public:
  virtual ~TimeLoop() = default;
  /// Takes one step towards `until`, with all its tries, halves and parts.
  virtual Advance next(Stepper& stepper, double until) = 0;
  virtual void archive(Archive& a) = 0;
};

/// Limit on the tries of one kind that a step may take. Steps that stay within their limit raise it
/// up to `most`, other steps lower it. Many steps in a row whose tries fail cost about one try
/// each. What steps leave unused may be saved for a step that needs more: the mean stays bounded.
class Allowance {
 public:
  /// `saves`: number of steps whose tries can be saved at most; a run begins with a share of them.
  /// No step takes more than `most` tries, saved ones included.
  explicit Allowance(int most, double saves = 0.0)
      : most_(most), now_(most), saves_(saves), saved_(kSavedAtFirst * saves) {}
  /// Begins a step. If the last step exceeded its limit, the new limit is a quarter of it, one at
  /// least; otherwise it is twice as large, up to `most`, and its unused tries are saved.
  void begin();
  /// Uses up one try, a saved one beyond the limit; false: none is left.
  bool take();
  /// Limits the present step to n tries at most.
  void atMost(int n) {
    if (!exhausted()) taken_ = std::min(taken_, n);
    now_ = std::min(now_, n);
  }
  /// Leaves the present step no further tries.
  void exhaust() { taken_ = now_ + 1; }
  bool exhausted() const { return taken_ > now_; }
  void archive(Archive& a);

 private:
  static constexpr double kSavedAtFirst = 0.4;
  int most_, now_, taken_ = 0;
  int drawn_ = 0;         // saved tries that the present step has taken
  double saves_, saved_;  // in steps of the present limit
};

/// Number of parts of a step of a model with nu velocities, each of which costs `evaluations`
/// evaluations of all bodies, within the budget of a step.
long partsWithinWork(int nu, long evaluations);
/// The same with 144 000 velocities for the tries of a step whose length the scheme chooses: there
/// may always be 8 of them, and never more than 2000.
int mostParts(int nu, long evaluations);

/// Steps of length Δt from a counter: t = iΔt, the last one is shortened to end at `until`; if
/// `until` is moved ahead after that, the remainder of this step comes first. A step
/// that would pass a contact is taken in parts: up to the contact, across it in a very short part,
/// and the rest. A step whose inclusion is not solved is taken in halves. The smallest length of a
/// part, the allowances and the budget of the step limit both; beyond them the rest of the step is
/// taken as it is, and beyond the budget at a small cost.
class FixedStep final : public TimeLoop {
 public:
  /// `nu`: number of velocities of the model, which limits the parts of a step.
  /// `divides`: steps that are too coarse are divided into equal parts. Steps end at `samples`.
  FixedStep(double dt, NonConvergence policy, int nu, bool divides = false,
            SampleInstants samples = {})
      : grid_(dt),
        samples_(std::move(samples)),
        policy_(policy),
        nu_(nu),
        division_(divides),
        budget_(nu) {}
  Advance next(Stepper& stepper, double until) override;
  void archive(Archive& a) override;

 private:
  /// Finds a contact that a step would pass. Without fast bodies in the last steps, nothing is
  /// looked for: the step itself shows it.
  Passing ahead(Stepper& stepper, double dt);
  /// Finds a contact that the attempted step has passed.
  Passing passed(Stepper& stepper);
  /// Takes a full step up to each instant at which an element samples the motion, and to tEnd.
  bool sampled(Stepper& stepper, double tEnd, double dt);
  /// Takes a full step, in as many equal parts as the last one needed.
  bool full(Stepper& stepper, double tEnd, double dt);
  /// Number of equal parts into which the attempted step of length dt is to be divided; 1: none.
  /// `evaluations`: what one part costs, in evaluations of all bodies.
  int partsOf(Stepper& stepper, double dt, long evaluations);
  /// Takes a step in n equal parts.
  bool divide(Stepper& stepper, double tEnd, double dt, int n);
  /// Takes one step with the policy for missed tolerances; it has been halved `depth` times so far. The scheme may
  /// end it early as long as its part is longer than `shortest` [s]; 0: an eighth of dt.
  bool advance(Stepper& stepper, double tEnd, double dt, int depth, double shortest = 0.0);
  /// The other n parts of length dt of a step that the scheme has ended after one.
  bool goOn(Stepper& stepper, double tEnd, double dt, int n, int depth, double shortest);
  /// Takes a step in parts, such that the contact of `p` closes in a part that is too short to
  /// matter.
  bool inParts(Stepper& stepper, const Passing& p, double tEnd, double dt, int depth);
  TimeGrid grid_;
  SampleInstants samples_;
  NonConvergence policy_;
  long i_ = 0;  // full steps done
  int nu_;
  StepDivision division_;
  double whole_ = 0.0;  // length of the present full step [s]
  StepBudget budget_;
  int quiet_ = 1 << 20;  // full steps since one was taken in parts
  Allowance parts_{2000, 50.0}, halves_{24};
  bool first_ = true;  // no attempt yet
  bool rest_ = false;  // a step that the end has shortened was taken
};

}  // namespace dynamy
