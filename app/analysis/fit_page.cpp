#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/version.hpp>
#include <dynamy/io/replay/plot_scale.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <filesystem>
#include <map>

#include "analysis/fit_facts.hpp"
#include "analysis/fit_text.hpp"
#include "page.hpp"
#include "report_plots.hpp"

namespace dynamy::app {
namespace {

constexpr double kFitWidth = 1000, kFitLeft = 80, kFitRight = 20, kFitGap = 26;
constexpr double kFitHigh = 190, kFitLow = 90;  ///< heights of signal and residuals
constexpr std::size_t kMostFitPlots = 40;

/// A panel of a plot: its ranges on the page and of the values.
struct Panel {
  double top = 0, height = 0, t0 = 0, t1 = 1, low = 0, high = 1;
  double x(double t) const {
    return kFitLeft + (t - t0) / (t1 - t0) * (kFitWidth - kFitLeft - kFitRight);
  }
  double y(double v) const { return top + height - (v - low) / (high - low) * height; }
  void cover(double v) { low = std::min(low, v), high = std::max(high, v); }
  void widen() {
    const double room = high > low ? 0.06 * (high - low) : 1.0;
    low -= room, high += room;
  }
  std::string axes(bool times) const {
    std::string out;
    const Ticks values = niceTicks(low, high, 5), instants = niceTicks(t0, t1, 10);
    for (const double v : values.values)
      out += fmt::format(
          "<path class='grid' d='M{} {:.1f}H{}'/><text x='{}' y='{:.1f}' "
          "text-anchor='end'>{}</text>\n",
          kFitLeft, y(v), kFitWidth - kFitRight, kFitLeft - 6, y(v) + 4, tickLabel(v, values.step));
    for (const double t : instants.values) {
      out += fmt::format("<path class='grid' d='M{:.1f} {}v{}'/>\n", x(t), top, height);
      if (times)
        out += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{} s</text>\n", x(t),
                           top + height + 16, tickLabel(t, instants.step));
    }
    return out;
  }
};

/// Measurements of one signal in one run, the signal of the fit, and the residuals in σ below.
std::string plotOf(const std::vector<const FittedPoint*>& points, const std::string& title) {
  Panel above{.top = 30, .height = kFitHigh},
      below{.top = 30 + kFitHigh + kFitGap, .height = kFitLow};
  above.t0 = points.front()->measured.t, above.t1 = points.back()->measured.t;
  if (!(above.t1 > above.t0)) above.t0 -= 0.5, above.t1 += 0.5;
  below.t0 = above.t0, below.t1 = above.t1;
  above.low = above.high = points.front()->fitted, below.low = -2.2, below.high = 2.2;
  std::string line, dots, rests;
  for (const FittedPoint* p : points) {
    above.cover(p->measured.value), above.cover(p->fitted);
    below.cover((p->measured.value - p->fitted) / p->measured.sigma);
  }
  above.widen();
  for (const FittedPoint* p : points) {
    const double t = above.x(p->measured.t);
    line += fmt::format("{}{:.2f} {:.2f}", line.empty() ? 'M' : 'L', t, above.y(p->fitted));
    dots += fmt::format("<circle cx='{:.2f}' cy='{:.2f}' r='2.2'/>", t, above.y(p->measured.value));
    rests += fmt::format("<circle cx='{:.2f}' cy='{:.2f}' r='2.2'/>", t,
                         below.y((p->measured.value - p->fitted) / p->measured.sigma));
  }
  const double height = below.top + below.height + 24;
  return fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}'>"
      "<style>text {{ font: 12px sans-serif; fill: #5f6c7b }} .grid {{ stroke: #dfe3e8 }}</style>"
      "<text x='{2}' y='18'>{3}</text>\n{4}{5}"
      "<rect x='{2}' y='{6:.1f}' width='{7}' height='{8:.1f}' fill='#1769aa' fill-opacity='0.08'/>"
      "<g fill='#d95f02'>{9}\n{10}</g>\n"
      "<path d='{11}' fill='none' stroke='#1769aa' stroke-width='1.6'/>\n</svg>\n",
      kFitWidth, height, kFitLeft, escapedXml(title), above.axes(false), below.axes(true),
      below.y(1.96), kFitWidth - kFitLeft - kFitRight, below.y(-1.96) - below.y(1.96), dots, rests,
      line);
}

