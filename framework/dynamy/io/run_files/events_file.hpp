#pragma once
/// \file
/// events.csv: one line for each impact and each contact that changed its status, at the end of the
/// step in which it happened (doc/run_folder.md). At most kMostEvents lines: a heap of grains has
/// millions, and nobody jumps from one to the next of those.

#include <dynamy/io/files/output_file.hpp>
#include <dynamy/simulation/report/record_sink.hpp>

namespace dynamy {

class EventsFile {
 public:
  static constexpr long kMostEvents = 20'000;

  /// Creates the file and writes its head. \throws FileError
  explicit EventsFile(const std::filesystem::path& path);
  /// Goes on at `keep` in the file of an earlier run, which had `events` lines and could not write
  /// `pending`. \throws FileError
  EventsFile(const std::filesystem::path& path, const FilePlace& keep, long events,
             std::string pending = {});
  ~EventsFile();
  EventsFile(const EventsFile&) = delete;
  EventsFile& operator=(const EventsFile&) = delete;

  /// Adds a line; `contact` is the name of the contact. \throws FileError
  void event(const ContactEvent& event, std::string_view contact);
  bool full() const { return events_ >= kMostEvents; }
  /// \throws WriteError; what is left is kept for the next try
  void flush();
  /// What is in the file; pending() is not.
  const FilePlace& place() const { return file_.place(); }
  const std::string& pending() const { return buffer_; }
  void sync() { file_.sync(); }  ///< \throws WriteError
  long events() const { return events_; }

 private:
  OutputFile file_;
  std::string buffer_;
  long events_ = 0;
};

}  // namespace dynamy
