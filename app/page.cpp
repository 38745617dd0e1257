#include "page.hpp"

#include <algorithm>
#include <dynamy/io/replay/svg_plot.hpp>
#include <filesystem>

namespace dynamy::app {

std::string filled(std::string_view page, const Values& values) {
  std::string out;
  for (;;) {
    const std::size_t begin = page.find("{{");
    out += page.substr(0, begin);
    if (begin == std::string_view::npos) return out;
    page.remove_prefix(begin);
    const std::string_view name = page.substr(2, page.find("}}") - 2);
    const auto value =
        std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
    out += value == values.end() ? "{{" : std::string_view(value->second);
    page.remove_prefix(value == values.end() ? 2 : name.size() + 4);
  }
}

std::string filledPage(const std::string& file, const std::string& title, const std::string& data) {
  // '<' occurs in JSON only inside strings. Escaped, no "</script>" can end the data early.
  std::string escaped;
  escaped.reserve(data.size());
  for (const char c : data) {
    if (c == '<')
      escaped += "\\u003c";
    else
      escaped += c;
  }
  const std::string script = std::filesystem::path(file).stem().string() + ".js";
  return filled(pageFile(file), {{"title", escapedXml(title)},
                                 {"style", std::string(pageFile("pages.css"))},
                                 {"script", std::string(pageFile(script))},
                                 {"data", escaped}});
}

}  // namespace dynamy::app
