#pragma once
/// \file
/// An XML file as an immutable tree in which every element, attribute and value knows its place.
///
/// The content comes from the parser (tinyxml2), the places from a scanner over the same text, see
/// xml_scanner.hpp. Rejected: the parser's own tree, which has lines but no columns, and no lines
/// at all once the file is closed.

#include <dynamy/core/error.hpp>
#include <dynamy/io/xml/source_text.hpp>
#include <dynamy/io/xml/xml_scanner.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

struct XmlAttribute {
  std::string name = {};
  std::string value = {};  ///< decoded: entities replaced, line ends are LF
  Place namePlace = {};
  Place valuePlace = {};   ///< without the quotes
  std::size_t source = 0;  ///< byte of the file at which the value begins
  std::vector<XmlShift> shifts = {};
};

/// A part of an element's text that stands in one piece in the file.
struct XmlPiece {
  std::ptrdiff_t offset = 0;  ///< in XmlNode::text; negative before white space that was cut off
  std::size_t source = 0;     ///< byte of the file
  bool cdata = false;
};

struct XmlNode {
  std::string tag = {};
  Place place = {};  ///< of `<Tag`
  std::vector<XmlAttribute> attributes = {};
  std::vector<XmlNode> children = {};
  std::string text = {};  ///< decoded, all pieces joined, without white space around it
  Place textPlace = {};   ///< line 0 if there is no text
  std::vector<XmlPiece> pieces = {};

  /// The attribute of this name; nullptr if it is not given.
  const XmlAttribute* attribute(std::string_view name) const;
  /// The element as messages name it: `RigidBody name="ball"`.
  std::string label() const;
};

class XmlDocument {
 public:
  /// \throws ModelError if there is no such file or it is no well-formed XML
  static XmlDocument read(const std::filesystem::path& file);
  /// \param name name of the file in messages
  /// \throws ModelError if the text is no well-formed XML
  static XmlDocument parse(std::string text, std::string name);

  const XmlNode& root() const { return root_; }
  const std::string& name() const { return source_.name(); }
  std::size_t size() const { return source_.text().size(); }  ///< bytes
  std::string_view sourceLine(int line) const { return source_.line(line); }
  /// The line that a message about `place` shows (SourceText::shownLine).
  std::string shownLine(const Place& place) const { return source_.shownLine(place); }

  /// Place of `length` bytes from byte `offset` of a decoded value; both are cut at its end.
  Place at(const XmlAttribute& attribute, std::size_t offset, std::size_t length = 1) const;
  /// Place of `length` bytes from byte `offset` of an element's text; both are cut at its end.
  Place at(const XmlNode& node, std::size_t offset, std::size_t length = 1) const;

  /// An error at a place of this file, with its line.
  Diagnostic diagnostic(Place place, const XmlNode& node, std::string text,
                        std::string hint = {}) const;

 private:
  XmlDocument(SourceText source, XmlNode root);
  SourceText source_;
  XmlNode root_;
};

/// A word of a value, e.g. of `0 0 {h0 + 0.1}`: words are separated by white space outside of
/// braces.
struct XmlWord {
  std::string_view text = {};
  std::size_t offset = 0;  ///< in the value
  bool balanced = true;    ///< every brace has its partner
};
/// \pre `value` outlives the result
std::vector<XmlWord> xmlWords(std::string_view value);

/// Escapes text for the content of an element: & < > are replaced, forbidden control characters
/// become U+FFFD.
std::string escapeXmlText(std::string_view text);
/// Escapes text for a value between quotes of either kind; line ends and tabs become entities, too.
std::string escapeXmlValue(std::string_view text);

/// The parser and its version, "tinyxml2 9.0.0".
std::string xmlParserText();

}  // namespace dynamy
