#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <dynamy/io/replay/plot_scale.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kWidth = 1000, kLeft = 86, kRight = 24, kTop = 56, kBottom = 54;
constexpr double kPlotWidth = kWidth - kLeft - kRight;
constexpr double kPanel = 150, kGap = 44;  // height of a panel; between two, with the names above
constexpr std::size_t kMostPanels = 40, kMostCurves = 6;
constexpr std::array kColours{"#1769aa", "#c2410c", "#2f7d32", "#7b3fa0", "#b3861b", "#5b6472"};

struct AxisRange {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void take(double x) {
    if (!std::isfinite(x)) return;
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  /// The range widened by the margin `share`; it has some extent even for constant or empty curves.
  AxisRange widened(double share) const {
    if (!(lo <= hi)) return {0, 1};
    double margin = (hi - lo) * share;
    if (hi - lo <= 1e-12 * std::max(std::abs(lo), std::abs(hi)) || hi == lo) {
      margin = lo == 0 ? 1 : 0.1 * std::abs(lo);
    }
    return {lo - margin, hi + margin};
  }
};

/// Text of a coordinate with two decimals, to a hundredth of a pixel.
std::string px(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", x);
  return text.data();
}

std::string textAt(double x, double y, const char* attributes, const std::string& text) {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + attributes + ">" + text + "</text>\n";
}

std::string lineTo(double x1, double y1, double x2, double y2, const char* kind) {
  return "<path class=\"" + std::string(kind) + "\" d=\"M" + px(x1) + ' ' + px(y1) + 'L' + px(x2) +
         ' ' + px(y2) + "\"/>\n";
}

/// One curve as a path, interrupted at values that are not finite.
std::string curve(std::span<const double> t, std::span<const double> y, AxisRange time,
                  AxisRange value, double top, const char* colour) {
  std::string d;
  bool down = false;
  for (const std::size_t i : thinned(t, y, static_cast<std::size_t>(kPlotWidth))) {
    if (!std::isfinite(y[i])) {
      down = false;
      continue;
    }
    d += down ? 'L' : 'M';
    d += px(kLeft + (t[i] - time.lo) / (time.hi - time.lo) * kPlotWidth) + ' ' +
         px(top + (value.hi - y[i]) / (value.hi - value.lo) * kPanel);
    down = true;
  }
  return "<path class=\"curve\" stroke=\"" + std::string(colour) + "\" d=\"" + d + "\"/>\n";
}

std::string panel(const SignalTable& table, const std::vector<std::size_t>& members, AxisRange time,
                  double top, bool last) {
  AxisRange value;
  for (const std::size_t k : members) {
    for (const double y : table.columns[k]) value.take(y);
  }
  value = value.widened(0.06);
  std::string svg;

  // grid and ticks
  const Ticks yTicks = niceTicks(value.lo, value.hi, 6);
  for (const double y : yTicks.values) {
    const double at = top + (value.hi - y) / (value.hi - value.lo) * kPanel;
    svg += lineTo(kLeft, at, kLeft + kPlotWidth, at, y == 0 ? "zero" : "grid");
    svg +=
        textAt(kLeft - 8, at + 4, "class=\"tick\" text-anchor=\"end\"", tickLabel(y, yTicks.step));
  }
  const Ticks tTicks = niceTicks(time.lo, time.hi, 11);
  for (const double t : tTicks.values) {
    const double at = kLeft + (t - time.lo) / (time.hi - time.lo) * kPlotWidth;
    svg += lineTo(at, top, at, top + kPanel, "grid");
    if (last) {
      svg += textAt(at, top + kPanel + 18, "class=\"tick\" text-anchor=\"middle\"",
                    tickLabel(t, tTicks.step));
    }
  }
  svg += lineTo(kLeft, top, kLeft, top + kPanel, "axis");
  svg += lineTo(kLeft, top + kPanel, kLeft + kPlotWidth, top + kPanel, "axis");

  // names in the colours of their curves, with the unit
  std::string names;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const SignalName& signal = table.signals[members[i]];
    names += "<tspan fill=\"" + std::string(kColours[i % kColours.size()]) + "\"" +
             (i > 0 ? " dx=\"14\"" : "") + ">" + escapedXml(signal.name) + "</tspan>";
  }
  const std::string& unit = table.signals[members.front()].unit;
  if (!unit.empty()) names += "<tspan class=\"unit\" dx=\"8\">[" + escapedXml(unit) + "]</tspan>";
  svg += textAt(kLeft, top - 9, "class=\"name\"", names);

  for (std::size_t i = 0; i < members.size(); ++i) {
    svg +=
        curve(table.t, table.columns[members[i]], time, value, top, kColours[i % kColours.size()]);
  }
  return svg;
}

constexpr const char* kStyle =
    "<style>text{font-family:'Helvetica Neue',Arial,'DejaVu Sans',sans-serif;fill:#1f2933}"
    ".title{font-size:18px;font-weight:600}.name{font-size:14px;font-weight:600}"
    ".unit,.label{font-size:13px;font-weight:400;fill:#52606d}.tick{font-size:12px;fill:#52606d}"
    "path{fill:none}.grid{stroke:#e4e7eb;stroke-width:1}.zero{stroke:#9aa5b1;stroke-width:1}"
    ".axis{stroke:#52606d;stroke-width:1}"
    ".curve{stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round}</style>\n";

}  // namespace

std::string escapedXml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::vector<std::vector<std::size_t>> panelsOf(std::span<const SignalName> signals) {
  const auto owner = [](const std::string& name) { return name.substr(0, name.rfind('.')); };
  std::vector<std::vector<std::size_t>> panels;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const auto fits = [&](const std::vector<std::size_t>& panel) {
      const SignalName& first = signals[panel.front()];
      return !signals[i].unit.empty() && first.unit == signals[i].unit &&
             owner(first.name) == owner(signals[i].name) && panel.size() < kMostCurves;
    };
    const auto panel = std::find_if(panels.begin(), panels.end(), fits);
    if (panel == panels.end()) {
      panels.push_back({i});
    } else {
      panel->push_back(i);
    }
  }
  return panels;
}

std::string signalsSvg(const SignalTable& table, const std::string& title) {
  auto panels = panelsOf(table.signals);
  const std::size_t all = panels.size();
  panels.resize(std::min(all, kMostPanels));
  AxisRange time;
  for (const double t : table.t) time.take(t);
  time = time.widened(0);

  const auto count = static_cast<double>(std::max<std::size_t>(panels.size(), 1));
  const double height = kTop + 24 + count * kPanel + (count - 1) * kGap + kBottom;
  const std::string size = px(kWidth) + " " + px(height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size +
                    "\" width=\"" + px(kWidth) + "\" height=\"" + px(height) + "\">\n" + kStyle +
                    "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  svg += textAt(kLeft, 32, "class=\"title\"", escapedXml(title));
  double top = kTop + 24;
  for (std::size_t i = 0; i < panels.size(); ++i, top += kPanel + kGap) {
    svg += panel(table, panels[i], time, top, i + 1 == panels.size());
  }
  std::string label = "time [s]";
  if (all > panels.size()) {
    label += " — " + std::to_string(all - panels.size()) + " more panels are left out";
  }
  svg +=
      textAt(kLeft + kPlotWidth / 2, height - 12, "class=\"label\" text-anchor=\"middle\"", label);
  return svg + "</svg>\n";
}

void writeSignalsSvg(const std::filesystem::path& path, const SignalTable& table,
                     const std::string& title) {
  writeWholeFile(path, signalsSvg(table, title));
}

}  // namespace dynamy
