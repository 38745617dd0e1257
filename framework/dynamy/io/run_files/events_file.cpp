#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/run_files/events_file.hpp>
#include <dynamy/io/run_files/signals_file.hpp>

namespace dynamy {
namespace {

constexpr std::size_t kEventBufferBytes = 1 << 16;

const char* kindOf(const ContactEvent& e) {
  switch (e.of) {
    case ContactEvent::Of::jump:
      return ",jump,";
    case ContactEvent::Of::sleep:
      return ",sleep,";
    case ContactEvent::Of::wake:
      return ",wake,";
    default:
      return e.impact ? ",impact," : ",switch,";
  }
}

}  // namespace

EventsFile::EventsFile(const std::filesystem::path& path) : file_(path) {
  buffer_.reserve(kEventBufferBytes + 512);
  buffer_ = "t,event,contact,from,to,speed,impulse\n";
  flush();
}

EventsFile::EventsFile(const std::filesystem::path& path, const FilePlace& keep, long events,
                       std::string pending)
    : file_(path, keep), buffer_(std::move(pending)), events_(events) {
  buffer_.reserve(kEventBufferBytes + 512);
}

EventsFile::~EventsFile() {
  try {
    flush();
  } catch (const FileError&) {  // a destructor cannot report it
  }
}

void EventsFile::event(const ContactEvent& e, std::string_view name) {
  if (events_++ >= kMostEvents) return;
  appendNumber(buffer_, e.t);
  const bool contact = e.of == ContactEvent::Of::contact;
  buffer_ += kindOf(e);
  appendCsvField(buffer_, name);
  buffer_ += ',';
  if (contact) buffer_ += statusText(e.from);
  buffer_ += ',';
  if (contact) buffer_ += statusText(e.to);
  buffer_ += ',';
  if (e.impact) appendNumber(buffer_, e.speed);
  buffer_ += ',';
  if (e.impact) appendNumber(buffer_, e.impulse);
  buffer_ += '\n';
  if (buffer_.size() >= kEventBufferBytes) flush();
}

void EventsFile::flush() { file_.write(buffer_); }

}  // namespace dynamy
