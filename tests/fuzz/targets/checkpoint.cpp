/// A checkpoint of any bytes: it is refused with words. And what a checkpoint keeps of a run,
/// behind a checksum that agrees: the run goes on or is refused. The first byte chooses the scene.
#include <cstdint>
#include <dynamy/io/run_files/checkpoint.hpp>

#include "../small_runs.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dynamy;
  static fuzz::World world;  // kStandardElements
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    readCheckpoint(bytes, "checkpoint");
  } catch (const FileError&) {
  }
  if (bytes.empty()) return 0;
  const auto scene = static_cast<std::size_t>(data[0]);
  fuzz::goesOn(world, scene, bytes.substr(1));
  return 0;
}
