/// FollowedRun: one run of a model to a tolerance, which stops at given instants, with the values
/// wanted there and the sequence of its steps; by its own steps, or by those of another run.
#pragma once
#include <dynamy/simulation/gradient/event_instants.hpp>
#include <dynamy/simulation/gradient/motion_sequence.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <memory>

namespace dynamy {

class LocatedDormandPrince;

/// A signal at an instant [s].
struct SignalAt {
  std::string signal;
  double t = 0.0;
};

/// The scheme of such runs; `givenSteps`: it takes steps of given lengths.
std::unique_ptr<LocatedDormandPrince> locatedScheme(bool givenSteps);

/// Throws ModelError with the nearest known name.
const NamedSignal* signalNamed(const Model& model, const std::string& name);

struct FollowedRun {
  std::vector<double> values;  ///< of the signals, the instants, then of the model's checks
  MotionSequence sequence;
  std::vector<double> sizes;     ///< of the values: largest at the ends of steps, of signals
  std::size_t firstInstant = 0;  ///< index of the first instant among the values
  std::vector<int> events;       ///< per wanted instant: how many such events there were
  State end;
};

/// Start, steps and instants of a run. What is null or empty is not wanted.
struct FollowedRunOptions {
  const MotionSequence* like = nullptr;  ///< takes the steps of that run
  const State* from = nullptr;           ///< its start; null: the model's
  const std::vector<WantedInstant>* instants = nullptr;
  long most = 0;         ///< steps that it may take; 0: any number
  bool located = false;  ///< its switches have to be located: steps in time have no derivatives
};

/// Runs `model` to `tolerance`; `of`: instants up to its end. Throws ModelError if the run ends early,
/// takes more steps than it may, or cannot locate its switches.
FollowedRun followedRun(Model& model, const std::vector<SignalAt>& of, double tolerance,
                        const FollowedRunOptions& options = {});

/// The error of a run that begins to step in time at t [s].
ModelError denseSwitches(double t);

}  // namespace dynamy
