/// RunWatch: measures during a run how far its figures can be trusted, and reports at the end which
/// of them cannot and why. All limits are ratios, so that none depends on the units or the size of
/// a scene:
///
///   energy      error, rise and gain over the largest T, sampled at some hundred instants, and
///               where T has grown by a fifth: EnergyWatch
///   overlap     penetration over the scene's length, and over the distance that the fastest frame
///               or contact moves in a step, which bounds it for a scheme on velocity level: GapWatch
///   joints      the worst position error over the scene's length, at the same instants as the
///               energy: GapWatch
///   resolution  ωΔt of smooth motion, and the fall in a step over the scene's length:
///               ResolutionWatch
///   turn, leap  what bodies turn and move in a step: TravelWatch
///
/// Rejected: a second run with half the step for every run. It measures the error itself, but costs
/// three times as much; it is available on request (dynamy run --error-bar).
#pragma once
#include <dynamy/simulation/report/energy_watch.hpp>
#include <dynamy/simulation/report/gap_watch.hpp>
#include <dynamy/simulation/report/resolution_watch.hpp>
#include <dynamy/simulation/report/travel_watch.hpp>

namespace dynamy {

class RunWatch final : public Observer {
 public:
  /// `ledger` sees every step before the watch does.
  RunWatch(Model& model, EnergyLedger& ledger, RunReport& report);
  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  void finish(const StepView& last) override;
  void archive(Archive& a) override;

 private:
  void sample(const StepView& view);
  static double kineticEnergy(const StepView& view);
  double length_;  // of the scene [m]
  RunReport& report_;
  EnergyWatch energy_;
  double fastest_ = 0.0;  // largest T of the samples [J]
  GapWatch gaps_;
  ResolutionWatch resolution_;
  TravelWatch travel_;
  double sampleEvery_, nextSample_ = 0.0, lastSample_ = -1.0;  // [s]
};

/// What a warning says of a run.
enum class Says : std::uint8_t {
  note,      ///< something in the model contradicts itself, and the run resolved it as documented
  warning,   ///< figures of the run may be off
  qualifies  ///< the run is not what the model asks for: exit status 3
};

/// A kind of warning.
struct WarningKind {
  const char* name;
  Says says;
  const char* text;  ///< when it is reported
};
std::span<const WarningKind> warningKinds();
/// What warnings of this kind say; `warning` for an unknown kind.
Says says(const Warning& w);
/// The kind of this name; null: there is none.
const WarningKind* warningKind(std::string_view name);

/// Warnings that follow from the figures of a finished run, each with its cause, the most serious
/// first.
std::vector<Warning> warningsOf(const RunReport& report, double sceneLength);

/// A figure of a report that a `<check>` may request as `run.NAME`, with its description.
struct RunFigure {
  const char* name;
  const char* text;
  double (*value)(const RunReport&);
};
std::span<const RunFigure> runFigures();
/// The figure `run.NAME`; null if there is none of this name.
const RunFigure* runFigure(std::string_view signal);

}  // namespace dynamy
