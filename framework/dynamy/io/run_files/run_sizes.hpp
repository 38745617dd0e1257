/// RunSizes: estimates the files of a run from the model alone, before the run begins.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <filesystem>

namespace dynamy {

struct RunSizes {
  double rows = 0.0;      ///< of signals.csv, without the extra rows at impacts
  double columns = 0.0;   ///< of a row, the time among them
  double pictures = 0.0;  ///< of frames.bin
  double poses = 0.0;     ///< of a picture; the number of contacts is unknown
  double bytes = 0.0;     ///< of both files, approximately
};

/// `model` is built. A number in text takes about 18 bytes, a pose 28 (doc/run_folder.md).
RunSizes runSizes(const Model& model);

/// Throws ModelError if the disk of `folder` has less free space than the run will write.
void requireRoom(const Model& model, const std::filesystem::path& folder);

/// Text of a size: "3 kB", "1.2 GB".
std::string bytesText(double bytes);

}  // namespace dynamy
