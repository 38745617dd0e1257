#include "page.hpp"

#include <dynamy/io/svg_plot.hpp>
#include <filesystem>

namespace dynamy::app {

void fill(std::string& page, std::string_view name, std::string_view value) {
  const std::string mark = "{{" + std::string(name) + "}}";
  for (std::size_t at = page.find(mark); at != std::string::npos;
       at = page.find(mark, at + value.size()))
    page.replace(at, mark.size(), value);
}

std::string filledPage(const std::string& file, const std::string& title, const std::string& data) {
  // '<' occurs in JSON inside of strings only; escaped there, no "</script>" can end the data early
  std::string escaped;
  escaped.reserve(data.size());
  for (const char c : data) {
    if (c == '<')
      escaped += "\\u003c";
    else
      escaped += c;
  }
  // The data last: a mark inside of a text must not be filled.
  std::string page(pageFile(file));
  fill(page, "title", escapedXml(title));
  fill(page, "style", pageFile("pages.css"));
  fill(page, "script", pageFile(std::filesystem::path(file).stem().string() + ".js"));
  fill(page, "data", escaped);
  return page;
}

}  // namespace dynamy::app
