#pragma once
/// \file
/// frames.bin: poses and contacts at recorded instants, in self-contained chunks. Little-endian;
/// doc/run_folder.md gives every byte:
///
///     head   "DYNFRAME" u32 version, u32 0x01020304, u32 poses, u32 bytes of JSON | JSON | u32 CRC
///     chunk  "CHNK" u32 frames, u64 bytes of payload, f64 first t, f64 last t, u32 CRC, u32 0
///            | payload
///     frame  f64 t, u32 contacts, f32 Δt | poses × 7 f32 (x y z qw qx qy qz) | contacts × 11 f32
///
/// Times are double, poses single: 2^-24 of the scene's size is far below a pixel, and signals.csv
/// has the full numbers. Forces are Λ/Δt; with Δt a reader gives impacts in N s. Version 2 had a zero
/// in its place and is still read. Rejected: one record per frame without chunks, which needs a checksum and
/// a flush for 40 bytes. Also rejected: an index at the end, because a killed run does not write
/// it.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/run_files/scene.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Version of the format that is written and read.
inline constexpr std::uint32_t kFramesVersion = 3;

/// Pose of a frame K of the scene.
struct Pose {
  Eigen::Vector3d r_OS_I = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond p_IK =
      Eigen::Quaterniond::Identity();  ///< A_IK as a unit quaternion; 0: absent
};

enum class ContactState { open = 0, stick = 1, slip = 2, impact = 3, spin = 4 };

/// A contact to be drawn: where, in which direction, and the force on the body the normal points
/// to. Normal part N = n·F, friction T = F − N n.
struct ContactMark {
  Eigen::Vector3d r_OC_I = Eigen::Vector3d::Zero();  ///< contact point [m]
  Eigen::Vector3d n_I = Eigen::Vector3d::UnitZ();    ///< unit normal
  Eigen::Vector3d F_I = Eigen::Vector3d::Zero();     ///< force Λ/Δt, of an impact, too [N]
  ContactState state = ContactState::open;
  double limit = 0.0;  ///< largest friction force that the law allows now [N]; 0: none
};

class FramesFile {
 public:
  /// Creates the file and writes its head; every frame then has scene.frames.size() poses.
  /// \throws FileError
  FramesFile(const std::filesystem::path& path, const Scene& scene);
  /// Continues the file of an earlier run after the bytes `keep`; it has `poses` poses per frame,
  /// and `pending` are bytes that could not be written. \throws FileError
  FramesFile(const std::filesystem::path& path, std::size_t poses, const FilePlace& keep,
             std::string pending = {});
  /// Writes the frames that are left. An error is not reported here; call flush() first to see it.
  ~FramesFile();
  FramesFile(const FramesFile&) = delete;
  FramesFile& operator=(const FramesFile&) = delete;

  /// Adds the frame at t [s]; `step` is the Δt of the forces [s], 0 if there is none. Does not allocate
  /// after the first chunk. \throws FileError
  void frame(double t, std::span<const Pose> poses, std::span<const ContactMark> contacts = {},
             double step = 0.0);
  /// Ends the chunk if the last one was written long ago: for loops with rare frames.
  void flushIfDue();
  /// Ends the chunk and writes it. \throws WriteError; the bytes left are kept for the next try
  void flush();
  /// The bytes in the file; pending() and frames since the last flush() are not part of them.
  const FilePlace& place() const { return file_.place(); }
  const std::string& pending() const { return head_; }
  void sync() { file_.sync(); }  ///< \throws WriteError

 private:
  OutputFile file_;
  std::size_t poses_;
  std::string payload_;
  std::string head_;  // head and chunks that are not written yet
  std::uint32_t frames_ = 0;
  double first_ = 0;
  double last_ = 0;
  std::chrono::steady_clock::time_point written_;
};

/// A frames.bin in memory.
struct Frames {
  static constexpr std::size_t kPoseNumbers = 7;      ///< x y z qw qx qy qz
  static constexpr std::size_t kContactNumbers = 11;  ///< position, normal, force, state, limit

  std::string scene;                         ///< JSON
  std::size_t poses = 0;                     ///< a frame
  std::vector<double> t;                     ///< [s], one a frame
  std::vector<float> step;                   ///< Δt of the forces [s], one a frame; 0: unknown
  std::vector<float> pose;                   ///< frame-major, 7 a pose
  std::vector<std::size_t> firstContact{0};  ///< frame f has contacts firstContact[f] … [f+1]−1
  std::vector<float> contact;                ///< 11 a contact
  bool complete = true;  ///< false: what follows the frames is broken or cut off
};

/// Reads frames.bin up to its end, or up to the first chunk that is cut off or has a wrong check
/// sum. \throws FileError if the head is not one of ours
Frames readFrames(const std::filesystem::path& path);
/// Reads the frames in the bytes of a file; `file` is named in messages.
Frames framesIn(std::string_view bytes, const std::string& file);

}  // namespace dynamy
