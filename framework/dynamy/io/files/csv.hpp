#pragma once
/// \file
/// Fields and lines of CSV as in RFC 4180: comma, fields quoted only where they must be.

#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Appends a field, in quotes only if it holds a comma, a quote or a line end.
void appendCsvField(std::string& out, std::string_view field);

/// Splits the first line of `text` into `fields`; quotes may hold commas and line ends. Returns the
/// number of bytes read, including the line end.
std::size_t readCsvLine(std::string_view text, std::vector<std::string>& fields);

/// All whole lines of `text`; a last line without line end is left out, because its writer was
/// stopped.
std::vector<std::vector<std::string>> readCsv(std::string_view text);

}  // namespace dynamy
