/// Combines two readings of one text, the scanner's list of places and the parser's tree; both are
/// in document order.

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <dynamy/io/xml/xml_scanner.hpp>

#include <tinyxml2.h>

#include <algorithm>
#include <fstream>
#include <system_error>

namespace dynamy {

namespace {

constexpr std::string_view kXmlSpace = " \t\r\n";

/// Walks over the parser's tree and takes the places from the scan.
class TreeBuilder {
 public:
  TreeBuilder(const SourceText& source, const XmlScan& scan)
      : source_(source), scan_(scan), locator_(source) {}

  XmlNode build(const tinyxml2::XMLElement& parsed) {
    require(element_ < scan_.elements.size(), parsed.GetLineNum());
    const XmlScan::Element& found = scan_.elements[element_++];
    XmlNode node;
    node.tag = parsed.Name();
    require(node.tag.size() + 1 == found.size, parsed.GetLineNum());
    node.place = locator_.place(found.begin, found.size);

    // Attributes.
    node.attributes.reserve(found.attributes);
    for (const auto* a = parsed.FirstAttribute(); a != nullptr; a = a->Next()) {
      require(node.attributes.size() < found.attributes, a->GetLineNum());
      node.attributes.push_back(buildAttribute(*a));
    }
    require(node.attributes.size() == found.attributes, parsed.GetLineNum());

    // Texts and children in document order.
    for (const auto* n = parsed.FirstChild(); n != nullptr; n = n->NextSibling()) {
      if (const tinyxml2::XMLElement* child = n->ToElement())
        node.children.push_back(build(*child));
      else if (const tinyxml2::XMLText* text = n->ToText())
        addText(node, *text);
    }
    trim(node);
    return node;
  }

  void finish() const {
    require(element_ == scan_.elements.size() && attribute_ == scan_.attributes.size() &&
                text_ == scan_.texts.size(),
            0);
  }

 private:
  XmlAttribute buildAttribute(const tinyxml2::XMLAttribute& parsed) {
    const XmlScan::Attribute& found = scan_.attributes[attribute_++];
    XmlAttribute result;
    result.name = parsed.Name();
    result.value = parsed.Value();
    require(result.name.size() == found.nameSize, parsed.GetLineNum());
    result.namePlace = locator_.place(found.name, found.nameSize);
    result.valuePlace = locator_.place(found.value, found.valueSize);
    result.source = found.value;
    if (result.value.size() != found.valueSize)
      result.shifts =
          xmlShifts(source_.text().substr(0, found.value + found.valueSize), found.value);
    return result;
  }

  void addText(XmlNode& node, const tinyxml2::XMLText& parsed) {
    require(text_ < scan_.texts.size(), parsed.GetLineNum());
    const XmlScan::Text& found = scan_.texts[text_++];
    require(parsed.CData() == found.cdata, parsed.GetLineNum());
    node.pieces.push_back(
        {static_cast<std::ptrdiff_t>(node.text.size()), found.begin, found.cdata});
    const std::string_view content = parsed.Value();
    const std::size_t visible = content.find_first_not_of(kXmlSpace);
    if (node.textPlace.line == 0 && visible != std::string_view::npos) {
      const std::size_t last = content.find_last_not_of(kXmlSpace) + 1;
      const std::size_t begin = sourceOffset(source_.text(), found.begin, visible, found.cdata);
      const std::size_t end = sourceOffset(source_.text(), found.begin, last, found.cdata);
      node.textPlace = locator_.place(begin, end - begin);
    }
    node.text += content;
  }

  /// Cuts off white space around the text; offsets of the pieces move with it.
  void trim(XmlNode& node) const {
    const std::size_t first = node.text.find_first_not_of(kXmlSpace);
    if (first == std::string::npos) {
      node.text.clear();
      node.pieces.clear();
      return;
    }
    node.text.resize(node.text.find_last_not_of(kXmlSpace) + 1);
    node.text.erase(0, first);
    for (XmlPiece& piece : node.pieces) piece.offset -= static_cast<std::ptrdiff_t>(first);
  }

  void require(bool agrees, int line) const {
    if (!agrees)
      throw ModelError(Diagnostic{.place = {source_.name(), line},
                                  .text = "the file is read in two ways: its XML is ambiguous"});
  }

