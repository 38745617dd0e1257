#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/model/file_branch.hpp>
#include <dynamy/io/model/parameter_hint.hpp>
#include <dynamy/simulation/orbit/section_points.hpp>
#include <utility>

namespace dynamy {
namespace {

constexpr int kPoints = 100;  ///< between the ends of the range, if no number is given

struct Over {
  std::string name, from, to;
  int points = kPoints;
};

/// "mu=0.2:0.5:50".
Over readOver(const std::string& text) {
  const auto fail = [&](const std::string& why) {
    throw ModelError('"' + text + "\" is no range: " + why,
                     "write the parameter, its bounds and, if wanted, about how many points: "
                     "mu=0.2:0.5:50");
  };
  const std::size_t at = text.find('='), colon = text.find(':');
  if (at == std::string::npos || colon == std::string::npos || colon < at) fail("no bounds");
  const std::size_t second = text.find(':', colon + 1);
  Over out{text.substr(0, at), text.substr(at + 1, colon - at - 1),
           text.substr(colon + 1, second == std::string::npos ? second : second - colon - 1)};
  if (second == std::string::npos) return out;
  const std::string count = text.substr(second + 1);
  char* end = nullptr;
  const double n = std::strtod(count.c_str(), &end);
  if (count.empty() || *end != '\0' || !(n >= 2.0 && n <= 1e5) || n != std::floor(n))
    fail("the number of points is a whole number from 2 on");
  out.points = static_cast<int>(n);
  return out;
}

/// The value of a parameter that is set to a text, e.g. "30deg".
double valueOf(const std::string& name, const std::string& text, const FileOrbit& wanted,
               Registry& registry, PluginLoader& plugins) {
  std::map<std::string, double> values;
  LoadOptions options;
  options.set = wanted.set, options.parameters = &values;
  if (!text.empty()) options.set.emplace_back(name, text);
  const Model model = loadModel(wanted.file, registry, plugins, options);
  const auto found = values.find(name);
  if (found != values.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, value] : values) known.push_back(other);
  throw ModelError("no parameter \"" + name + '"', parameterHint(model, name, known));
}

}  // namespace

NamedBranch branch(const FileBranch& wanted, Registry& registry, PluginLoader& plugins) {
  const Over over = readOver(wanted.over);
  const auto value = [&](const std::string& text) {
    return valueOf(over.name, text, wanted.orbit, registry, plugins);
  };
  BranchRequest request;
  request.at = value(""), request.from = value(over.from), request.to = value(over.to);
  request.points = over.points, request.tolerance = wanted.orbit.tolerance;
  const OrbitMaker make = [&](double p, OrbitSection& section) {
    FileOrbit at = wanted.orbit;
    at.set.emplace_back(over.name, fmt::format("{}", p));
    return loadOrbitModel(at, registry, plugins, section);
  };
  State start;
  if (!wanted.orbit.start.empty()) {
    OrbitSection section;
    start = startOf(make(request.at, section), wanted.orbit);
  }
  NamedBranch out;
  out.parameter = over.name;
  out.branch = orbitBranch(make, request, wanted.orbit.start.empty() ? nullptr : &start);
  const double step = (request.to - request.from) / std::max(1, wanted.brute - 1);
  for (int i = 0; i < wanted.brute; ++i) {
    const double p = request.from + i * step;
    OrbitSection section;
    Model model = make(p, section);
    for (std::vector<double>& state : sectionPoints(model, section, out.branch.near(p)))
      out.brute.push_back({p, std::move(state)});
  }
  return out;
}

std::string branchCsv(const NamedBranch& of) {
  Eigen::Index most = 0;
  for (const BranchPoint& p : of.branch.points) most = std::max(most, p.multipliers.size());
  std::string out;
  appendCsvField(out, of.parameter);
  out += ",period";
  for (const std::string& signal : of.branch.signals) out += ',', appendCsvField(out, signal);
  for (Eigen::Index i = 1; i <= most; ++i) out += fmt::format(",re{0},im{0}", i);
  out += ",zeros,stable,bifurcation,text\n";
  for (const BranchPoint& p : of.branch.points) {
    out += fmt::format("{},{}", p.p, p.period);
    for (const double x : p.state) out += fmt::format(",{}", x);
    for (Eigen::Index i = 0; i < most; ++i)
      out += i < p.multipliers.size()
                 ? fmt::format(",{},{}", p.multipliers[i].real(), p.multipliers[i].imag())
                 : ",,";
    out += fmt::format(",{},{},{},", p.zeros, p.stable ? 1 : 0, p.kind);
    appendCsvField(out, p.text);
    out += '\n';
  }
  return out;
}

std::string bruteCsv(const NamedBranch& of) {
  std::string out;
  appendCsvField(out, of.parameter);
  for (const std::string& signal : of.branch.signals) out += ',', appendCsvField(out, signal);
  out += '\n';
  for (const BrutePoint& b : of.brute) {
    out += fmt::format("{}", b.p);
    for (const double x : b.state) out += fmt::format(",{}", x);
    out += '\n';
  }
  return out;
}

void writeBranch(JsonWriter& j, const NamedBranch& of) {
  j.member("parameter", of.parameter).member("section", of.branch.section.text());
  j.member("points", of.branch.points.size()).member("cycles", of.branch.cycles);
  j.member("brute", of.brute.size());
  j.key("found").beginArray();
  for (const BranchPoint& p : of.branch.points) {
    if (p.kind.empty()) continue;
    j.beginObject().member(of.parameter, p.p).member("period", p.period);
    j.member("bifurcation", p.kind).member("text", p.text).endObject();
  }
  j.endArray();
}

}  // namespace dynamy
