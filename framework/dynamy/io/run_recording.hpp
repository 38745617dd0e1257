/// RunRecording: what a recorder takes goes to signals.csv, events.csv, ledger.csv and
/// frames.bin of a run folder.
#pragma once
#include <dynamy/io/events_file.hpp>
#include <dynamy/io/frames_file.hpp>
#include <dynamy/io/run_folder.hpp>
#include <dynamy/io/signals_file.hpp>
#include <dynamy/simulation/recorder.hpp>
#include <optional>

namespace dynamy {

/// Names and units of the recorded signals, in the order of the columns.
std::vector<SignalName> recordedSignals(const Model& model);

class RunRecording final : public RecordSink {
 public:
  /// Creates the files. \throws FileError, ModelError for unknown signals
  RunRecording(const RunFolder& folder, const Model& model);
  /// Goes on in the files of an earlier run; what follows its checkpoint is dropped by archive(),
  /// and nothing is written before.
  struct Resume {};
  RunRecording(const RunFolder& folder, const Model& model, Resume);

  void row(double t, std::span<const double> values) override;
  void frame(double t, std::span<const FramePose> poses,
             std::span<const ContactRecord> contacts) override;
  void event(const ContactEvent& event) override;
  void ledger(const LedgerRow& row) override;
  bool wantsLedger() const override { return true; }
  void archive(Archive& a) override;
  /// To be called now and then: rows that wait for a slow step are handed over.
  void flushIfDue();
  /// Hands all over. \throws FileError
  void flush();

 private:
  const RunFolder& folder_;
  const Model& model_;
  std::size_t columns_ = 0, poses_ = 0;
  std::optional<SignalsFile> signals_, ledger_;
  std::optional<EventsFile> events_;
  std::optional<FramesFile> frames_;
  std::vector<Pose> pose_;
  std::vector<ContactMark> marks_;
};

}  // namespace dynamy
