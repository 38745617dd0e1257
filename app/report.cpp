/// dynamy report DIR: writes one printable page about a run from the files of its folder.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <memory>

#include "page.hpp"
#include "paths.hpp"
#include "program.hpp"
#include "report_plots.hpp"
#include "run/progress.hpp"

namespace dynamy::app {
namespace {

constexpr std::size_t kWorst = 12;  ///< number of impacts in the table

/// A number with six digits, a count as an integer, a dash for a missing value.
std::string shown(const JsonValue& v) {
  if (v.type == JsonValue::Type::text) return escapedXml(v.text);
  if (v.type != JsonValue::Type::number) return "–";
  return std::abs(v.value) < 1e15 && v.value == std::floor(v.value)
             ? fmt::format("{:.0f}", v.value)
             : fmt::format("{:.6g}", v.value);
}
std::string shown(const JsonValue& v, const std::string& unit) {
  return v ? shown(v) + ' ' + unit : shown(v);
}

/// An HTML table of two columns, name and value.
class Facts {
 public:
  void row(const std::string& name, const std::string& value, const char* kind = "") {
    html_ += "<tr><td class=\"text soft\">" + name + "</td><td class=\"text " + kind + "\">" +
             value + "</td></tr>\n";
  }
  std::string html() const { return "<div class=\"wide\"><table>\n" + html_ + "</table></div>\n"; }

