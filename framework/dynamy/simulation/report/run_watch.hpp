/// RunWatch: measures during a run how far its figures can be trusted, and reports at the end which
/// of them cannot and why. All limits are ratios, so that none depends on the units or the size of
/// a scene:
///
///   energy      e(t) = |ΔT + ΔV − works + joints|, summed over intervals without an impact,
///               because some schemes book the loss of an impact in this term alone; and
///               rise(t) = (T + V) − start − the work of drives and boundaries.
///               Both are sampled at some hundred instants and divided by the largest T
///   rounding    r = max((64 + N) ε, 1e-11) (max T + max|V| + Σ|works|) + ε ½ sᵀM s/t²: the error
///               of the energies by rounding in N steps and by positions known to g_tol, and
///               the energy of a motion by √ε of the scene's length s (1 rad for angles) until
///               the end t. Only what e and rise exceed r by counts
///   resolution  (ωΔt)² = √(Σ|Δ²u|²_M / Σ(|u|²_M + |Δt M⁻¹h|²_M)) over steps without a change of
///               contacts: an oscillation of ω has Δ²u = −(ωΔt)² u
///   turn        the largest |Ω| Δt of a frame
///   fall        ½ Δt² |M⁻¹h|, the distance that the forces alone cause in a step, over the scene's
///               length
///   leap        the distance a shape moves in a step, over the sum of its smallest size and that
///               of the smallest shape it could meet: above 1 they may pass through each other
///               unnoticed; half spaces are never passed
///   overlap     penetration over the scene's length, and over the distance that the fastest frame
///               or contact moves in a step, which bounds it for a scheme on velocity level.
///               Penetration is measured where steps evaluate the contacts, and at the ends of
///               steps, which are recorded: γ^E extrapolates from the former to the latter. If the
///               extrapolated depth exceeds all before, gaps are evaluated there, as long as that
///               costs little
///   joints      the worst position error over the scene's length, at the same instants as the
///               energy: schemes hold joints at the ends of steps, not where they evaluate them
///
/// Rejected: a second run with half the step for every run. It measures the error itself, but costs
/// three times as much; it is available on request (dynamy run --error-bar).
#pragma once
#include <dynamy/simulation/report/run_report.hpp>
#include <memory>

namespace dynamy {

class RunWatch final : public Observer {
 public:
  /// `ledger` sees every step before the watch does.
  RunWatch(Model& model, EnergyLedger& ledger, RunReport& report);
  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  void finish(const StepView& last) override;
  void archive(Archive& a) override;

 private:
  void sample(const StepView& view);
  void energy(const StepView& view);
  void positions(const State& x);
  void ends(const StepView& view);
  void overlapsAt(const State& x);
  void rounding(const EnergyReport& e);
  void resolution(const StepView& view);
  void travel(const StepView& view);
  void collectShapes(const Model& model);
  MechanicalSystem& ends();
  Model& model_;
  EnergyLedger& ledger_;
  RunReport& report_;
  /// System evaluated at the ends of steps, where schemes hold positions; created at its first use.
  std::unique_ptr<MechanicalSystem> ends_;
  double sampleEvery_ = 0.0, nextSample_ = 0.0, lastSample_ = -1.0;
  struct Mover {
    FrameHandle frame;
    double size;  ///< sum of its smallest size and that of the smallest it could meet [m]
  };
  std::vector<Mover> movers_;
  double sampled_ = 0.0, unexplained_ = 0.0;
  // Lowest values so far of rise(t), see above, and of the energy that the scheme itself brought in
  // [J].
  double least_ = 0.0, leastOwn_ = 0.0;
  double sinceLeast_ = 0.0;  // largest energy that forces gave in a step since then [J]
  long sampledImpacts_ = 0;
  double inertia_ = 0.0;  // ½ sᵀM s/t² [J]
  double moves_ = 0.0;    // largest T + |V| + Σ|works| [J]
  long looks_ = 0;        // evaluations of gaps at ends of steps
  bool joints_ = false;   // something is held by joints
  long switches_ = 0, impacts_ = 0;
  int smooth_ = 0;  // steps without a change of contacts, in a row
  double curvature_ = 0.0, speed_ = 0.0;
  Eigen::VectorXd increment_, before_, momentum_;
};

/// A kind of warning.
struct WarningKind {
  const char* name;
  bool qualifies;    ///< the run is not what the model asks for: exit status 3
  const char* text;  ///< when it is reported
};
std::span<const WarningKind> warningKinds();
/// The kind of this name; null: there is none.
const WarningKind* warningKind(std::string_view name);

/// Warnings that follow from the figures of a finished run, each with its cause, the most serious
/// first.
std::vector<Warning> warningsOf(const RunReport& report, double sceneLength);

/// A figure of a report that a `<check>` may request as `run.NAME`, with its description.
struct RunFigure {
  const char* name;
  const char* text;
  double (*value)(const RunReport&);
};
std::span<const RunFigure> runFigures();
/// The figure `run.NAME`; null if there is none of this name.
const RunFigure* runFigure(std::string_view signal);

}  // namespace dynamy
