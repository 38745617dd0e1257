#include "stability/stability_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <map>

#include "stability/stability_files.hpp"

namespace dynamy::app {
namespace {

std::string field(const std::string& text) {
  std::string out;
  appendCsvField(out, text);
  return out;
}

const StabilityScene& sceneOf(const StabilityMatrix& m, const StabilityTask& t) {
  return m.scenes[static_cast<std::size_t>(t.scene)];
}

std::string quoted(const std::string& words) {
  return words.find(' ') == std::string::npos ? words : '"' + words + '"';
}

std::string commandLine(const StabilityMatrix& m, const StabilityTask& t,
                        const std::string& folder) {
  return fmt::format("dynamy run {}/{}.xml --set dt={} --integrator {} --solver {}", folder,
                     sceneOf(m, t).name, numberText(t.step), quoted(t.scheme), quoted(t.solver));
}

// Colours by Okabe and Ito. A mark accompanies each colour, so that colour is never the only sign.
struct Look {
  const char *fill, *ink, *mark, *text;
};
constexpr std::array<Look, 4> kLooks = {{{"#8fcfb8", "#0b4f3a", "", "pass"},
                                         {"#e3e6ea", "#5f6b76", "–", "refused, with the reason"},
                                         {"#f2b48a", "#8a3c00", "×", "fails, and says so"},
                                         {"#b00020", "#ffffff", "!", "fails silently"}}};

const Look& look(Verdict v) { return kLooks[static_cast<std::size_t>(v)]; }

/// A column of the picture: a scheme with the default solver, or a solver with the default scheme.
struct MatrixColumn {
  std::string name;
  bool scheme;
};

std::vector<MatrixColumn> columnsOf(const StabilityMatrix& m) {
  std::vector<MatrixColumn> out;
  for (const bool scheme : {true, false})
    for (const StabilityTask& t : m.tasks) {
      if (scheme ? !t.ofSchemes : !t.ofSolvers) continue;
      const std::string& name = scheme ? t.scheme : t.solver;
      const auto same = [&](const MatrixColumn& c) { return c.scheme == scheme && c.name == name; };
      if (std::none_of(out.begin(), out.end(), same)) out.push_back({name, scheme});
    }
  return out;
}

constexpr double kLeft = 210.0, kTop = 190.0, kWidth = 26.0, kHeight = 17.0, kGap = 14.0;

class Picture {
 public:
  explicit Picture(const StabilityMatrix& m) : m_(m), columns_(columnsOf(m)) {
    double x = kLeft;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (c > 0 && !columns_[c].scheme && columns_[c - 1].scheme) x += kGap;
      x_.push_back(x);
      x += kWidth;
    }
    right_ = x + 150.0;
  }
  std::string text() {
    const double height = kTop + kHeight * static_cast<double>(m_.scenes.size()) + 50.0;
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"system-ui,sans-serif\" font-size=\"11\" fill=\"#1b1f24\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
        right_, height);
    legend();
    heads();
    for (std::size_t s = 0; s < m_.scenes.size(); ++s) row(s);
    return out_ + "</svg>\n";
  }

