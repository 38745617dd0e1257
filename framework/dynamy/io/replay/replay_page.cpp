#include <algorithm>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/replay/plot_scale.hpp>
#include <dynamy/io/replay/replay_coding.hpp>
#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <dynamy/io/replay/viewer_files.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <system_error>

namespace dynamy {
namespace {

constexpr std::size_t kSignalColumns = 1000;  // pixel columns of a plot: up to 4 points each

void packedMember(JsonWriter& json, std::string_view name, const std::string& bytes) {
  std::string text = "\"";
  appendBase64(text, deflated(bytes));
  text += '"';
  json.key(name).raw(text);
}

std::string timesOf(const Frames& frames, const std::vector<std::size_t>& kept) {
  std::string t;
  for (const std::size_t f : kept) appendBytes(t, frames.t[f]);
  return t;
}

std::string stepsOf(const Frames& frames, const std::vector<std::size_t>& kept) {
  std::string steps;
  for (const std::size_t f : kept)
    appendBytes(steps, f < frames.step.size() ? frames.step[f] : 0.0F);
  return steps;
}

void writeFrames(JsonWriter& json, const Frames& frames, const std::vector<std::size_t>& kept,
                 const CodedPoses& poses, const CodedContacts& contacts) {
  json.beginObject().member("count", kept.size()).member("recorded", frames.t.size());
  json.member("poses", frames.poses);
  json.member("placeSteps", poses.steps.place).member("turnSteps", poses.steps.turn);
  packedMember(json, "t", timesOf(frames, kept));
  packedMember(json, "steps", stepsOf(frames, kept));
  packedMember(json, "ranges", poses.ranges);
  packedMember(json, "orders", poses.orders);
  json.key("data").raw('"' + poses.data + '"');
  json.key("contacts").beginObject();
  json.key("box").beginArray();
  for (const float x : contacts.box) json.value(x);
  json.endArray();
  json.member("placeSteps", contacts.steps.place).member("turnSteps", contacts.steps.turn);
  json.member("octaveSteps", contacts.steps.octave);
  packedMember(json, "counts", contacts.counts);
  json.key("data").raw('"' + contacts.data + '"').endObject().endObject();
}

/// Writes every n-th frame and the last; n is the smallest number with which poses and contacts
/// take at most `bytes`.
void writeFrames(JsonWriter& json, const Frames& frames, std::size_t bytes, ReplaySize& size) {
  size.recorded = frames.t.size();
  for (std::size_t stride = 1;;) {
    const auto kept = keptFrames(frames.t.size(), stride);
    const CodedPoses poses = codedPoses(frames, kept);
    const CodedContacts contacts = codedContacts(frames, kept);
    const std::size_t needed = poses.data.size() + contacts.data.size();
    if (stride == 1) size.wholeBytes = needed;
    if (needed <= bytes || kept.size() <= 2) {
      size.frames = kept.size(), size.poseBytes = poses.data.size();
      size.contactBytes = contacts.data.size();
      size.contacts = contacts.kept, size.contactsRecorded = contacts.recorded;
      writeFrames(json, frames, kept, poses, contacts);
      return;
    }
    stride = std::max(stride + 1, (stride * needed + bytes - 1) / bytes);
  }
}

/// Writes each signal, thinned to what a plot can show; "t" is left out if it equals that of the
/// signal before.
void writeSignals(JsonWriter& json, const SignalTable& table) {
  json.beginArray();
  std::string before;
  for (std::size_t k = 0; k < table.signals.size(); ++k) {
    std::string t, y;
    for (const std::size_t i : thinned(table.t, table.columns[k], kSignalColumns)) {
      appendBytes(t, table.t[i]);
      appendBytes(y, static_cast<float>(table.columns[k][i]));
    }
    json.beginObject().member("name", table.signals[k].name).member("unit", table.signals[k].unit);
    if (k == 0 || t != before) packedMember(json, "t", t);
    packedMember(json, "y", y);
    json.endObject();
    before = std::move(t);
  }
  json.endArray();
}

/// Replaces the mark "{{name}}" of the template by `value`.
void fill(std::string& page, const std::string& name, std::string_view value) {
  const std::string mark = "{{" + name + "}}";
  const std::size_t at = page.find(mark);
  if (at != std::string::npos) page.replace(at, mark.size(), value);
}

}  // namespace

std::string replayData(const Frames& frames, const SignalTable& signals, const ReplayText& text,
                       ReplaySize* size) {
  std::string data;
  JsonWriter json(data);
  json.beginObject().member("format", "dynamy-replay").member("version", 4);
  json.member("title", text.title);
  json.key("model").beginObject();
  json.member("name", text.modelName).member("text", text.modelText).endObject();
  json.key("run").raw(text.runJson.empty() ? "null" : text.runJson);
  packedMember(json, "scene",
               frames.scene.empty() ? R"({"view":"","frames":[],"shapes":[]})" : frames.scene);
  ReplaySize counted;
  json.key("frames");
  writeFrames(json, frames, text.frameBytes, counted);
  json.key("signals");
  writeSignals(json, signals);
  packedMember(json, "events", text.events);
  packedMember(json, "ledger", text.ledger);
  json.endObject();
  if (size != nullptr) *size = counted;
  return data;
}

namespace {

/// JSON without "<", which occurs only inside of strings: no "</script>" can end the data early.
std::string withoutTags(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

struct RecordedRun {
  Frames frames;
  SignalTable signals;
  ReplayText text;
};

RecordedRun readRun(const std::filesystem::path& folder) {
  std::error_code error;
  const auto text = [&](const char* name) {
    const auto file = folder / name;
    return std::filesystem::exists(file, error) ? readWholeFile(file) : std::string();
  };
  RecordedRun run;
  if (std::filesystem::exists(folder / "frames.bin", error))
    run.frames = readFrames(folder / "frames.bin");
  run.signals = signalsOf(folder);
  ReplayText& page = run.text;
  page.title = std::filesystem::absolute(folder).lexically_normal().filename().string();
  if (page.title.empty()) page.title = folder.parent_path().filename().string();
  page.runJson = text("run.json");
  page.modelName = "model.xml";
  page.modelText = text("model.xml");
  page.events = text("events.csv");
  page.ledger = text("ledger.csv");
  return run;
}

}  // namespace

std::string replayPage(const Frames& frames, const SignalTable& signals, const ReplayText& text,
                       ReplaySize* size) {
  // the data are filled in last, because a mark inside the model text must not be replaced
  std::string page(viewerFile("replay.html"));
  fill(page, "title", escapedXml(text.title));
  fill(page, "style", viewerFile("replay.css"));
  fill(page, "script", viewerFile("replay.js"));
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  if (!text.other.empty())
    page.insert(page.find(mark), std::string("<script type=\"application/json\" id=\"other\"") +
                                     (text.beside ? " data-beside=\"1\">" : ">") +
                                     withoutTags(text.other) + "</script>\n");
  const std::size_t at = page.rfind("{{data}}");
  return page.replace(at, 8, withoutTags(replayData(frames, signals, text, size)));
}

ReplaySize writeReplay(const std::filesystem::path& folder, const std::filesystem::path& other,
                       bool beside) {
  RecordedRun run = readRun(folder);
  run.text.beside = beside;
  if (!other.empty()) {
    const RecordedRun second = readRun(other);
    run.text.other = replayData(second.frames, second.signals, second.text);
  }
  ReplaySize size;
  const std::string html = replayPage(run.frames, run.signals, run.text, &size);
  writeWholeFile(folder / "replay.html", html);
  return size;
}

}  // namespace dynamy
