#pragma once
/// \file
/// How the film is coded in replay.html (doc/replay.md): numbers are rounded to the range that
/// each runs through, replaced by the error of a prediction from the numbers before, split into
/// planes of low and high bytes, deflated, and written in base64.
///
///     x → c = round((x − lo)/(hi − lo) · steps)          coordinates that never change: nothing
///     e_f = c_f,   c_f − c_{f−1}   or   c_f − 2c_{f−1} + c_{f−2}   (mod 2¹⁶), whichever is least
///     z = (e << 1) ^ (e >> 15), so that small errors of both signs have a high byte of zero
///
/// Every frame has another set of contacts, so that they cannot be predicted. But few steps are
/// enough for the direction of an arrow, and logarithms for its length.
///
/// Smooth motion leaves a few bits per number: about 5 bytes per body and frame, compared with 28
/// as f32. Rejected: coding only the three smallest components of a quaternion, because their
/// choice jumps, and a jump costs more than the fourth component. Also rejected: general video
/// codecs, which do not use that bodies move.

#include <array>
#include <dynamy/io/run_files/frames_file.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// `bytes` in the zlib format (RFC 1950).
std::string deflated(std::string_view bytes);

/// Indices 0, stride, 2 stride, … and the last of `count` frames.
std::vector<std::size_t> keptFrames(std::size_t count, std::size_t stride);

struct PoseSteps {
  int place = 65535;  ///< of the range of a position
  int turn = 65535;   ///< of that of a component of a quaternion
};

struct CodedPoses {
  PoseSteps steps;
  std::string ranges;  ///< f32 lo, hi of each coordinate 7 i + k
  std::string orders;  ///< one byte per changing coordinate: numbers that predict it
  std::string data;    ///< base64 of the deflated planes: all low bytes, then all high bytes
};

/// Codes the poses of the kept frames. Each quaternion gets the sign that is nearer to the one
/// before.
CodedPoses codedPoses(const Frames& frames, const std::vector<std::size_t>& kept);

struct ContactSteps {
  int place = 65535;  ///< of an edge of the box
  int turn = 8192;    ///< of 1, in components of unit vectors
  int octave = 128;   ///< of a factor of two, in forces
};

inline constexpr std::size_t kContactColumns = 12;

struct CodedContacts {
  ContactSteps steps;
  std::array<float, 6> box{};  ///< lo, hi of x, y, z around all contact points [m]
  std::string counts;          ///< u32: contacts of each kept frame
  std::string data;            ///< 12 columns as planes
  std::size_t recorded = 0;    ///< most contacts of one frame
  std::size_t kept = 0;        ///< most contacts of one frame that are kept
};

/// Codes the contacts of the kept frames. With many bodies only those with the largest forces are
/// kept, one for ten bodies and 100 at least: more arrows cannot be distinguished, and would take
/// ten times as much as the poses.
CodedContacts codedContacts(const Frames& frames, const std::vector<std::size_t>& kept);

}  // namespace dynamy
