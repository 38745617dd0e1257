#include "analysis/branch_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/version.hpp>
#include <dynamy/io/replay/plot_scale.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <set>

#include "page.hpp"

namespace dynamy::app {
namespace {

constexpr double kBranchWidth = 760.0, kBranchHeight = 380.0;
constexpr double kPlotLeft = 84.0, kPlotRight = 736.0, kPlotTop = 34.0, kPlotBottom = 332.0;
constexpr double kMargin = 0.05;  ///< of the range of values, above and below

/// Colour of a mark by what happens there.
std::string colourOf(const std::string& kind) {
  if (kind == "flip") return "#d95f02";
  if (kind == "fold" || kind == "branching") return "#7b3fa0";
  if (kind == "Neimark-Sacker") return "#1b7f47";
  if (kind == "end") return "#1b1f24";
  return "#b3261e";
}

/// The section holds this signal, or nothing depends on it: its curve says nothing.
bool saysNothing(const NamedBranch& of, const std::string& signal) {
  const auto& none = of.branch.ignorable;
  return signal == of.branch.section.signal ||
         std::find(none.begin(), none.end(), signal) != none.end();
}

class BranchPicture {
 public:
  BranchPicture(const NamedBranch& of, const std::string& quantity) : of_(of), quantity_(quantity) {
    const auto& names = of.branch.signals;
    signal_ =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), quantity) - names.begin());
    for (const BranchPoint& p : of.branch.points) y_.push_back(value(p));
    double low = *std::min_element(y_.begin(), y_.end());
    double high = *std::max_element(y_.begin(), y_.end());
    x0_ = x1_ = of.branch.points.front().p;
    for (const BranchPoint& p : of.branch.points)
      x0_ = std::min(x0_, p.p), x1_ = std::max(x1_, p.p);
    if (isSignal())
      for (const BrutePoint& b : of.brute) {
        x0_ = std::min(x0_, b.p), x1_ = std::max(x1_, b.p);
        low = std::min(low, b.state[signal_]), high = std::max(high, b.state[signal_]);
      }
    if (quantity == "multiplier") low = std::min(low, 1.0), high = std::max(high, 1.0);
    const double size = std::max(std::abs(low), std::abs(high));
    const double margin = std::max(kMargin * (high - low), 1e-9 * size + 1e-300);
    y0_ = low - margin, y1_ = high + margin;
  }
  std::string text() {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"system-ui,sans-serif\" font-size=\"11.5\" fill=\"#1b1f24\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
        kBranchWidth, kBranchHeight);
    axes();
    if (isSignal()) dots();
    curves();
    marks();
    return out_ + "</svg>\n";
  }

 private:
  bool isSignal() const { return signal_ < of_.branch.signals.size(); }
  double value(const BranchPoint& p) const {
    if (isSignal()) return p.state[signal_];
    if (quantity_ == "period") return p.period;
    return p.multipliers.size() > 0 ? p.multipliers.cwiseAbs().maxCoeff() : 0.0;
  }
  double x(double p) const {
    return kPlotLeft + (kPlotRight - kPlotLeft) * (p - x0_) / (x1_ - x0_);
  }
  double y(double v) const {
    return kPlotBottom - (kPlotBottom - kPlotTop) * (v - y0_) / (y1_ - y0_);
  }
  void axes() {
    const std::string what = isSignal()              ? quantity_ + " at the section"
                             : quantity_ == "period" ? "period [s]"
                                                     : "largest modulus of a multiplier";
    out_ += fmt::format("<text x=\"{}\" y=\"20\" font-size=\"13\" font-weight=\"600\">{}</text>\n",
                        kPlotLeft, escapedXml(what));
    const Ticks h = niceTicks(x0_, x1_, 9), v = niceTicks(y0_, y1_, 7);
    for (const double p : h.values)
      out_ += fmt::format(
          "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#dfe3e8\"/><text x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\" fill=\"#5f6c7b\">{4}</text>\n",
          x(p), kPlotTop, kPlotBottom, kPlotBottom + 16.0, tickLabel(p, h.step));
    for (const double p : v.values)
      out_ += fmt::format(
          "<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#dfe3e8\"/><text x=\"{3}\" y=\"{4:.1f}\" "
          "text-anchor=\"end\" fill=\"#5f6c7b\">{5}</text>\n",
          kPlotLeft, y(p), kPlotRight, kPlotLeft - 8.0, y(p) + 4.0, tickLabel(p, v.step));
    out_ +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                    0.5 * (kPlotLeft + kPlotRight), kPlotBottom + 34.0, escapedXml(of_.parameter));
  }
  /// Passes of plain runs, one dot for all in the same half of a pixel.
  void dots() {
    std::set<std::pair<int, int>> seen;
    std::string path;
    for (const BrutePoint& b : of_.brute) {
      const double cx = x(b.p), cy = y(b.state[signal_]);
      const auto cell = [](double v) { return static_cast<int>(std::lround(2.0 * v)); };
      if (seen.insert({cell(cx), cell(cy)}).second) path += fmt::format("M{:.1f} {:.1f}h0", cx, cy);
    }
    if (!path.empty())
      out_ += fmt::format(
          "<path d=\"{}\" stroke=\"#6b7785\" stroke-width=\"2.4\" stroke-linecap=\"round\"/>\n",
          path);
  }
  /// Lines between points; a part is dashed if the orbit at its end is unstable.
  void curves() {
    const auto& points = of_.branch.points;
    std::string path;
    const auto draw = [&](bool stable) {
      if (!path.empty())
        out_ += fmt::format(
            "<path d=\"{}\" fill=\"none\" stroke=\"#1769aa\" stroke-width=\"1.8\"{}/>\n", path,
            stable ? "" : " stroke-dasharray=\"6 4\"");
      path.clear();
    };
    bool last = true;
    for (std::size_t i = 1; i < points.size(); ++i) {
      // At a bifurcation the multiplier is 1 in modulus: the other end of the part says.
      const bool special = !points[i].kind.empty() && points[i].kind != "end";
      const bool stable = special ? points[i - 1].stable : points[i].stable;
      if (stable != last) draw(last);
      if (path.empty()) path = fmt::format("M{:.2f} {:.2f}", x(points[i - 1].p), y(y_[i - 1]));
      path += fmt::format("L{:.2f} {:.2f}", x(points[i].p), y(y_[i]));
      last = stable;
    }
    draw(last);
  }
  void marks() {
    for (std::size_t i = 0; i < y_.size(); ++i) {
      const BranchPoint& p = of_.branch.points[i];
      if (p.kind.empty()) continue;
      out_ += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.6\" fill=\"#ffffff\" stroke=\"{}\" "
          "stroke-width=\"1.8\"><title>{}</title></circle>\n",
          x(p.p), y(y_[i]), colourOf(p.kind),
          escapedXml(fmt::format("{} at {} = {:.9g}: {}", p.kind, of_.parameter, p.p, p.text)));
    }
  }

  const NamedBranch& of_;
  std::string quantity_;
  std::size_t signal_ = 0;
  std::vector<double> y_;
  double x0_ = 0.0, x1_ = 1.0, y0_ = 0.0, y1_ = 1.0;
  std::string out_;
};

}  // namespace

