/// The picture of a scene: decades on both axes, one line with marks for each method, a legend.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/io/replay/svg_plot.hpp>

#include "precision/precision_page.hpp"

namespace dynamy::app {
namespace {

constexpr double kChartWidth = 940.0, kChartLeft = 66.0, kChartTop = 34.0, kChartRight = 600.0,
                 kBottom = 440.0;
constexpr double kLegendRow = 17.0;  ///< height of a row of the legend
constexpr double kSmallest = 1e-16;  ///< smaller errors are drawn at this value

// Colours by Okabe and Ito; dark ones of one family for the methods of this program. Each line also
// has a mark of its own.
constexpr std::array kOwn = {"#08519c", "#2b8cd6", "#016c59", "#54278f", "#3690c0", "#02818a"};
struct Engine {
  const char *name, *colour;
};
constexpr std::array kEngines = {Engine{"Siconos", "#d55e00"}, Engine{"Simbody", "#b8860b"},
                                 Engine{"ODE", "#cc79a7"},     Engine{"Bullet", "#a50f15"},
                                 Engine{"DART", "#7f6000"},    Engine{"MuJoCo", "#e69f00"},
                                 Engine{"Rapier", "#636363"}};

struct CurveLine {
  std::string engine, method, colour;
  int mark = 0;
  std::vector<std::size_t> points;
};

class ChartPicture {
 public:
  ChartPicture(const PrecisionChart& m, int scene) : m_(m), scene_(scene) {
    for (std::size_t i = 0; i < m.points.size(); ++i)
      if (m.points[i].scene == scene && std::isfinite(m.results[i].error) && m.results[i].cpu > 0.0)
        add(i);
    colours();
    ranges();
  }
  std::string text() {
    const double legend = kChartTop + kLegendRow * (static_cast<double>(lines_.size()) + 1.0);
    const double height = std::max(kBottom + 46.0, legend + 10.0);
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"system-ui,sans-serif\" font-size=\"11.5\" fill=\"#1b1f24\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
        kChartWidth, height);
    axes();
    for (const CurveLine& line : lines_) draw(line);
    legendText();
    return out_ + "</svg>\n";
  }

