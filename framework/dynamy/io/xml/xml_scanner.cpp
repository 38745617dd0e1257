/// One pass over the text with a stack of open elements. Errors after which the rest can still be
/// read (doubled attribute, unknown entity) are collected; all other errors end the scan, because
/// after them a scanner can only guess.
#include <algorithm>
#include <array>
#include <dynamy/core/foreign_format.hpp>
#include <dynamy/core/utf8.hpp>
#include <dynamy/io/xml/fault_list.hpp>
#include <dynamy/io/xml/xml_scanner.hpp>
#include <string>
#include <utility>

namespace dynamy {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool isNameCharacter(char c) {
  return isNameStart(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

bool isXmlCharacter(char32_t c) {
  return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
}

std::string quotedName(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string hexadecimal(char c) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(c);
  return {'0', 'x', digits[byte >> 4], digits[byte & 15]};
}

/// Errors of one text, with their places and lines.
class ScanErrors {
 public:
  explicit ScanErrors(const SourceText& source) : source_(source) {}

  Diagnostic at(std::size_t offset, std::size_t size, std::string element, std::string text,
                std::string hint) const {
    Place place = source_.place(offset, size);
    std::string line = source_.shownLine(place);
    return {std::move(place), std::move(element), std::move(text), std::move(hint),
            std::move(line)};
  }
  /// Adds to an error what stands at another place.
  void note(Diagnostic& error, std::size_t offset, std::size_t size, std::string text) const {
    const Diagnostic there = at(offset, size, {}, std::move(text), {});
    error.notes.push_back({there.place, there.text, there.sourceLine});
  }
  void add(Diagnostic error) { all_.add(std::move(error)); }
  void throwIfAny() const { all_.throwIfAny(); }

  // Errors that end the scan.
  [[noreturn]] void fail(Diagnostic error) {
    add(std::move(error));
    all_.throwAll();
  }
  [[noreturn]] void fail(std::size_t offset, std::size_t size, std::string element,
                         std::string text, std::string hint) {
    fail(at(offset, size, std::move(element), std::move(text), std::move(hint)));
  }
  /// An error of the file as a whole.
  [[noreturn]] void failFile(std::string text, std::string hint = {}) const {
    throw ModelError(
        Diagnostic{.place = {source_.name()}, .text = std::move(text), .hint = std::move(hint)});
  }

 private:
  const SourceText& source_;
  FaultList all_;
};

/// True for pictures, programs and other files that hold no text.
bool looksBinary(std::string_view text) {
  constexpr std::size_t kLooked = 4096;
  return std::any_of(text.begin(),
                     text.begin() + static_cast<std::ptrdiff_t>(std::min(kLooked, text.size())),
                     [](char c) { return static_cast<unsigned char>(c) < 9; });
}

/// True: the text begins as a page of HTML does.
bool looksLikeHtml(std::string_view text) {
  std::string begin(text.substr(0, 200));
  for (char& c : begin) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return begin.find("<!doctype html") != std::string::npos;
}

/// Checks that the whole text is UTF-8 without characters that XML forbids.
void checkCharacters(std::string_view text, ScanErrors& errors) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    errors.failFile("the text is UTF-16", "store the file as UTF-8");
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    errors.failFile("the file is empty");
  if (const ForeignFormat format = foreignFormat(text); !format.name.empty())
    errors.failFile("the file is " + std::string(format.name) + ", no text",
                    std::string(format.remedy));
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = nextCharacter(text, i);
    if (!c.valid)
      errors.fail(i, 1, {}, "the byte " + hexadecimal(text[i]) + " is no UTF-8",
                  looksBinary(text) ? "is this an XML file?" : "store the file as UTF-8");
    if (!isXmlCharacter(c.code))
      errors.fail(i, 1, {}, "the byte " + hexadecimal(text[i]) + " is no text",
                  "is this an XML file?");
    i += c.bytes.size();
  }
}

/// Bytes of the typographic quote that begins at `at`, 0 if there is none.
std::size_t typographicQuote(std::string_view text, std::size_t at) {
  for (const std::string_view quote : {"“", "”", "„", "‘", "’", "‚", "«", "»"})
    if (text.substr(at).starts_with(quote)) return quote.size();
  return 0;
}

class Scanner {
 public:
  explicit Scanner(const SourceText& source) : text_(source.text()), errors_(source) {}

