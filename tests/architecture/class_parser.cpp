#include "architecture/class_parser.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace dynamy::architecture {
namespace {

using Tokens = std::vector<std::string>;

bool isWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isWord(const std::string& token) { return isWordCharacter(token.front()); }

bool isOneOf(const std::string& token, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), token) != words.end();
}

/// The end of a string that begins with the quote at `at`; raw: R"delimiter( … )delimiter".
std::size_t endOfString(std::string_view text, std::size_t at, bool raw) {
  if (raw) {
    const std::size_t open = std::min(text.find('(', at), text.size());
    const std::string end = ")" + std::string(text.substr(at + 1, open - at - 1)) + '"';
    return std::min(text.find(end, open), text.size() - end.size()) + end.size();
  }
  const char quote = text[at];
  for (++at; at < text.size() && text[at] != quote; ++at)
    if (text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

/// The index behind the bracket that closes the one at `at`.
std::size_t afterBracket(const Tokens& t, std::size_t at) {
  int depth = 0;
  for (; at < t.size(); ++at) {
    if (isOneOf(t[at], {"(", "{", "["})) ++depth;
    if (isOneOf(t[at], {")", "}", "]"}) && --depth == 0) return at + 1;
  }
  return t.size();
}

/// The index behind the `>` of the template's arguments that begin at `at`.
std::size_t afterAngles(const Tokens& t, std::size_t at) {
  int depth = 0;
  while (at < t.size() && t[at] != ";") {
    if (isOneOf(t[at], {"(", "{", "["})) {
      at = afterBracket(t, at);
      continue;
    }
    if (t[at] == "<") ++depth;
    if (t[at++] == ">" && --depth == 0) return at;
  }
  return at;
}

/// The index of the `{` of a class whose head begins behind `class` or `struct`, and its name;
/// t.size() if there is no definition.
std::size_t bodyOfClass(const Tokens& t, std::size_t at, std::string& name) {
  name.clear();
  for (bool bases = false; at < t.size();) {
    if (t[at] == "{") return at;
    if (t[at] == "alignas" || t[at] == "[") {
      at = afterBracket(t, t[at] == "[" ? at : at + 1);
    } else if (t[at] == "<") {
      at = afterAngles(t, at);
    } else if (t[at] == ":") {
      bases = true, ++at;
    } else if (isWord(t[at]) || t[at] == "::" || (bases && t[at] == ",")) {
      if (!bases && isWord(t[at]) && t[at] != "final") name = t[at];
      ++at;
    } else {
      break;
    }
  }
  return t.size();
}

/// The index behind a function whose parameters begin at `at`: behind its body or its `;`.
std::size_t afterFunction(const Tokens& t, std::size_t at) {
  at = afterBracket(t, at);
  while (at < t.size() && !isOneOf(t[at], {";", "{", ":"})) {
    if (t[at] == "(" || t[at] == "[")
      at = afterBracket(t, at);
    else
      ++at;
  }
  if (at < t.size() && t[at] == ":")  // members that a constructor initialises
    do {
      while (++at < t.size() && !isOneOf(t[at], {"(", "{"}))
        if (t[at] == "<") at = afterAngles(t, at) - 1;
      at = afterBracket(t, at);
      while (at < t.size() && t[at] == ".") ++at;
    } while (at < t.size() && t[at] == ",");
  return at < t.size() && t[at] == "{" ? afterBracket(t, at) : at + 1;
}

/// Counts the members of one class, statement after statement.
class MemberCounter {
 public:
  explicit MemberCounter(const Tokens& tokens) : t_(tokens) {}

  ClassSize count(std::string name, std::size_t begin, std::size_t end) {
    size_ = {std::move(name), 0, 0};
    for (std::size_t at = begin; at < end;) at = statement(at);
    return size_;
  }

 private:
  std::size_t statement(std::size_t at) {
    if (isOneOf(t_[at], {"public", "private", "protected"})) return at + 2;
    if (t_[at] == ";") return at + 1;
    if (isOneOf(t_[at], {"using", "friend", "typedef", "static_assert"})) return afterData(at);
    if (t_[at] == "template") return statement(afterAngles(t_, at + 1));
    if (isOneOf(t_[at], {"class", "struct", "union", "enum"})) {
      std::string name;
      const std::size_t open = bodyOfClass(t_, at + 1, name);
      if (open == t_.size()) return afterData(at);  // declared alone
      const std::size_t next = afterBracket(t_, open);
      return t_[next] == ";" ? next + 1 : data(next);
    }
    return functionOrData(at);
  }

  std::size_t functionOrData(std::size_t at) {
    bool ofClass = false;
    for (std::size_t i = at; i < t_.size();) {
      ofClass = ofClass || t_[i] == "static";
      if (t_[i] == "operator") return function(i + 1);
      if (t_[i] == "(") return t_[i + 1] == "*" ? data(at) : function(i);
      if (isOneOf(t_[i], {";", "=", "{", ","})) return ofClass ? afterData(at) : data(at);
      if (t_[i] == "<")
        i = afterAngles(t_, i);
      else if (t_[i] == "[")
        i = afterBracket(t_, i);
      else if (isOneOf(t_[i], {"alignas", "decltype", "explicit"}) && t_[i + 1] == "(")
        i = afterBracket(t_, i + 1);
      else
        ++i;
    }
    return t_.size();
  }

  /// `at`: in the name of the function, or its parameters.
  std::size_t function(std::size_t at) {
    ++size_.functions;
    if (t_[at] == "(" && t_[at + 1] == ")" && t_[at + 2] == "(") at += 2;  // operator()
    while (at < t_.size() && t_[at] != "(") ++at;
    return afterFunction(t_, at);
  }

  /// Counts the variables of one declaration.
  std::size_t data(std::size_t at) {
    ++size_.data;
    while (at < t_.size() && t_[at] != ";") {
      if (t_[at] == ",") ++size_.data;
      if (isOneOf(t_[at], {"(", "{", "["}))
        at = afterBracket(t_, at);
      else if (t_[at] == "<")
        at = afterAngles(t_, at);
      else
        ++at;
    }
    return at + 1;
  }

  std::size_t afterData(std::size_t at) const {
    while (at < t_.size() && t_[at] != ";") at = t_[at] == "{" ? afterBracket(t_, at) : at + 1;
    return at + 1;
  }

  const Tokens& t_;
  ClassSize size_;
};

}  // namespace

std::vector<std::string> tokensOf(std::string_view text) {
  Tokens out;
  bool lineBegins = true;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const std::string_view rest = text.substr(at);
    if (c == '\n') {
      lineBegins = true, ++at;
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at;
    } else if (rest.starts_with("//")) {
      at = std::min(text.find('\n', at), text.size());
    } else if (rest.starts_with("/*")) {
      at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
    } else if (c == '#' && lineBegins) {
      while (at < text.size() && text[at] != '\n') at += text[at] == '\\' ? 2 : 1;
    } else if (c == '"' || c == '\'') {
      const bool raw = c == '"' && !out.empty() && out.back() == "R" && text[at - 1] == 'R';
      if (raw) out.pop_back();
      at = endOfString(text, at, raw);
      out.emplace_back("\"\"");
      lineBegins = false;
    } else {
      std::size_t size = rest.starts_with("::") ? 2 : 1;
      const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0;
      if (isWordCharacter(c))  // 1'000 is one number
        while (size < rest.size() && (isWordCharacter(rest[size]) ||
                                      (number && (rest[size] == '\'' || rest[size] == '.'))))
          ++size;
      out.emplace_back(rest.substr(0, size));
      at += size;
      lineBegins = false;
    }
  }
  return out;
}

