#include <charconv>
#include <dynamy/core/error.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <string_view>

namespace dynamy {
namespace {

constexpr std::size_t kRowBufferBytes = 1 << 16;
constexpr std::size_t kBytesPerNumber = 26;  // 24 digits at most, and a comma or the line's end
constexpr auto kRowsDue = std::chrono::milliseconds(500);

}  // namespace

SignalsFile::SignalsFile(const std::filesystem::path& path, std::span<const SignalName> signals)
    : file_(path), columns_(signals.size()) {
  buffer_.reserve(kRowBufferBytes + kBytesPerNumber * (columns_ + 1));
  buffer_ = "t";
  for (const SignalName& signal : signals) {
    buffer_ += ',';
    appendCsvField(buffer_, signal.name);
  }
  buffer_ += '\n';
  flush();
}

SignalsFile::SignalsFile(const std::filesystem::path& path, std::size_t columns,
                         const FilePlace& keep, std::string pending)
    : file_(path, keep), columns_(columns), buffer_(std::move(pending)) {
  buffer_.reserve(kRowBufferBytes + kBytesPerNumber * (columns_ + 1));
  written_ = std::chrono::steady_clock::now();
}

SignalsFile::~SignalsFile() {
  try {
    flush();
  } catch (const FileError&) {  // a destructor cannot report it
  }
}

void SignalsFile::row(double t, std::span<const double> values) {
  expects(values.size() == columns_, "a row has one value a signal");
  appendNumber(buffer_, t);
  for (const double value : values) {
    buffer_ += ',';
    appendNumber(buffer_, value);
  }
  buffer_ += '\n';
  if (buffer_.size() >= kRowBufferBytes) {
    flush();
  } else {
    flushIfDue();
  }
}

void SignalsFile::flushIfDue() {
  if (std::chrono::steady_clock::now() - written_ >= kRowsDue) flush();
}

void SignalsFile::flush() {
  file_.write(buffer_);
  written_ = std::chrono::steady_clock::now();
}

SignalTable readSignals(const std::filesystem::path& path) {
  return signalsIn(readWholeFile(path), path.string());
}

SignalTable signalsIn(std::string_view text, const std::string& file) {
  std::vector<std::string> names;
  std::size_t at = readCsvLine(text, names);
  if (names.front() != "t") throw FileError(file + ":1", "the first column must be t");

  SignalTable table;
  for (std::size_t i = 1; i < names.size(); ++i) table.signals.push_back({names[i], ""});
  table.columns.resize(table.signals.size());

  std::vector<double> row(names.size());
  for (int line = 2; at < text.size(); ++line) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) break;  // the run was stopped while it wrote this row
    const char* c = text.data() + at;
    const char* const stop = text.data() + (end > at && text[end - 1] == '\r' ? end - 1 : end);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto number = std::from_chars(c, stop, row[i]);
      const bool last = i + 1 == row.size();
      if (number.ec != std::errc() ||
          (last ? number.ptr != stop : number.ptr == stop || *number.ptr != ',')) {
        throw FileError(file + ':' + std::to_string(line),
                        "expected " + std::to_string(row.size()) + " numbers with commas between");
      }
      c = number.ptr + 1;
    }
    table.t.push_back(row[0]);
    for (std::size_t i = 1; i < row.size(); ++i) table.columns[i - 1].push_back(row[i]);
    at = end + 1;
  }
  return table;
}

}  // namespace dynamy
