#pragma once
/// \file
/// events.csv: one line for each impact and each contact that changed its status, at the end of the
/// step in which it happened (doc/run_folder.md). At most kMostEvents lines: a heap of grains has
/// millions, and nobody jumps from one to the next of those.

#include <dynamy/io/output_file.hpp>
#include <dynamy/simulation/record_sink.hpp>

namespace dynamy {

class EventsFile {
 public:
  static constexpr long kMostEvents = 20'000;

  /// Creates the file and writes its head. \throws FileError
  explicit EventsFile(const std::filesystem::path& path);
  /// Goes on after the first `keep` bytes of the file of an earlier run, which has `events` lines.
  /// \throws FileError
  EventsFile(const std::filesystem::path& path, std::uint64_t keep, long events);
  ~EventsFile();
  EventsFile(const EventsFile&) = delete;
  EventsFile& operator=(const EventsFile&) = delete;

  /// Adds a line; `contact` is the name of the contact. \throws FileError
  void event(const ContactEvent& event, std::string_view contact);
  bool full() const { return events_ >= kMostEvents; }
  void flush();
  std::uint64_t size() const { return file_.size(); }
  long events() const { return events_; }

 private:
  OutputFile file_;
  std::string buffer_;
  long events_ = 0;
};

}  // namespace dynamy
