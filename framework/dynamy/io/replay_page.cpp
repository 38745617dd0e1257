#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <dynamy/io/bytes.hpp>
#include <dynamy/io/plot_scale.hpp>
#include <dynamy/io/replay_page.hpp>
#include <dynamy/io/svg_plot.hpp>
#include <dynamy/io/viewer_files.hpp>
#include <iterator>
#include <limits>
#include <system_error>

namespace dynamy {
namespace {

constexpr std::size_t kSignalColumns = 600;  // pixel columns of a plot: up to 4 points each
constexpr std::array kScripts{"decode.js", "camera.js", "shapes.js", "draw.js",
                              "plots.js",  "panels.js", "replay.js"};

/// Smallest and largest of the numbers that a coordinate takes; not finite ones do not count.
struct Range {
  float lo = std::numeric_limits<float>::infinity();
  float hi = -std::numeric_limits<float>::infinity();

  void take(float x) {
    if (!std::isfinite(x)) return;
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  bool isConstant() const { return !(lo < hi); }
  /// lo … hi as 0 … 65535.
  std::uint16_t rounded(float x) const {
    if (isConstant() || !std::isfinite(x)) return 0;
    const double share = (static_cast<double>(x) - lo) / (static_cast<double>(hi) - lo);
    return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535.0));
  }
};

void base64Member(JsonWriter& json, std::string_view name, const std::string& bytes) {
  std::string text = "\"";
  appendBase64(text, bytes);
  text += '"';
  json.key(name).raw(text);
}

/// Frames that are kept: every n-th and the last, so that the poses stay below `bytes`.
std::vector<std::size_t> keptFrames(const Frames& frames, std::size_t bytes) {
  const std::size_t numbers =
      frames.poses * frames.t.size() * Frames::kPoseNumbers + frames.contact.size();
  const std::size_t stride = std::max<std::size_t>(1, (numbers * 2 + bytes - 1) / bytes);
  std::vector<std::size_t> kept;
  for (std::size_t f = 0; f < frames.t.size(); f += stride) kept.push_back(f);
  if (!kept.empty() && kept.back() + 1 != frames.t.size()) kept.push_back(frames.t.size() - 1);
  return kept;
}

/// q and −q are the same rotation: take the one next to that of the frame before, so that
/// components run smoothly and the page may interpolate.
std::vector<float> smoothPoses(const Frames& frames, const std::vector<std::size_t>& kept) {
  const std::size_t width = frames.poses * Frames::kPoseNumbers;
  std::vector<float> poses;
  poses.reserve(kept.size() * width);
  for (const std::size_t f : kept) {
    const auto begin = frames.pose.begin() + static_cast<std::ptrdiff_t>(f * width);
    poses.insert(poses.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    if (poses.size() <= width) continue;
    for (std::size_t at = poses.size() - width; at < poses.size(); at += Frames::kPoseNumbers) {
      float dot = 0;
      for (std::size_t k = 3; k < 7; ++k) dot += poses[at + k] * poses[at + k - width];
      if (dot >= 0) continue;
      for (std::size_t k = 3; k < 7; ++k) poses[at + k] = -poses[at + k];
    }
  }
  return poses;
}

/// Coordinate by coordinate: its range, and if it changes its course as 16-bit numbers.
void writePoses(JsonWriter& json, const Frames& frames, const std::vector<std::size_t>& kept) {
  const std::vector<float> poses = smoothPoses(frames, kept);
  const std::size_t width = frames.poses * Frames::kPoseNumbers;
  std::string ranges, data;
  for (std::size_t k = 0; k < width; ++k) {
    Range range;
    for (std::size_t at = k; at < poses.size(); at += width) range.take(poses[at]);
    if (range.lo > range.hi) range = {0, 0};
    appendBytes(ranges, range.lo);
    appendBytes(ranges, range.hi);
    if (range.isConstant()) continue;
    for (std::size_t at = k; at < poses.size(); at += width) {
      appendBytes(data, range.rounded(poses[at]));
    }
  }
  base64Member(json, "ranges", ranges);
  base64Member(json, "data", data);
}

/// Ten 16-bit numbers a contact: position in its range, normal in −1 … 1, force as the upper half
/// of a 32-bit float (forces of an impact and of rest differ by powers of ten), state.
void writeContacts(JsonWriter& json, const Frames& frames, const std::vector<std::size_t>& kept) {
  std::array<Range, 3> box;
  for (std::size_t at = 0; at < frames.contact.size(); at += Frames::kContactNumbers) {
    for (std::size_t k = 0; k < 3; ++k) box[k].take(frames.contact[at + k]);
  }
  constexpr Range normal{-1, 1};
  std::string first, data;
  std::uint32_t count = 0;
  appendBytes(first, count);
  for (const std::size_t f : kept) {
    for (std::size_t c = frames.firstContact[f]; c < frames.firstContact[f + 1]; ++c, ++count) {
      const float* const x = &frames.contact[c * Frames::kContactNumbers];
      for (std::size_t k = 0; k < 3; ++k) appendBytes(data, box[k].rounded(x[k]));
      for (std::size_t k = 3; k < 6; ++k) appendBytes(data, normal.rounded(x[k]));
      for (std::size_t k = 6; k < 9; ++k) {
        appendBytes(data, static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(x[k]) >> 16));
      }
      appendBytes(data, static_cast<std::uint16_t>(x[9]));
    }
    appendBytes(first, count);
  }
  json.key("contacts").beginObject();
  json.key("box").beginArray();
  for (const Range& range : box) {
    json.value(count > 0 ? range.lo : 0.f).value(count > 0 ? range.hi : 0.f);
  }
  json.endArray();
  base64Member(json, "first", first);
  base64Member(json, "data", data);
  json.endObject();
}

void writeFrames(JsonWriter& json, const Frames& frames, std::size_t bytes) {
  const auto kept = keptFrames(frames, bytes);
  std::string t;
  for (const std::size_t f : kept) appendBytes(t, frames.t[f]);
  json.beginObject().member("count", kept.size()).member("recorded", frames.t.size());
  json.member("poses", frames.poses);
  base64Member(json, "t", t);
  writePoses(json, frames, kept);
  writeContacts(json, frames, kept);
  json.endObject();
}

/// Each signal thinned to what a plot can show; "t" is left out where it is that of the one before.
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
    if (k == 0 || t != before) base64Member(json, "t", t);
    base64Member(json, "y", y);
    json.endObject();
    before = std::move(t);
  }
  json.endArray();
}

