#pragma once
/// \file
/// Fields and lines of CSV as in RFC 4180: comma, fields quoted only where they must be.

#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Appends a field: quoted only where a comma, a quote or a line's end makes it needed.
void appendCsvField(std::string& out, std::string_view field);

/// Splits the first line of `text` into `fields`; quotes may hold commas and line ends. Returns the
/// bytes it took, with the line's end.
std::size_t readCsvLine(std::string_view text, std::vector<std::string>& fields);

/// All whole lines of `text`; a last line without its end is left out, its writer was stopped.
std::vector<std::vector<std::string>> readCsv(std::string_view text);

}  // namespace dynamy
