#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/replay/replay_coding.hpp>
#include <limits>
#include <numeric>

namespace dynamy {
namespace {

constexpr std::size_t kManyPoses = 50;
constexpr std::size_t kArrows = 100;  ///< contacts of a frame that are kept in any case
constexpr int kNone = -32768;         ///< stands for the logarithm of zero
/// With few bodies each coordinate has a range of its own. With many bodies the range is that of
/// the scene, because finer steps are not visible, and equal steps for all bodies give similar
/// numbers, which deflate well.
constexpr PoseSteps kFewPoses{65535, 65535}, kManyPosesSteps{8192, 512};
constexpr ContactSteps kFewContacts{65535, 8192, 128}, kManyContacts{8192, 64, 8};
using Column = std::vector<std::uint16_t>;

/// Smallest and largest value of a coordinate; values that are not finite do not count.
struct CodedRange {
  float lo = std::numeric_limits<float>::infinity();
  float hi = -std::numeric_limits<float>::infinity();

  void take(float x) {
    if (!std::isfinite(x)) return;
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  bool isConstant() const { return !(lo < hi); }
  float length() const { return isConstant() ? 0.0f : hi - lo; }
  /// Maps lo … hi to 0 … steps.
  std::uint16_t rounded(float x, int steps) const {
    if (isConstant() || !std::isfinite(x)) return 0;
    const double share = (static_cast<double>(x) - lo) / (static_cast<double>(hi) - lo);
    return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
  }
};

std::uint16_t zigzag(std::uint16_t e) {
  return static_cast<std::uint16_t>((e << 1) ^ ((e & 0x8000u) != 0 ? 0xffffu : 0u));
}

/// Error of the prediction of c[f] from the `order` numbers before it, coded by zigzag(); the
/// prediction of the first number is 0.
std::uint16_t error(const Column& c, std::size_t f, int order) {
  const int a = f > 0 ? c[f - 1] : 0, b = f > 1 ? c[f - 2] : a;
  const int guess = order == 0 ? 0 : order == 1 ? a : 2 * a - b;
  return zigzag(static_cast<std::uint16_t>(c[f] - guess));
}

/// The order with the least sum of bits.
int bestOrder(const Column& c) {
  std::array<std::size_t, 3> bits{};
  for (std::size_t f = 0; f < c.size(); ++f)
    for (int order = 0; order < 3; ++order)
      bits[static_cast<std::size_t>(order)] +=
          static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(error(c, f, order))));
  return static_cast<int>(std::min_element(bits.begin(), bits.end()) - bits.begin());
}

/// Low and high bytes of the errors, stored separately.
struct Planes {
  std::string low, high;
  void add(const Column& c, int order) {
    for (std::size_t f = 0; f < c.size(); ++f) {
      const std::uint16_t e = error(c, f, order);
      low += static_cast<char>(e & 0xff);
      high += static_cast<char>(e >> 8);
    }
  }
  std::string text() const {
    std::string out;
    appendBase64(out, deflated(low + high));
    return out;
  }
};

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

/// The box with all edges as long as the longest, so that all axes have the same step.
std::array<CodedRange, 3> cube(std::array<CodedRange, 3> box) {
  float edge = 0.0f;
  for (const CodedRange& b : box) edge = std::max(edge, b.length());
  for (CodedRange& b : box)
    if (b.lo <= b.hi) b.hi = b.lo + edge;
  return box;
}

/// The logarithm of a force, in steps, because forces of impacts and of rest differ by powers of
/// ten.
int logarithm(double x, int octaveSteps) {
  if (!(x > 0.0) || !std::isfinite(x)) return kNone;
  return static_cast<int>(std::clamp(std::lround(std::log2(x) * octaveSteps), -32767L, 32767L));
}

/// Codes a contact as 12 integers (doc/replay.md).
std::array<int, kContactColumns> codedContact(const float* x, const std::array<CodedRange, 3>& box,
                                              const ContactSteps& steps) {
  const auto of = [](float part) { return std::isfinite(part) ? static_cast<double>(part) : 0.0; };
  const double size = std::hypot(of(x[6]), of(x[7]), of(x[8]));
  std::array<int, kContactColumns> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = box[k].rounded(x[k], steps.place);
    out[3 + k] = static_cast<int>(std::lround(std::clamp(of(x[3 + k]), -1.0, 1.0) * steps.turn));
    if (size > 0.0)
      out[7 + k] = static_cast<int>(std::lround(of(x[6 + k]) / size * steps.turn)) - out[3 + k];
  }
  out[6] = logarithm(size, steps.octave);
  out[10] = static_cast<int>(x[9]);
  const double limit = of(x[10]);
  out[11] = logarithm(size > 0.0 ? limit / size : limit, steps.octave);
  return out;
}

