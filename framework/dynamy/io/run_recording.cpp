#include <dynamy/io/model_scene.hpp>
#include <dynamy/io/run_recording.hpp>
#include <dynamy/simulation/contact_facts.hpp>

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

RunRecording::RunRecording(const RunFolder& folder, const Model& model, Resume)
    : folder_(folder),
      model_(model),
      columns_(recordedSignals(model).size()),
      poses_(drawnFrames(model).size()),
      pose_(poses_) {}

RunRecording::RunRecording(const RunFolder& folder, const Model& model)
    : RunRecording(folder, model, Resume{}) {
  signals_.emplace(folder.signals(), recordedSignals(model));
  frames_.emplace(folder.frames(), modelScene(model));
  events_.emplace(folder.events());
  std::vector<SignalName> names;
  for (std::size_t i = 0; i < LedgerRow::kNumbers; ++i)
    names.push_back({LedgerRow::kNames[i], LedgerRow::kUnits[i]});
  ledger_.emplace(folder.ledger(), names);
}

namespace {

/// Nothing recorded is lost silently: a resumed run has to be read before it is written to.
[[noreturn]] void tooEarly() {
  throwExpectation("a resumed run is read before it is recorded", std::source_location::current());
}

}  // namespace

void RunRecording::row(double t, std::span<const double> values) {
  if (!signals_) tooEarly();
  signals_->row(t, values);
}

void RunRecording::frame(double t, std::span<const FramePose> poses,
                         std::span<const ContactRecord> contacts) {
  for (std::size_t i = 0; i < poses.size(); ++i)
    pose_[i] = {poses[i].r_OS_I, Eigen::Quaterniond(poses[i].A_IK)};
  marks_.clear();
  for (const ContactRecord& c : contacts)
    marks_.push_back({c.point, c.normal, c.force, drawnState(c), c.limit});
  if (!frames_) tooEarly();
  frames_->frame(t, pose_, marks_);
}

void RunRecording::event(const ContactEvent& event) {
  if (!events_) tooEarly();
  if (!events_->full()) events_->event(event, contactName(model_, event.key));
}

void RunRecording::ledger(const LedgerRow& row) {
  if (!ledger_) tooEarly();
  ledger_->row(row.t, row.value);
}

void RunRecording::archive(Archive& a) {
  std::uint64_t rows = 0, frames = 0, ledger = 0, events = 0;
  long lines = 0;
  if (!a.reading()) {
    flush();
    if (signals_) rows = signals_->size();
    if (frames_) frames = frames_->size();
    if (ledger_) ledger = ledger_->size();
    if (events_) events = events_->size(), lines = events_->events();
  }
  a(rows), a(frames), a(ledger), a(events), a(lines);
  if (a.reading()) {
    signals_.emplace(folder_.signals(), columns_, rows);
    frames_.emplace(folder_.frames(), poses_, frames);
    ledger_.emplace(folder_.ledger(), LedgerRow::kNumbers, ledger);
    events_.emplace(folder_.events(), events, lines);
  }
}

void RunRecording::flushIfDue() {
  if (signals_) signals_->flushIfDue();
  if (ledger_) ledger_->flushIfDue();
  if (frames_) frames_->flushIfDue();
}

void RunRecording::flush() {
  if (signals_) signals_->flush();
  if (ledger_) ledger_->flush();
  if (events_) events_->flush();
  if (frames_) frames_->flush();
}

}  // namespace dynamy
