#pragma once
/// \file
/// Finds the places of all elements, attributes and texts in an XML text, and reports its errors
/// exactly.
///
/// The parser of the tree (tinyxml2) knows lines only, and it accepts two roots, doubled
/// attributes, text outside of the root and unknown entities. The scanner reads the same text
/// before the parser. Either it throws a ModelError with line, column and cause, or it lists the
/// byte offsets of all elements, attributes and texts in document order. The parser then gives the
/// content.
///
/// Document types (`<!DOCTYPE`) with their entities are not supported; they give an error.

#include <dynamy/io/xml/source_text.hpp>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace dynamy {

/// Byte offsets in the source of all that carries content, in document order.
struct XmlScan {
  struct Element {
    std::size_t begin = 0, size = 0;  ///< `<Tag`
    std::size_t attributes = 0;       ///< number of attributes
  };
  struct Attribute {
    std::size_t name = 0, nameSize = 0, value = 0, valueSize = 0;
  };
  struct Text {
    std::size_t begin = 0;
    bool cdata = false;
  };
  std::vector<Element> elements;
  std::vector<Attribute> attributes;
  std::vector<Text> texts;  ///< texts of white space alone are left out
};

/// Deepest nesting of elements that is read.
constexpr std::size_t kDeepestXml = 64;
/// Most attributes of one element that are read.
constexpr std::size_t kMostXmlAttributes = 256;

/// A piece of a value whose length in the file differs from its decoded length: an entity, or a
/// line end of two bytes.
struct XmlShift {
  std::size_t begin = 0, size = 0;              ///< in the decoded value
  std::size_t sourceBegin = 0, sourceSize = 0;  ///< bytes of the file
};

/// \throws ModelError if the text is no well-formed XML in UTF-8.
XmlScan scanXml(const SourceText& source);

/// An entity such as `&lt;` or `&#176;`: its size in the source and the character it stands for.
struct XmlEntity {
  std::size_t size = 0;
  char32_t code = 0;
};
/// The entity that begins with the `&` at byte `at`, if XML defines it.
std::optional<XmlEntity> xmlEntity(std::string_view text, std::size_t at);

/// The pieces that decoding shortens in the value from byte `begin` to the end of `text`.
std::vector<XmlShift> xmlShifts(std::string_view text, std::size_t begin);

/// Offset in the source of a character of decoded content: the one that holds byte `decoded` of the
/// content that begins at `begin`. A line end of two bytes counts as one, an entity as the bytes of
/// its character; in a CDATA section there are no entities.
std::size_t sourceOffset(std::string_view text, std::size_t begin, std::size_t decoded, bool cdata);

}  // namespace dynamy