/// Indices of the contacts of frame f that are kept, ascending.
void strongest(const Frames& frames, std::size_t f, std::size_t most,
               std::vector<std::size_t>& kept) {
  kept.resize(frames.firstContact[f + 1] - frames.firstContact[f]);
  std::iota(kept.begin(), kept.end(), std::size_t{frames.firstContact[f]});
  if (kept.size() <= most) return;
  const auto force = [&frames](std::size_t c) {
    const float* const x = &frames.contact[c * Frames::kContactNumbers + 6];
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  };
  std::nth_element(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(most), kept.end(),
                   [&](std::size_t a, std::size_t b) {
                     return force(a) > force(b) || (force(a) == force(b) && a < b);
                   });
  kept.resize(most);
  std::sort(kept.begin(), kept.end());
}

}  // namespace

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()), 7);
  expects(status == Z_OK, "zlib compresses into a buffer of the size that it asked for");
  out.resize(size);
  return out;
}

std::vector<std::size_t> keptFrames(std::size_t count, std::size_t stride) {
  std::vector<std::size_t> kept;
  for (std::size_t f = 0; f < count; f += stride) kept.push_back(f);
  if (!kept.empty() && kept.back() + 1 != count) kept.push_back(count - 1);
  return kept;
}

CodedPoses codedPoses(const Frames& frames, const std::vector<std::size_t>& kept) {
  const std::vector<float> poses = smoothPoses(frames, kept);
  const std::size_t width = frames.poses * Frames::kPoseNumbers;
  const bool many = frames.poses >= kManyPoses;
  std::vector<CodedRange> ranges(width);
  std::array<CodedRange, 3> box;
  for (std::size_t k = 0; k < width; ++k) {
    for (std::size_t at = k; at < poses.size(); at += width) ranges[k].take(poses[at]);
    const std::size_t axis = k % Frames::kPoseNumbers;
    if (axis < 3) box[axis].take(ranges[k].lo), box[axis].take(ranges[k].hi);
  }
  const std::array<CodedRange, 3> scene = cube(box);
  CodedPoses out;
  out.steps = many ? kManyPosesSteps : kFewPoses;
  Planes planes;
  Column column;
  for (std::size_t k = 0; k < width; ++k) {
    CodedRange range = ranges[k];
    if (range.lo > range.hi) range = {0, 0};
    const std::size_t axis = k % Frames::kPoseNumbers;
    if (many && !range.isConstant()) range = axis < 3 ? scene[axis] : CodedRange{-1, 1};
    appendBytes(out.ranges, range.lo);
    appendBytes(out.ranges, range.hi);
    if (range.isConstant()) continue;
    column.clear();
    for (std::size_t at = k; at < poses.size(); at += width)
      column.push_back(range.rounded(poses[at], axis < 3 ? out.steps.place : out.steps.turn));
    const int order = bestOrder(column);
    out.orders += static_cast<char>(order);
    planes.add(column, order);
  }
  out.data = planes.text();
  return out;
}

CodedContacts codedContacts(const Frames& frames, const std::vector<std::size_t>& kept) {
  const bool many = frames.poses >= kManyPoses;
  std::array<CodedRange, 3> box;
  for (std::size_t at = 0; at < frames.contact.size(); at += Frames::kContactNumbers)
    for (std::size_t k = 0; k < 3; ++k) box[k].take(frames.contact[at + k]);
  if (many) box = cube(box);
  CodedContacts out;
  out.steps = many ? kManyContacts : kFewContacts;
  std::array<Column, kContactColumns> columns;
  const std::size_t most =
      many ? std::max(kArrows, frames.poses / 10) : std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> shown;
  for (const std::size_t f : kept) {
    strongest(frames, f, most, shown);
    const std::size_t recorded = frames.firstContact[f + 1] - frames.firstContact[f];
    out.recorded = std::max(out.recorded, recorded), out.kept = std::max(out.kept, shown.size());
    appendBytes(out.counts, static_cast<std::uint32_t>(shown.size()));
    for (const std::size_t c : shown) {
      const auto x = codedContact(&frames.contact[c * Frames::kContactNumbers], box, out.steps);
      for (std::size_t k = 0; k < x.size(); ++k)
        columns[k].push_back(static_cast<std::uint16_t>(x[k]));
    }
  }
  Planes planes;
  for (const Column& column : columns) planes.add(column, 0);
  out.data = planes.text();
  const bool any = !columns[0].empty();
  for (std::size_t k = 0; k < 3; ++k)
    out.box[2 * k] = any ? box[k].lo : 0.f, out.box[2 * k + 1] = any ? box[k].hi : 0.f;
  return out;
}

}  // namespace dynamy
