/// A run as a film: the replay of a run folder is shown in a browser without a window, which draws
/// and codes it.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace dynamy::app {

struct VideoChoice {
  std::string file;               ///< .gif, .webm, .mp4; a folder for pictures
  int width = 960, height = 720;  ///< [px], even
  double fps = 25.0;
  std::optional<double> slower;    ///< than the mechanism; none: as the replay begins
  std::optional<double> from, to;  ///< of the run [s]
  std::string look;                ///< as in the address of the replay: "view=xz&theme=dark"
};

/// Throws CLI::ValidationError if no film has this kind of file.
void checkVideo(const VideoChoice& choice);

/// Writes the film of the page `replay`. Throws FileError.
void writeVideo(const std::filesystem::path& replay, const VideoChoice& choice);

}  // namespace dynamy::app
