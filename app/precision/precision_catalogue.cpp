/// Reads the files of bench/work_precision, and the points that the programs of peers offer.
///
///   scenes.txt   NAME[+FORM] STEP …      one line per form of a scene; the first has the steps
///   methods.txt  label | step or tolerance | scheme | scenes | tolerances
#include <fmt/format.h>

#include <algorithm>
#include <dynamy/io/files/output_file.hpp>
#include <filesystem>
#include <sstream>

#include "precision/precision_files.hpp"
#include "precision/precision_output.hpp"
#include "precision/precision_point.hpp"

namespace dynamy::app {
namespace {

std::string fileOf(const std::string& folder, const std::string& name) {
  if (!folder.empty()) return readWholeFile(std::filesystem::path(folder) / name);
  return std::string(precisionFile(name));
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& w : words) out += (out.empty() ? "" : " ") + w;
  return out;
}

/// The parts of a line between the separators `bar`, without surrounding blanks.
std::vector<std::string> parts(const std::string& line, char bar) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part, bar);) out.push_back(joined(wordsOf(part)));
  return out;
}

/// All lines that are not empty, without comments.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    if (!wordsOf(line).empty()) out.push_back(line);
  }
  return out;
}

/// Text of the first comment of a model, without line ends.
std::string firstComment(const std::string& text) {
  const auto begin = text.find("<!--"), end = text.find("-->");
  if (begin == std::string::npos || end == std::string::npos) return "";
  return joined(wordsOf(text.substr(begin + 4, end - begin - 4)));
}

std::string titleOf(const std::string& text) {
  const auto at = text.find("title=\"");
  if (at == std::string::npos) return "";
  const auto begin = at + 7;
  return text.substr(begin, text.find('"', begin) - begin);
}

bool takeStar(std::string& word) {
  const bool star = !word.empty() && word.back() == '*';
  if (star) word.pop_back();
  return star;
}

}  // namespace

std::vector<PrecisionScene> precisionScenes(const std::string& folder) {
  std::vector<PrecisionScene> out;
  for (const std::string& line : linesOf(fileOf(folder, "scenes.txt"))) {
    std::vector<std::string> words = wordsOf(line);
    const std::string file = words.front();
    const std::string name = file.substr(0, file.find('+'));
    const std::string form = file.size() > name.size() ? file.substr(name.size() + 1) : "";
    const std::string text = fileOf(folder, file + ".xml");
    if (text.empty()) throw std::runtime_error("scenes.txt: no model " + file + ".xml");
    if (out.empty() || out.back().name != name) {
      PrecisionScene s;
      s.name = name, s.title = titleOf(text), s.about = firstComment(text);
      s.steps.assign(words.begin() + 1, words.end());
      out.push_back(std::move(s));
    }
    out.back().forms.push_back(form);
    out.back().texts.push_back(text);
  }
  return out;
}

std::vector<PrecisionMethod> precisionMethods(const std::string& folder) {
  std::vector<PrecisionMethod> out;
  for (const std::string& line : linesOf(fileOf(folder, "methods.txt"))) {
    std::vector<std::string> p = parts(line, '|');
    p.resize(5);
    if (p[1] != "step" && p[1] != "tolerance")
      throw std::runtime_error("methods.txt: \"" + line + "\": neither step nor tolerance");
    PrecisionMethod m{p[0], p[1] == "tolerance", p[2], wordsOf(p[3]), wordsOf(p[4])};
    if (p[3] == "all") m.scenes.clear();
    out.push_back(std::move(m));
  }
  return out;
}

std::vector<PrecisionPoint> ownPoints(const std::vector<PrecisionScene>& scenes, int scene,
                                      const std::vector<PrecisionMethod>& methods) {
  const PrecisionScene& s = scenes[static_cast<std::size_t>(scene)];
  std::vector<PrecisionPoint> out;
  for (const PrecisionMethod& m : methods) {
    if (!m.scenes.empty() && std::find(m.scenes.begin(), m.scenes.end(), s.name) == m.scenes.end())
      continue;
    for (std::size_t form = 0; form < s.forms.size(); ++form)
      for (std::string setting : m.byTolerance ? m.tolerances : s.steps) {
        PrecisionPoint p;
        p.scene = scene, p.engine = "dynamY", p.form = static_cast<int>(form), p.own = m;
        p.method = m.label + (s.forms[form].empty() ? "" : ", " + s.forms[form]);
        p.quick = takeStar(setting);
        p.setting = setting;
        out.push_back(std::move(p));
      }
  }
  return out;
}

PrecisionPeer askPeer(const std::string& program, const std::vector<PrecisionScene>& scenes,
                      std::vector<PrecisionPoint>& points) {
  PrecisionPeer out;
  out.program = program;
  out.name = std::filesystem::path(program).filename().string().substr(5);
  const ProcessOutput answer = outputOfProgram({program}, 20.0);
  if (answer.status != 0)
    throw std::runtime_error(fmt::format("{} does not say what it can do", program));
  for (const std::string& line : linesOf(answer.text)) {
    const std::string key = wordsOf(line).front();
    const std::string rest = line.size() > key.size() ? line.substr(key.size() + 1) : "";
    if (key == "engine") out.version = rest, out.name = rest.substr(0, rest.find(' '));
    if (key == "note") out.notes.push_back(rest);
    if (key != "point") continue;
    const std::vector<std::string> p = parts(rest, '\t');  // scene, method, setting
    if (p.size() != 3) throw std::runtime_error(program + ": not a point: " + line);
    const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const PrecisionScene& s) { return s.name == p[0]; });
    if (scene == scenes.end()) continue;
    PrecisionPoint point;
    point.scene = static_cast<int>(scene - scenes.begin()), point.program = program;
    point.engine = out.name, point.method = p[1], point.setting = p[2];
    point.quick = takeStar(point.setting);
    points.push_back(std::move(point));
  }
  return out;
}

}  // namespace dynamy::app
