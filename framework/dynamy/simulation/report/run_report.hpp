/// RunReport: the figures of a run, and the observer that counts them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <dynamy/simulation/report/energy_ledger.hpp>
#include <dynamy/simulation/report/record_sink.hpp>
#include <dynamy/simulation/report/step_impacts.hpp>
#include <string>

namespace dynamy {

/// A worst value with where and when.
struct Worst {
  double value = 0.0;
  double t = 0.0;  ///< [s]
  ContactKey contact;
  std::string name;  ///< of the contact; filled at the end of the run
  void archive(Archive& a) { a(value), a(t), a(contact), a(name); }
};

/// A step with a residual up to this, the default tolerance of solvers, that was not solved all the
/// same missed something else: a projection, the scheme's own iteration.
inline constexpr double kSolvedResidual = 1e-10;

/// The inclusion that was missed by most, and why as far as it can be told.
struct Unsolved {
  long step = 0;   ///< its number, from 1; 0: all were solved
  double t = 0.0;  ///< end of the step [s]
  double residual = 0.0;
  int iterations = 0;
  std::string status;    ///< "stalled", …
  std::string contact;   ///< name and place of the one with the largest residual
  std::string tried;     ///< the methods and what each left
  std::string findings;  ///< of the diagnosis, a line each: what is the case, what to do
  void archive(Archive& a) {
    a(step), a(t), a(residual), a(iterations), a(status), a(contact), a(tried), a(findings);
  }
};

/// What the figures of a run can be trusted for; RunWatch has the formulas.
struct RunTrust {
  double kineticMax = 0.0;                          ///< largest T seen [J]
  double stepEnergy = 0.0;                          ///< what the forces alone give in a step [J]
  double energyError = 0.0, energyErrorTime = 0.0;  ///< [J], [s]
  double energyRise = 0.0, energyRiseTime = 0.0;    ///< above the start [J], [s]
  /// Above the lowest level so far, as far as the scheme itself brought it in [J], [s].
  double energyGain = 0.0, energyGainTime = 0.0;
  double gainStep = 0.0;  ///< what forces gave in a step since that level [J]
  double omegaDt = 0.0;   ///< resolution of smooth motion
  double turn = 0.0;      ///< [rad]
  double way = 0.0;       ///< of the fastest frame in a step [m]
  double fall = 0.0;      ///< by the forces alone in a step [m]
  double leap = 0.0;      ///< way in a step over the sizes of shapes
  /// What rounding leaves of energies [J]; nothing below it is reported (RunWatch).
  double rounding = 0.0;
  /// What energies are compared with [J]; kWarned of it is never below `rounding`.
  double energyScale() const { return std::max({kineticMax, stepEnergy, rounding / kWarned}); }
  /// The same for energyGain: forces that were gone when it began are no measure of it.
  double gainScale() const { return std::max({kineticMax, gainStep, rounding / kWarned}); }
  static constexpr double kWarned = 0.01;  ///< of the scale: changes of energy above are reported
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

/// What had to be changed so that a run starts on its joints (ConsistentStart).
struct StartReport {
  /// Of positions [m, rad] or velocities [m/s, rad/s].
  struct Part {
    double off = 0.0;   ///< largest error of a joint's row as the model gives it
    double left = 0.0;  ///< the same afterwards; positions that cannot be met stay as they were
    /// Of velocities: size of the change over the larger of both, in the metric of the mass.
    double share = 0.0;
    long joints = 0;      ///< that were off by more than rounding of a file's numbers
    std::string joint;    ///< the one that was off by most, with its place
    std::string against;  ///< the one that is left off by most, with its place; empty: none is
    void archive(Archive& a) { a(off), a(left), a(share), a(joints), a(joint), a(against); }
  };
  Part positions, velocities;
  double kineticBefore = 0.0;  ///< with the velocities of the model [J]
  double kineticAfter = 0.0;   ///< with those that the run starts with [J]
  void archive(Archive& a) { a(positions), a(velocities), a(kineticBefore), a(kineticAfter); }
};

/// Where switches were too dense to be located, and steps in time took their place.
struct SteppingReport {
  long periods = 0, steps = 0;
  int systems = 0;       ///< most that were stepped at once; switches of the others were located
  long stalls = 0;       ///< periods that began because no step was short enough
  double time = 0.0;     ///< all periods together [s]
  double longest = 0.0;  ///< step [s]
  double error = 0.0;    ///< largest estimated error of a step, in units of the tolerance
  Worst first;           ///< when the first period began and the contact that switched there
  void archive(Archive& a) {
    a(periods), a(steps), a(systems), a(stalls), a(time), a(longest), a(error), a(first);
  }
};

struct RunReport {
  enum class Ended { finished, stopped, failed };
  /// What a failure is one of; the last two would not have happened on a larger machine.
  enum class Cause { simulation, memory, files };
  Ended ended = Ended::finished;
  Cause cause = Cause::simulation;
  std::string reason;    ///< why it failed; empty: it did not
  bool refused = false;  ///< it failed because the scheme does not admit the scene
  double t = 0.0;        ///< time reached [s]

