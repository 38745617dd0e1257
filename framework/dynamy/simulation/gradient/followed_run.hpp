/// FollowedRun: one run of a model to a tolerance, which stops at given instants, with the values
/// wanted there and the sequence of its steps; by its own steps, or by those of another run.
#pragma once
#include <dynamy/simulation/gradient/motion_sequence.hpp>
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// A signal at an instant [s].
struct SignalAt {
  std::string signal;
  double t = 0.0;
};

struct FollowedRun {
  std::vector<double> values;  ///< of the signals, then of the model's checks
  MotionSequence sequence;
};

/// Runs `model` to `tolerance`; `of`: instants up to its end; `like`: takes the steps of that run.
/// Throws ModelError if the run ends early, or cannot locate its switches.
FollowedRun followedRun(Model& model, const std::vector<SignalAt>& of, double tolerance,
                        const MotionSequence* like = nullptr);

}  // namespace dynamy
