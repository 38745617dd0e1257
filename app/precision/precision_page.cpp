#include "precision/precision_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/replay/svg_plot.hpp>

#include "page.hpp"

namespace dynamy::app {
namespace {

std::string pointField(const std::string& text) {
  std::string out;
  appendCsvField(out, text);
  return out;
}

std::string digits(double x) { return std::isfinite(x) ? fmt::format("{:.3g}", x) : "–"; }

std::string tableOf(const PrecisionChart& m, int scene) {
  std::string out =
      "<details><summary>All points</summary><div class=\"wide\"><table>\n<tr><th class=\"text\">"
      "engine</th><th class=\"text\">method</th><th class=\"text\">step or tolerance</th><th>error"
      "</th><th>CPU [s]</th><th>evaluations</th><th class=\"text\">note</th></tr>\n";
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    const PrecisionPoint& p = m.points[i];
    const PrecisionResult& r = m.results[i];
    if (p.scene != scene) continue;
    out += fmt::format(
        "<tr><td class=\"text\">{}</td><td class=\"text\">{}</td><td class=\"setting\">{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td><td class=\"long\">{}</td></tr>\n",
        escapedXml(p.engine), escapedXml(p.method), escapedXml(p.setting), digits(r.error),
        digits(r.cpu), r.evaluations > 0 ? std::to_string(r.evaluations) : "–", escapedXml(r.note));
  }
  return out + "</table></div></details>\n";
}

/// Methods without any point in a scene, with the reason given for their first setting.
std::string absentOf(const PrecisionChart& m, int scene) {
  std::vector<std::pair<std::string, std::string>> lines;  // name, reason; "": it has points
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    const PrecisionPoint& p = m.points[i];
    if (p.scene != scene) continue;
    const std::string name = p.engine + ", " + p.method;
    const bool there = std::isfinite(m.results[i].error);
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const auto& line) { return line.first == name; });
    if (found == lines.end())
      lines.emplace_back(name, there ? "" : m.results[i].note);
    else if (there)
      found->second.clear();
  }
  std::string out;
  for (const auto& [name, reason] : lines)
    if (!reason.empty())
      out += "<li>" + escapedXml(name) + ": <span class=\"soft\">" + escapedXml(reason) +
             "</span></li>\n";
  return out.empty() ? "" : "<p>No point:</p><ul>\n" + out + "</ul>\n";
}

}  // namespace

std::string precisionCsv(const PrecisionChart& m) {
  std::string out = "scene,engine,method,setting,error,cpu_s,evaluations,note\n";
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    const PrecisionPoint& p = m.points[i];
    const PrecisionResult& r = m.results[i];
    out += fmt::format("{},{},{},{},{},{:.6g},{},{}\n",
                       m.scenes[static_cast<std::size_t>(p.scene)].name, pointField(p.engine),
                       pointField(p.method), pointField(p.setting), r.error, r.cpu, r.evaluations,
                       pointField(r.note));
  }
  return out;
}

std::string precisionPage(const PrecisionChart& m) {
  std::string contents, body, machine = m.machine + '\n';
  for (const PrecisionPeer& p : m.peers) {
    machine += p.version + '\n';
    for (const std::string& note : p.notes) machine += "    " + note + '\n';
  }
  for (std::size_t s = 0; s < m.scenes.size(); ++s) {
    const PrecisionScene& scene = m.scenes[s];
    const int index = static_cast<int>(s);
    contents += fmt::format("<a href=\"#{}\">{}</a>\n", scene.name, escapedXml(scene.title));
    body += fmt::format(
        "<section id=\"{}\"><h2>{}</h2><p class=\"soft about\">{}</p>\n<figure>{}</figure>\n{}{}"
        "</section>\n",
        scene.name, escapedXml(scene.title), escapedXml(scene.about), precisionSvg(m, index),
        absentOf(m, index), tableOf(m, index));
  }
  return filled(pageFile("work_precision.html"), {{"style", std::string(pageFile("pages.css"))},
                                                  {"machine", escapedXml(machine)},
                                                  {"contents", contents},
                                                  {"body", body}});
}

}  // namespace dynamy::app
