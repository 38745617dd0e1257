/// CoupledRun: a run that another program advances from instant to instant, with the events on the
/// way and a state that can be set back.
///
/// Without inputs the steps are those of a run on its own: the run is up to one step ahead, and
/// values between its steps follow from the scheme's interpolation. So the result has the same bits
/// whatever the instants are. With inputs, or with steps of given length, steps end at the instants.
///
/// A state is the checkpoint before the last step, and what was set since: setting it back takes
/// that step again, which gives the same bits, because a step depends on its checkpoint alone.
/// Rejected: a copy of the state after the step, from which values inside of the step, forces and
/// the values right before an impact could not be had again.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/simulation/run/sample_instants.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <optional>
#include <span>

namespace dynamy::fmu {

/// What a run hands on while it takes steps: events, and the last step itself.
class StepWatch final : public RecordSink, public Observer {
 public:
  // As a sink: events alone.
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void event(const ContactEvent&) override { ++events_; }
  // As an observer: the last step.
  void start(const StepView& initial) override { view_.emplace(initial); }
  void step(const StepView& view) override { view_.emplace(view); }

  const StepView* view() const { return view_ ? &*view_ : nullptr; }
  /// Number of events since the last call.
  long events() { return std::exchange(events_, 0); }

 private:
  std::optional<StepView> view_;
  long events_ = 0;
};

/// An input of the model that has been set.
struct SetInput {
  MemoryHandle at;
  double value = 0.0;
};

class CoupledRun {
 public:
  /// An input of this place stands for `sample`.
  static constexpr int kSampled = -1;
  /// Called at the ends of steps on the way: true ends the advance there.
  using OnTheWay = std::function<bool(double t)>;
  struct Reached {
    bool good = true;    ///< false: the run has ended with an error
    bool event = false;  ///< at the instant reached, or on the way: an impact, a switch, a jump
  };

  /// `model` is built and outlives the run; `until`: the end that the other program has announced
  /// [s]. The run starts with these inputs. Throws ModelError.
  CoupledRun(Model& model, const std::vector<const NamedSignal*>& signals, double until,
             std::vector<SetInput> inputs);
  /// A change of these signals, statuses of contacts, is an event, too: those at the start are known
  /// at the end of the first step only.
  void watch(const std::vector<const NamedSignal*>& statuses);
  /// Why the run has ended; empty: it has not.
  const std::string& fault() const { return simulation_->report().reason; }

  double t() const { return t_; }
  /// The signals at t; `before`: right before the impact or switch there.
  std::span<const double> values(bool before);
  /// Continues to `target`, or with `stops` to the first event if that is earlier.
  Reached advance(double target, bool stops, const OnTheWay& onTheWay);
  /// From now on an input has this value.
  void input(const SetInput& set);
  /// Blocks that sample at t sample again if inputs were set since.
  void sample();
  /// The next instant after t at which a block samples; infinity: none.
  double nextSample() const { return samples_.after(t_); }
  /// Writes or reads the state. Throws ModelError if the bytes are of another model.
  void archive(Archive& a);

 private:
  bool take();
  bool isReached(double target, double t) const;
  void begin(const std::string& checkpoint);
  bool statusesChange();
  Model& model_;
  bool ahead_ = false;  // steps do not end at the instants
  SignalSampler sampler_;
  SampleInstants samples_;
  std::unique_ptr<StepWatch> watch_;
  std::unique_ptr<Simulation> simulation_;
  /// At the start; set since the checkpoint, with kSampled where blocks have sampled again.
  std::vector<SetInput> startInputs_, inputs_;
  bool stale_ = false;      // inputs were set since blocks sampled
  std::string checkpoint_;  // before the last step; empty: there was none
  double t_ = 0.0;
  bool event_ = false;  // at the end of the last step, not yet reached
  std::vector<double> values_;
  std::unique_ptr<SignalSampler> statuses_;
  std::vector<double> statusesBefore_, statusesNow_;  // at the ends of the last two steps
};

}  // namespace dynamy::fmu
