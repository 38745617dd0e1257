/// Recorder: samples the requested signals every Δt_rec and the poses of all frames that carry
/// shapes at the rate of the film, both through the scheme's own interpolation. Impacts whose instant
/// is known have pictures of their own, about as many as the film has at most.
///
/// The numbers go to a RecordSink: the files of the run folder (io), or a table in memory (tests,
/// comparisons). Writing files from here was rejected: simulation does not know io.
#pragma once
#include <dynamy/simulation/model/time_grid.hpp>
#include <dynamy/simulation/report/record_sink.hpp>
#include <dynamy/simulation/report/row_instants.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/simulation/report/step_impacts.hpp>

namespace dynamy {

/// A frame that carries shapes.
struct DrawnFrame {
  int system = -1, id = 0;
};
/// Frames that carry shapes, in the order of the systems: the order of poses in RecordSink::frame.
std::vector<DrawnFrame> drawnFrames(const Model& model);

class Recorder final : public Observer {
 public:
  /// `model` is built; its record settings give `every` (0: until/1000), `at` and `framesPerSecond`.
  /// Throws ModelError for unknown signals.
  Recorder(const Model& model, RecordSink& sink);
  const std::vector<const NamedSignal*>& signals() const { return sampler_.signals(); }
  /// Why the sink can store no more; empty: it can.
  std::string_view fault() const { return sink_.fault(); }

  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  /// Adds a last row and picture at the end time.
  void finish(const StepView& last) override;
  void archive(Archive& a) override;
  /// Contacts, ascending, of bodies that sleep from now on, or no longer: pictures show them with
  /// their percussions in `view`.
  void rest(const StepView& view, const std::vector<ContactKey>& contacts);
  void wake(const std::vector<ContactKey>& contacts);

 private:
  struct Resting {
    ContactKey key;
    ContactRecord record;
    void archive(Archive& a);
  };
  void row(const StepView& view, double t, double theta);
  void write(double t);
  void writeFirst(const StepView& view, bool forces);
  void frame(const StepView& view, double t, double theta);
  void contacts(const StepView& view, bool atEnd);
  RecordSink& sink_;
  SignalSampler sampler_;
  Topology drawn_;
  Kinematics kinematics_;
  State at_;
  StepImpacts impacts_;
  ContactInstant instant_;
  std::vector<ContactKey> hit_;  // contacts with an impact at the present picture
  RowInstants rows_;
  TimeGrid frames_;
  long nextFrame_ = 0, impactFrames_ = 0;
  double lastRow_ = -1.0, lastFrame_ = -1.0;
  std::vector<double> values_;
  std::vector<double> first_;  // row of the start that waits for its forces; empty: none
  std::vector<FramePose> poses_;
  std::vector<ContactRecord> contacts_;
  std::vector<Resting> resting_;
};

}  // namespace dynamy
