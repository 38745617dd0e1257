#include "sweep/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <dynamy/core/version.hpp>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/files/output_file.hpp>

#include "page.hpp"
#include "sweep/sweep_row.hpp"

namespace dynamy::app {
namespace {

using Line = std::vector<std::string>;

/// The result line of a run without its id; empty if the run has no result.
Line lineOf(const SweepFolder& folder, std::size_t id, std::size_t columns) {
  if (!folder.has(id)) return {};
  auto lines = readCsv(readWholeFile(folder.result(id)));
  if (lines.size() != 1 || lines[0].size() != columns + 1 || lines[0][0] != std::to_string(id))
    throw FileError(folder.result(id).string(),
                    "is no line of this sweep; remove it, and the run is done again");
  lines[0].erase(lines[0].begin());
  return lines[0];
}

/// Writes a number or else a text as JSON; "" and numbers that are not finite become null.
void cell(JsonWriter& j, const std::string& text) {
  double x = 0.0;
  const char* const end = text.data() + text.size();
  if (text.empty() || text == "nan" || text == "inf" || text == "-inf")
    j.raw("null");
  else if (const auto r = std::from_chars(text.data(), end, x); r.ec == std::errc() && r.ptr == end)
    j.value(x);
  else
    j.value(text);
}

std::string csvText(const Sweep& sweep, const std::vector<Column>& columns,
                    const std::vector<Line>& lines) {
  std::string out = "id";
  for (const std::string& name : sweep.plan.names) out += ',', appendCsvField(out, name);
  for (const Column& c : columns) out += ',', appendCsvField(out, c.name);
  out += '\n';
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    out += std::to_string(i + 1);
    for (const auto* fields : {&sweep.plan.rows[i], &lines[i]})
      for (const std::string& field : *fields) out += ',', appendCsvField(out, field);
    out += '\n';
  }
  return out;
}

std::string dataText(const Sweep& sweep, const SweepFolder& folder,
                     const std::vector<Column>& columns, const std::vector<Line>& lines) {
  std::string out;
  JsonWriter j(out);
  j.beginObject().member("title", sweep.title).member("model", sweep.choice.model);
  j.member("dynamy", versionString()).member("measured", sweep.columns.size());
  j.key("fixed").beginArray();
  for (const auto& [name, value] : sweep.choice.set)
    j.beginArray().value(name).value(value).endArray();
  j.endArray().key("parameters").beginArray();
  for (const std::string& name : sweep.plan.names) j.value(name);
  j.endArray().key("columns").beginArray();
  for (const Column& c : columns)
    j.beginObject().member("name", c.name).member("unit", c.unit).endObject();
  j.endArray().key("rows").beginArray();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    j.beginObject().member("id", i + 1).key("values").beginArray();
    for (const std::string& value : sweep.plan.rows[i]) cell(j, value);
    j.endArray().key("cells").beginArray();
    for (const std::string& field : lines[i]) cell(j, field);
    j.endArray();
    if (std::filesystem::exists(folder.run(i + 1) / "replay.html"))
      j.member("link", "runs/" + std::to_string(i + 1) + "/replay.html");
    j.endObject();
  }
  j.endArray().endObject();
  return out;
}

/// True if one of the kinds, given as in "unsolved; overlap", is not accepted.
bool qualifies(const std::string& kinds, const Accepted& accept) {
  for (std::size_t from = 0; from < kinds.size();) {
    const std::size_t end = std::min(kinds.find("; ", from), kinds.size());
    if (!accept.takes(kinds.substr(from, end - from))) return true;
    from = end + 2;
  }
  return false;
}

}  // namespace

Collected collect(const Sweep& sweep, const SweepFolder& folder, const Accepted& accept) {
  std::vector<Column> columns = sweep.columns;
  for (Column& c : factColumns()) columns.push_back(std::move(c));
  const std::size_t state = sweep.columns.size();
  Collected out;
  std::vector<Line> lines;
  for (std::size_t id = 1; id <= sweep.runs(); ++id) {
    const Line& line = lines.emplace_back(lineOf(folder, id, columns.size()));
    if (line.empty()) {
      ++out.missing;
    } else if (line[state] != "finished") {
      ++out.failed;
      if (out.firstFault.empty()) out.firstFault = fmt::format("run {}: {}", id, line.back());
    } else {
      ++out.finished;
      const std::string& warnings = line[line.size() - 2];
      if (qualifies(warnings, accept) && out.qualified++ == 0)
        out.firstQualified = fmt::format("run {}: {}", id, warnings);
      out.failedChecks += line[state + 1] != "0";
    }
  }
  writeWholeFile(folder.results(), csvText(sweep, columns, lines));
  writeWholeFile(folder.page(),
                 filledPage("sweep.html", sweep.title, dataText(sweep, folder, columns, lines)));
  return out;
}

}  // namespace dynamy::app