std::string branchSvg(const NamedBranch& branch, const std::string& quantity) {
  return BranchPicture(branch, quantity).text();
}

std::string shownSignal(const NamedBranch& of) {
  std::string out = "period";
  double most = 0.0;
  for (std::size_t k = 0; k < of.branch.signals.size(); ++k) {
    double low = of.branch.points.front().state[k], high = low;
    for (const BranchPoint& p : of.branch.points)
      low = std::min(low, p.state[k]), high = std::max(high, p.state[k]);
    const double size = std::max(std::abs(low), std::abs(high));
    if (saysNothing(of, of.branch.signals[k]) || !(size > 0.0)) continue;
    if ((high - low) / size > most) most = (high - low) / size, out = of.branch.signals[k];
  }
  return out;
}

std::string branchPage(const std::string& model, const NamedBranch& of) {
  std::string body = "<p>Periodic orbits over " + escapedXml(of.parameter) +
                     ": stable parts are solid, unstable ones dashed" +
                     (of.brute.empty() ? "" : ", dots are passes of the section by plain runs") +
                     ". Section: " + escapedXml(of.branch.section.text()) + ".</p>\n";
  std::vector<std::string> all = of.branch.signals;
  all.insert(all.begin(), {"period", "multiplier"});
  std::erase_if(all, [&](const std::string& s) { return saysNothing(of, s); });
  for (const std::string& quantity : all)
    body += "<figure>" + branchSvg(of, quantity) + "</figure>\n";
  body += "<h2>Found</h2><div class=\"wide\"><table><tr><th>" + escapedXml(of.parameter) +
          "</th><th>period [s]</th><th class=\"text\">what</th><th class=\"text\"></th></tr>\n";
  for (const BranchPoint& p : of.branch.points)
    if (!p.kind.empty())
      body += fmt::format(
          "<tr><td>{:.10g}</td><td>{:.10g}</td><td class=\"text\">{}</td>"
          "<td class=\"long\">{}</td></tr>\n",
          p.p, p.period, escapedXml(p.kind), escapedXml(p.text));
  body += "</table></div>\n";
  return filled(pageFile("report.html"), {{"title", escapedXml("Branch over " + of.parameter)},
                                          {"style", std::string(pageFile("pages.css"))},
                                          {"model", escapedXml(model)},
                                          {"dynamy", versionString()},
                                          {"body", body}});
}

}  // namespace dynamy::app
