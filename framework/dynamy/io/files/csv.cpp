#include <dynamy/io/files/csv.hpp>

namespace dynamy {

void appendCsvField(std::string& out, std::string_view field) {
  if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += field;
    return;
  }
  out += '"';
  for (const char c : field) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

std::size_t readCsvLine(std::string_view text, std::vector<std::string>& fields) {
  fields.assign(1, "");
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      fields.back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      fields.emplace_back();
    } else if (!quoted && c == '\n') {
      return i + 1;
    } else if (quoted || c != '\r') {
      fields.back() += c;
    }
  }
  return text.size();
}

std::vector<std::vector<std::string>> readCsv(std::string_view text) {
  std::vector<std::vector<std::string>> lines;
  while (!text.empty()) {
    std::vector<std::string> fields;
    const std::size_t taken = readCsvLine(text, fields);
    if (text[taken - 1] != '\n') break;
    lines.push_back(std::move(fields));
    text.remove_prefix(taken);
  }
  return lines;
}

}  // namespace dynamy