 private:
  std::string html_;
};

std::string rows(const std::vector<std::vector<std::string>>& cells) {
  std::string out = "<div class=\"wide\"><table>\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const char* const tag = i == 0 ? "th" : "td";
    out += "<tr>";
    for (std::size_t k = 0; k < cells[i].size(); ++k)
      out += fmt::format("<{0}{1}>{2}</{0}>", tag, k == 0 ? " class=\"text\"" : "", cells[i][k]);
    out += "</tr>\n";
  }
  return out + "</table></div>\n";
}

std::string section(const std::string& title, const std::string& html) {
  return html.empty() ? std::string() : "<section><h2>" + title + "</h2>\n" + html + "</section>\n";
}

std::string worst(const JsonValue& w, const char* unit) {
  if (!(w["value"].value > 0.0)) return "none";
  return fmt::format("{:.3g} {} at {}, t = {:.6g} s", w["value"].value, unit,
                     escapedXml(w["contact"].text), w["t"].value);
}

/// True: the scheme of the run locates switches.
bool located(const JsonValue& run) {
  const JsonValue& e = run["effort"];
  return e["smooth"].value + e["events"].value + e["stepping"].value > 0.0;
}

std::string resultHtml(const JsonValue& run) {
  Facts f;
  const bool finished = run["state"].text == "finished";
  f.row("state", shown(run["state"]) + (run["reason"] ? ": " + shown(run["reason"]) : ""),
        finished ? "good" : "bad");
  const double t = run["t"].value, wall = run["wall_s"].value;
  f.row("time reached", shown(run["t"], "s") + " of " + shown(run["settings"]["until"], "s"));
  f.row("steps", shown(run["steps"]) + ", " + shown(run["rejected"]) + " taken back");
  f.row("impacts, switches", shown(run["impacts"]) + ", " + shown(run["switches"]));
  if (located(run)) {
    f.row("switches located, accumulations passed",
          shown(run["switchesLocated"]) + ", " + shown(run["accumulationsPassed"]));
    if (run["undecided"].value > 0.0) f.row("switches undecided", shown(run["undecided"]), "bad");
    if (const JsonValue& s = run["stepping"]; s["periods"].value > 0.0)
      f.row("stepped in time, switches not located",
            shown(s["time"], "s") + " in " + shown(s["periods"]) + " periods, " +
                shown(s["steps"]) + " steps, of " + shown(s["systems"]) + " systems");
  }
  const JsonValue& solver = run["solver"];
  f.row("steps not solved to tolerance",
        shown(solver["unconverged"]) + " of " + shown(solver["solves"]) + " with contacts",
        solver["unconverged"].value > 0.0 ? "bad" : "");
  f.row("time of the clock",
        (wall < 60.0 ? fmt::format("{:.3g} s", wall) : durationText(wall)) +
            (wall > 0.0 ? fmt::format(", {:.3g} times as fast as reality", t / wall) : ""));
  f.row("hash of the results", shown(run["hash"]));
  return f.html();
}

std::string costHtml(const JsonValue& run) {
  const JsonValue &size = run["sizes"], &solver = run["solver"], &set = run["settings"];
  Facts f;
  f.row("systems", shown(size["systems"]) + ", mass blocks " + shown(size["blocks"]));
  f.row("positions q, velocities u", shown(size["q"]) + ", " + shown(size["u"]));
  f.row("contact elements", shown(size["contactElements"]));
  f.row("closed contacts, at most", shown(size["contactsMax"]));
  if (set["tolerance"].value > 0.0)
    f.row("scheme, tolerance", shown(set["integrator"]) + ", " + shown(set["tolerance"]));
  else
    f.row("scheme, step", shown(set["integrator"]) + ", " + shown(set["step"], "s"));
  f.row("solver", shown(set["solver"]) +
                      fmt::format(", {:.3g} iterations on average, at most ",
                                  solver["iterationsMean"].value) +
                      shown(solver["iterationsMax"]));
  f.row("impact law", shown(set["impactLaw"]));
  f.row("evaluations", shown(run["evaluations"]));
  if (const JsonValue& e = run["effort"]; located(run)) {
    f.row("of these: smooth motion", shown(e["smooth"]));
    f.row("steps that were too long", shown(e["rejected"]));
    f.row("finding switches", shown(e["switches"]));
    f.row("switches themselves", shown(e["events"]));
    if (e["stepping"].value > 0.0) f.row("steps in time", shown(e["stepping"]));
  }
  const double steps = run["steps"].value;
  if (steps > 0.0)
    f.row("CPU time", fmt::format("{:.3g} s, {:.3g} µs a step", run["cpu_s"].value,
                                  1e6 * run["cpu_s"].value / steps));
  for (std::size_t i = 0; i < set["set"].names.size(); ++i)
    f.row("--set " + escapedXml(set["set"].names[i]), shown(set["set"].items[i]));
  return f.html();
}

std::string checksHtml(const JsonValue& checks) {
  if (checks.items.empty()) return "<p class=\"soft\">The model has no &lt;check&gt;.</p>\n";
  std::vector<std::vector<std::string>> cells{{"what", "got", "expected", "part of the band", ""}};
  for (const JsonValue& c : checks.items) {
    const double low = c["low"].value, high = c["high"].value;
    const double part = (c["got"].value - 0.5 * (low + high)) / (0.5 * (high - low));
    std::string what = c["measure"].text == "value" ? "" : shown(c["measure"]) + ' ';
    what += shown(c["signal"]) + (c["over"] ? ' ' + shown(c["over"]) : "");
    cells.push_back({what, c["note"] ? shown(c["note"]) : fmt::format("{:.9g}", c["got"].value),
                     shown(c["expected"]),
                     std::isfinite(part) ? fmt::format("{:+.0f} %", 100.0 * part) : "",
                     c["pass"].flag ? "<span class=\"good\">holds</span>"
                                    : "<span class=\"bad\">FAILS</span>"});
  }
  return rows(cells);
}

std::string errorBarsHtml(const JsonValue& b) {
  if (!b) return {};
  std::string out =
      "<p>From a second run with " +
      (b["tolerance"].value > 0.0 ? "a tenth of the tolerance, " + shown(b["tolerance"])
                                  : "half the step, " + shown(b["step"], "s")) +
      ".</p>\n";
  if (b["reason"]) return out + "<p class=\"bad\">It ended early: " + shown(b["reason"]) + "</p>\n";
  std::vector<std::vector<std::string>> cells{{"", "value", "±"}};
  for (const JsonValue& c : b["checks"].items)
    cells.push_back({(c["measure"].text == "value" ? "" : shown(c["measure"]) + ' ') +
                         shown(c["signal"]) + ", checked",
                     fmt::format("{:.9g}", c["got"].value), fmt::format("{:.2g}", c["bar"].value)});
  for (const JsonValue& s : b["signals"].items)
    cells.push_back({shown(s["name"]) + " at the end", fmt::format("{:.9g}", s["end"].value),
                     fmt::format("{:.2g}, at most {:.2g} (t = {:.4g} s)", s["bar"].value,
                                 s["largest"].value, s["t"].value)});
  out += rows(cells);
  if (b["chaotic"].flag)
    out += fmt::format("<p>Differences grow tenfold every {:.3g} s: the motion is chaotic.</p>\n",
                       std::log(10.0) / b["growth"].value);
  if (b["horizon"].type == JsonValue::Type::number)
    out += fmt::format(
        "<p class=\"bad\">A tenth of the range of a signal is lost at t = {:.4g} s: beyond, no "
        "figure of a single motion means anything.</p>\n",
        b["horizon"].value);
  return out;
}

std::string energyHtml(const JsonValue& e) {
  if (!e) return {};
  std::vector<std::vector<std::string>> cells{{"", "work [J]"}};
  const auto add = [&](const char* text, const JsonValue& v, bool always = true) {
    if (always || v.value != 0.0) cells.push_back({text, fmt::format("{:.6g}", v.value)});
  };
  add("energy at the start, T + V", e["start"]);
  add("drives and dampers", e["nonPotential"], false);
  add("friction", e["friction"], false);
  add("normal forces", e["normal"], false);
  add("joints", e["joints"], false);
  add("moving boundaries", e["boundaries"], false);
  add("discretisation", e["discretisation"]);
  add("energy at the end", e["end"]);
  add("what these lines leave unexplained", e["imbalance"]);
  std::string out = rows(cells);
  if (e["largestGain"].value > 0.0)
    out += fmt::format(
        "<p class=\"soft\">Contacts never fed more than {:.2g} J into a step (t = {:.6g} s).</p>\n",
        e["largestGain"].value, e["largestGainTime"].value);
  return out;
}

std::string worstHtml(const JsonValue& run, std::vector<EventLine> events) {
  Facts f;
  f.row("penetration", worst(run["penetration"], "m"));
  f.row("joint error", worst(run["jointError"], "m"));
  f.row("residual", worst(run["solver"]["worstResidual"], ""));
  f.row("energy an impact would have gained", worst(run["energyGain"], "J"));
  std::string out = f.html();
  if (const JsonValue& u = run["solver"]["unsolved"]; u) {
    out += fmt::format(
        "<p class=\"bad\">Step {}, t = {:.6g} s: {} after {} iterations at {}</p>\n<pre>",
        shown(u["step"]), u["t"].value, shown(u["status"]), shown(u["iterations"]),
        shown(u["contact"]));
    out += "tried: " + shown(u["tried"]) + '\n' + shown(u["findings"]) + "</pre>\n";
  }
  std::erase_if(events, [](const EventLine& e) { return !e.impact; });
  if (events.empty()) return out;
  std::stable_sort(events.begin(), events.end(),
                   [](const EventLine& a, const EventLine& b) { return a.impulse > b.impulse; });
  std::vector<std::vector<std::string>> cells{
      {"hardest impacts", "t [s]", "speed [m/s]", "percussion [N s]"}};
  for (std::size_t i = 0; i < std::min(events.size(), kWorst); ++i)
    cells.push_back({escapedXml(events[i].contact), fmt::format("{:.6g}", events[i].t),
                     fmt::format("{:.4g}", events[i].speed),
                     fmt::format("{:.4g}", events[i].impulse)});
  return out + rows(cells);
}

std::string plotHtml(const SignalTable& table, const std::string& text) {
  return table.t.empty() || table.signals.empty() ? "" : imageOf(signalsSvg(table, ""), text);
}

SignalTable tableOf(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error) ? readSignals(file) : SignalTable();
}

