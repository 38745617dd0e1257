#include <dynamy/io/model_scene.hpp>
#include <dynamy/io/run_recording.hpp>

namespace dynamy {
namespace {

ContactState drawnState(const ContactRecord& c) {
  if (c.impact) return ContactState::impact;
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
      columns_(recordedSignals(model).size()),
      poses_(drawnFrames(model).size()),
      pose_(poses_) {}

RunRecording::RunRecording(const RunFolder& folder, const Model& model)
    : RunRecording(folder, model, Resume{}) {
  signals_.emplace(folder.signals(), recordedSignals(model));
  frames_.emplace(folder.frames(), modelScene(model));
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
    marks_.push_back({c.point, c.normal, c.force * c.normal, drawnState(c)});
  if (!frames_) tooEarly();
  frames_->frame(t, pose_, marks_);
}

void RunRecording::archive(Archive& a) {
  std::uint64_t rows = 0, frames = 0;
  if (!a.reading()) {
    flush();
    if (signals_) rows = signals_->size();
    if (frames_) frames = frames_->size();
  }
  a(rows), a(frames);
  if (a.reading()) {
    signals_.emplace(folder_.signals(), columns_, rows);
    frames_.emplace(folder_.frames(), poses_, frames);
  }
}

void RunRecording::flushIfDue() {
  if (signals_) signals_->flushIfDue();
  if (frames_) frames_->flushIfDue();
}

void RunRecording::flush() {
  if (signals_) signals_->flush();
  if (frames_) frames_->flush();
}

}  // namespace dynamy