 private:
  void add(std::size_t i) {
    const PrecisionPoint& p = m_.points[i];
    for (CurveLine& line : lines_)
      if (line.engine == p.engine && line.method == p.method) {
        line.points.push_back(i);
        return;
      }
    lines_.push_back({p.engine, p.method, "", 0, {i}});
  }
  void colours() {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      CurveLine& line = lines_[k];
      for (std::size_t j = 0; j < k; ++j) line.mark += lines_[j].engine == line.engine ? 1 : 0;
      const auto nth = static_cast<std::size_t>(line.mark);
      line.colour = "#444444";
      if (line.engine == "dynamY") line.colour = kOwn[nth % kOwn.size()];
      for (const Engine& e : kEngines)
        if (line.engine == e.name) line.colour = e.colour;
    }
  }
  double error(std::size_t i) const { return std::max(m_.results[i].error, kSmallest); }
  void ranges() {
    double xLow = 1e300, xHigh = 0.0, yLow = 1e300, yHigh = 0.0;
    for (const CurveLine& line : lines_)
      for (const std::size_t i : line.points) {
        xLow = std::min(xLow, m_.results[i].cpu), xHigh = std::max(xHigh, m_.results[i].cpu);
        yLow = std::min(yLow, error(i)), yHigh = std::max(yHigh, error(i));
      }
    if (lines_.empty()) xLow = 1e-3, xHigh = 1.0, yLow = 1e-6, yHigh = 1.0;
    yHigh = std::min(yHigh, 1e3);  // larger errors are drawn on the upper edge
    x0_ = std::floor(std::log10(xLow) + 1e-9), x1_ = std::ceil(std::log10(xHigh) - 1e-9);
    y0_ = std::floor(std::log10(std::min(yLow, yHigh)) + 1e-9);
    y1_ = std::ceil(std::log10(yHigh) - 1e-9);
    x1_ = std::max(x1_, x0_ + 1.0), y1_ = std::max(y1_, y0_ + 1.0);
  }
  double x(double cpu) const {
    return kChartLeft + (kChartRight - kChartLeft) * (std::log10(cpu) - x0_) / (x1_ - x0_);
  }
  double y(double e) const {
    return kBottom - (kBottom - kChartTop) * std::min((std::log10(e) - y0_) / (y1_ - y0_), 1.0);
  }
  void axes() {
    out_ +=
        fmt::format("<text x=\"{:.0f}\" y=\"20\" font-size=\"13\" font-weight=\"600\">{}</text>\n",
                    kChartLeft, escapedXml(m_.scenes[static_cast<std::size_t>(scene_)].title));
    for (int k = static_cast<int>(x0_); k <= static_cast<int>(x1_); ++k)
      out_ += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#dfe3e8\"/><text x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\" fill=\"#5f6c7b\">{4}</text>\n",
          x(std::pow(10.0, k)), kChartTop, kBottom, kBottom + 16.0, power(k));
    const int every = y1_ - y0_ > 10.5 ? 2 : 1;
    for (int k = static_cast<int>(y0_); k <= static_cast<int>(y1_); ++k)
      if ((k - static_cast<int>(y0_)) % every == 0)
        out_ += fmt::format(
            "<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#dfe3e8\"/><text x=\"{3}\" y=\"{4:.1f}\" "
            "text-anchor=\"end\" fill=\"#5f6c7b\">{5}</text>\n",
            y(std::pow(10.0, k)), kChartLeft, kChartRight, kChartLeft - 7.0,
            y(std::pow(10.0, k)) + 4.0, power(k));
    out_ += fmt::format(
        "<text x=\"{0:.0f}\" y=\"{1:.0f}\" text-anchor=\"middle\">CPU time [s]</text>\n"
        "<text x=\"16\" y=\"{2:.0f}\" text-anchor=\"middle\" transform=\"rotate(-90 16 {2:.0f})\">"
        "error</text>\n",
        0.5 * (kChartLeft + kChartRight), kBottom + 36.0, 0.5 * (kChartTop + kBottom));
  }
  static std::string power(int k) {
    return fmt::format("10<tspan dy=\"-4\" font-size=\"8.5\">{}{}</tspan>", k < 0 ? "−" : "",
                       std::abs(k));
  }
  void draw(const CurveLine& line) {
    std::string path;
    for (const std::size_t i : line.points)
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(m_.results[i].cpu),
                          y(error(i)));
    const bool own = line.engine == "dynamY";
    out_ +=
        fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", path,
                    line.colour, own ? 2.2 : 1.3, own || line.mark == 0 ? "" : dashes(line.mark));
    for (const std::size_t i : line.points) {
      const PrecisionResult& r = m_.results[i];
      out_ += fmt::format("<g><title>{}: {}, {}\nerror {:.3g}, {:.3g} s</title>{}</g>\n",
                          escapedXml(line.engine), escapedXml(line.method),
                          escapedXml(m_.points[i].setting), r.error, r.cpu,
                          mark(line, x(r.cpu), y(error(i))));
    }
  }
  static std::string dashes(int n) {
    constexpr std::array kDashes = {"", "5 3", "2 2.5", "8 3 2 3", "1 3"};
    return fmt::format(" stroke-dasharray=\"{}\"",
                       kDashes[static_cast<std::size_t>(n) % kDashes.size()]);
  }
  static std::string mark(const CurveLine& line, double px, double py) {
    const char* fill = line.engine == "dynamY" ? line.colour.c_str() : "#ffffff";
    const std::string look =
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.4\"", fill, line.colour);
    switch (line.mark % 4) {
      case 0:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" {}/>", px, py, look);
      case 1:
        return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"6.4\" height=\"6.4\" {}/>",
                           px - 3.2, py - 3.2, look);
      case 2:
        return fmt::format("<path d=\"M{:.1f} {:.1f}l4.2 7.2h-8.4z\" {}/>", px, py - 4.6, look);
      default:
        return fmt::format("<path d=\"M{:.1f} {:.1f}l4.4 4.4l-4.4 4.4l-4.4 -4.4z\" {}/>", px,
                           py - 4.4, look);
    }
  }
  void legendText() {
    double row = kChartTop + 8.0;
    const double left = kChartRight + 24.0;
    for (const CurveLine& line : lines_) {
      const bool own = line.engine == "dynamY";
      out_ += fmt::format(
          "<path d=\"M{:.0f} {:.1f}h26\" stroke=\"{}\" stroke-width=\"{}\"{}/>{}"
          "<text x=\"{:.0f}\" y=\"{:.1f}\"{}>{}</text>\n",
          left, row, line.colour, own ? 2.2 : 1.3, own || line.mark == 0 ? "" : dashes(line.mark),
          mark(line, left + 13.0, row), left + 34.0, row + 4.0, own ? " font-weight=\"600\"" : "",
          escapedXml(line.engine + ": " + line.method));
      row += kLegendRow;
    }
  }

  const PrecisionChart& m_;
  int scene_;
  std::vector<CurveLine> lines_;
  double x0_ = 0.0, x1_ = 1.0, y0_ = 0.0, y1_ = 1.0;
  std::string out_;
};

}  // namespace

std::string precisionSvg(const PrecisionChart& chart, int scene) {
  return ChartPicture(chart, scene).text();
}

}  // namespace dynamy::app
