#pragma once
/// \file
/// A text file in memory that knows its lines: byte offsets become places, places become lines.
/// Everything that reads text works on byte offsets; lines and columns are computed only where
/// somebody asks for them.

#include <dynamy/core/error.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Bytes of the longest line that messages hold: a thousand copies of a line without end would
/// fill the memory.
inline constexpr std::size_t kLongestShownLine = 10000;

class SourceText {
 public:
  /// `name` is the file's name in messages.
  SourceText(std::string text, std::string name);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }

  /// Line `number` (from 1) without its end (LF or CR LF) and without a byte order mark; "" if
  /// there is no such line.
  std::string_view line(int number) const;
  /// What a message about `place` shows of its line: of a line longer than kLongestShownLine the
  /// beginning, "" if the place lies far behind it.
  std::string shownLine(const Place& place) const;

  /// Place of `length` bytes from `offset`, at most to the end of the line. Cost: `length`, however
  /// long the line is.
  Place place(std::size_t offset, std::size_t length = 1) const;

 private:
  friend class Locator;
  /// Characters of the text before byte `at`.
  std::size_t charactersBefore(std::size_t at) const;
  std::string text_, name_;
  std::vector<std::size_t> lineStarts_;
  std::vector<std::size_t> blocks_;  ///< characters before byte 0, 64, 128, …
};

/// Places of offsets that never decrease: linear in the text, also if all of it is one line.
class Locator {
 public:
  explicit Locator(const SourceText& source) : source_(source) {}
  /// \pre offset is not less than in the call before; the text is valid UTF-8.
  Place place(std::size_t offset, std::size_t length);

 private:
  const SourceText& source_;
  std::size_t line_ = 0, offset_ = 0;
  int column_ = 1;
};

}  // namespace dynamy
