/// dynamy bench work-precision: error against CPU time for this program and for other programs.
#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <filesystem>
#include <fstream>
#include <memory>

#include "chosen_scenes.hpp"
#include "numbers.hpp"
#include "paths.hpp"
#include "precision/precision_page.hpp"

namespace dynamy::app {
namespace {
namespace fs = std::filesystem;

constexpr double kLongRun = 0.5;  ///< [s]; points that cost more are run once

struct PrecisionChoice {
  std::string out = "runs/work_precision", folder, peersIn;
  std::vector<std::string> scenes, peers = {"auto"};
  bool quick = false;
  int repeats = 5;
  double limit = 20.0;
};

/// Folder of the programs peer_NAME: that of this program unless the user names another.
fs::path peerFolder(const PrecisionChoice& c) {
  if (!c.peersIn.empty()) return c.peersIn;
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none).parent_path();
}

std::vector<std::string> peerPrograms(const PrecisionChoice& c) {
  std::vector<std::string> out, names;
  if (c.peers == std::vector<std::string>{"none"}) return out;
  std::error_code none;
  for (const fs::directory_entry& e : fs::directory_iterator(peerFolder(c), none))
    if (e.path().filename().string().starts_with("peer_") && access(e.path().c_str(), X_OK) == 0) {
      out.push_back(e.path().string());
      names.push_back(e.path().filename().string().substr(5));
    }
  std::sort(out.begin(), out.end());
  if (c.peers == std::vector<std::string>{"auto"}) return out;
  std::vector<std::string> chosen;
  for (const std::string& name : c.peers) {
    const auto found = std::find_if(out.begin(), out.end(), [&](const std::string& p) {
      return fs::path(p).filename().string() == "peer_" + name;
    });
    const std::string hint = didYouMean(nearest(name, names));
    if (found == out.end())
      throw CLI::ValidationError(
          "--peers", fmt::format("no program peer_{} in {}; bench/peers/install builds them{}{}",
                                 name, peerFolder(c).string(), hint.empty() ? "" : " — ", hint));
    chosen.push_back(*found);
  }
  return chosen;
}

std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name"))
      return line.substr(std::min(line.find(':') + 2, line.size()));
  return "unknown processor";
}

std::string machineText() {
  double load[3] = {0.0, 0.0, 0.0};
  const bool known = getloadavg(load, 3) > 0;
  return fmt::format("{}, {} cores{}\n{}", processorName(), sysconf(_SC_NPROCESSORS_ONLN),
                     known ? fmt::format(", load {:.1f} at the start", load[0]) : "",
                     versionText());
}

/// Runs all points in turn, `repeats` times, so that other load of the machine affects all points
/// alike. The cost of a point is the median.
void measure(Program& program, PrecisionChart& m, const PrecisionChoice& c) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  m.results.resize(m.points.size());
  std::vector<std::vector<double>> costs(m.points.size());
  for (int turn = 0; turn < (c.quick ? 1 : c.repeats); ++turn)
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      if (terminal)
        fmt::print(stderr, "\r turn {} of {}, point {} of {} ", turn + 1, c.quick ? 1 : c.repeats,
                   i + 1, m.points.size());
      const bool again = std::isfinite(m.results[i].error) && m.results[i].cpu < kLongRun;
      if (turn > 0 && !again) continue;
      const PrecisionResult r = runPoint(program, m.scenes, m.points[i], c.limit);
      if (turn == 0) m.results[i] = r;
      costs[i].push_back(r.cpu);
      std::vector<double> sorted = costs[i];
      std::sort(sorted.begin(), sorted.end());
      m.results[i].cpu = 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
    }
  if (terminal) fmt::print(stderr, "\r{:50}\r", "");
}