  long steps = 0, rejected = 0;
  long swept = 0;    ///< attempted steps whose path was looked along for fast bodies
  long parted = 0;   ///< steps taken in parts, because a body would have passed a contact
  long left = 0;     ///< steps of so many parts that the rest was taken without looking
  Worst firstLeft;   ///< of these the first, and the contact that was passed; no value
  int damped = 0;    ///< most forces at a time that steps do not resolve and take at their end
  long simpler = 0;  ///< steps that a simpler scheme took, StepReport::simpler
  double firstSimpler = 0.0;  ///< where the first of these ends [s]
  long evaluations = 0;       ///< of M, h and contacts
  long solves = 0;            ///< inclusions with at least one contact
  long iterations = 0;
  int iterationsMax = 0;
  long unconverged = 0;  ///< accepted steps whose inclusion missed its tolerance
  long impacts = 0, switches = 0;
  long located = 0;              ///< switches whose instants were located
  long accumulations = 0;        ///< infinite sequences of impacts that were passed
  double accumulationEnd = 0.0;  ///< when the last of them comes to rest [s]
  StepEffort effort;             ///< what the evaluations of a scheme with own steps were for
  SteppingReport stepping;
  long undecided = 0;  ///< switches at which no status was consistent, or several were
  Worst unseen;        ///< the longest step at rest while forces changed faster than it looks [s]
  int contactsMax = 0;
  long repairedImpacts = 0;  ///< groups of contacts whose impact would have gained energy
  Worst energyGain;          ///< the largest such gain, before the repair [J]
  Unsolved unsolved;
  Worst residual;                ///< largest of E_f, E_u
  Worst penetration;             ///< −g of unilateral contacts, at ends of steps as well [m]
  Worst solvedOverlap;           ///< the same where steps solve for their forces alone [m]
  Worst jointError;              ///< position error of joints at ends of steps [m]
  double cpu = 0.0, wall = 0.0;  ///< [s]
  EnergyReport energy;
  RunTrust trust;
  StartReport start;
  std::vector<Warning> warnings;  ///< at the end of the run
  std::uint64_t hash = 0;         ///< of the motion: MotionHash

  /// True: a warning says that the run is not what the model asks for (WarningKind::qualifies).
  bool qualified() const;
  double iterationsMean() const {
    return solves > 0 ? static_cast<double>(iterations) / static_cast<double>(solves) : 0.0;
  }
  void archive(Archive& a);
};

/// Counts what the accepted steps tell.
class StepStatistics final : public Observer {
 public:
  explicit StepStatistics(RunReport& report) : report_(report) {}
  /// Tells `sink` of impacts and switches from now on.
  void tell(RecordSink& sink) { sink_ = &sink; }
  void step(const StepView& view) override;
  void archive(Archive& a) override;

 private:
  struct Seen {
    ContactKey key;
    Status status;
    bool impact;
    void archive(Archive& a) { a(key), a(status), a(impact); }
  };
  void stepped(const StepView& view);
  void gaps(const StepView& view);
  void statuses(const StepView& view);
  void switched(double t, const Seen& from, const Seen& to);
  RunReport& report_;
  RecordSink* sink_ = nullptr;
  StepImpacts impacts_;
  std::vector<Seen> before_, now_;
};

}  // namespace dynamy
