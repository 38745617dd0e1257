#include "report_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/replay/plot_scale.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <map>

namespace dynamy::app {
namespace {

constexpr double kPlotWidth = 1000, kPlotLeft = 190, kPlotRight = 24, kPlotRow = 24, kBar = 14;
constexpr std::size_t kMostPlotRows = 30;

/// Colour of the bar for a status; "" for an open contact, which has no bar.
std::string colourOf(const std::string& status) {
  if (status == "stick") return "#2f7d32";
  if (status == "slip") return "#e08a1e";
  if (status == "lower" || status == "upper") return "#7b3fa0";
  if (status == "locked") return "#5b6472";
  return {};
}

const std::vector<double>* column(const SignalTable& table, const std::string& name) {
  for (std::size_t i = 0; i < table.signals.size(); ++i)
    if (table.signals[i].name == name) return &table.columns[i];
  return nullptr;
}

bool isZero(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(), [](double v) { return v == 0.0; });
}

/// The row of one contact: bars for its status, ticks for its impacts.
std::string rowSvg(const std::vector<const EventLine*>& events, double y, double begin, double end,
                   double fastest) {
  const auto x = [&](double t) {
    return kPlotLeft + (t - begin) / (end - begin) * (kPlotWidth - kPlotLeft - kPlotRight);
  };
  std::string bars, ticks;
  double since = begin;
  std::string status, afterImpact;
  bool hit = false;
  const auto bar = [&](double until) {
    if (const std::string colour = colourOf(status); !colour.empty())
      bars += fmt::format("<rect x='{:.2f}' y='{:.1f}' width='{:.2f}' height='{}' fill='{}'/>\n",
                          x(since), y + (kPlotRow - kBar) / 2, std::max(x(until) - x(since), 0.4),
                          kBar, colour);
  };
  for (const EventLine* e : events) {
    status = e->from;  // a contact that opens right after its impact has no event of its own
    if (hit) afterImpact = status;
    bar(e->t);
    since = e->t, status = e->to, hit = e->impact;
    if (!hit) continue;
    const double height = 6 + (kPlotRow - 6) * (fastest > 0.0 ? e->speed / fastest : 1.0);
    ticks += fmt::format("<path d='M{0:.2f} {1:.1f}V{2:.1f}'/>\n", x(e->t), y + kPlotRow - 1,
                         y + kPlotRow - 1 - height);
  }
  // No event says whether the contact opened after its last impact. It is assumed to do the same as
  // after the impact before.
  if (hit && !afterImpact.empty()) status = afterImpact;
  bar(end);
  return bars + "<g stroke='#b3261e' stroke-width='1.3'>" + ticks + "</g>\n";
}

std::string legend(double y) {
  std::string out;
  double x = kPlotLeft;
  for (const auto& [status, text] :
       std::vector<std::pair<std::string, std::string>>{{"stick", "sticks"},
                                                        {"slip", "slips or closed"},
                                                        {"lower", "at a limit"},
                                                        {"locked", "locked"}}) {
    out += fmt::format("<rect x='{}' y='{}' width='18' height='10' fill='{}'/>", x, y - 9,
                       colourOf(status));
    out += fmt::format("<text x='{}' y='{}'>{}</text>\n", x + 24, y, text);
    x += 145;
  }
  return out + fmt::format(
                   "<path d='M{0} {1}v-12' stroke='#b3261e' stroke-width='1.3'/>"
                   "<text x='{2}' y='{1}'>impact, its height the speed</text>\n",
                   x + 8, y, x + 18);
}

}  // namespace

std::vector<EventLine> readEvents(const std::filesystem::path& file) {
  std::vector<EventLine> out;
  const auto lines = readCsv(readWholeFile(file));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto& f = lines[i];
    if (f.size() != 7)
      throw FileError(file.string() + ':' + std::to_string(i + 1), "expected seven fields");
    if (f[1] != "impact" && f[1] != "switch") continue;  // of a system; rows are contacts
    const auto number = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
    out.push_back({number(f[0]), f[1] == "impact", f[2], f[3], f[4], number(f[5]), number(f[6])});
  }
  return out;
}

