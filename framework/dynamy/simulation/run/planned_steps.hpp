/// PlannedSteps: the loop of a scheme that chooses its steps, which stops at given instants. With
/// the steps of another run of nearly the same motion, it takes steps of the same lengths: only
/// switches, and the last steps before the instants, end where this motion needs it (theory 53).
#pragma once
#include <dynamy/simulation/run/time_loop.hpp>
#include <dynamy/system/state.hpp>
#include <vector>

namespace dynamy {

struct PlannedStep {
  enum class End : std::uint8_t {
    bounded,   ///< by the length or by the error
    ofMotion,  ///< a switch, or another instant that the motion decides
    atStop     ///< an instant at which a step has to end
  };
  double dt = 0.0;  ///< [s]
  End end = End::bounded;
};

/// With neither stops nor steps the loop is that of the model; only the start is another one.
struct StepPlan {
  std::vector<double> stops;       ///< instants at which a step ends, ascending [s]
  std::vector<PlannedStep> steps;  ///< empty: the scheme chooses the lengths
  const State* from = nullptr;     ///< state at the start; null: the initial state of the model
};

class PlannedSteps final : public TimeLoop {
 public:
  explicit PlannedSteps(StepPlan plan) : plan_(std::move(plan)) {}
  Advance next(Stepper& stepper, double until) override;
  void archive(Archive&) override {}

 private:
  double bound(const Stepper& stepper, double rest) const;
  StepPlan plan_;
  std::size_t taken_ = 0, stop_ = 0;
};

}  // namespace dynamy