/// Puts `value` in the place of the mark "{{name}}" of the template.
void fill(std::string& page, const std::string& name, std::string_view value) {
  const std::string mark = "{{" + name + "}}";
  const std::size_t at = page.find(mark);
  if (at != std::string::npos) page.replace(at, mark.size(), value);
}

}  // namespace

std::string replayData(const Frames& frames, const SignalTable& signals, const ReplayText& text) {
  std::string data;
  JsonWriter json(data);
  json.beginObject().member("format", "dynamy-replay").member("version", 1);
  json.member("title", text.title);
  json.key("model").beginObject();
  json.member("name", text.modelName).member("text", text.modelText).endObject();
  json.key("run").raw(text.runJson.empty() ? "null" : text.runJson);
  json.key("scene").raw(frames.scene.empty() ? R"({"view":"","frames":[],"shapes":[]})"
                                             : frames.scene);
  json.key("frames");
  writeFrames(json, frames, text.frameBytes);
  json.key("signals");
  writeSignals(json, signals);
  json.endObject();
  return data;
}

std::string replayPage(const Frames& frames, const SignalTable& signals, const ReplayText& text) {
  // '<' occurs in JSON inside strings only; escaped there, no "</script>" can end the data early
  const std::string raw = replayData(frames, signals, text);
  std::string data;
  data.reserve(raw.size());
  for (const char c : raw) {
    if (c == '<') {
      data += "\\u003c";
    } else {
      data += c;
    }
  }
  std::string script;
  for (const char* name : kScripts) script += viewerFile(name);

  // the data last: a mark inside the model text must not be filled
  std::string page(viewerFile("replay.html"));
  fill(page, "title", escapedXml(text.title));
  fill(page, "style", viewerFile("replay.css"));
  fill(page, "script", script);
  fill(page, "data", data);
  return page;
}

void writeReplay(const std::filesystem::path& folder) {
  const auto text = [&](const char* name) {
    std::error_code error;
    const auto file = folder / name;
    return std::filesystem::exists(file, error) ? readWholeFile(file) : std::string();
  };
  std::error_code error;
  Frames frames;
  if (std::filesystem::exists(folder / "frames.bin", error))
    frames = readFrames(folder / "frames.bin");
  SignalTable signals;
  if (std::filesystem::exists(folder / "signals.csv", error))
    signals = readSignals(folder / "signals.csv");
  ReplayText page;
  page.title = std::filesystem::absolute(folder).lexically_normal().filename().string();
  if (page.title.empty()) page.title = folder.parent_path().filename().string();
  page.runJson = text("run.json");
  page.modelName = "model.xml";
  page.modelText = text("model.xml");
  writeWholeFile(folder / "replay.html", replayPage(frames, signals, page));
}

}  // namespace dynamy
