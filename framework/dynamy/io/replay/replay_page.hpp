#pragma once
/// \file
/// replay.html: a run as one page that opens from disk, without a server and without a network.
/// Page = template + style + built script of app/viewer + one JSON object with scene, frames,
/// signals, events, ledger, run facts and model text; numbers are coded by replay_coding. Loading
/// frames.bin from the page was rejected: browsers forbid it for pages from disk.

#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <string>
#include <string_view>

namespace dynamy {

/// What the page shows beside frames and signals.
struct ReplayText {
  std::string title;
  std::string runJson = "null";  ///< content of run.json
  std::string modelName = {};    ///< file name of the model
  std::string modelText = {};
  std::string events = {};  ///< content of events.csv
  std::string ledger = {};  ///< content of ledger.csv
  std::string other = {};   ///< data object of another run that is laid over this one; empty: none
  bool beside = false;      ///< the other run has a picture of its own beside that of this one
  std::size_t frameBytes = 30'000'000;  ///< [byte] if frames take more, only every n-th is kept
};

/// How much of a film a page holds.
struct ReplaySize {
  std::size_t frames = 0, recorded = 0;            ///< in the page; in frames.bin
  std::size_t poseBytes = 0, contactBytes = 0;     ///< [byte] in the page, as text
  std::size_t contacts = 0, contactsRecorded = 0;  ///< most of a frame: in the page; in frames.bin
  std::size_t wholeBytes = 0;                      ///< [byte] that all frames would take
  bool thinned() const { return frames < recorded; }
};

/// The data object of the page as JSON (doc/replay.md).
std::string replayData(const Frames& frames, const SignalTable& signals, const ReplayText& text,
                       ReplaySize* size = nullptr);

/// The whole page.
std::string replayPage(const Frames& frames, const SignalTable& signals, const ReplayText& text,
                       ReplaySize* size = nullptr);

/// Writes replay.html into a run folder from the files that are in it. Files that are missing are
/// left out of the page. `other`: the folder of a run that is laid over this one; empty: none.
/// `beside`: it has a picture of its own. \throws FileError if a file is broken or the page cannot be
/// written
ReplaySize writeReplay(const std::filesystem::path& folder, const std::filesystem::path& other = {},
                       bool beside = false);

}  // namespace dynamy
