/// Pages of one file: a template of app/pages with style, script and data put in.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy::app {

/// The text of app/pages/`name`, or of a template of new-plugin; empty if there is no such file.
std::string_view pageFile(std::string_view name);

/// Names and what is put in the place of each "{{name}}".
using Values = std::vector<std::pair<std::string_view, std::string>>;

/// The page with all values in their places, in one pass: a mark inside of a value is text.
std::string filled(std::string_view page, const Values& values);

/// The template `file` with title, the common style, the script of its name if there is one, and
/// `data` (JSON), which cannot end its <script> early.
std::string filledPage(const std::string& file, const std::string& title, const std::string& data);

}  // namespace dynamy::app
