/// RunSizes: what a run will write, from the model alone, before it begins.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <filesystem>

namespace dynamy {

struct RunSizes {
  double rows = 0.0;      ///< of signals.csv, but for those on both sides of impacts
  double columns = 0.0;   ///< of a row, the time among them
  double pictures = 0.0;  ///< of frames.bin
  double poses = 0.0;     ///< of a picture; its contacts come with the motion
  double bytes = 0.0;     ///< of both files, about
};

/// `model` is built. A number in text takes about 18 bytes, a pose 28 (doc/run_folder.md).
RunSizes runSizes(const Model& model);

/// Throws ModelError if the disk of `folder` has less room left than the run will write.
void requireRoom(const Model& model, const std::filesystem::path& folder);

/// "3 kB", "1.2 GB".
std::string bytesText(double bytes);

}  // namespace dynamy
