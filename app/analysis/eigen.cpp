/// dynamy eigen MODEL: linearises about a steady motion and computes eigenvalues and critical
/// values of a parameter.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/model/driving_forces.hpp>
#include <dynamy/io/model/start_values.hpp>
#include <filesystem>
#include <limits>
#include <memory>

#include "analysis/analysis_result.hpp"
#include "analysis/eigen_text.hpp"
#include "numbers.hpp"
#include "program.hpp"
#include "sweep/sweep_plan.hpp"

namespace dynamy::app {
namespace {

namespace fs = std::filesystem;

struct EigenTask {
  std::string model, over, rootOf;
  std::vector<std::string> set, start;
  double near = LinearisationOptions{}.near;
  bool asItIs = false;
  AnalysisResult result{"eigen"};
};

/// Number of intervals of a parameter that are searched for a change of sign.
constexpr int kIntervals = 20;
constexpr int kHalvings = 6;  ///< halvings of such an interval

class Eigenvalues {
 public:
  Eigenvalues(Program& program, const EigenTask& task) : program_(program), task_(task) {
    options_.set = assignments(task.set);
  }
  Model load() const {
    return loadModel(task_.model, program_.registry, program_.plugins, options_);
  }
  Model load(const std::string& name, double value) const {
    LoadOptions options = options_;
    options.set.emplace_back(name, fmt::format("{}", value));
    return loadModel(task_.model, program_.registry, program_.plugins, options);
  }
  const Overrides& set() const { return options_.set; }
  Linearisation solve(Model& model) const {
    State x = model.initialState();
    for (const std::string& s : task_.start) {
      const auto [name, value] = numberAssignment("--start", s);
      placeInState(model, name, value, x);
    }
    LinearisationOptions options;
    options.seek = !task_.asItIs, options.near = task_.near;
    return linearise(model, x, options);
  }
  Linearisation at(const std::string& name, double value) const {
    Model model = load(name, value);
    return solve(model);
  }

  /// One root in each interval whose ends have different numbers of growing motions.
  std::vector<CriticalValue> critical() const {
    const auto [name, text] = assignment(task_.rootOf);
    const Variation range = readBounds(name, text, kIntervals + 1, "--root-of");
    std::vector<CriticalValue> out;
    double a = std::stod(range.values.front());
    int before = at(name, a).growing();
    for (std::size_t i = 1; i < range.values.size(); ++i) {
      const double end = std::stod(range.values[i]);
      const int after = at(name, end).growing();
      if (after != before) out.push_back(root(name, a, end, before, after));
      a = end, before = after;
    }
    return out;
  }

  Locus locus() const {
    const auto [name, text] = assignment(task_.over);
    Locus out;
    out.name = name;
    for (const std::string& value : readVariation(name, text, "--over").values) {
      out.value.push_back(std::stod(value));
      out.eigenvalues.push_back(at(name, out.value.back()).eigenvalues);
    }
    return out;
  }

 private:
  /// Bisection by the number of growing motions, then inverse interpolation: a polynomial gives the
  /// parameter as a function of the real part and is evaluated at 0. No tolerance for "zero"
  /// enters.
  CriticalValue root(const std::string& name, double a, double b, int before, int after) const {
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (a + b);
      (at(name, middle).growing() == before ? a : b) = middle;
    }
    const std::complex<double> near = crossing(at(name, 0.5 * (a + b)).eigenvalues, {});
    constexpr int kPoints = 8;
    double real[kPoints], value[kPoints], imaginary[kPoints];
    for (int i = 0; i < kPoints; ++i) {
      value[i] = a + (b - a) * (static_cast<double>(i) / (kPoints - 1) * 2.0 - 0.5);
      const std::complex<double> z = crossing(at(name, value[i]).eigenvalues, near);
      real[i] = z.real(), imaginary[i] = z.imag();
    }
    CriticalValue out{name, 0.0, 0.0, before, after};
    for (int i = 0; i < kPoints; ++i) {  // Lagrange's form at 0
      double weight = 1.0;
      for (int k = 0; k < kPoints; ++k)
        if (k != i) weight *= real[k] / (real[k] - real[i]);
      out.value += weight * value[i], out.frequency += weight * imaginary[i];
    }
    return out;
  }

  /// The eigenvalue nearest to the imaginary axis among those with about the frequency of `near`.
  static std::complex<double> crossing(const Eigen::VectorXcd& all, std::complex<double> near) {
    std::complex<double> out;
    double least = std::numeric_limits<double>::infinity();
    for (const std::complex<double>& z : all) {
      const double off =
          std::abs(z.real()) + std::abs(z.imag() - near.imag()) * (near == 0.0 ? 0.0 : 1.0);
      if (z.imag() >= 0.0 && off < least) least = off, out = z;
    }
    return out;
  }

  Program& program_;
  const EigenTask& task_;
  LoadOptions options_;
};

void eigen(Program& program, const EigenTask& task) {
  const Eigenvalues all(program, task);
  Model model = all.load();
  const Linearisation l = [&] {
    try {
      return all.solve(model);
    } catch (const ModelError& error) {
      throw namingDrivingForces(error, task.model, all.set(), program.registry, program.plugins);
    }
  }();
  std::vector<CriticalValue> critical;
  if (!task.rootOf.empty()) critical = all.critical();
  const fs::path folder = task.result.folder(task.model);
  writeWholeFile(folder / "eigen.csv", eigenCsv(l.eigenvalues));
  if (!task.over.empty()) writeWholeFile(folder / "locus.csv", locusCsv(all.locus()));
  task.result.tell(
      task.model,
      [&](JsonWriter& j) {
        writeEigen(j, model, l);
        writeCritical(j, critical);
      },
      eigenText(model, l) + criticalText(critical));
  if (!task.rootOf.empty() && critical.empty())
    fmt::print(stderr, "dynamy: no real part changes its sign in {}\n", task.rootOf);
}

}  // namespace

void addEigen(CLI::App& app, Program& program) {
  auto t = std::make_shared<EigenTask>();
  CLI::App* c = app.add_subcommand("eigen",
                                   "eigenvalues of small disturbances of a steady motion, with "
                                   "closed contacts and joints as constraints");
  c->add_option("MODEL", t->model, "XML file")->required();
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--start", t->start,
                "where the steady motion is looked for, instead of the model's start")
      ->type_name("SYSTEM.COORDINATE=VALUE");
  c->add_flag("--as-it-is", t->asItIs, "the start is the steady motion; none is looked for");
  c->add_option("--near", t->near,
                "gaps up to this part of the scene's length count as closed, slips up to this part "
                "of the fastest velocity as sticking; default: 1e-6")
      ->type_name("NUMBER")
      ->check(positiveNumber());
  c->add_option("--root-of", t->rootOf,
                "also where a real part changes its sign while a parameter goes from A to B")
      ->type_name("NAME=A:B");
  c->add_option("--over", t->over, "also the eigenvalues over a parameter, into locus.csv")
      ->type_name("NAME=A:B:COUNT");
  t->result.declare(*c, program, "eigen.csv and eigen.json");
  c->callback([t, &program] {
    program.load();
    eigen(program, *t);
  });
}

}  // namespace dynamy::app
