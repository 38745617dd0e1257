/// RunReport: the figures of a run, by what they are about.
#pragma once
#include <algorithm>
#include <cstdint>
#include <dynamy/simulation/report/energy_ledger.hpp>
#include <string>

namespace dynamy {

/// The worst value of a figure, with its contact and its time.
struct Worst {
  double value = 0.0;
  double t = 0.0;  ///< [s]
  ContactKey contact;
  std::string name;  ///< of the contact; filled at the end of the run
  void archive(Archive& a) { a(value), a(t), a(contact), a(name); }
};

/// Default tolerance of solvers. An unsolved step with a residual up to this value missed something
/// else: a projection, or the scheme's own iteration.
inline constexpr double kSolvedResidual = 1e-10;

/// The unsolved inclusion with the largest residual, and the cause as far as it is known.
struct Unsolved {
  long step = 0;   ///< its number, from 1; 0: all were solved
  double t = 0.0;  ///< end of the step [s]
  double residual = 0.0;
  int iterations = 0;
  std::string status;    ///< "stalled", …
  std::string contact;   ///< name and place of the one with the largest residual
  std::string tried;     ///< the methods and what each left
  std::string findings;  ///< of the diagnosis, one line each: the cause, then the advice
  void archive(Archive& a) {
    a(step), a(t), a(residual), a(iterations), a(status), a(contact), a(tried), a(findings);
  }
};

/// How far the figures of a run can be trusted; RunWatch has the formulas.
struct RunTrust {
  double kineticMax = 0.0;                          ///< largest T seen [J]
  double stepEnergy = 0.0;                          ///< most that forces alone give in a step [J]
  double energyError = 0.0, energyErrorTime = 0.0;  ///< [J], [s]
  double energyRise = 0.0, energyRiseTime = 0.0;    ///< above the start [J], [s]
  /// T + V rose by kDiverged times all that the run began with and all works, and nothing brought it
  /// in: its numbers say nothing, and it ends (theory 6.3).
  bool diverged = false;
  static constexpr double kDiverged = 1e12;
  /// Largest rise of T + V above its lowest level so far, as far as the scheme itself caused it
  /// [J], and its time [s].
  double energyGain = 0.0, energyGainTime = 0.0;
  double regain = 0.0;    ///< largest rise of T + V above its lowest level so far, of any cause [J]
  double gainStep = 0.0;  ///< largest energy of the forces in a step since that level [J]
  double omegaDt = 0.0;   ///< resolution of smooth motion
  double turn = 0.0;      ///< [rad]
  double way = 0.0;       ///< distance of the fastest frame in a step [m]
  double fall = 0.0;      ///< distance by the forces alone in a step [m]
  double leap = 0.0;      ///< distance in a step over the sizes of shapes
  /// Steps after which velocities were reduced, since they gained energy.
  struct Slowed {
    long steps = 0;
    double most = 0.0, t = 0.0;  ///< most energy taken [J], when [s]
  };
  Slowed slowed;
  int damped = 0;  ///< most forces that one step does not resolve and takes at its end
  /// Energy that steps without an impact took from such forces by damping them [J].
  double dampedLoss = 0.0;
  /// Error of the energies by rounding [J]; changes below it are not reported (RunWatch).
  double rounding = 0.0;
  /// Scale that changes of energy are compared with [J]; kWarned times this scale is never below
  /// `rounding`.
  double energyScale() const { return std::max({kineticMax, stepEnergy, rounding / kWarned}); }
  /// Scale that energyGain is compared with [J]: forces that had ended before the gain began do not
  /// count.
  double gainScale() const { return std::max({kineticMax, gainStep, rounding / kWarned}); }
  static constexpr double kWarned = 0.01;  ///< share of the scale above which changes are reported
  void archive(Archive& a);
};

/// A reason not to trust the figures of a run.
struct Warning {
  std::string kind;        ///< one of warningKinds(): "energy", "overlap", …
  std::string text;        ///< what, where, when; what to do
  long count = 1;          ///< how often: inclusions, impacts, periods, …
  double t = 0.0;          ///< of the worst, or the first [s]
  std::string place = {};  ///< contact or joint by its name; empty: the scene as a whole
};

/// Corrections that bring the initial state onto the joints (ConsistentStart).
struct StartReport {
  /// Errors and corrections of positions [m, rad] or of velocities [m/s, rad/s].
  struct Part {
    double off = 0.0;   ///< largest error of a joint's row as the model gives it
    double left = 0.0;  ///< the same afterwards; positions that cannot be met stay as they were
    /// For velocities: size of the change over the larger of the sizes before and after it, in the
    /// metric of the mass.
    double share = 0.0;
    long joints = 0;      ///< joints that were off by more than rounding of a file's numbers
    std::string joint;    ///< the joint that was off by most, with its place
    std::string against;  ///< the joint with the largest error left, with its place; empty: none
    void archive(Archive& a) { a(off), a(left), a(share), a(joints), a(joint), a(against); }
  };
  Part positions, velocities;
  double kineticBefore = 0.0;  ///< with the velocities of the model [J]
  double kineticAfter = 0.0;   ///< with those that the run starts with [J]
  std::string kept;            ///< what the model keeps, its names; empty: nothing
  void archive(Archive& a) {
    a(positions), a(velocities), a(kineticBefore), a(kineticAfter), a(kept);
  }
};

/// Periods of time stepping, in which switches were too dense to be located.
struct SteppingReport {
  long periods = 0, steps = 0;
  int systems = 0;       ///< most systems stepped at once; switches of the others were located
  long stalls = 0;       ///< periods that began because no step was short enough
  long impatient = 0;    ///< periods that began because the work of the run was used up
  double time = 0.0;     ///< all periods together [s]
  double longest = 0.0;  ///< step [s]
  double error = 0.0;    ///< largest estimated error of a step, in units of the tolerance
  double total = 0.0;    ///< sum of these errors
  Worst first;           ///< when the first period began and the contact that switched there
  void archive(Archive& a) {
    a(periods), a(steps), a(systems), a(stalls), a(impatient), a(time), a(longest), a(error),
        a(total), a(first);
  }
};

/// How the inclusions of accepted steps were solved.
struct SolverReport {
  long solves = 0;  ///< inclusions with at least one contact
  long iterations = 0;
  int iterationsMax = 0;
  long unconverged = 0;  ///< accepted steps whose inclusion missed its tolerance
  Unsolved unsolved;
  Worst residual;  ///< largest of E_f, E_u
  double iterationsMean() const {
    return solves > 0 ? static_cast<double>(iterations) / static_cast<double>(solves) : 0.0;
  }
  void archive(Archive& a) {
    a(solves), a(iterations), a(iterationsMax), a(unconverged), a(unsolved), a(residual);
  }
};

/// What happened at the contacts.
struct ContactReport {
  int most = 0;  ///< largest number of closed contacts in a step
  long impacts = 0;
  long switches = 0;         ///< changes of a contact's status
  long repairedImpacts = 0;  ///< groups of contacts whose impact would have gained energy
  Worst energyGain;          ///< the largest such gain, before the repair [J]
  void archive(Archive& a) { a(most), a(impacts), a(switches), a(repairedImpacts), a(energyGain); }
};

/// Gaps at positions that contacts and joints should not reach.
struct GapReport {
  Worst penetration;    ///< −g of unilateral contacts, at ends of steps as well [m]
  Worst atStart;        ///< the same of the initial state [m]
  Worst solvedOverlap;  ///< −g only where steps solve for their forces [m]
  Worst jointError;     ///< position error of joints at ends of steps [m]
  void archive(Archive& a) { a(penetration), a(atStart), a(solvedOverlap), a(jointError); }
};

/// Steps taken in parts: they were too long for the motion, or fast bodies would have passed a
/// contact (theory 37).
struct PassingReport {
  long swept = 0;    ///< attempted steps whose path was searched for fast bodies
  long divided = 0;  ///< full steps taken in equal parts, because they were too long
  int finest = 1;    ///< most of these parts
  long parted = 0;   ///< steps taken in parts, because a body would have passed a contact
  long left = 0;     ///< steps with too many parts, whose rest was taken without a search
  long bounded = 0;  ///< full steps that used up their work: the rest was taken at a small cost
  Worst firstLeft;   ///< first step counted by `left`, and the contact passed; no value
  /// Without `swept`: a resumed run counts its own.
  void archive(Archive& a) { a(divided), a(finest), a(parted), a(left), a(bounded), a(firstLeft); }
};

/// Steps that a simpler scheme took, StepReport::simpler.
struct SimplerReport {
  long steps = 0;
  double firstEnd = 0.0;  ///< end of the first of these steps [s]
  void archive(Archive& a) { a(steps), a(firstEnd); }
};

/// Switches of a scheme that locates their instants.
struct LocatedReport {
  long switches = 0;             ///< switches whose instants were located
  long islands = 0;              ///< most islands with steps of their own at once
  long accumulations = 0;        ///< infinite sequences of impacts that were passed
  double accumulationEnd = 0.0;  ///< when the last of them comes to rest [s]
  long undecided = 0;            ///< switches at which no status was consistent, or several were
  Worst unseen;  ///< longest step at rest while forces changed between its looks [s]
  void archive(Archive& a) {
    a(switches), a(islands), a(accumulations), a(accumulationEnd), a(undecided), a(unseen);
  }
};

/// Bodies at rest that steps left out (theory 58). A system of several bodies counts as one.
struct SleepReport {
  long asleep = 0, most = 0;  ///< systems, at the end and at once
  long slept = 0, woken = 0;  ///< how often a system fell asleep, and woke
  long saved = 0, all = 0;    ///< steps of systems that were left out, and with them all
  double energy = 0.0;        ///< taken by u := 0 [J]
  std::string reason;         ///< why nothing may sleep in this run; empty: something may
  void archive(Archive& a) { a(asleep), a(most), a(slept), a(woken), a(saved), a(all), a(energy); }
};

/// What a run has cost.
struct CostReport {
  long evaluations = 0;          ///< of M, h and contacts
  StepEffort effort;             ///< evaluations of a scheme that chooses its steps, by purpose
  double cpu = 0.0, wall = 0.0;  ///< [s]
  SleepReport sleep;
  void archive(Archive& a);
};

struct RunReport {
  enum class Ended { finished, stopped, failed };
  /// Kinds of failures; the last two would not have happened on a larger machine.
  enum class Cause { simulation, memory, files };
  Ended ended = Ended::finished;
  Cause cause = Cause::simulation;
  std::string reason;    ///< why it failed; empty: it did not
  bool refused = false;  ///< it failed because the scheme does not admit the scene
  double t = 0.0;        ///< time reached [s]

  long steps = 0;     ///< accepted
  long rejected = 0;  ///< tries that were not accepted
  SimplerReport simpler;
  PassingReport passing;
  LocatedReport located;
  SteppingReport stepping;
  SolverReport solver;
  ContactReport contacts;
  GapReport gaps;
  EnergyReport energy;
  RunTrust trust;
  StartReport start;
  CostReport cost;
  std::vector<Warning> warnings;  ///< at the end of the run
  std::uint64_t hash = 0;         ///< of the motion: MotionHash

  /// True: a warning says that the run is not what the model asks for (WarningKind::qualifies).
  bool qualified() const;
  /// Without what is known at the end only: `energy`, `warnings`, `hash` and how it ended.
  void archive(Archive& a);
};

}  // namespace dynamy