  const SourceText& source_;
  const XmlScan& scan_;
  Locator locator_;
  std::size_t element_ = 0, attribute_ = 0, text_ = 0;
};

[[noreturn]] void failFile(const std::string& name, std::string text, std::string hint = {}) {
  throw ModelError(Diagnostic{.place = {name}, .text = std::move(text), .hint = std::move(hint)});
}

/// Paths of the XML files in a folder, in order.
std::vector<std::string> modelsIn(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::string> out;
  for (std::filesystem::directory_iterator it(folder, ignored), end; !ignored && it != end;
       it.increment(ignored))
    if (it->path().extension() == ".xml") out.push_back(it->path().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// Name of a file in the same folder that was probably meant.
std::string nearFile(const std::filesystem::path& file) {
  std::error_code ignored;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::vector<std::string> known, stems;
  for (std::filesystem::directory_iterator it(folder, ignored), end; !ignored && it != end;
       it.increment(ignored))
    known.push_back(it->path().filename().string());
  std::sort(known.begin(), known.end());
  // Endings are compared apart: "none.xml" has as much of "bin.xml" as a name of eight letters, and "ball"
  // lacks four of "ball.xml".
  const std::string ending = file.has_extension() ? file.extension().string() : ".xml";
  for (const std::string& name : known)
    if (name.ends_with(ending)) stems.push_back(std::filesystem::path(name).stem().string());
  std::string name = nearest(file.stem().string(), stems);
  if (!name.empty()) return (file.parent_path() / (name + ending)).string();
  // A file whose ending is misspelt, too; an equal ending alone makes no two names alike.
  std::erase_if(known, [&](const std::string& k) { return k.ends_with(ending); });
  name = nearest(file.filename().string(), known);
  return name.empty() ? name : (file.parent_path() / name).string();
}

/// The hint for a file that does not exist: a similar name, else the models of its folder.
std::string hintForMissing(const std::filesystem::path& file) {
  if (const std::string near = nearFile(file); !near.empty()) return didYouMean(near);
  std::error_code ignored;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, ignored))
    return "there is no folder " + folder.string();
  const std::vector<std::string> models = modelsIn(folder);
  if (models.empty())
    return "no XML file is in " +
           std::filesystem::absolute(folder, ignored).lexically_normal().string();
  std::vector<std::string> names;
  for (const std::string& path : models)
    names.push_back(std::filesystem::path(path).filename().string());
  constexpr std::size_t kMostNames = 5;
  return "its folder has " + quotedList(names, kMostNames);
}

/// The hint for a folder that is named instead of a file: a model in it.
std::string fileInFolder(const std::filesystem::path& folder) {
  const std::vector<std::string> models = modelsIn(folder);
  return models.empty() ? "no XML file is in it" : "name a file in it, such as " + models.front();
}

/// The byte of the file that holds byte `decoded` of a value.
std::size_t sourceByte(const XmlAttribute& a, std::size_t decoded) {
  const auto next =
      std::upper_bound(a.shifts.begin(), a.shifts.end(), decoded,
                       [](std::size_t at, const XmlShift& s) { return at < s.begin; });
  if (next == a.shifts.begin()) return a.source + decoded;
  const XmlShift& s = *(next - 1);
  if (decoded < s.begin + s.size) return s.sourceBegin;
  return s.sourceBegin + s.sourceSize + (decoded - s.begin - s.size);
}

Place placeIn(const SourceText& source, std::size_t begin, std::size_t offset, std::size_t length,
              bool cdata) {
  const std::size_t first = sourceOffset(source.text(), begin, offset, cdata);
  const std::size_t last = sourceOffset(source.text(), begin, offset + length, cdata);
  return source.place(first, last - first);
}

std::string escaped(std::string_view text, bool value) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const bool space = c == '\t' || c == '\n' || c == '\r';
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"' && value)
      result += "&quot;";
    else if (c == '\'' && value)
      result += "&apos;";
    else if (c == '\r' || (space && value))
      result += "&#" + std::to_string(static_cast<int>(c)) + ';';
    else if (static_cast<unsigned char>(c) < 0x20 && !space)
      result += "\uFFFD";
    else
      result += c;
  }
  return result;
}

}  // namespace

