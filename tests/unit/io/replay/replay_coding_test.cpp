#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/replay/replay_coding.hpp>

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

TEST(CodedPoses, OfManyBodiesShareTheirSteps) {
  // 60 points on a line of 8.192 m; each moves a little. Steps are 1 mm for every axis of each.
  Frames frames;
  frames.poses = 60;
  const auto x = [](std::size_t f, std::size_t i) {
    return static_cast<float>(i) * 8.192f / 59.f - (f == 1 ? 0.002f * (i == 59 ? 1.f : 0.5f) : 0.f);
  };
  for (std::size_t f = 0; f < 2; ++f) {
    frames.t.push_back(static_cast<double>(f));
    frames.firstContact.push_back(0);
    for (std::size_t i = 0; i < frames.poses; ++i)
      for (const float c : {x(f, i), 1.f, 2.f, 1.f, 0.f, 0.f, 0.f}) frames.pose.push_back(c);
  }
  const CodedPoses coded = codedPoses(frames, keptFrames(2, 1));
  EXPECT_EQ(coded.steps.place, 8192);
  ASSERT_EQ(coded.orders.size(), 60u);
  const auto course = columns(unpacked(coded.data), coded.orders);
  const auto lo = readBytes<float>(coded.ranges.data()), hi = readBytes<float>(&coded.ranges[4]);
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_EQ(readBytes<float>(&coded.ranges[56 * i]), lo);
    EXPECT_EQ(readBytes<float>(&coded.ranges[56 * i + 4]), hi);
    for (std::size_t f = 0; f < 2; ++f)  // half a step, and what single precision leaves of 8 m
      EXPECT_NEAR(static_cast<double>(lo) + (static_cast<double>(hi) - lo) * course[i][f] / 8192,
                  x(f, i), 0.5e-3 + 2e-6);
  }
}

/// Contacts of a film of `poses` poses that stand.
Frames standing(std::size_t poses, const std::vector<std::vector<float>>& contacts) {
  Frames frames;
  frames.poses = poses;
  frames.t = {0.0};
  for (std::size_t i = 0; i < poses; ++i)
    for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f}) frames.pose.push_back(c);
  for (const auto& c : contacts) frames.contact.insert(frames.contact.end(), c.begin(), c.end());
  frames.firstContact = {0, contacts.size()};
  return frames;
}

double powerOf(int x, int steps) {
  return x == -32768 ? 0.0 : std::exp2(static_cast<double>(x) / steps);
}

/// Point, normal, force, state and limit as the document says they are read.
std::vector<double> decoded(const CodedContacts& coded, const std::vector<std::vector<int>>& c,
                            std::size_t i) {
  std::vector<double> out;
  std::array<int, 12> x{};
  for (std::size_t k = 0; k < 12; ++k) x[k] = static_cast<std::int16_t>(c[k][i]);
  for (std::size_t k = 0; k < 3; ++k) {
    const double lo = static_cast<double>(coded.box[2 * k]);
    out.push_back(lo +
                  (static_cast<double>(coded.box[2 * k + 1]) - lo) * c[k][i] / coded.steps.place);
  }
  const double n = std::hypot(x[3], x[4], x[5]);
  for (std::size_t k = 3; k < 6; ++k) out.push_back(x[k] / n);
  const double e = std::hypot(x[3] + x[7], x[4] + x[8], x[5] + x[9]);
  const double size = powerOf(x[6], coded.steps.octave);
  for (std::size_t k = 3; k < 6; ++k) out.push_back(size * (x[k] + x[4 + k]) / (e > 0 ? e : 1.0));
  out.push_back(x[10]);
  out.push_back(powerOf(x[11], coded.steps.octave) * (size > 0.0 ? size : 1.0));
  return out;
}

TEST(CodedContacts, AreReadBackWithinTheirSteps) {
  const std::vector<std::vector<float>> contacts = {
      {0, 0, 0, 0, 0, 1, 1, -2, 8, 2, 3},                 // slips
      {4, 2, 0, 1, 0, 0, 0, 0, 0, 1, 5},                  // no force, but a limit
      {1, 0.3f, -2, 0.6f, 0, 0.8f, 6e5f, 0, 8e5f, 3, 0},  // along the normal, large, no limit
      {1, 0, 0, 0, -1, 0, 1e-6f, 1e-6f, 1e-6f, 1, 4e-7f}};
  for (const std::size_t poses : {1u, 60u}) {
    const CodedContacts coded = codedContacts(standing(poses, contacts), keptFrames(1, 1));
    EXPECT_EQ(readBytes<std::uint32_t>(coded.counts.data()), 4u);
    const auto c = columns(unpacked(coded.data), std::string(12, '\0'));
    // half a step: of a part of the box (edge 4 m), of each component, of an octave
    const double place = 0.51 * 4.0 / coded.steps.place, turn = 1.5 / coded.steps.turn;
    const double share = std::exp2(0.51 / coded.steps.octave) - 1.0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto& x = contacts[i];
      const auto y = decoded(coded, c, i);
      const double size = std::hypot(x[6], x[7], x[8]);
      for (std::size_t k = 0; k < 11; ++k) {
        const double limit = static_cast<double>(x[10]);
        const double error = k < 3    ? place
                             : k < 6  ? turn
                             : k < 9  ? (turn + share) * size
                             : k == 9 ? 0.0
                                      : 2.1 * share * limit;
        EXPECT_NEAR(y[k], static_cast<double>(x[k]), error) << "contact " << i << ", number " << k;
      }
    }
  }
}

}  // namespace
}  // namespace dynamy