  XmlScan scan() {
    checkCharacters(text_, errors_);
    at_ = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (at_ < text_.size()) {
      text();
      if (at_ < text_.size()) markup();
    }
    if (!open_.empty()) {
      const XmlScan::Element& element = scan_.elements[open_.back()];
      errors_.fail(element.begin, element.size, tag(element), "the element is not closed",
                   "expected </" + tag(element) + "> before the end of the file");
    }
    if (scan_.elements.empty()) errors_.failFile("there is no element in it");
    errors_.throwIfAny();
    return std::move(scan_);
  }

 private:
  bool startsWith(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skipSpace() {
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
  }

  /// The name at the current place, "" if there is none.
  std::string_view name() {
    const std::size_t begin = at_;
    if (at_ < text_.size() && isNameStart(text_[at_]))
      while (at_ < text_.size() && isNameCharacter(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::string tag(const XmlScan::Element& element) const {
    return std::string(text_.substr(element.begin + 1, element.size - 1));
  }
  std::string openTag() const { return open_.empty() ? "" : tag(scan_.elements[open_.back()]); }

  void checkEntities(std::size_t begin, std::size_t end, const std::string& element) {
    const std::string_view content = text_.substr(0, end);
    for (std::size_t i = content.find('&', begin); i < end; i = content.find('&', i + 1)) {
      if (xmlEntity(text_, i)) continue;
      const std::size_t stop = text_.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789#", i + 1);
      const bool closed = stop < end && text_[stop] == ';' && stop > i + 1;
      const std::size_t size = closed ? stop + 1 - i : 1;
      errors_.add(errors_.at(
          i, size, element,
          (closed ? "unknown entity " : "no entity begins at this ") +
              quotedName(text_.substr(i, size)),
          "known are &lt; &gt; &amp; &quot; &apos; &#number; and a plain & is written &amp;"));
    }
  }

  // Content.

  void text() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find('<', at_), text_.size());
    const std::size_t visible = text_.find_first_not_of(" \t\r\n", begin);
    if (visible >= at_) return;
    if (open_.empty())
      errors_.fail(visible, at_ - visible, {},
                   scan_.elements.empty() ? "text before the first element"
                                          : "text after the end of the root element",
                   scan_.elements.empty()
                       ? "a model is an XML file and begins with <dynamy version=\"1\">"
                       : "an element was closed too early, or twice");
    checkEntities(begin, at_, openTag());
    scan_.texts.push_back({begin, false});
  }

  void markup() {
    if (startsWith("<!--")) return skipTo("-->", 4, "the comment is not closed by -->");
    if (startsWith("<![CDATA[")) return cdata();
    if (startsWith("<!"))
      errors_.fail(at_, 2, openTag(), "document types and their entities are not read",
                   looksLikeHtml(text_)
                       ? "the file is a page of HTML; a model begins with <dynamy version=\"1\">"
                       : "remove the declaration");
    if (startsWith("<?")) return instruction();
    if (startsWith("</")) return closing();
    opening();
  }

  void skipTo(std::string_view end, std::size_t head, std::string error) {
    const std::size_t stop = text_.find(end, at_ + head);
    if (stop == std::string_view::npos) errors_.fail(at_, head, openTag(), std::move(error), {});
    at_ = stop + end.size();
  }

  void cdata() {
    if (open_.empty()) errors_.fail(at_, 9, {}, "text outside of the root element", {});
    scan_.texts.push_back({at_ + 9, true});
    skipTo("]]>", 9, "the CDATA section is not closed by ]]>");
  }

  void instruction() {
    if (!scan_.elements.empty())
      errors_.fail(at_, 2, openTag(), "<? ?> is allowed only before the first element", {});
    skipTo("?>", 2, "<? is not closed by ?>");
  }

  /// After "<" without a name: "< Box" is a tag with a blank, all else a sign in a text.
  std::string meantByBracket() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    const std::string_view tag = name();
    return tag.empty() ? "in a text \"<\" is written &lt;"
                       : "a tag has no blank there, <" + std::string(tag) +
                             "; in a text \"<\" is written &lt;";
  }

  void opening() {
    const std::size_t begin = at_++;
    const std::string_view tagName = name();
    if (tagName.empty())
      errors_.fail(begin, 1, openTag(), "no name follows \"<\"", meantByBracket());
    XmlScan::Element element{begin, tagName.size() + 1, 0};
    if (open_.empty() && !scan_.elements.empty()) {
      Diagnostic error = errors_.at(begin, element.size, std::string(tagName),
                                    "second root element", "a file has one root element");
      const XmlScan::Element& first = scan_.elements[0];
      errors_.note(error, first.begin, first.size, '<' + tag(first) + "> is the first");
      errors_.fail(std::move(error));
    }
    if (open_.size() >= kDeepestXml)
      errors_.fail(begin, element.size, std::string(tagName),
                   "elements are nested deeper than " + std::to_string(kDeepestXml), {});
    const bool empty = attributes(element);
    scan_.elements.push_back(element);
    if (!empty) open_.push_back(scan_.elements.size() - 1);
  }

  void closing() {
    const std::size_t begin = at_;
    at_ += 2;
    const std::string found(name());
    skipSpace();
    const std::size_t size = at_ - begin;
    if (open_.empty()) errors_.fail(begin, size, found, "</" + found + "> closes nothing", {});
    const XmlScan::Element& element = scan_.elements[open_.back()];
    if (found != tag(element)) {
      Diagnostic error = errors_.at(begin, size, tag(element),
                                    "expected </" + tag(element) + ">, found </" + found + '>',
                                    "a tag without children ends with \"/>\"");
      if (scan_.elements.size() > open_.back() + 1) error.hint.clear();  // it has children
      errors_.note(error, element.begin, element.size, '<' + tag(element) + "> is opened here");
      errors_.fail(std::move(error));
    }
    if (!startsWith(">")) errors_.fail(begin, size, found, "the closing tag has no \">\"", {});
    ++at_;
    open_.pop_back();
  }

  // Attributes.

  /// Reads up to the end of the tag. \return whether the element ends with it (`/>`)
  bool attributes(XmlScan::Element& element) {
    for (;;) {
      skipSpace();
      if (startsWith("/>")) return at_ += 2, true;
      if (startsWith(">")) return ++at_, false;
      if (at_ >= text_.size() || text_[at_] == '<')
        errors_.fail(element.begin, element.size, tag(element), "the tag has no \">\"", {});
      attribute(element);
    }
  }

  void attribute(XmlScan::Element& element) {
    XmlScan::Attribute attribute;
    attribute.name = at_;
    const std::string attributeName(name());
    attribute.nameSize = attributeName.size();
    if (attributeName.empty())
      errors_.fail(at_, 1, tag(element),
                   "unexpected character " + quotedName(nextCharacter(text_, at_).bytes),
                   startsWith("/") ? "a tag ends with \">\" or \"/>\""
                                   : "an attribute is written name=\"value\"");
    skipSpace();
    if (!startsWith("="))
      errors_.fail(attribute.name, attribute.nameSize, tag(element),
                   "the attribute " + quotedName(attributeName) + " has no value",
                   "write " + attributeName + "=\"…\"");
    ++at_;
    skipSpace();
    value(element, attribute, attributeName);
    checkDouble(element, attribute, attributeName);
    if (element.attributes == kMostXmlAttributes)
      errors_.fail(
          attribute.name, attribute.nameSize, tag(element),
          "the element has more than " + std::to_string(kMostXmlAttributes) + " attributes", {});
    scan_.attributes.push_back(attribute);
    ++element.attributes;
  }

  void value(const XmlScan::Element& element, XmlScan::Attribute& attribute,
             const std::string& attributeName) {
    const std::size_t begin = at_;
    const char quote = begin < text_.size() ? text_[begin] : '\0';
    if (const std::size_t size = typographicQuote(text_, begin); size > 0) {
      std::size_t end = begin + size;
      while (end < text_.size() && typographicQuote(text_, end) == 0 && text_[end] != '\n') ++end;
      errors_.fail(begin, end - begin + size, tag(element),
                   "the value of " + quotedName(attributeName) + " is in typographic quotes",
                   "write " + attributeName + "=\"" +
                       std::string(text_.substr(begin + size, end - begin - size)) + '"');
    }
    if (quote != '"' && quote != '\'') {
      const std::size_t end = std::min(text_.find_first_of(" \t\r\n<>/\"'", begin), text_.size());
      const std::string word(text_.substr(begin, end - begin));
      errors_.fail(begin, end - begin, tag(element),
                   "the value of " + quotedName(attributeName) + " is not in quotes",
                   "write " + attributeName + "=\"" + (word.empty() ? "…" : word) + '"');
    }

    // An unclosed quote takes in the text up to the next quote.
    const std::size_t end = text_.find(quote, begin + 1);
    const std::string_view content = text_.substr(begin + 1, end - begin - 1);
    const char next = end < text_.size() - 1 ? text_[end + 1] : '>';
    const bool glued = end < text_.size() && !isSpace(next) && next != '>' && next != '/';
    const bool less = content.find('<') != std::string_view::npos;
    if (end == std::string_view::npos || less || (glued && content.find('=') < content.size()))
      errors_.fail(begin, content.substr(0, content.find_first_of("=<\n")).size() + 1, tag(element),
                   "the value of " + quotedName(attributeName) + " has no closing quote",
                   less
                       ? "in a value \"<\" is written &lt;"
                       : "write " + attributeName + "=\"" +
                             std::string(content.substr(0, content.find_first_of(" =<>\n"))) + '"');
    if (glued)
      errors_.fail(end + 1, 1, tag(element),
                   "expected a space after the value of " + quotedName(attributeName), {});
    checkEntities(begin + 1, end, tag(element));
    attribute.value = begin + 1;
    attribute.valueSize = content.size();
    at_ = end + 1;
  }

  void checkDouble(const XmlScan::Element& element, const XmlScan::Attribute& attribute,
                   const std::string& attributeName) {
    for (std::size_t i = 0; i < element.attributes; ++i) {
      const XmlScan::Attribute& other = scan_.attributes[scan_.attributes.size() - 1 - i];
      if (text_.substr(other.name, other.nameSize) != attributeName) continue;
      Diagnostic error =
          errors_.at(attribute.name, attribute.nameSize, tag(element),
                     "the attribute " + quotedName(attributeName) + " is given twice", {});
      errors_.note(error, other.name, other.nameSize, "the first is here");
      errors_.add(std::move(error));
      return;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::size_t> open_;  // indices of open elements
  XmlScan scan_;
  ScanErrors errors_;
};

}  // namespace

XmlScan scanXml(const SourceText& source) { return Scanner(source).scan(); }

std::optional<XmlEntity> xmlEntity(std::string_view text, std::size_t at) {
  constexpr std::array<std::pair<std::string_view, char32_t>, 5> known{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  const std::string_view rest = text.substr(at);
  for (const auto& [word, code] : known)
    if (rest.starts_with(word)) return XmlEntity{word.size(), code};
  if (!rest.starts_with("&#")) return std::nullopt;

  // A number: &#176; or &#xB0;
  const bool hex = rest.starts_with("&#x");
  const std::size_t first = hex ? 3 : 2;
  char32_t code = 0;
  std::size_t i = first;
  for (; i < rest.size() && code <= 0x10FFFF; ++i) {
    const char c = rest[i];
    int digit = -1;
    if (c >= '0' && c <= '9') digit = c - '0';
    if (hex && c >= 'a' && c <= 'f') digit = c - 'a' + 10;
    if (hex && c >= 'A' && c <= 'F') digit = c - 'A' + 10;
    if (digit < 0) break;
    code = code * (hex ? 16 : 10) + static_cast<char32_t>(digit);
  }
  const bool closed = i > first && i < rest.size() && rest[i] == ';';
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (!closed || surrogate || code > 0x10FFFF || !isXmlCharacter(code)) return std::nullopt;
  return XmlEntity{i + 1, code};
}

namespace {

/// Sizes in bytes of the unit of content that begins at byte `at`: in the source, and decoded.
std::pair<std::size_t, std::size_t> unitAt(std::string_view text, std::size_t at, bool cdata) {
  const char c = text[at];
  const char next = at + 1 < text.size() ? text[at + 1] : '\0';
  if ((c == '\r' && next == '\n') || (c == '\n' && next == '\r')) return {2, 1};
  if (c != '&' || cdata) return {1, 1};
  const auto entity = xmlEntity(text, at);
  if (!entity) return {1, 1};
  const char32_t code = entity->code;
  return {entity->size, code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4};
}

}  // namespace

std::size_t sourceOffset(std::string_view text, std::size_t begin, std::size_t decoded,
                         bool cdata) {
  std::size_t at = begin, done = 0;
  while (at < text.size()) {
    const auto [size, bytes] = unitAt(text, at, cdata);
    if (done + bytes > decoded) break;
    done += bytes;
    at += size;
  }
  return at;
}

std::vector<XmlShift> xmlShifts(std::string_view text, std::size_t begin) {
  std::vector<XmlShift> out;
  std::size_t done = 0;
  for (std::size_t at = begin; at < text.size();) {
    const auto [size, bytes] = unitAt(text, at, false);
    if (size != bytes) out.push_back({done, bytes, at, size});
    done += bytes;
    at += size;
  }
  return out;
}

}  // namespace dynamy
