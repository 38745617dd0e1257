#include <dynamy/core/utf8.hpp>
#include <dynamy/io/xml/source_text.hpp>

#include <algorithm>
#include <utility>

namespace dynamy {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kBlock = 64;  // bytes between two counts of characters

/// Number of characters in valid UTF-8: bytes that are no continuation.
int validCharacterCount(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// The character that holds byte `at` <= text.size(): index of its first byte and of the byte after
/// it.
std::pair<std::size_t, std::size_t> characterAround(std::string_view text, std::size_t at) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(at, 3); ++back) {
    const std::size_t size = nextCharacter(text, at - back).bytes.size();
    if (size > back) return {at - back, at - back + size};
  }
  return {at, at};
}

}  // namespace

SourceText::SourceText(std::string text, std::string name)
    : text_(std::move(text)), name_(std::move(name)) {
  lineStarts_.push_back(text_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  for (std::size_t i = text_.find('\n'); i != std::string::npos; i = text_.find('\n', i + 1))
    lineStarts_.push_back(i + 1);
  blocks_.push_back(0);
  for (std::size_t i = 0; i + kBlock <= text_.size(); i += kBlock)
    blocks_.push_back(blocks_.back() + static_cast<std::size_t>(validCharacterCount(
                                           std::string_view(text_).substr(i, kBlock))));
}

std::size_t SourceText::charactersBefore(std::size_t at) const {
  const std::size_t block = at / kBlock;
  return blocks_[block] + static_cast<std::size_t>(validCharacterCount(
                              std::string_view(text_).substr(block * kBlock, at % kBlock)));
}

std::string_view SourceText::line(int number) const {
  if (number < 1 || static_cast<std::size_t>(number) > lineStarts_.size()) return {};
  const std::size_t begin = lineStarts_[static_cast<std::size_t>(number) - 1];
  const bool last = static_cast<std::size_t>(number) == lineStarts_.size();
  const std::size_t end = last ? text_.size() : lineStarts_[static_cast<std::size_t>(number)] - 1;
  std::string_view rest = std::string_view(text_).substr(begin, end - begin);
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  return rest;
}

std::string SourceText::shownLine(const Place& place) const {
  const std::string_view all = line(place.line);
  if (all.size() <= kLongestShownLine) return std::string(all);
  if (static_cast<std::size_t>(std::max(place.column, 0)) > kLongestShownLine / 8) return {};
  return std::string(all.substr(0, characterAround(all, kLongestShownLine).first));
}

Place SourceText::place(std::size_t offset, std::size_t length) const {
  const auto next = std::upper_bound(lineStarts_.begin() + 1, lineStarts_.end(), offset);
  const std::size_t begin = *(next - 1);
  const int number = static_cast<int>(next - lineStarts_.begin());
  const std::string_view content = line(number);
  const std::size_t first = std::min(offset - std::min(begin, offset), content.size());
  const std::size_t last = first + std::min(length, content.size() - first);

  // An offset inside of a character selects the whole character.
  const std::size_t at = characterAround(content, first).first;
  const int marked = characterCount(content.substr(at, characterAround(content, last).second - at));
  const std::size_t before = charactersBefore(begin + at) - charactersBefore(begin);
  return {name_, number, static_cast<int>(before) + 1, std::max(marked, 1)};
}

Place Locator::place(std::size_t offset, std::size_t length) {
  const std::vector<std::size_t>& starts = source_.lineStarts_;
  while (line_ + 1 < starts.size() && starts[line_ + 1] <= offset) {
    offset_ = starts[++line_];
    column_ = 1;
  }
  if (line_ == 0) offset_ = std::max(offset_, starts[0]);
  const std::string_view text = source_.text();
  column_ += validCharacterCount(text.substr(offset_, offset - offset_));
  offset_ = offset;
  const std::string_view marked = text.substr(offset, length);
  const int characters = validCharacterCount(marked.substr(0, marked.find_first_of("\r\n")));
  return {source_.name(), static_cast<int>(line_) + 1, column_, std::max(characters, 1)};
}

}  // namespace dynamy
