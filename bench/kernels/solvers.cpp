/// The kernels of the solvers, each done N times, for a tool that counts instructions.
///
///   bench_kernels --count N KERNEL      does it N times; prints a number that depends on the
///   result bench_kernels --list                kernels, one a line: name, units in one run, what a
///   unit is
///
/// The difference of two runs with different N, divided by the units, leaves out the start. Times
/// were rejected: instructions repeat exactly and can be compared across days.
#include <cstdlib>
#include <cstring>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <iostream>

#include "support/contact_problems.hpp"

namespace {

using namespace dynamy;

/// A problem, its solution, and a solver by name.
class Bench {
 public:
  Bench(const FclibProblem& problem, const std::string& solver, std::vector<GivenValue> values)
      : given_(inclusionProblem(condensed(problem))),
        solution_(Eigen::VectorXd::Zero(problem.rows())) {
    registerFramework(registry_);
    solver_ = made(solver, std::move(values));
    made("Automatic", {{"tolerance", 1e-13}})->solve(given_->problem(), view(solution_));
  }

  /// From Λ = 0.
  SolveReport cold() {
    Lambda_ = Eigen::VectorXd::Zero(solution_.size());
    return solver_->solve(given_->problem(), view(Lambda_));
  }
  /// From the solution, wrong by the part `off`, as the step before leaves it.
  SolveReport warm(double off) {
    Lambda_ = (1.0 + off) * solution_;
    return solver_->solve(given_->problem(), view(Lambda_));
  }
  double certificate() {
    return residuals(given_->problem(), view(std::as_const(solution_)), scratch_).Eu;
  }
  int contacts() const { return given_->problem().size(); }

 private:
  static Vec view(Eigen::VectorXd& x) { return Vec(x.data(), x.size()); }
  static ConstVec view(const Eigen::VectorXd& x) { return ConstVec(x.data(), x.size()); }
  std::unique_ptr<InclusionSolver> made(const std::string& type, std::vector<GivenValue> values) {
    const RegisteredType* t = registry_.find(type);
    if (t == nullptr) throw std::invalid_argument("no solver " + type);
    std::unique_ptr<Element> e = t->make(Parameters::of(t->attributes, type, "", values));
    return std::unique_ptr<InclusionSolver>(static_cast<InclusionSolver*>(e.release()));
  }

  Registry registry_;
  std::unique_ptr<GivenProblem> given_;
  std::unique_ptr<InclusionSolver> solver_;
  Eigen::VectorXd solution_, Lambda_;
  std::vector<double> scratch_;
};

constexpr int kSweeps = 1000;  // far more than the start costs

/// One contact of three rows with friction that slides.
FclibProblem slidingContact() {
  FclibProblem p;
  p.dim = 3;
  p.W = (Eigen::MatrixXd(3, 3) << 2.0, 0.3, 0.1, 0.3, 3.0, 0.2, 0.1, 0.2, 2.5)
            .finished()
            .sparseView();
  p.q = Eigen::Vector3d(-1.0, 2.0, 0.5);
  p.mu = Eigen::VectorXd::Constant(1, 0.3);
  return p;
}

std::vector<GivenValue> endless() {
  return {{"tolerance", 1e-300}, {"maxIterations", std::to_string(kSweeps)}};
}

/// The box of four contacts is pulled at half of what friction can hold, so that it sticks.
FclibProblem box() { return boxStack(1, 1.0, 0.6, 0.3); }
/// Twenty contacts of which the upper ones press on the lower.
FclibProblem stack() { return boxStack(5, 1.0, 0.6, 0.3); }

struct Kernel {
  const char *name, *unit;
  Bench bench;
  double (*once)(Bench&);
  int units;
};

double iterations(const SolveReport& r) { return r.iterations + r.residuals.Eu; }

std::vector<Kernel> kernels() {
  std::vector<Kernel> out;
  const auto sweeps = [&out](const char* name, const char* solver) {
    Bench bench(stack(), solver, endless());
    const int units = bench.contacts() * bench.cold().iterations;
    out.push_back({name, "contact of a sweep, with its share of the tests", std::move(bench),
                   [](Bench& b) { return iterations(b.cold()); }, units});
  };
  sweeps("sweep_gauss_seidel", "ProxGaussSeidel");
  sweeps("sweep_jacobi", "ProxJacobi");
  Bench certified(stack(), "Automatic", {});
  const int contacts = certified.contacts();
  out.push_back({"certificate", "contact", std::move(certified),
                 [](Bench& b) { return b.certificate(); }, contacts});
  for (const auto& [name, problem] :
       {std::pair{"newton_step_4", box()}, std::pair{"newton_step_20", stack()}}) {
    Bench newton(problem, "ProximalNewton", {{"tolerance", 1e-12}});
    const int steps = std::max(newton.warm(1e-3).newton, 1);
    out.push_back({name, "Newton step, with the tests and the start of the solve",
                   std::move(newton), [](Bench& b) { return iterations(b.warm(1e-3)); }, steps});
  }
  out.push_back({"one_contact_cold", "solve", Bench(slidingContact(), "Automatic", {}),
                 [](Bench& b) { return iterations(b.cold()); }, 1});
  out.push_back({"box_warm", "solve", Bench(box(), "Automatic", {}),
                 [](Bench& b) { return iterations(b.warm(1e-6)); }, 1});
  out.push_back({"box_cold", "solve", Bench(box(), "Automatic", {}),
                 [](Bench& b) { return iterations(b.cold()); }, 1});
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::vector<Kernel> all = kernels();
    if (argc == 2 && std::strcmp(argv[1], "--list") == 0) {
      for (const Kernel& k : all) std::cout << k.name << ' ' << k.units << ' ' << k.unit << '\n';
      return EXIT_SUCCESS;
    }
    for (Kernel& k : all) {
      if (argc != 4 || std::strcmp(argv[1], "--count") != 0 || k.name != std::string(argv[3]))
        continue;
      double sum = 0.0;
      for (long n = std::atol(argv[2]); n > 0; --n) sum += k.once(k.bench);
      std::cout << sum << '\n';
      return EXIT_SUCCESS;
    }
    std::cerr << "bench_kernels --list | --count N KERNEL\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