std::string timelineSvg(const std::vector<EventLine>& events, double begin, double end) {
  if (events.empty() || !(end > begin)) return {};
  std::map<std::string, std::vector<const EventLine*>> byContact;
  double fastest = 0.0;
  for (const EventLine& e : events)
    byContact[e.contact].push_back(&e), fastest = std::max(fastest, e.speed);
  std::vector<std::string> names;
  for (const auto& [name, list] : byContact) names.push_back(name);
  std::stable_sort(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return byContact[a].size() > byContact[b].size();
  });
  const std::size_t all = names.size();
  names.resize(std::min(all, kMostPlotRows));
  std::sort(names.begin(), names.end());

  const double top = 30, bottom = top + kPlotRow * static_cast<double>(names.size());
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
      "font-family='Helvetica Neue,Arial,DejaVu Sans,sans-serif' font-size='12' fill='#52606d'>\n",
      kPlotWidth, bottom + 44);
  svg += legend(16);
  for (const auto ticks = niceTicks(begin, end, 11); const double t : ticks.values) {
    const double x =
        kPlotLeft + (t - begin) / (end - begin) * (kPlotWidth - kPlotLeft - kPlotRight);
    svg += fmt::format("<path d='M{0:.2f} {1}V{2}' stroke='#e4e7eb'/>", x, top, bottom);
    svg += fmt::format("<text x='{:.2f}' y='{}' text-anchor='middle'>{}</text>\n", x, bottom + 16,
                       tickLabel(t, ticks.step));
  }
  double y = top;
  for (const std::string& name : names) {
    svg += fmt::format("<text x='{}' y='{}' text-anchor='end' fill='#1f2933'>{}</text>\n",
                       kPlotLeft - 10, y + kPlotRow / 2 + 4, escapedXml(name));
    svg += rowSvg(byContact[name], y, begin, end, fastest);
    y += kPlotRow;
  }
  svg += fmt::format("<path d='M{0} {1}H{2}' stroke='#52606d'/>\n", kPlotLeft, bottom,
                     kPlotWidth - kPlotRight);
  std::string label = "time [s]";
  if (all > names.size())
    label += fmt::format(" — {} more contacts with fewer events are left out", all - names.size());
  svg += fmt::format("<text x='{}' y='{}' text-anchor='middle' font-size='13'>{}</text>\n</svg>\n",
                     (kPlotLeft + kPlotWidth - kPlotRight) / 2, bottom + 36, label);
  return svg;
}

SignalTable energyTable(const SignalTable& ledger) {
  SignalTable out;
  out.t = ledger.t;
  const auto add = [&](const std::string& name, std::vector<double> values) {
    out.signals.push_back({name, "J"}), out.columns.push_back(std::move(values));
  };
  const auto *T = column(ledger, "kinetic"), *V = column(ledger, "potential");
  if (T == nullptr || V == nullptr) return out;
  std::vector<double> sum(T->size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = (*T)[i] + (*V)[i];
  add("energy.kinetic", *T), add("energy.potential", *V), add("energy.sum", std::move(sum));
  for (const char* name :
       {"nonPotential", "friction", "normal", "joints", "boundaries", "discretisation"})
    if (const auto* work = column(ledger, name); work != nullptr && !isZero(*work))
      add("work." + std::string(name == std::string("normal") ? "normal forces" : name), *work);
  return out;
}

SignalTable solverTable(const SignalTable& ledger) {
  SignalTable out;
  out.t = ledger.t;
  const auto add = [&](const std::string& name, const std::string& unit, std::vector<double> x) {
    out.signals.push_back({name, unit}), out.columns.push_back(std::move(x));
  };
  if (const auto* r = column(ledger, "residual"); r != nullptr && !isZero(*r)) {
    std::vector<double> decades;
    for (const double x : *r) decades.push_back(x > 0.0 ? std::log10(x) : std::nan(""));
    add("log10 of the largest residual", "", std::move(decades));
  }
  for (const auto& [name, text, unit] :
       {std::tuple("iterations", "iterations of a step, at most", ""),
        {"contacts", "closed contacts, at most", ""},
        {"penetration", "penetration, at most", "m"}})
    if (const auto* x = column(ledger, name); x != nullptr && !isZero(*x)) add(text, unit, *x);
  return out;
}

std::string imageOf(const std::string& svg, const std::string& text) {
  std::string out =
      "<figure><img alt=\"" + escapedXml(text) + "\" src=\"data:image/svg+xml;base64,";
  appendBase64(out, svg);
  return out + "\"></figure>\n";
}

}  // namespace dynamy::app