std::string plots(const Fit& f) {
  std::map<std::pair<int, std::string>, std::vector<const FittedPoint*>> groups;
  for (const FittedPoint& p : f.points) groups[{p.run, p.measured.signal}].push_back(&p);
  std::string out =
      "<p class=\"soft\">Points: measured. Line: the fit. Below: residuals in standard deviations, "
      "with the band that holds 95 % of them.</p>\n";
  std::size_t drawn = 0;
  for (auto& [key, points] : groups) {
    if (drawn++ == kMostFitPlots) {
      out += fmt::format("<p>{} more plots are left out; residuals.csv has all points.</p>\n",
                         groups.size() - kMostFitPlots);
      break;
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const auto* a, const auto* b) { return a->measured.t < b->measured.t; });
    const std::string title = key.second + ", " + f.runs[static_cast<std::size_t>(key.first)].name;
    out += imageOf(plotOf(points, title), "measurements and fit of " + title);
  }
  return out;
}

std::string table(const std::vector<std::vector<std::string>>& cells) {
  std::string out = "<div class=\"wide\"><table>\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    out += "<tr>";
    for (std::size_t k = 0; k < cells[i].size(); ++k)
      out += fmt::format("<{0}{1}>{2}</{0}>", i == 0 ? "th" : "td", k == 0 ? " class=\"text\"" : "",
                         escapedXml(cells[i][k]));
    out += "</tr>\n";
  }
  return out + "</table></div>\n";
}

std::string parametersHtml(const Fit& f) {
  std::vector<std::vector<std::string>> cells{
      {"parameter", "value", "standard deviation", "95 % from", "to", "interval"}};
  for (const FittedParameter& p : f.parameters) {
    auto& row = cells.emplace_back(std::vector<std::string>{fittedName(f, p)});
    if (!p.identifiable)
      row.insert(row.end(), {"–", "–", "–", "–", "not identifiable"});
    else
      row.insert(row.end(),
                 {fitNumber(p.value, p.sigma), fmt::format("{:.2g}", p.sigma),
                  fitNumber(p.low, p.sigma), fitNumber(p.high, p.sigma), intervalWords(p)});
  }
  std::string out = table(cells);
  out += fmt::format("<p>χ² = {:.6g} with {} degrees of freedom</p>\n", f.chi2, f.freedom);
  for (const std::string& remark : fitRemarks(f))
    out += "<p class=\"bad\">" + escapedXml(remark) + "</p>\n";
  return out;
}

std::string correlationsHtml(const Fit& f) {
  constexpr std::size_t kMost = 40;
  std::vector<std::vector<std::string>> cells{{"", "", "correlation"}};
  for (const FitCorrelation& c : correlations(f, 0.0)) {
    if (cells.size() > kMost) break;
    cells.push_back({c.a, c.b, fmt::format("{:+.3f}", c.value)});
  }
  return cells.size() > 1 ? "<section><h2>Correlations</h2>\n" + table(cells) + "</section>\n" : "";
}

std::string runsHtml(const Fit& f) {
  std::vector<std::vector<std::string>> cells{{"run", "measurements", "χ²", "motions computed",
                                               "order of switches changed", "across switches",
                                               "ended early"}};
  for (const FittedRun& r : f.runs)
    cells.push_back({r.name, fmt::format("{}", r.count), fmt::format("{:.4g}", r.chi2),
                     fmt::format("{}", r.effort.runs), fmt::format("{}", r.effort.reordered),
                     fmt::format("{}", r.effort.across), fmt::format("{}", r.effort.ended)});
  std::vector<std::vector<std::string>> signals{
      {"signal", "measurements", "standard deviation", ""}};
  for (const FittedSignal& s : f.signals)
    signals.push_back({s.signal, fmt::format("{}", s.count), fmt::format("{:.4g}", s.sigma),
                       s.estimated ? "of the residuals" : "given"});
  return table(cells) + table(signals);
}

}  // namespace

std::string fitPage(const std::string& model, const Fit& f) {
  const std::string body = "<section><h2>Parameters</h2>\n" + parametersHtml(f) + "</section>\n" +
                           correlationsHtml(f) + "<section><h2>Runs</h2>\n" + runsHtml(f) +
                           "</section>\n<section><h2>Residuals</h2>\n" + plots(f) + "</section>\n";
  return filled(pageFile("report.html"),
                {{"title", "fit of " + escapedXml(std::filesystem::path(model).stem().string())},
                 {"style", std::string(pageFile("pages.css"))},
                 {"model", escapedXml(model)},
                 {"dynamy", versionString()},
                 {"body", body}});
}

}  // namespace dynamy::app