std::string body(const RunFolder& folder, const JsonValue& run) {
  std::error_code error;
  SignalTable signals = signalsOf(folder.path());
  for (std::size_t i = 0; i < signals.signals.size() && i < run["signals"].items.size(); ++i)
    signals.signals[i].unit = run["signals"].items[i]["unit"].text;
  const SignalTable ledger = tableOf(folder.ledger());
  std::vector<EventLine> events;
  if (std::filesystem::exists(folder.events(), error)) events = readEvents(folder.events());
  const double end = run["t"] ? run["t"].value : signals.t.empty() ? 0.0 : signals.t.back();
  const std::string timeline = timelineSvg(events, 0.0, end);

  std::string out = "<div class=\"pair\">" + section("Result", resultHtml(run)) +
                    section("What it costs", costHtml(run)) + "</div>\n";
  out += section("Checks", checksHtml(run["checks"]));
  out += section("Error bars", errorBarsHtml(run["errorBars"]));
  out += section("Energy", energyHtml(run["energy"]) +
                               plotHtml(energyTable(ledger), "energies and works over time"));
  out += section("Impacts and switches",
                 timeline.empty() ? "<p class=\"soft\">None.</p>\n"
                                  : imageOf(timeline, "status of the contacts over time"));
  out += section("Worst events", worstHtml(run, events));
  out += section("Convergence", plotHtml(solverTable(ledger), "residual and iterations over time"));
  out += section("Signals", plotHtml(signals, "recorded signals over time"));
  if (std::filesystem::exists(folder.model(), error))
    out += section("Model", "<pre>" + escapedXml(readWholeFile(folder.model())) + "</pre>\n");
  return out;
}

int report(const std::string& path, const std::string& to) {
  const RunFolder folder = RunFolder::existing(path);
  const JsonValue run = readJson(readWholeFile(folder.facts()), folder.facts().string());
  const std::string page = filled(pageFile("report.html"),
                                  {{"title", escapedXml(run["title"] ? run["title"].text : path)},
                                   {"style", std::string(pageFile("pages.css"))},
                                   {"model", shown(run["model"])},
                                   {"dynamy", shown(run["dynamy"])},
                                   {"body", body(folder, run)}});
  const std::filesystem::path file = to.empty() ? folder.report() : std::filesystem::path(to);
  writeWholeFile(file, page);
  fmt::print("{}\n", file.string());
  return kOk;
}

}  // namespace

void addReport(CLI::App& app, Program& program) {
  auto folder = std::make_shared<std::string>(), out = std::make_shared<std::string>();
  CLI::App* c = app.add_subcommand("report", "one printable page about a run");
  c->add_option("DIR", *folder, "run folder, e.g. runs/ball")->required();
  c->add_option("--out", *out, "file to write; default: DIR/report.html")
      ->type_name("FILE")
      ->check(someName());
  c->callback([folder, out, &program] { program.exitCode = report(*folder, *out); });
}

}  // namespace dynamy::app