 private:
  void legend() {
    double x = 14.0;
    for (const Look& l : kLooks) {
      out_ += fmt::format(
          "<rect x=\"{0:.0f}\" y=\"14\" width=\"14\" height=\"13\" fill=\"{1}\"/>"
          "<text x=\"{2:.0f}\" y=\"24.5\" text-anchor=\"middle\" fill=\"{3}\">{4}</text>"
          "<text x=\"{5:.0f}\" y=\"24.5\">{6}</text>\n",
          x, l.fill, x + 7, l.ink, l.mark, x + 19, l.text);
      x += 40.0 + 6.2 * static_cast<double>(std::string_view(l.text).size());
    }
    out_ +=
        "<text x=\"14\" y=\"46\" fill=\"#5f6b76\">a field a step, the largest on the left</text>\n";
  }
  void heads() {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const bool own = columns_[c].name == (columns_[c].scheme ? m_.scheme : m_.solver);
      const double x = x_[c] + 0.5 * kWidth + 4.0, y = kTop - 8.0;
      out_ += fmt::format(
          "<text x=\"{0:.1f}\" y=\"{1:.1f}\" transform=\"rotate(-55 {0:.1f} "
          "{1:.1f})\"{2}>{3}</text>\n",
          x, y, own ? " font-weight=\"700\"" : "", escapedXml(columns_[c].name));
    }
  }
  void row(std::size_t scene) {
    const double y = kTop + kHeight * static_cast<double>(scene);
    out_ += fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                        kLeft - 8.0, y + 12.0, escapedXml(m_.scenes[scene].name));
    for (std::size_t c = 0; c < columns_.size(); ++c) cells(scene, c, y);
  }
  void cells(std::size_t scene, std::size_t c, double y) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < m_.tasks.size(); ++i) {
      const StabilityTask& t = m_.tasks[i];
      if (t.scene != static_cast<int>(scene)) continue;
      const bool here = columns_[c].scheme ? t.ofSchemes && t.scheme == columns_[c].name
                                           : t.ofSolvers && t.solver == columns_[c].name;
      if (here) all.push_back(i);
    }
    if (all.empty()) return;
    std::sort(all.begin(), all.end(),
              [&](std::size_t a, std::size_t b) { return m_.tasks[a].step > m_.tasks[b].step; });
    const double w = (kWidth - 3.0) / static_cast<double>(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const StabilityResult& r = m_.results[all[k]];
      const Look& l = look(r.verdict);
      const double x = x_[c] + w * static_cast<double>(k);
      out_ += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" fill=\"{}\"/>", x, y,
          w - 1.0, kHeight - 2.0, l.fill);
      if (w > 5.0 && *l.mark != '\0')
        out_ += fmt::format(
            "<text x=\"{:.2f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"{}\">{}</text>",
            x + 0.5 * (w - 1.0), y + 11.5, l.ink, l.mark);
      out_ += '\n';
    }
  }
  const StabilityMatrix& m_;
  std::vector<MatrixColumn> columns_;
  std::vector<double> x_;
  double right_ = 0.0;
  std::string out_;
};

std::string json(const StabilityMatrix& m, const std::string& folder) {
  std::string out;
  JsonWriter j(out);
  j.beginObject().member("scheme", m.scheme).member("solver", m.solver);
  j.key("scenes").beginArray();
  for (const StabilityScene& s : m.scenes)
    j.beginObject()
        .member("name", s.name)
        .member("title", s.title)
        .member("about", s.about)
        .endObject();
  j.endArray().key("cells").beginArray();
  for (std::size_t i = 0; i < m.tasks.size(); ++i) {
    const StabilityTask& t = m.tasks[i];
    const StabilityResult& r = m.results[i];
    j.beginObject().member("scene", t.scene).member("scheme", t.scheme).member("solver", t.solver);
    j.member("step", t.step).member("verdict", verdictText(r.verdict)).member("figure", r.figure);
    j.member("passMark", r.passMark).member("words", r.words).member("steps", r.steps);
    j.member("cpu", r.cpu).member("run", commandLine(m, t, folder)).endObject();
  }
  j.endArray().endObject();
  // Escaped, since "</" would end the script element.
  for (std::size_t at = 0; (at = out.find("</", at)) != std::string::npos; at += 3)
    out.replace(at, 2, "<\\/");
  return out;
}

}  // namespace

std::string stabilityCsv(const StabilityMatrix& m) {
  std::string out = "scene,scheme,solver,step,verdict,figure,passmark\n";
  for (std::size_t i = 0; i < m.tasks.size(); ++i) {
    const StabilityTask& t = m.tasks[i];
    const StabilityResult& r = m.results[i];
    out += fmt::format("{},{},{},{},{},{},{}\n", sceneOf(m, t).name, field(t.scheme),
                       field(t.solver), numberText(t.step), verdictText(r.verdict),
                       numberText(r.figure), field(r.passMark));
  }
  return out;
}

std::string stabilitySvg(const StabilityMatrix& m) { return Picture(m).text(); }

std::string stabilityPage(const StabilityMatrix& m, const std::string& folder) {
  std::string page(stabilityFile("page.html"));
  const std::string mark = "/*DATA*/";
  const auto at = page.find(mark);
  if (at != std::string::npos) page.replace(at, mark.size(), json(m, folder));
  return page;
}

}  // namespace dynamy::app
