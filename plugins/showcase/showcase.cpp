/// A scheme, a solver and an observer in a plug-in: users add them in the same way as elements.
///
///   VelocityFirst  M(u^E − u^A) = hΔt + WΛ at (t^A, q^A),   q^E = q^A + Δt (F u^E + β)
///   FixedPoint     Λ ← prox_C(Λ − r (GΛ + c)),   r = factor/λ_max(G) for all rows
///   ImpulseMeter   Σ Λ_N of the run
#include <dynamy/dynamy.hpp>
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/solver/prox/relaxation.hpp>
#include <fstream>
#include <string>
#include <vector>

using namespace dynamy;

namespace {

class VelocityFirst final : public OneStep {
 public:
  static void declare(Attributes& a) {
    a.about("Velocities from the forces and contacts at the begin of the step, then positions.");
    a.example("<simulation until=\"1\" step=\"1e-3\"><VelocityFirst/></simulation>");
  }
  explicit VelocityFirst(const Parameters& x) : OneStep(x) {}
  int order() const override { return 1; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override {
    s.evaluate(x);                           // M, h, and W, χ where g(q^A) ≤ g_tol
    auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
    const auto solved = problem.solve(solver);
    problem.velocityFromImpulses(x);  // u^E = u^A + M⁻¹(h Δt + W Λ)
    s.move(x, dt);                    // q^E = q^A + Δt (F u^E + β)
    return {dt, solved, problem.size()};
  }
};

class FixedPoint final : public InclusionSolver {
 public:
  static void declare(Attributes& a) {
    a.about("Fixed-point iteration of the proximal equations with one step length for all rows.");
    a.optional("tolerance", Unit::none, 1e-10, "of both residuals").positive();
    a.optional("factor", Unit::none, 1.0, "multiplies the step length").positive();
    a.add(AttributeType::integer, "maxIterations", "10000", "sweeps after which it gives up")
        .positive();
    a.example("<simulation until=\"1\" step=\"1e-3\"><FixedPoint factor=\"0.9\"/></simulation>");
  }
  explicit FixedPoint(const Parameters& x)
      : InclusionSolver(x),
        tolerance_(x["tolerance"]),
        factor_(x["factor"]),
        maxIterations_(x["maxIterations"].integer()) {}

  SolveReport solve(const InclusionProblem& p, Vec Lambda) override {
    SolveReport report;
    relaxation(p, Relaxation::spectral, factor_, r_);
    xi_.resize(p.c.size());
    for (; report.iterations < maxIterations_; ++report.iterations) {
      report.residuals = residuals(p, {Lambda.data(), Lambda.size()}, scratch_);
      if (report.residuals.largest() <= tolerance_) return report;
      p.G->apply(Lambda.data(), xi_.data());
      for (std::size_t k = 0; k < xi_.size(); ++k) xi_[k] += p.c[k];
      for (int i = 0; i < p.size(); ++i) {
        const int row = p.row0(i);
        p.law(i).prox(p.input(i), r_.data() + row, xi_.data() + row, Lambda.data() + row);
      }
    }
    report.status = SolveStatus::maxIterations;
    return report;
  }

 private:
  double tolerance_, factor_;
  int maxIterations_;
  std::vector<double> r_, xi_, scratch_;
};

class ImpulseMeter final : public Observer {
 public:
  static void declare(Attributes& a) {
    a.about("Adds up all normal percussions of a run and writes the sum to a file [N s].");
    a.add(AttributeType::text, "file", "", "file to write at the end; empty: none");
    a.example("<ImpulseMeter name=\"meter\" file=\"impulse.txt\"/>");
  }
  explicit ImpulseMeter(const Parameters& x) : Observer(x), file_(x["file"].text) {}
  void start(const StepView&) override { sum_ = 0.0; }
  void step(const StepView& view) override {
    const InclusionProblem& p = view.system.problem();
    for (int i = 0; i < p.size(); ++i)
      for (int row = 0; row < p.dim(i); ++row)
        if (p.law(i).rowKind(row) == RowKind::normal) sum_ += view.Lambda[p.row0(i) + row];
  }
  void finish(const StepView&) override {
    if (file_.empty()) return;
    std::ofstream out(file_);
    out.precision(17);
    out << sum_ << '\n';
  }
  void archive(Archive& a) override { a(sum_); }  // a resumed run continues the sum

 private:
  std::string file_;
  double sum_ = 0.0;
};

void registerElements(Registry& r) {
  r.add<VelocityFirst>("VelocityFirst");
  r.add<FixedPoint>("FixedPoint");
  r.add<ImpulseMeter>("ImpulseMeter");
}

}  // namespace

DYNAMY_PLUGIN("showcase", "1.0.0", registerElements)
