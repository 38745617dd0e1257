#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/io/bytes.hpp>
#include <dynamy/io/replay_coding.hpp>
#include <limits>
#include <numeric>

namespace dynamy {
namespace {

constexpr std::size_t kManyPoses = 50;  // from here on 12 bits of a quaternion are enough
/// Of so many poses nobody sees more of a body than these parts of the scene, and turns of its
/// components in a quaternion.
constexpr double kSeenPlace = 1.0 / 8192.0, kSeenTurn = 1.0 / 256.0;
constexpr std::size_t kArrows = 100;  ///< contacts of a frame that are kept in any case
using Column = std::vector<std::uint16_t>;

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
  /// lo … hi as 0 … steps, in multiples of `unit`.
  std::uint16_t rounded(float x, int steps = 65535, int unit = 1) const {
    if (isConstant() || !std::isfinite(x)) return 0;
    const double share = (static_cast<double>(x) - lo) / (static_cast<double>(hi) - lo);
    const long c = unit * std::lround(std::clamp(share, 0.0, 1.0) * steps / unit);
    return static_cast<std::uint16_t>(std::min<long>(c, steps));
  }
  /// The largest power of two whose steps are not above `seen`; 1 if one step is.
  int unit(int steps, double seen) const {
    int out = 1;
    while (out < steps && 2.0 * out * (static_cast<double>(hi) - lo) <= seen * steps) out *= 2;
    return out;
  }
};

std::uint16_t zigzag(std::uint16_t e) {
  return static_cast<std::uint16_t>((e << 1) ^ ((e & 0x8000u) != 0 ? 0xffffu : 0u));
}

/// Error of the prediction of c[f] from `order` numbers before; those before the first are 0.
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

/// Low and high bytes of the errors, apart from each other.
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

/// Forces of an impact and of rest differ by powers of ten: the upper half of an f32.
std::uint16_t upperHalf(float x) {
  return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(x) >> 16);
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
  CodedPoses out;
  if (frames.poses >= kManyPoses) out.turnSteps = 4095;
  const bool many = frames.poses >= kManyPoses;
  std::vector<Range> ranges(width);
  double extent = 0.0;  // of the scene
  std::array<Range, 3> box;
  for (std::size_t k = 0; k < width; ++k) {
    for (std::size_t at = k; at < poses.size(); at += width) ranges[k].take(poses[at]);
    const std::size_t axis = k % Frames::kPoseNumbers;
    if (axis < 3) box[axis].take(ranges[k].lo), box[axis].take(ranges[k].hi);
  }
  for (const Range& b : box)
    if (!b.isConstant()) extent = std::max(extent, static_cast<double>(b.hi) - b.lo);
  Planes planes;
  Column column;
  for (std::size_t k = 0; k < width; ++k) {
    Range& range = ranges[k];
    if (range.lo > range.hi) range = {0, 0};
    appendBytes(out.ranges, range.lo);
    appendBytes(out.ranges, range.hi);
    if (range.isConstant()) continue;
    column.clear();
    const bool place = k % Frames::kPoseNumbers < 3;
    const int steps = place ? 65535 : out.turnSteps;
    const int unit = many ? range.unit(steps, place ? kSeenPlace * extent : kSeenTurn) : 1;
    for (std::size_t at = k; at < poses.size(); at += width)
      column.push_back(range.rounded(poses[at], steps, unit));
    const int order = bestOrder(column);
    out.orders += static_cast<char>(order);
    planes.add(column, order);
  }
  out.data = planes.text();
  return out;
}

CodedContacts codedContacts(const Frames& frames, const std::vector<std::size_t>& kept) {
  std::array<Range, 3> box;
  for (std::size_t at = 0; at < frames.contact.size(); at += Frames::kContactNumbers)
    for (std::size_t k = 0; k < 3; ++k) box[k].take(frames.contact[at + k]);
  constexpr Range normal{-1, 1};
  CodedContacts out;
  std::array<Column, Frames::kContactNumbers> columns;
  const std::size_t most = frames.poses < kManyPoses ? std::numeric_limits<std::size_t>::max()
                                                     : std::max(kArrows, frames.poses / 10);
  std::vector<std::size_t> shown;
  for (const std::size_t f : kept) {
    strongest(frames, f, most, shown);
    const std::size_t recorded = frames.firstContact[f + 1] - frames.firstContact[f];
    out.recorded = std::max(out.recorded, recorded), out.kept = std::max(out.kept, shown.size());
    appendBytes(out.counts, static_cast<std::uint32_t>(shown.size()));
    for (const std::size_t c : shown) {
      const float* const x = &frames.contact[c * Frames::kContactNumbers];
      for (std::size_t k = 0; k < 3; ++k) columns[k].push_back(box[k].rounded(x[k]));
      for (std::size_t k = 3; k < 6; ++k) columns[k].push_back(normal.rounded(x[k]));
      for (std::size_t k = 6; k < 9; ++k) columns[k].push_back(upperHalf(x[k]));
      columns[9].push_back(static_cast<std::uint16_t>(x[9]));
      columns[10].push_back(upperHalf(x[10]));
    }
  }
  Planes planes;
  for (const Column& column : columns) planes.add(column, 1);
  out.data = planes.text();
  const bool any = !columns[0].empty();
  for (std::size_t k = 0; k < 3; ++k)
    out.box[2 * k] = any ? box[k].lo : 0.f, out.box[2 * k + 1] = any ? box[k].hi : 0.f;
  return out;
}

}  // namespace dynamy
