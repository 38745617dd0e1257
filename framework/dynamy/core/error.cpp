/// Text of errors with a place. The one subtle part is the caret: it stands under the right
/// character also after tabs (kept in both lines), after characters of several bytes, and in a line
/// that is too long for a terminal (a window around the place is shown).

#include <dynamy/core/error.hpp>
#include <dynamy/core/utf8.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace dynamy {

namespace {

constexpr std::size_t kShownCharacters = 160;  // characters of a line that are shown at most
constexpr std::size_t kBeforeCaret = 100;      // most of these characters before the place
constexpr std::size_t kShownErrors = 100;

std::vector<Utf8Character> characters(std::string_view text) {
  std::vector<Utf8Character> result;
  for (std::size_t at = 0; at < text.size(); at += result.back().bytes.size())
    result.push_back(nextCharacter(text, at));
  return result;
}

bool printable(const Utf8Character& c) {
  return c.valid && (c.code == '\t' || (c.code >= 0x20 && (c.code < 0x7F || c.code > 0x9F)));
}

/// Columns of a terminal that a character takes: 0 for combining marks, 2 for wide East Asian
/// characters and emoji, else 1. The main ranges are enough for a caret.
int terminalWidth(char32_t code) {
  const auto in = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  if (in(0x300, 0x36F) || in(0x200B, 0x200F) || in(0x20D0, 0x20F0) || in(0xFE00, 0xFE0F)) return 0;
  if (in(0x1100, 0x115F) || in(0x2E80, 0xA4CF) || in(0xAC00, 0xD7A3) || in(0xF900, 0xFAFF) ||
      in(0xFE30, 0xFE6F) || in(0xFF00, 0xFF60) || in(0x1F300, 0x1FAFF) || in(0x20000, 0x3FFFD))
    return 2;
  return 1;
}

/// The line and, under it, the caret: "    7 | text" / "      | ^~~~".
std::string excerpt(const Place& place, std::string_view line) {
  if (line.empty() || place.line <= 0) return {};
  const std::vector<Utf8Character> all = characters(line);
  const std::size_t caret = place.column > 0 ? static_cast<std::size_t>(place.column) - 1 : 0;
  const std::size_t length = static_cast<std::size_t>(std::max(place.length, 1));

  // A window around the place, if the line is long.
  std::size_t first = 0;
  if (all.size() > kShownCharacters && caret > kBeforeCaret)
    first = std::min(caret - kBeforeCaret, all.size() - kShownCharacters);
  const std::size_t last = std::min(all.size(), first + kShownCharacters);

  // The text; what a terminal cannot show becomes a replacement character.
  const std::string number = std::to_string(place.line);
  const std::string gutter(std::max<std::size_t>(number.size(), 5), ' ');
  std::string shown = "\n" + gutter.substr(number.size()) + number + " | ";
  std::string marks = "\n" + gutter + " | ";
  if (first > 0) shown += "…", marks += ' ';
  for (std::size_t i = first; i < last; ++i) shown += printable(all[i]) ? all[i].bytes : "\uFFFD";
  if (last < all.size()) shown += "…";
  if (place.column <= 0) return shown;

  // The caret: tabs are kept, wide characters take two columns.
  const auto width = [&](std::size_t i) {
    return i < all.size() && printable(all[i]) ? terminalWidth(all[i].code) : 1;
  };
  for (std::size_t i = first; i < caret && i <= last; ++i) {
    const bool tab = i < all.size() && all[i].code == '\t' && all[i].valid;
    marks += tab ? std::string(1, '\t') : std::string(static_cast<std::size_t>(width(i)), ' ');
  }
  int underlined = 0;
  for (std::size_t i = caret; i < std::min(last, caret + length); ++i) underlined += width(i);
  marks += '^' + std::string(static_cast<std::size_t>(std::max(underlined - 1, 0)), '~');
  return shown + marks;
}

std::string header(const Place& place, const char* kind) {
  const std::string where = place.format();
  return where.empty() ? std::string(kind) + ": " : where + ": " + kind + ": ";
}

}  // namespace

std::string Place::format() const {
  std::string text = file;
  if (line <= 0) return text;
  if (text.empty()) text = "<text>";
  text += ':' + std::to_string(line);
  if (column > 0) text += ':' + std::to_string(column);
  return text;
}

std::string Diagnostic::format() const {
  std::string message = header(place, "error");
  if (!element.empty()) message += '<' + element + ">: ";
  message += text;
  if (!hint.empty()) message += " — " + hint;
  message += excerpt(place, sourceLine);
  for (const Note& note : notes)
    message += '\n' + header(note.place, "note") + note.text + excerpt(note.place, note.sourceLine);
  return message;
}

std::string format(const std::vector<Diagnostic>& diagnostics) {
  const std::size_t shown = std::min(diagnostics.size(), kShownErrors);
  std::string message;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) message += '\n';
    message += diagnostics[i].format();
  }
  if (const std::size_t rest = diagnostics.size() - shown; rest > 0)
    message += "\n… and " + std::to_string(rest) + (rest == 1 ? " more error" : " more errors");
  return message;
}

ModelError::ModelError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(dynamy::format(diagnostics)), diagnostics_(std::move(diagnostics)) {}

ModelError::ModelError(Diagnostic diagnostic)
    : ModelError(std::vector<Diagnostic>{std::move(diagnostic)}) {}

ModelError::ModelError(std::string text, std::string hint)
    : ModelError(Diagnostic{.text = std::move(text), .hint = std::move(hint)}) {}

void Diagnostics::add(Diagnostic diagnostic) { items_.push_back(std::move(diagnostic)); }

void Diagnostics::add(const ModelError& error) {
  items_.insert(items_.end(), error.diagnostics().begin(), error.diagnostics().end());
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  // Rank files in the order in which they were met; in a file, errors without a line first.
  std::map<std::string, std::size_t> rank;
  for (const Diagnostic& d : items_) rank.emplace(d.place.file, rank.size());
  const auto key = [&](const Diagnostic& d) {
    return std::tuple(rank.at(d.place.file), d.place.line, d.place.column);
  };
  std::vector<Diagnostic> result = items_;
  std::stable_sort(result.begin(), result.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  const auto same = [](const Diagnostic& a, const Diagnostic& b) {
    return a.place == b.place && a.element == b.element && a.text == b.text && a.hint == b.hint;
  };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

void Diagnostics::throwIfAny() const {
  if (!empty()) throw ModelError(sorted());
}

std::string didYouMean(std::string_view name) {
  return name.empty() ? std::string() : "did you mean \"" + std::string(name) + "\"?";
}

void throwExpectation(const char* what, const std::source_location& where) {
  throw std::logic_error(std::string(where.file_name()) + ':' + std::to_string(where.line()) +
                         ": expected: " + what + " (in '" + where.function_name() + "')");
}

}  // namespace dynamy