/// Prints for each scene and engine the point with the smallest error.
void say(const PrecisionChart& m) {
  for (std::size_t s = 0; s < m.scenes.size(); ++s) {
    fmt::print(" {}\n", m.scenes[s].name);
    std::vector<std::string> engines;
    for (const PrecisionPoint& p : m.points)
      if (std::find(engines.begin(), engines.end(), p.engine) == engines.end())
        engines.push_back(p.engine);
    for (const std::string& engine : engines) {
      std::size_t best = m.points.size();
      for (std::size_t i = 0; i < m.points.size(); ++i)
        if (m.points[i].scene == static_cast<int>(s) && m.points[i].engine == engine &&
            std::isfinite(m.results[i].error) &&
            (best == m.points.size() || m.results[i].error < m.results[best].error))
          best = i;
      if (best == m.points.size()) continue;
      fmt::print("   {:<10} smallest error {:<9.3g} in {:<9.3g} s   {} {}\n", engine,
                 m.results[best].error, m.results[best].cpu, m.points[best].method,
                 m.points[best].setting);
    }
  }
}

void writeChart(const PrecisionChart& m, const fs::path& folder) {
  fs::create_directories(folder);
  writeWholeFile(folder / "work_precision.csv", precisionCsv(m));
  for (std::size_t s = 0; s < m.scenes.size(); ++s)
    writeWholeFile(folder / ("work_precision_" + m.scenes[s].name + ".svg"),
                   precisionSvg(m, static_cast<int>(s)));
  writeWholeFile(folder / "work_precision.html", precisionPage(m));
  fmt::print(" wrote   {}/  work_precision.html work_precision.csv work_precision_*.svg\n",
             folder.string());
}

void benchPrecision(Program& program, const PrecisionChoice& c) {
  program.load();
  PrecisionChart m;
  m.scenes = chosenScenes(precisionScenes(c.folder), c.scenes);
  const std::vector<PrecisionMethod> methods = precisionMethods(c.folder);
  for (const PrecisionMethod& method : methods)
    if (!method.words.empty()) methodElement(program.registry, method.words, Kind::scheme);
  for (std::size_t s = 0; s < m.scenes.size(); ++s) {
    const auto points = ownPoints(m.scenes, static_cast<int>(s), methods);
    m.points.insert(m.points.end(), points.begin(), points.end());
  }
  for (const std::string& peer : peerPrograms(c))
    m.peers.push_back(askPeer(peer, m.scenes, m.points));
  if (c.quick) std::erase_if(m.points, [](const PrecisionPoint& p) { return !p.quick; });
  m.machine = machineText();
  fmt::print("{}\n", m.machine);
  for (const PrecisionPeer& p : m.peers) fmt::print("{}\n", p.version);
  if (m.peers.empty()) fmt::print("no peers\n");
  measure(program, m, c);
  say(m);
  writeChart(m, c.out);
}

}  // namespace

void addBenchPrecision(CLI::App& bench, Program& program) {
  auto t = std::make_shared<PrecisionChoice>();
  CLI::App* c = bench.add_subcommand(
      "work-precision", "error against CPU time, beside the programs of others that are installed");
  c->add_option("--out", t->out, "folder of page, pictures and table")
      ->type_name("DIR")
      ->check(someName());
  c->add_flag("--quick", t->quick, "a few points of each line, once");
  c->add_option("--scene", t->scenes, "these scenes only")->delimiter(',');
  c->add_option("--scenes", t->folder, "folder of other scenes: scenes.txt, methods.txt, models")
      ->type_name("DIR");
  c->add_option("--peers", t->peers, "auto (all that are found), none, or names")->delimiter(',');
  c->add_option("--peers-in", t->peersIn,
                "folder of the programs peer_NAME; default: the program's")
      ->type_name("DIR");
  c->add_option("--repeats", t->repeats, "turns through all points; the cost is the median")
      ->check(CLI::PositiveNumber);
  c->add_option("--limit", t->limit, "CPU time of a point [s]")->check(numberBetween(1.0, 3600.0));
  addPlugins(*c, program);
  c->callback([t, &program] { benchPrecision(program, *t); });
}

}  // namespace dynamy::app
