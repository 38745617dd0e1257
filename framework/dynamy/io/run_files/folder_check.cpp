#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/run_files/checkpoint.hpp>
#include <dynamy/io/run_files/events_file.hpp>
#include <dynamy/io/run_files/folder_check.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <functional>
#include <system_error>

namespace dynamy {
namespace fs = std::filesystem;
namespace {

constexpr long kMostBytes = 1L << 53;
constexpr double kSameTime = 1e-9;  ///< tolerance of the last time, over the end time

/// The statements of run.json about the other files.
struct Facts {
  std::string state;
  bool finished = false;  ///< or stopped between steps: rows and frames are complete
  double t = 0.0;         ///< reached [s]
  std::vector<std::string> signals;
  std::vector<RecordedFile> files;
};

std::uint32_t hexadecimal(const std::string& text) {
  std::uint32_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return value;
}

Facts readFacts(const RunFolder& folder) {
  const JsonValue run = readJson(readWholeFile(folder.facts()), "run.json");
  Facts out;
  out.state = run["state"].text;
  if (out.state.empty()) throw FileError("run.json", "does not say how the run ended");
  // A run that was stopped within a step gives a reason, like one that failed.
  out.finished =
      out.state == "finished" || (out.state.starts_with("stopped") && run["reason"].text.empty());
  out.t = run["t"].value;
  for (const JsonValue& s : run["signals"].items) out.signals.push_back(s["name"].text);
  for (const JsonValue& f : run["files"].items) {
    const std::optional<long> bytes = f["bytes"].whole(0, kMostBytes);
    if (!bytes) throw FileError("run.json", "does not say how long " + f["name"].text + " is");
    out.files.push_back(
        {f["name"].text, {static_cast<std::uint64_t>(*bytes), hexadecimal(f["crc"].text)}});
  }
  return out;
}

/// Compares the size and CRC-32 of a file with run.json. Throws FileError.
void compare(const RunFolder& folder, const Facts& facts, const std::string& name) {
  for (const RecordedFile& f : facts.files) {
    if (f.name != name) continue;
    const fs::path path = folder.path() / name;
    if (const std::string why = placeFault(path, f.place); !why.empty()) throw FileError(name, why);
    if (fs::file_size(path) != f.place.bytes)
      throw FileError(
          name, fmt::format("has {} bytes, the run wrote {}", fs::file_size(path), f.place.bytes));
  }
}

/// Checks that times do not decrease, and that they reach the end time of a finished run.
void compareTimes(const std::vector<double>& t, const Facts& facts, const std::string& name) {
  for (std::size_t i = 0; i < t.size(); ++i)
    if (!std::isfinite(t[i]) || (i > 0 && t[i] < t[i - 1]))
      throw FileError(name, fmt::format("row {}: the time goes back to {} s", i + 2, t[i]));
  if (!facts.finished || t.empty()) return;
  if (std::abs(t.back() - facts.t) > kSameTime * std::max(1.0, std::abs(facts.t)))
    throw FileError(name, fmt::format("ends at t = {} s, the run at t = {} s", t.back(), facts.t));
}

std::string rowsText(std::size_t rows, const std::vector<double>& t) {
  if (rows == 0) return "no row";
  return fmt::format("{} row{} to t = {:g} s", rows, rows == 1 ? "" : "s", t.back());
}

std::string checkSignals(const SignalTable& table, const Facts& facts, const std::string& name) {
  std::vector<std::string> names;
  for (const SignalName& s : table.signals) names.push_back(s.name);
  if (names != facts.signals && !facts.signals.empty())
    throw FileError(name, "names other signals than run.json");
  compareTimes(table.t, facts, name);
  return rowsText(table.t.size(), table.t);
}

std::string checkLedger(const RunFolder& folder, const Facts& facts) {
  const SignalTable table = signalsIn(readWholeFile(folder.ledger()), "ledger.csv");
  bool same = table.signals.size() == LedgerRow::kNumbers;
  for (std::size_t i = 0; same && i < LedgerRow::kNumbers; ++i)
    same = table.signals[i].name == LedgerRow::kNames[i];
  if (!same) throw FileError("ledger.csv:1", "names other columns than a ledger has");
  compareTimes(table.t, facts, "ledger.csv");
  return rowsText(table.t.size(), table.t);
}

std::string checkEvents(const RunFolder& folder) {
  const std::string text = readWholeFile(folder.events());
  const std::vector<std::vector<std::string>> lines = readCsv(text);
  if (lines.empty() || lines.front() != std::vector<std::string>{"t", "event", "contact", "from",
                                                                 "to", "speed", "impulse"})
    throw FileError("events.csv:1", "has another head than a list of events");
  if (lines.size() > EventsFile::kMostEvents + 1)
    throw FileError("events.csv", "has more events than a run writes");
  const auto isStatus = [](const std::string& word) {
    for (int s = 0; s <= static_cast<int>(Status::locked); ++s)
      if (statusText(static_cast<Status>(s)) == word) return true;
    return false;
  };
  const auto isEvent = [&](const std::vector<std::string>& f) {
    if (f[1] == "impact" || f[1] == "switch") return isStatus(f[3]) && isStatus(f[4]);
    const bool ofSystem = f[1] == "jump" || f[1] == "sleep" || f[1] == "wake";
    return ofSystem && f[3].empty() && f[4].empty();
  };
  double before = -1.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string>& f = lines[i];
    double t = 0.0;
    const bool time = !f[0].empty() &&
                      std::from_chars(f[0].data(), f[0].data() + f[0].size(), t).ec == std::errc();
    if (f.size() != 7 || !time || !(t >= before) || !isEvent(f))
      throw FileError(fmt::format("events.csv:{}", i + 1),
                      "is no event that follows the one before");
    before = t;
  }
  return fmt::format("{} event{}", lines.size() - 1, lines.size() == 2 ? "" : "s");
}

std::string checkFrames(const RunFolder& folder, const Facts& facts) {
  const Frames frames = framesIn(readWholeFile(folder.frames()), "frames.bin");
  readJson(frames.scene, "frames.bin");
  if (!frames.complete && facts.finished)
    throw FileError("frames.bin", fmt::format("is damaged after {} frames", frames.t.size()));
  if (!std::is_sorted(frames.t.begin(), frames.t.end()))
    throw FileError("frames.bin", "its times go back");
  return fmt::format("{} frame{} of {} pose{}{}", frames.t.size(), frames.t.size() == 1 ? "" : "s",
                     frames.poses, frames.poses == 1 ? "" : "s",
                     frames.complete ? "" : "; the last chunk is cut off");
}

std::string checkCheckpoint(const RunFolder& folder, const fs::path& file) {
  const Checkpoint c = readCheckpoint(readWholeFile(file), file.filename().string());
  for (const RecordedFile& f : c.files)
    if (f.name == "signals.csv" && !fs::exists(folder.signals())) {
      if (!fs::exists(packedSignals(folder)))
        throw FileError(file.filename().string(),
                        "needs signals.csv or signals.h5, which are missing");
    } else if (const std::string why =
                   placeFault(folder.path() / fs::path(f.name).filename(), f.place);
               !why.empty())
      throw FileError(file.filename().string(), "does not go with " + f.name + ", which " + why);
  if (fs::exists(folder.model()) && readWholeFile(folder.model()) != c.modelText)
    throw FileError(file.filename().string(), "is of another model than model.xml");
  return fmt::format("the run at t = {:g} s", c.t);
}

FileVerdict verdict(const std::string& file, const std::function<std::string()>& look) {
  FileVerdict out;
  out.file = file;
  try {
    out.text = look();
  } catch (const std::exception& e) {  // errors of files, with path and reason; lack of memory
    out.good = false, out.text = e.what();
    for (const std::string& twice : {file + ": ", file + ':'})
      if (out.text.starts_with(twice)) out.text.erase(0, twice.size());
  }
  return out;
}

std::string runText(const RunFolder& folder, const Facts& facts) {
  if (facts.state != "running") return facts.state + fmt::format(" at t = {:g} s", facts.t);
  const std::string who = FolderLock::holder(folder.path());
  if (!who.empty()) return "running, " + who;
  return "was killed while it ran: dynamy resume goes on from its checkpoint";
}

}  // namespace

