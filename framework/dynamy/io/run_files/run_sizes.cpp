#include <fmt/format.h>

#include <array>
#include <cmath>
#include <dynamy/io/run_files/run_sizes.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>

namespace dynamy {
namespace {

constexpr double kNumberBytes = 18.0;   // shortest text of most doubles and its comma
constexpr double kPoseBytes = 28.0;     // 7 floats
constexpr double kPictureBytes = 16.0;  // time and counts

}  // namespace

RunSizes runSizes(const Model& model) {
  RunSizes s;
  const double until = model.simulation.until;
  const RecordSettings& r = model.record;
  s.rows = (r.every > 0.0  ? std::floor(until / r.every)
            : r.at.empty() ? 1000.0
                           : 0.0) +
           1.0 + static_cast<double>(r.at.size());
  s.columns = 1.0 + static_cast<double>(chooseSignals(model, r.signals, r.places).size());
  s.poses = static_cast<double>(drawnFrames(model).size());
  if (r.framesPerSecond > 0.0 && s.poses > 0.0)
    s.pictures = std::floor(until * r.framesPerSecond) + 1.0;
  s.bytes = s.rows * s.columns * kNumberBytes + s.pictures * (kPictureBytes + s.poses * kPoseBytes);
  return s;
}

void requireRoom(const Model& model, const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  const RunSizes s = runSizes(model);
  if (error || s.bytes <= static_cast<double>(space.available)) return;
  Diagnostic d;
  const Place& written = model.record.place;
  d.place = written.line > 0 ? written : Place(model.file.name);
  d.element = "record";
  d.text = fmt::format(
      "the run would write about {}: {:.6g} rows of {:g} numbers and {:.6g} pictures of {:g} "
      "poses; "
      "the disk of {} has {} left",
      bytesText(s.bytes), s.rows, s.columns, s.pictures, s.poses, folder.string(),
      bytesText(static_cast<double>(space.available)));
  d.hint = "take a longer every, fewer signals or fewer frames";
  throw ModelError(std::move(d));
}

std::string bytesText(double bytes) {
  static constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1000.0 && unit + 1 < kUnits.size()) bytes /= 1000.0, ++unit;
  return fmt::format("{:.3g} {}", bytes, kUnits[unit]);
}

}  // namespace dynamy
