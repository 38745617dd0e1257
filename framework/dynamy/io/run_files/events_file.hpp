#pragma once
/// \file
/// events.csv: one line for each impact, each contact that changed its status and each jump of a
/// system, at the end of the step in which it happened (doc/run_folder.md). The file has at most
/// kMostEvents lines: a heap of grains has millions of events, and nobody steps through those one
/// by one. The events after that are counted (`eventsLeftOut` of run.json).

#include <dynamy/io/files/output_file.hpp>
#include <dynamy/simulation/report/record_sink.hpp>

namespace dynamy {

class EventsFile {
 public:
  static constexpr long kMostEvents = 20'000;

  /// Creates the file and writes its head. \throws FileError
  explicit EventsFile(const std::filesystem::path& path);
  /// Continues the file of an earlier run after the bytes `keep`; it had `events` events, and
  /// `pending` is text that could not be written. \throws FileError
  EventsFile(const std::filesystem::path& path, const FilePlace& keep, long events,
             std::string pending = {});
  ~EventsFile();
  EventsFile(const EventsFile&) = delete;
  EventsFile& operator=(const EventsFile&) = delete;

  /// Adds a line, or counts the event if the file is full; `name` is that of the contact, or of the
  /// system. \throws FileError
  void event(const ContactEvent& event, std::string_view name);
  bool full() const { return events_ >= kMostEvents; }
  /// \throws WriteError; the text left is kept for the next try
  void flush();
  /// The bytes in the file; pending() is not part of them.
  const FilePlace& place() const { return file_.place(); }
  const std::string& pending() const { return buffer_; }
  void sync() { file_.sync(); }            ///< \throws WriteError
  long events() const { return events_; }  ///< written and left out
  long leftOut() const { return full() ? events_ - kMostEvents : 0; }

 private:
  OutputFile file_;
  std::string buffer_;
  long events_ = 0;
};

}  // namespace dynamy