std::vector<FileVerdict> checkFolder(const fs::path& path) {
  const RunFolder folder = RunFolder::existing(path);
  std::vector<FileVerdict> out;
  Facts facts;
  out.push_back(verdict("run.json", [&] {
    facts = readFacts(folder);
    return runText(folder, facts);
  }));
  const auto table = [&](const fs::path& file, const std::function<std::string()>& look) {
    const std::string name = file.filename().string();
    out.push_back(verdict(name, [&] {
      std::string text = look();
      compare(folder, facts, name);
      return text;
    }));
  };
  std::error_code error;
  const bool packed = fs::exists(packedSignals(folder), error);
  if (!packed || fs::exists(folder.signals(), error))
    table(folder.signals(), [&] {
      return checkSignals(signalsIn(readWholeFile(folder.signals()), "signals.csv"), facts,
                          "signals.csv:1");
    });
  if (packed)
    table(packedSignals(folder), [&] {
      return checkSignals(readPackedSignals(packedSignals(folder)), facts, "signals.h5");
    });
  table(folder.events(), [&] { return checkEvents(folder); });
  table(folder.ledger(), [&] { return checkLedger(folder, facts); });
  table(folder.frames(), [&] { return checkFrames(folder, facts); });
  for (const fs::path& file : {folder.checkpoint(), folder.olderCheckpoint()})
    if (fs::exists(file, error))
      out.push_back(
          verdict(file.filename().string(), [&] { return checkCheckpoint(folder, file); }));
  return out;
}

}  // namespace dynamy
