/// Pages of one file: a template of app/pages with style, script and data put in.
#pragma once
#include <string>
#include <string_view>

namespace dynamy::app {

/// The text of app/pages/`name`, or of a template of new-plugin; empty if there is no such file.
std::string_view pageFile(std::string_view name);

/// Puts `value` in the place of each "{{name}}".
void fill(std::string& page, std::string_view name, std::string_view value);

/// The template `file` with title, the common style, the script of its name if there is one, and
/// `data` (JSON), which cannot end its <script> early.
std::string filledPage(const std::string& file, const std::string& title, const std::string& data);

}  // namespace dynamy::app