std::vector<ClassSize> classesIn(const Tokens& t) {
  std::vector<ClassSize> out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!isOneOf(t[i], {"class", "struct"})) continue;
    if (i > 0 && isOneOf(t[i - 1], {"enum", "friend", "<", ","})) continue;
    std::string name;
    const std::size_t open = bodyOfClass(t, i + 1, name);
    if (open == t.size() || name.empty()) continue;
    out.push_back(MemberCounter(t).count(name, open + 1, afterBracket(t, open) - 1));
  }
  return out;
}

std::set<std::string> classesDefinedOutside(const Tokens& t) {
  std::set<std::string> out;
  for (std::size_t at = 0; at < t.size();) {
    // Into namespaces; over everything else in braces.
    if (t[at] == "namespace" || t[at] == "extern") {
      while (at < t.size() && !isOneOf(t[at], {"{", ";", "("})) ++at;
      ++at;
    } else if (isOneOf(t[at], {"{", "["})) {
      at = afterBracket(t, at);
    } else if (t[at] == "(") {
      // … Class :: name (  or  Class :: ~name (  or  Class :: operator… (
      std::size_t name = at;
      while (name > 0 && name + 4 > at && t[name] != "::") --name;
      const bool tilde = name + 3 == at && t[name + 1] == "~";
      const bool plain = name + 2 == at || tilde || t[name + 1] == "operator";
      if (name > 0 && t[name] == "::" && plain && isWord(t[name - 1])) {
        out.insert(t[name - 1]);
        at = afterFunction(t, at);
      } else {
        at = afterBracket(t, at);
      }
    } else {
      ++at;
    }
  }
  return out;
}

}  // namespace dynamy::architecture
