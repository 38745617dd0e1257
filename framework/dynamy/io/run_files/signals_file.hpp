#pragma once
/// \file
/// signals.csv: one row for each recorded instant, first column t [s], then the signals by name.
/// Every number has the shortest text that reads back to the same bits. Whole rows are handed to
/// the operating system at least once a second of wall time: a killed run keeps all but its last
/// second. Rows are formatted in a buffer that stops growing after the first rows. Rejected:
/// formatting like printf, which is slower, depends on the locale and has too few or too many
/// digits.

#include <chrono>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Name of a signal (`ball.z`) and its unit for the axes ("m", "rad/s"; empty: not known).
struct SignalName {
  std::string name;
  std::string unit;
};

class SignalsFile {
 public:
  /// Creates the file and writes its head. \throws FileError
  SignalsFile(const std::filesystem::path& path, std::span<const SignalName> signals);
  /// Continues the file of an earlier run after the bytes `keep`; `pending` is text that could not
  /// be written.
  /// \throws FileError
  SignalsFile(const std::filesystem::path& path, std::size_t columns, const FilePlace& keep,
              std::string pending = {});
  /// Writes the rows that are left. An error is not reported here; call flush() first to see it.
  ~SignalsFile();
  SignalsFile(const SignalsFile&) = delete;
  SignalsFile& operator=(const SignalsFile&) = delete;

  /// Adds a row: t [s] and one value per signal. Does not allocate after the first rows.
  /// \throws FileError when the file cannot take more
  void row(double t, std::span<const double> values);
  /// Writes the collected rows if the last were written long ago: for loops with rare rows.
  void flushIfDue();
  /// Writes the collected rows now. \throws WriteError; the rows left are kept for the next try
  void flush();
  /// The bytes in the file; pending() is not part of them.
  const FilePlace& place() const { return file_.place(); }
  const std::string& pending() const { return buffer_; }
  void sync() { file_.sync(); }  ///< \throws WriteError

 private:
  OutputFile file_;
  std::size_t columns_;
  std::string buffer_;
  std::chrono::steady_clock::time_point written_;
};

/// The content of a signals.csv: signals[i] has the values columns[i][row] at t[row].
struct SignalTable {
  std::vector<SignalName> signals;
  std::vector<double> t;  ///< [s]
  std::vector<std::vector<double>> columns;
};

/// Reads signals.csv; an unfinished last row is left out. Units are not in the file and stay empty.
/// \throws FileError with the line of the first fault
SignalTable readSignals(const std::filesystem::path& path);
/// Reads the table in a text; `file` is named in messages.
SignalTable signalsIn(std::string_view text, const std::string& file);

}  // namespace dynamy
