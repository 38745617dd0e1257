/// FollowedRun: one run of a model to a tolerance, which stops at given instants, with the values
/// wanted there and the sequence of its steps; by its own steps, or by those of another run.
#pragma once
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
  std::vector<double> values;  ///< of the signals, then of the model's checks
  MotionSequence sequence;
  State end;
};

/// Runs `model` to `tolerance`; `of`: instants up to its end; `like`: takes the steps of that run;
/// `from`: its start, the model's initial state if null; `most`: steps that it may take, 0: any
/// number. Throws ModelError if the run ends early, or cannot locate its switches.
FollowedRun followedRun(Model& model, const std::vector<SignalAt>& of, double tolerance,
                        const MotionSequence* like = nullptr, const State* from = nullptr,
                        long most = 0);

}  // namespace dynamy
