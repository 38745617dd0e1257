#include "import/element_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/suggestion.hpp>

namespace dynamy::app {

void ElementReader::fault(const XmlNode& node, const Place& place, const std::string& text,
                          const std::string& hint) {
  faults_.add(documentOf(place).diagnostic(place, node, text, hint));
}

const XmlDocument& ElementReader::documentOf(const Place& place) const {
  for (const XmlDocument* document : documents_)
    if (document->name() == place.file) return *document;
  return *documents_.front();
}

void ElementReader::note(const XmlNode& node, const Place& place, const std::string& text) {
  machine_.notes.push_back({place, "<" + node.label() + ">", text});
}

void ElementReader::note(const XmlNode& node, const std::string& text) {
  note(node, node.place, text);
}

std::string ElementReader::required(const XmlNode& node, const char* name) {
  if (const XmlAttribute* found = node.attribute(name)) return found->value;
  std::vector<std::string> given;
  for (const XmlAttribute& a : node.attributes) given.push_back(a.name);
  const std::string near = nearest(name, given);
  fault(node, fmt::format("the attribute \"{}\" is missing", name),
        near.empty() ? std::string() : fmt::format("\"{}\" is given, did you mean that?", near));
  return {};
}

std::string valueOf(const XmlNode& node, const char* name, const std::string& otherwise) {
  const XmlAttribute* found = node.attribute(name);
  return found ? found->value : otherwise;
}

std::vector<double> ElementReader::parsed(const XmlNode& node, const std::string& what,
                                          std::string_view text, std::size_t count,
                                          const std::function<Place(std::size_t)>& place) {
  std::vector<double> out;
  const auto space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  for (std::size_t i = 0; i < text.size();) {
    if (space(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && !space(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    const char* begin = word.data() + (word[0] == '+' ? 1 : 0);
    double x = 0.0;
    const auto [stop, error] = std::from_chars(begin, word.data() + word.size(), x);
    if (error != std::errc() || stop != word.data() + word.size() || std::isnan(x)) {
      fault(node, place(i), fmt::format("{} \"{}\" is no number", what, word));
      return {};
    }
    out.push_back(x);
    i = end;
  }
  if (count > 0 && out.size() != count) {
    fault(node, place(0), fmt::format("{} has {} numbers instead of {}", what, out.size(), count));
    return {};
  }
  return out;
}

std::vector<double> ElementReader::numbers(const XmlNode& node, const char* name,
                                           std::size_t count) {
  const XmlAttribute* found = node.attribute(name);
  if (!found) return {};
  return parsed(node, name, found->value, count,
                [&](std::size_t offset) { return documentOf(node.place).at(*found, offset); });
}

std::vector<double> ElementReader::numbersOf(const XmlNode& node, std::size_t count) {
  return parsed(node, "its text", node.text, count, [&](std::size_t offset) {
    return node.text.empty() ? node.place : documentOf(node.place).at(node, offset);
  });
}

double ElementReader::numberOf(const XmlNode& node) {
  const std::vector<double> one = numbersOf(node, 1);
  return one.empty() ? 0.0 : one[0];
}

double ElementReader::number(const XmlNode& node, const char* name, double otherwise) {
  const std::vector<double> one = numbers(node, name, 1);
  return one.empty() ? otherwise : one[0];
}

double ElementReader::requiredNumber(const XmlNode& node, const char* name) {
  if (required(node, name).empty()) return 0.0;
  return number(node, name, 0.0);
}

Vec3 ElementReader::vector(const XmlNode& node, const char* name, const Vec3& otherwise) {
  const std::vector<double> all = numbers(node, name, 3);
  return all.empty() ? otherwise : Vec3(all[0], all[1], all[2]);
}

std::string ElementReader::word(const XmlNode& node, const char* name, const std::string& value,
                                const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), value) != words.end()) return value;
  const XmlAttribute* found = node.attribute(name);
  fault(node, found ? found->valuePlace : node.place, fmt::format("unknown {} \"{}\"", name, value),
        unknownNameHint(value, words));
  return words.front();
}

const XmlNode* childOf(const XmlNode& node, std::string_view tag) {
  for (const XmlNode& c : node.children)
    if (c.tag == tag) return &c;
  return nullptr;
}

std::vector<const XmlNode*> childrenOf(const XmlNode& node, std::string_view tag) {
  std::vector<const XmlNode*> out;
  for (const XmlNode& c : node.children)
    if (c.tag == tag) out.push_back(&c);
  return out;
}

void ElementReader::readOnly(const XmlNode& node,
                             std::initializer_list<std::string_view> attributes,
                             std::initializer_list<std::string_view> children,
                             std::initializer_list<Unsupported> why) {
  const auto reason = [&](const std::string& name) {
    const auto* found =
        std::find_if(why.begin(), why.end(), [&](const Unsupported& u) { return u.name == name; });
    return found == why.end() ? std::string("is not taken over") : std::string(found->why);
  };
  const auto among = [](const auto& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  // What an element lacks its likes lack, too: one note for all of them.
  const auto once = [&](const XmlNode& of, const Place& place, const std::string& text) {
    const auto [found, first] =
        repeated_.try_emplace(of.tag + ' ' + text, machine_.notes.size(), 0);
    if (first) {
      machine_.notes.push_back({place, "<" + of.label() + ">", text});
      return;
    }
    auto& [index, more] = found->second;
    machine_.notes[index].text = text + fmt::format(" (and {} more)", ++more);
  };
  for (const XmlAttribute& a : node.attributes)
    if (!among(attributes, a.name))
      once(node, a.namePlace, "attribute " + a.name + ": " + reason(a.name));
  for (const XmlNode& c : node.children)
    if (!among(children, c.tag)) once(c, c.place, reason(c.tag));
}

}  // namespace dynamy::app
