#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/model_scene.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <dynamy/io/run_files/run_sizes.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/run_watch.hpp>

namespace dynamy {
namespace {

ContactState drawnState(const ContactRecord& c) {
  if (c.impact) return ContactState::impact;
  if (c.spin) return ContactState::spin;
  switch (c.status) {
    case Status::open:
    case Status::separating:
      return ContactState::open;
    case Status::slip:
    case Status::lower:
    case Status::upper:
      return ContactState::slip;
    default:
      return ContactState::stick;
  }
}

}  // namespace

std::vector<SignalName> recordedSignals(const Model& model) {
  std::vector<SignalName> out;
  for (const NamedSignal* s : chooseSignals(model, model.record.signals, model.record.places)) {
    const std::string_view unit = unitText(s->signal.unit);
    out.push_back({s->name, unit == "-" ? "" : std::string(unit)});
  }
  return out;
}

void writeWarnings(JsonWriter& json, const std::vector<Warning>& warnings) {
  for (const bool notes : {false, true}) {
    json.key(notes ? "notes" : "warnings").beginArray();
    for (const Warning& w : warnings) {
      if ((says(w) == Says::note) != notes) continue;
      json.beginObject().member("kind", w.kind).member("text", w.text).member("count", w.count);
      json.member("t", w.t).member("place", w.place);
      if (!notes) json.member("qualifies", says(w) == Says::qualifies);
      json.endObject();
    }
    json.endArray();
  }
}

RunRecording::RunRecording(const RunFolder& folder, const Model& model, Resume)
    : folder_(folder),
      model_(model),
      columns_(recordedSignals(model).size()),
      poses_(drawnFrames(model).size()),
      pose_(poses_) {}

RunRecording::RunRecording(const RunFolder& folder, const Model& model)
    : RunRecording(folder, model, Resume{}) {
  requireRoom(model, folder.path());
  signals_.emplace(folder.signals(), recordedSignals(model));
  frames_.emplace(folder.frames(), modelScene(model));
  events_.emplace(folder.events());
  std::vector<SignalName> names;
  for (std::size_t i = 0; i < LedgerRow::kNumbers; ++i)
    names.push_back({LedgerRow::kNames[i], LedgerRow::kUnits[i]});
  ledger_.emplace(folder.ledger(), names);
}

namespace {

/// Error of a resumed recording that is used before archive() has read its checkpoint, so that no
/// recorded number is lost silently.
[[noreturn]] void tooEarly() {
  throwExpectation("a resumed run is read before it is recorded", std::source_location::current());
}

}  // namespace

void RunRecording::row(double t, std::span<const double> values) {
  if (!signals_) tooEarly();
  guarded([&] { signals_->row(t, values); });
}

void RunRecording::frame(FilmInstant at, std::span<const FramePose> poses,
                         std::span<const ContactRecord> contacts) {
  for (std::size_t i = 0; i < poses.size(); ++i)
    pose_[i] = {poses[i].r_OS_I, poses[i].absent ? Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0)
                                                 : Eigen::Quaterniond(poses[i].A_IK)};
  marks_.clear();
  for (const ContactRecord& c : contacts)
    marks_.push_back({c.point, c.normal, c.force, drawnState(c), c.limit});
  if (!frames_) tooEarly();
  guarded([&] { frames_->frame(at.t, pose_, marks_, at.step); });
}

void RunRecording::event(const ContactEvent& event) {
  if (!events_) tooEarly();
  if (events_->full()) return events_->event(event, {});  // only counted: no name is made
  guarded([&] {
    events_->event(event, event.system < 0
                              ? contactName(model_, event.key)
                              : model_.systems()[static_cast<std::size_t>(event.system)]->name());
  });
}

void RunRecording::ledger(const LedgerRow& row) {
  if (!ledger_) tooEarly();
  guarded([&] { ledger_->row(row.t, row.value); });
}

void RunRecording::archive(Archive& a) {
  a.section("files");
  FilePlace signalsAt, framesAt, ledgerAt, eventsAt;
  std::string rows, chunks, entries, lines;  // text that could not be written
  long count = 0;
  if (!a.reading()) {
    flush();
    if (signals_) signalsAt = signals_->place(), rows = signals_->pending();
    if (frames_) framesAt = frames_->place(), chunks = frames_->pending();
    if (ledger_) ledgerAt = ledger_->place(), entries = ledger_->pending();
    if (events_) eventsAt = events_->place(), lines = events_->pending(), count = events_->events();
  }
  for (FilePlace* p : {&signalsAt, &framesAt, &ledgerAt, &eventsAt}) a(p->bytes), a(p->crc);
  a(rows), a(chunks), a(entries), a(lines), a(count);
  if (!a.reading()) {
    archived_ = files();
    return;
  }
  if (count < 0) throw ModelError("the checkpoint counts " + std::to_string(count) + " events");
  signals_.emplace(folder_.signals(), columns_, signalsAt, std::move(rows));
  frames_.emplace(folder_.frames(), poses_, framesAt, std::move(chunks));
  ledger_.emplace(folder_.ledger(), LedgerRow::kNumbers, ledgerAt, std::move(entries));
  events_.emplace(folder_.events(), eventsAt, count, std::move(lines));
  archived_ = files();
}

/// Calls `write`. A file that cannot be written ends the run after the present step; until then its
/// numbers are collected in memory.
void RunRecording::guarded(const std::function<void()>& write) {
  try {
    write();
  } catch (const WriteError& e) {
    fault_ = e.what();
  }
}

void RunRecording::flushIfDue() {
  guarded([&] {
    if (signals_) signals_->flushIfDue();
    if (ledger_) ledger_->flushIfDue();
    if (frames_) frames_->flushIfDue();
  });
}

void RunRecording::flush() {
  fault_.clear();
  guarded([&] {
    if (signals_) signals_->flush();
  });
  guarded([&] {
    if (ledger_) ledger_->flush();
  });
  guarded([&] {
    if (events_) events_->flush();
  });
  guarded([&] {
    if (frames_) frames_->flush();
  });
}

void RunRecording::sync() {
  guarded([&] {
    if (signals_) signals_->sync();
    if (ledger_) ledger_->sync();
    if (events_) events_->sync();
    if (frames_) frames_->sync();
  });
}

long RunRecording::eventsLeftOut() const { return events_ ? events_->leftOut() : 0; }

std::vector<RecordedFile> RunRecording::files() const {
  std::vector<RecordedFile> out;
  const auto add = [&out](const std::filesystem::path& path, const auto& file) {
    if (file) out.push_back({path.filename().string(), file->place()});
  };
  add(folder_.signals(), signals_), add(folder_.events(), events_);
  add(folder_.ledger(), ledger_), add(folder_.frames(), frames_);
  return out;
}

}  // namespace dynamy
