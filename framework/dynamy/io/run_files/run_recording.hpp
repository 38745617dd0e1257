/// RunRecording: writes the recorded numbers of a run to signals.csv, events.csv, ledger.csv and
/// frames.bin of its run folder.
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/run_files/events_file.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <dynamy/simulation/report/run_report.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dynamy {

/// Names and units of the recorded signals, in the order of the columns.
std::vector<SignalName> recordedSignals(const Model& model);

/// A file of a run, with the number and checksum of its bytes.
struct RecordedFile {
  std::string name;  ///< in the folder
  FilePlace place;
  void archive(Archive& a) { a(name), a(place.bytes), a(place.crc); }
};
/// Writes the members `warnings` and `notes` of run.json.
void writeWarnings(JsonWriter& json, const std::vector<Warning>& warnings);

class RunRecording final : public RecordSink {
 public:
  /// Creates the files. \throws FileError, ModelError for unknown signals
  RunRecording(const RunFolder& folder, const Model& model);
  /// Continues the files of an earlier run. archive() removes the part after its checkpoint;
  /// nothing may be recorded before that.
  struct Resume {};
  RunRecording(const RunFolder& folder, const Model& model, Resume);

  void row(double t, std::span<const double> values) override;
  void frame(FilmInstant at, std::span<const FramePose> poses,
             std::span<const ContactRecord> contacts) override;
  void event(const ContactEvent& event) override;
  void ledger(const LedgerRow& row) override;
  bool wantsLedger() const override { return true; }
  /// The error of a file that cannot be written, because nothing is thrown within a step. Text that
  /// is not written is kept for the next try, and becomes part of a checkpoint.
  std::string_view fault() const override { return fault_; }
  void archive(Archive& a) override;
  /// Call this from time to time: it writes rows that wait during a slow step.
  void flushIfDue();
  /// Writes everything; fault() reports an error.
  void flush();
  /// Returns when all written bytes are on the disk; fault() reports an error.
  void sync();
  /// Events that events.csv has no room for.
  long eventsLeftOut() const;
  /// The files as they are written by now.
  std::vector<RecordedFile> files() const;
  /// The files as the last archive() left them.
  const std::vector<RecordedFile>& archived() const { return archived_; }

 private:
  void guarded(const std::function<void()>& write);
  const RunFolder& folder_;
  const Model& model_;
  std::size_t columns_ = 0, poses_ = 0;
  std::optional<SignalsFile> signals_, ledger_;
  std::optional<EventsFile> events_;
  std::optional<FramesFile> frames_;
  std::vector<Pose> pose_;
  std::vector<ContactMark> marks_;
  std::vector<RecordedFile> archived_;
  std::string fault_;
};

}  // namespace dynamy
