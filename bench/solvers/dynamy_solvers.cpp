/// Every registered inclusion solver, with a few variants of its attributes, on problems in the
/// layout of FCLIB; one line of CSV for each problem, solver and level.
///
///   bench_solvers [--limit S] [--loop S] [--levels 1e-4,1e-8,1e-12] [--only NAME,NAME]
///   FILE|FOLDER…
///
/// The solvers come from the registry, so that a new one joins by being registered.
#include <cstdlib>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <iostream>

#include "measure.hpp"

namespace {

using namespace dynamy;
using namespace dynamy::bench;

/// The measure of FCLIB, and the wish to stop at a time.
class TimedRule final : public FclibRule {
 public:
  bool enough() const override { return cpuSeconds() > until; }
  double until = 0.0;
};

bool declares(const RegisteredType& type, const std::string& attribute) {
  return type.attributes.find(attribute) != nullptr;
}

class RegisteredSolver final : public Candidate {
 public:
  RegisteredSolver(const RegisteredType& type, std::vector<GivenValue> values,
                   const FclibProblem& local)
      : type_(type), values_(std::move(values)), given_(inclusionProblem(local)) {
    given_->problem().rule = &rule_;
  }

  void prepare(double tolerance, int count) override {
    std::vector<GivenValue> values = values_;
    if (declares(type_, "tolerance")) values.emplace_back("tolerance", tolerance);
    // The limit is time, as it is for the others.
    if (declares(type_, "maxIterations")) values.emplace_back("maxIterations", "1000000000");
    solvers_.clear();
    for (int k = 0; k < count; ++k)
      solvers_.push_back(type_.make(Parameters::of(type_.attributes, type_.name, "", values)));
  }

  Said solve(int k, Eigen::VectorXd& r, double until) override {
    rule_.until = until;
    auto& solver = static_cast<InclusionSolver&>(*solvers_[static_cast<std::size_t>(k)]);
    const SolveReport report = solver.solve(given_->problem(), Vec(r.data(), r.size()));
    return {report.ok(), report.iterations, report.newton};
  }

 private:
  const RegisteredType& type_;
  std::vector<GivenValue> values_;
  std::unique_ptr<GivenProblem> given_;
  TimedRule rule_;
  std::vector<std::unique_ptr<Element>> solvers_;
};

/// Attribute variants besides the defaults; those of unknown solvers or attributes are left out.
struct Variant {
  const char *type, *attribute, *value;
};
constexpr Variant kVariants[] = {
    {"ProxGaussSeidel", "factor", "1.3"},
};

std::vector<Entry> entriesOf(const Registry& registry) {
  std::vector<Entry> entries;
  const auto add = [&entries](const RegisteredType& type, const std::string& name,
                              const std::vector<GivenValue>& values) {
    entries.push_back({name, [&type, values](const FclibProblem& local) {
                         return std::make_unique<RegisteredSolver>(type, values, local);
                       }});
  };
  for (const RegisteredType* type : registry.types()) {
    if (type->kind != Kind::solver) continue;
    add(*type, type->name, {});
    for (const Variant& v : kVariants)
      if (type->name == v.type && declares(*type, v.attribute))
        add(*type, type->name + ":" + v.attribute + "=" + v.value, {{v.attribute, v.value}});
  }
  return entries;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Registry registry;
    PluginLoader plugins;
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
    run(jobOf(argc, argv), "dynamy", entriesOf(registry), std::cout);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
