/// RunWatch: asks during a run what its figures can be trusted for, and says at the end what cannot
/// be trusted and why. All limits are ratios, so that none depends on the units or the size of a
/// scene:
///
///   energy      e(t) = |ΔT + ΔV − works + joints|, added over intervals without an impact (some
///               schemes have the loss of an impact nowhere else), and
///               rise(t) = (T + V) − start − what drives and boundaries brought in;
///               at some hundred instants, over the largest T
///   rounding    r = max((64 + N) ε, 1e-11) (max T + max|V| + Σ|works|) + ε ½ sᵀM s/t²: what N steps and
///               positions known to g_tol leave of the energies, and energies by which nothing moves
///               √ε of the scene's length s (1 rad for angles) until the end t; e and rise count
///               above it only
///   resolution  (ωΔt)² = √(Σ|Δ²u|²_M / Σ(|u|²_M + |Δt M⁻¹h|²_M)) over steps without a change of
///               contacts: an oscillation of ω has Δ²u = −(ωΔt)² u
///   turn        the largest |Ω| Δt of a frame
///   fall        ½ Δt² |M⁻¹h|, the way that the forces alone lead in a step, over the scene's length
///   leap        the way of a shape in a step over its smallest size plus that of the smallest one it
///               could meet: above 1 they may pass each other unseen; half spaces are never passed
///   overlap     penetration over the scene's length, and over the way in a step of the fastest
///               frame or contact, which bounds it for a scheme on velocity level. It is that of
///               the places where steps look, and of their ends, which are recorded: γ^E leads
///               from one to the other; where that lies deeper than all before, gaps are taken,
///               as long as that costs little
///   joints      the worst position error over the scene's length, at the same instants as the
///               energy: schemes hold joints at the ends of steps, not where they evaluate them
///
/// Rejected: a second run with half the step for every run, which tells the error itself and costs
/// three times as much; it is there on request (dynamy run --error-bar).
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
  /// Evaluated at ends of steps, where schemes hold positions; made when it is first asked.
  std::unique_ptr<MechanicalSystem> ends_;
  double sampleEvery_ = 0.0, nextSample_ = 0.0, lastSample_ = -1.0;
  struct Mover {
    FrameHandle frame;
    double size;  ///< its smallest, and the smallest of what it could meet [m]
  };
  std::vector<Mover> movers_;
  double sampled_ = 0.0, unexplained_ = 0.0;
  // Lowest so far of T + V over that of the start, and of what the scheme itself brought in [J].
  double least_ = 0.0, leastOwn_ = 0.0;
  double sinceLeast_ = 0.0;  // largest that forces gave in a step since then [J]
  long sampledImpacts_ = 0;
  double inertia_ = 0.0;  // ½ sᵀM s/t² [J]
  double moves_ = 0.0;    // largest T + |V| + Σ|works| [J]
  long looks_ = 0;        // at ends of steps
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

/// What the figures of a finished run say against it; each with its cause, in the order of weight.
std::vector<Warning> warningsOf(const RunReport& report, double sceneLength);

/// Figures of a report that a `<check>` may ask for as `run.NAME`, with what they are.
struct RunFigure {
  const char* name;
  const char* text;
  double (*value)(const RunReport&);
};
std::span<const RunFigure> runFigures();
/// The figure `run.NAME`; null if there is none of this name.
const RunFigure* runFigure(std::string_view signal);

}  // namespace dynamy
