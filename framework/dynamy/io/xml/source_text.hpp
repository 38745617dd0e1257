#pragma once
/// \file
/// A text file in memory with an index of its lines: it converts byte offsets into places, and
/// places into lines. Readers of text work on byte offsets; lines and columns are computed only
/// when they are needed.

#include <dynamy/core/error.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Length in bytes of the longest line that messages quote: a thousand copies of an endless line
/// would fill the memory.
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
  /// The line that a message about `place` shows. Of a line longer than kLongestShownLine it is the
  /// beginning, or "" if the place lies far after it.
  std::string shownLine(const Place& place) const;

  /// Place of `length` bytes from `offset`, at most to the end of the line. The cost grows with
  /// `length`, not with the length of the line.
  Place place(std::size_t offset, std::size_t length = 1) const;

 private:
  friend class Locator;
  /// Characters of the text before byte `at`.
  std::size_t charactersBefore(std::size_t at) const;
  std::string text_, name_;
  std::vector<std::size_t> lineStarts_;
  std::vector<std::size_t> blocks_;  ///< characters before byte 0, 64, 128, …
};

/// Finds the places of offsets that never decrease. The cost is linear in the text, even if it is a
/// single line.
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
