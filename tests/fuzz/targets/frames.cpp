/// A frames.bin of any bytes: frames up to the first fault, or an error that names the file.
#include <cstdint>
#include <cstdlib>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/frames_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dynamy;
  try {
    const Frames f = framesIn({reinterpret_cast<const char*>(data), size}, "frames.bin");
    if (f.pose.size() != f.t.size() * f.poses * Frames::kPoseNumbers ||
        f.firstContact.size() != f.t.size() + 1 ||
        f.contact.size() != f.firstContact.back() * Frames::kContactNumbers)
      std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
