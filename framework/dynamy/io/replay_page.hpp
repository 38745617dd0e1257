#pragma once
/// \file
/// replay.html: a run as one page that opens from disk, without a server and without a network.
/// Page = template + style + scripts of app/viewer + one JSON object with scene, frames, signals,
/// run facts and model text. Poses are rounded to 16 bits of the range each coordinate runs through
/// (1e-5 of it, below a pixel); coordinates that never change take no space. Loading frames.bin
/// from the page was rejected: browsers forbid it for pages from disk.

#include <dynamy/io/frames_file.hpp>
#include <dynamy/io/signals_file.hpp>
#include <string>
#include <string_view>

namespace dynamy {

/// What the page shows beside frames and signals.
struct ReplayText {
  std::string title;
  std::string runJson = "null";  ///< content of run.json
  std::string modelName = {};    ///< file name of the model
  std::string modelText = {};
  std::size_t frameBytes =
      30'000'000;  ///< [byte] more than that, and only every n-th frame is kept
};

/// The data object of the page as JSON (doc/run_folder.md).
std::string replayData(const Frames& frames, const SignalTable& signals, const ReplayText& text);

/// The whole page.
std::string replayPage(const Frames& frames, const SignalTable& signals, const ReplayText& text);

/// Writes replay.html into a run folder from the files that are in it. Files that are missing are
/// left out of the page. \throws FileError if one is broken or the page cannot be written
void writeReplay(const std::filesystem::path& folder);

}  // namespace dynamy
