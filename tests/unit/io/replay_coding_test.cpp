#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <dynamy/io/bytes.hpp>
#include <dynamy/io/replay_coding.hpp>

namespace dynamy {
namespace {

/// The bytes behind base64 text of zlib data, by zlib itself.
std::string unpacked(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0;
  int bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    word = word << 6 | static_cast<unsigned>(digits.find(c));
    if ((bits += 6) >= 8) bytes += static_cast<char>(word >> (bits -= 8) & 0xff);
  }
  std::string out(1 << 22, '\0');
  uLongf size = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  out.resize(size);
  return out;
}

/// Columns behind the planes, decoded as the document says.
std::vector<std::vector<int>> columns(const std::string& planes, const std::string& orders) {
  const std::size_t n = orders.size(), count = n > 0 ? planes.size() / 2 / n : 0;
  std::vector<std::vector<int>> out(n);
  for (std::size_t v = 0; v < n; ++v) {
    for (std::size_t f = 0; f < count; ++f) {
      const std::size_t at = v * count + f;
      const int z = static_cast<unsigned char>(planes[at]) |
                    static_cast<unsigned char>(planes[n * count + at]) << 8;
      const int e = (z >> 1) ^ -(z & 1);
      const int a = f > 0 ? out[v][f - 1] : 0, b = f > 1 ? out[v][f - 2] : a;
      const int guess = orders[v] == 0 ? 0 : orders[v] == 1 ? a : 2 * a - b;
      out[v].push_back((e + guess) & 0xffff);
    }
  }
  return out;
}

/// One pose that moves as `x` says along x, the other coordinates standing.
template <class F>
Frames along(std::size_t n, F&& x) {
  Frames frames;
  frames.poses = 1;
  for (std::size_t f = 0; f < n; ++f) {
    frames.t.push_back(static_cast<double>(f));
    for (const float c : {static_cast<float>(x(f)), 2.f, 0.f, 1.f, 0.f, 0.f, 0.f})
      frames.pose.push_back(c);
    frames.firstContact.push_back(0);
  }
  return frames;
}

TEST(CodedPoses, AreReadBackWithinHalfAStepOfTheirRange) {
  const auto x = [](std::size_t f) { return std::sin(0.1 * static_cast<double>(f)); };
  const Frames frames = along(200, x);
  const CodedPoses coded = codedPoses(frames, keptFrames(200, 1));
  ASSERT_EQ(coded.orders.size(), 1u);  // what stands takes nothing
  const auto course = columns(unpacked(coded.data), coded.orders);
  const auto lo = readBytes<float>(coded.ranges.data()), hi = readBytes<float>(&coded.ranges[4]);
  EXPECT_EQ(readBytes<float>(&coded.ranges[8]), 2.f);
  const double step = (static_cast<double>(hi) - static_cast<double>(lo)) / 65535.0;
  for (std::size_t f = 0; f < 200; ++f) {
    // half a step, and the rounding of x to single precision
    EXPECT_NEAR(static_cast<double>(lo) + step * course[0][f], x(f), 0.51 * step + 6e-8);
  }
}

TEST(CodedPoses, SmoothMotionIsPredictedByTwoNumbersAndAlternationByNone) {
  const auto smooth = [](std::size_t f) { return 1e-3 * static_cast<double>(f * f); };
  const auto alternating = [](std::size_t f) {
    return f == 5 ? 3.0 : f % 2 == 0 ? 0.0 : 1.0;  // one value far off: the others are small
  };
  EXPECT_EQ(codedPoses(along(300, smooth), keptFrames(300, 1)).orders, std::string(1, '\2'));
  EXPECT_EQ(codedPoses(along(300, alternating), keptFrames(300, 1)).orders, std::string(1, '\0'));
}

TEST(CodedPoses, TakeTheNearerOfTwoEqualQuaternions) {
  Frames frames = along(2, [](std::size_t) { return 0.0; });
  frames.pose[7 + 3] = -1.f;  // the same rotation
  EXPECT_TRUE(codedPoses(frames, keptFrames(2, 1)).orders.empty());
}

TEST(CodedPoses, ATumblingHeapTakesAtMostEightBytesABodyAndFrame) {
  Frames frames;
  frames.poses = 600;
  constexpr std::size_t kFrames = 60;
  for (std::size_t f = 0; f < kFrames; ++f) {
    const double t = static_cast<double>(f) / 60.0;
    frames.t.push_back(t);
    frames.firstContact.push_back(0);
    for (std::size_t i = 0; i < frames.poses; ++i) {
      // thrown up with its own speed and spin, bouncing every second
      const auto k = static_cast<double>(i);
      const double s = std::fmod(t + 0.37 * k, 1.0), spin = (1.0 + std::fmod(k, 7.0)) * t;
      const double r[] = {0.1 * k + 0.3 * std::sin(k) * t, std::cos(k) * t, 5.0 * s * (1.0 - s)};
      const double q[] = {std::cos(spin), std::sin(spin) * std::sin(k),
                          std::sin(spin) * std::cos(k), 0.0};
      for (const double c : r) frames.pose.push_back(static_cast<float>(c));
      for (const double c : q) frames.pose.push_back(static_cast<float>(c));
    }
  }
  const CodedPoses coded = codedPoses(frames, keptFrames(kFrames, 1));
  EXPECT_LE(coded.data.size(), 8 * frames.poses * kFrames);
}

TEST(CodedContacts, AreReadBack) {
  Frames frames;
  frames.poses = 0;
  frames.t = {0.0, 1.0};
  frames.contact = {0, 0, 0, 0, 0, 1, 1, -2, 8, 2, 3, 4, 2, 1, 0, 1, 0, 0, 0, 0.5f, 1, 5};
  frames.firstContact = {0, 2, 2};
  const CodedContacts coded = codedContacts(frames, keptFrames(2, 1));
  EXPECT_EQ(readBytes<std::uint32_t>(coded.counts.data()), 2u);
  EXPECT_EQ(readBytes<std::uint32_t>(&coded.counts[4]), 0u);
  const auto c = columns(unpacked(coded.data), std::string(11, '\1'));
  EXPECT_EQ(coded.box, (std::array<float, 6>{0, 4, 0, 2, 0, 1}));
  EXPECT_EQ(c[0], (std::vector<int>{0, 65535}));
  EXPECT_EQ(c[5], (std::vector<int>{65535, 32768}));  // 1 and 0 in −1 … 1
  const std::vector<std::vector<float>> upper = {{1, 0}, {-2, 0}, {8, 0.5f}};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i)  // these floats have an empty lower half
      EXPECT_EQ(c[6 + k][i], static_cast<int>(std::bit_cast<std::uint32_t>(upper[k][i]) >> 16));
  EXPECT_EQ(c[9], (std::vector<int>{2, 1}));
}

}  // namespace
}  // namespace dynamy
