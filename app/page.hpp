/// HTML pages of a single file: a template of app/pages with style, script and data inserted.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy::app {

/// The text of app/pages/`name`, or of a template of new-plugin; empty if there is no such file.
std::string_view pageFile(std::string_view name);

/// Pairs of a name and the text that replaces "{{name}}".
using Values = std::vector<std::pair<std::string_view, std::string>>;

/// The page with all values inserted, in one pass: "{{…}}" inside a value stays as text.
std::string filled(std::string_view page, const Values& values);

/// The template `file` with title, common style, the script of the same name if there is one, and
/// `data` (JSON). The data are escaped, so that they cannot end their <script> element early.
std::string filledPage(const std::string& file, const std::string& title, const std::string& data);

}  // namespace dynamy::app
