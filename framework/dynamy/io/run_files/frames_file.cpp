#include <dynamy/core/error.hpp>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <string_view>

namespace dynamy {
namespace {

constexpr std::string_view kFramesMagic = "DYNFRAME";
constexpr std::string_view kChunk = "CHNK";
constexpr std::uint32_t kFramesByteOrder = 0x01020304u;
constexpr std::size_t kFileHead = 24;   // magic, version, byte order, poses, bytes of JSON
constexpr std::size_t kChunkHead = 40;  // "CHNK", frames, bytes, first and last t, CRC, 0
constexpr std::size_t kFramesCrcAt =
    32;  // the CRC of a chunk covers its head up to here, and the payload
constexpr std::uint32_t kOldestVersion = 2;  // without Δt
constexpr std::size_t kFrameHead = 16;       // t, contacts, Δt
constexpr std::size_t kChunkBytes = 1 << 18;
constexpr auto kFrameDue = std::chrono::milliseconds(500);

void append(std::string& out, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) appendBytes(out, static_cast<float>(v[i]));
}

/// Adds the frames of a payload; false if it does not hold exactly `count` of them.
bool readPayload(std::string_view payload, std::uint32_t count, Frames& frames) {
  std::size_t at = 0;
  const auto floats = [&](std::size_t n, std::vector<float>& out) {
    for (std::size_t i = 0; i < n; ++i, at += 4) out.push_back(readBytes<float>(&payload[at]));
  };
  for (std::uint32_t f = 0; f < count; ++f) {
    if (payload.size() - at < kFrameHead) return false;
    const auto t = readBytes<double>(&payload[at]);
    const std::size_t contacts = readBytes<std::uint32_t>(&payload[at + 8]);
    const auto step = readBytes<float>(&payload[at + 12]);
    at += kFrameHead;
    const std::size_t numbers =
        frames.poses * Frames::kPoseNumbers + contacts * Frames::kContactNumbers;
    if ((payload.size() - at) / 4 < numbers) return false;
    frames.t.push_back(t);
    frames.step.push_back(step);
    floats(frames.poses * Frames::kPoseNumbers, frames.pose);
    floats(contacts * Frames::kContactNumbers, frames.contact);
    frames.firstContact.push_back(frames.firstContact.back() + contacts);
  }
  return at == payload.size();
}

/// Reads the chunk at the beginning of `rest` and returns its size in bytes; 0 if it is cut off or
/// broken.
std::size_t readChunk(std::string_view rest, Frames& frames) {
  if (rest.size() < kChunkHead || rest.substr(0, 4) != kChunk) return 0;
  const auto count = readBytes<std::uint32_t>(&rest[4]);
  const auto bytes = readBytes<std::uint64_t>(&rest[8]);
  if (bytes > rest.size() - kChunkHead) return 0;
  const std::string_view payload = rest.substr(kChunkHead, bytes);
  const auto crc = readBytes<std::uint32_t>(&rest[kFramesCrcAt]);
  if (crc != crc32(payload, crc32(rest.substr(0, kFramesCrcAt)))) return 0;
  if (readBytes<std::uint32_t>(&rest[kFramesCrcAt + 4]) != 0) return 0;
  return readPayload(payload, count, frames) ? kChunkHead + bytes : 0;
}

}  // namespace

FramesFile::FramesFile(const std::filesystem::path& path, const Scene& scene)
    : file_(path), poses_(scene.frames.size()) {
  std::string json;
  JsonWriter writer(json);
  write(writer, scene);
  head_ = kFramesMagic;
  appendBytes(head_, kFramesVersion);
  appendBytes(head_, kFramesByteOrder);
  appendBytes(head_, static_cast<std::uint32_t>(poses_));
  appendBytes(head_, static_cast<std::uint32_t>(json.size()));
  head_ += json;
  appendBytes(head_, crc32(head_));
  file_.write(head_);
  payload_.reserve(kChunkBytes + kFrameHead + poses_ * Frames::kPoseNumbers * 4);
  written_ = std::chrono::steady_clock::now();
}