const XmlAttribute* XmlNode::attribute(std::string_view name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const XmlAttribute& a) { return a.name == name; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string XmlNode::label() const {
  const XmlAttribute* name = attribute("name");
  return name == nullptr ? tag : tag + " name=\"" + name->value + '"';
}

XmlDocument::XmlDocument(SourceText source, XmlNode root)
    : source_(std::move(source)), root_(std::move(root)) {}

XmlDocument XmlDocument::read(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    failFile(name, "there is no such file", hintForMissing(file));
  if (error) failFile(name, "the file cannot be read: " + error.message());
  if (std::filesystem::is_directory(status))
    failFile(name, "this is a folder, not a file", fileInFolder(file));
  if (!std::filesystem::is_regular_file(status)) failFile(name, "this is no regular file");

  std::ifstream stream(file, std::ios::binary);
  if (!stream) failFile(name, "the file cannot be opened", "may it be read?");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::string text(error ? 0 : static_cast<std::size_t>(size), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (error || stream.bad() || stream.gcount() != static_cast<std::streamsize>(text.size()))
    failFile(name, "the file cannot be read");
  return parse(std::move(text), name);
}

XmlDocument XmlDocument::parse(std::string text, std::string name) {
  SourceText source(std::move(text), std::move(name));
  const XmlScan scan = scanXml(source);

  tinyxml2::XMLDocument parsed;
  parsed.Parse(source.text().data(), source.text().size());
  if (parsed.Error() || parsed.RootElement() == nullptr) {
    Diagnostic error{.place = {source.name(), parsed.ErrorLineNum()},
                     .text = std::string("the file is no XML: ") + parsed.ErrorName()};
    error.sourceLine = source.shownLine(error.place);
    throw ModelError(std::move(error));
  }
  TreeBuilder builder(source, scan);
  XmlNode root = builder.build(*parsed.RootElement());
  builder.finish();

  return XmlDocument(std::move(source), std::move(root));
}

Place XmlDocument::at(const XmlAttribute& attribute, std::size_t offset, std::size_t length) const {
  const std::size_t begin = std::min(offset, attribute.value.size());
  const std::size_t size = std::min(length, attribute.value.size() - begin);
  const std::size_t first = sourceByte(attribute, begin);
  return source_.place(first, sourceByte(attribute, begin + size) - first);
}

Place XmlDocument::at(const XmlNode& node, std::size_t offset, std::size_t length) const {
  if (node.pieces.empty()) return node.place;
  const std::size_t begin = std::min(offset, node.text.size());
  const auto signedBegin = static_cast<std::ptrdiff_t>(begin);
  auto piece = node.pieces.begin();
  while (piece + 1 != node.pieces.end() && (piece + 1)->offset <= signedBegin) ++piece;

  // The length is cut at the end of the piece.
  std::size_t end = node.text.size();
  if (piece + 1 != node.pieces.end()) end = static_cast<std::size_t>((piece + 1)->offset);
  return placeIn(source_, piece->source, static_cast<std::size_t>(signedBegin - piece->offset),
                 std::min(length, end - begin), piece->cdata);
}

Diagnostic XmlDocument::diagnostic(Place place, const XmlNode& node, std::string text,
                                   std::string hint) const {
  std::string line = source_.shownLine(place);
  return {std::move(place), node.label(), std::move(text), std::move(hint), std::move(line)};
}

std::vector<XmlWord> xmlWords(std::string_view value) {
  std::vector<XmlWord> words;
  std::size_t at = value.find_first_not_of(kXmlSpace);
  while (at < value.size()) {
    XmlWord word{{}, at, true};
    int depth = 0;
    std::size_t end = at;
    for (; end < value.size(); ++end) {
      if (depth <= 0 && kXmlSpace.find(value[end]) != std::string_view::npos) break;
      if (value[end] == '{') ++depth;
      if (value[end] == '}' && --depth < 0) word.balanced = false, depth = 0;
    }
    if (depth > 0) word.balanced = false;
    word.text = value.substr(at, end - at);
    words.push_back(word);
    at = value.find_first_not_of(kXmlSpace, end);
  }
  return words;
}

std::string escapeXmlText(std::string_view text) { return escaped(text, false); }
std::string escapeXmlValue(std::string_view text) { return escaped(text, true); }

std::string xmlParserText() {
  return "tinyxml2 " + std::to_string(TINYXML2_MAJOR_VERSION) + '.' +
         std::to_string(TINYXML2_MINOR_VERSION) + '.' + std::to_string(TINYXML2_PATCH_VERSION);
}

}  // namespace dynamy