FramesFile::FramesFile(const std::filesystem::path& path, std::size_t poses, const FilePlace& keep,
                       std::string pending)
    : file_(path, keep), poses_(poses), head_(std::move(pending)) {
  payload_.reserve(kChunkBytes + kFrameHead + poses_ * Frames::kPoseNumbers * 4);
  written_ = std::chrono::steady_clock::now();
}

FramesFile::~FramesFile() {
  try {
    flush();
  } catch (const FileError&) {  // a destructor cannot report it
  }
}

void FramesFile::frame(double t, std::span<const Pose> poses, std::span<const ContactMark> contacts,
                       double step) {
  expects(poses.size() == poses_, "a frame has one pose a frame of the scene");
  if (frames_++ == 0) first_ = t;
  last_ = t;
  appendBytes(payload_, t);
  appendBytes(payload_, static_cast<std::uint32_t>(contacts.size()));
  appendBytes(payload_, static_cast<float>(step));
  for (const Pose& pose : poses) {
    append(payload_, pose.r_OS_I);
    appendBytes(payload_, static_cast<float>(pose.p_IK.w()));
    append(payload_, pose.p_IK.vec());
  }
  for (const ContactMark& contact : contacts) {
    append(payload_, contact.r_OC_I);
    append(payload_, contact.n_I);
    append(payload_, contact.F_I);
    appendBytes(payload_, static_cast<float>(contact.state));
    appendBytes(payload_, static_cast<float>(contact.limit));
  }
  if (payload_.size() >= kChunkBytes) {
    flush();
  } else {
    flushIfDue();
  }
}

void FramesFile::flushIfDue() {
  if (std::chrono::steady_clock::now() - written_ >= kFrameDue) flush();
}

void FramesFile::flush() {
  written_ = std::chrono::steady_clock::now();
  if (frames_ > 0) {
    const std::size_t begin = head_.size();
    head_ += kChunk;
    appendBytes(head_, frames_);
    appendBytes(head_, static_cast<std::uint64_t>(payload_.size()));
    appendBytes(head_, first_);
    appendBytes(head_, last_);
    appendBytes(head_, crc32(payload_, crc32(std::string_view(head_).substr(begin))));
    appendBytes(head_, std::uint32_t{0});
    head_ += payload_;
    payload_.clear();
    frames_ = 0;
  }
  file_.write(head_);
}

Frames readFrames(const std::filesystem::path& path) {
  return framesIn(readWholeFile(path), path.string());
}

Frames framesIn(std::string_view text, const std::string& file) {
  if (text.size() < kFileHead || text.substr(0, kFramesMagic.size()) != kFramesMagic) {
    throw FileError(file, "is no frames.bin of dynamy");
  }
  if (readBytes<std::uint32_t>(&text[12]) != kFramesByteOrder) {
    throw FileError(file, "the byte order mark is broken");
  }
  const auto version = readBytes<std::uint32_t>(&text[8]);
  if (version < kOldestVersion || version > kFramesVersion) {
    throw FileError(file, "has version " + std::to_string(version) +
                              " of the format, this program reads the versions " +
                              std::to_string(kOldestVersion) + " to " +
                              std::to_string(kFramesVersion));
  }
  const std::size_t json = readBytes<std::uint32_t>(&text[20]);
  if (text.size() < kFileHead + json + 4 || readBytes<std::uint32_t>(&text[kFileHead + json]) !=
                                                crc32(text.substr(0, kFileHead + json))) {
    throw FileError(file, "the head is cut off or broken");
  }

  Frames frames;
  frames.poses = readBytes<std::uint32_t>(&text[16]);
  frames.scene = text.substr(kFileHead, json);
  std::size_t at = kFileHead + json + 4;
  while (at < text.size()) {
    const std::size_t bytes = readChunk(text.substr(at), frames);
    frames.complete = bytes > 0;
    if (!frames.complete) break;
    at += bytes;
  }
  constexpr auto kLastState = static_cast<float>(ContactState::spin);
  for (std::size_t c = 9; c < frames.contact.size(); c += Frames::kContactNumbers)
    if (!(frames.contact[c] >= 0.0F && frames.contact[c] <= kLastState))
      throw FileError(file, "a contact has a state that there is not");
  return frames;
}

}  // namespace dynamy
