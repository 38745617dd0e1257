/// SteppedIslands: one step in time of islands whose switches are not located, and its error
/// (theory 50.7).
///
///   e = h/2 |Δu − Δu⁻ h/h⁻| / (tol s_i),   or the largest overlap at its end over tol L, if it grew
///
/// The step is that of EnergyMomentum. Where Newton's iteration on joints does not converge, this
/// step and all later ones of the period are those of StaggeredMoreau, which holds joints by their
/// mean velocity and projects them: it needs no iteration. The caller chooses the length of steps
/// (SwitchGovernor), and moves the other islands meanwhile.
#pragma once
#include <dynamy/schemes/energy_momentum.hpp>
#include <dynamy/stages/error_norm.hpp>
#include <dynamy/stages/islands.hpp>

namespace dynamy {

class SteppedIslands {
 public:
  struct Trial {
    StepReport report;
    double error = 0.0;  ///< in units of the tolerance
    int newton = 0;      ///< solves by Newton's method, at least one
    /// The step errs by a tenth of the scales and doubles the kinetic energy: it diverges.
    bool bursts = false;
    bool good() const { return error <= 1.0 && report.solved.ok(); }
  };
  /// Begins a period of steps in time.
  void begin() { rate_.resize(0), overlap_ = 0.0, projected_ = false, hitAt_.clear(); }
  /// What a run does once before its first steps in time, and a resumed run again.
  void prepare(MechanicalSystem& s, const State& from, double h) {
    midpoint_.findJoints(s, from, h);
  }
  /// Takes a step of length h [s] from `from`, into x, with this effort. It moves all systems; the
  /// error of those counts whose flag in `stepped` is not 0.
  Trial attempt(MechanicalSystem& s, InclusionSolver& solver, const ErrorNorm& norm,
                const Islands& islands, const std::vector<char>& stepped, Effort effort,
                const State& from, State& x, double h);
  /// Accepts the last attempt, which ended at x, as a step of the run.
  void take(const MechanicalSystem& s, const State& from, const State& x, double h);

  // What is kept from step to step.
  const Eigen::VectorXd& rate() const { return rate_; }  ///< Δu/h of the last step; empty: none
  double overlap() const { return overlap_; }            ///< overlap at the end of that step [m]
  bool projected() const { return projected_; }          ///< joints are projected
  void resume(ConstVec rate, double overlap, bool projected) {
    rate_ = rate, overlap_ = overlap, projected_ = projected;
  }

  /// State at fraction theta of the last step, which went from a to b. Velocities of a system are
  /// linear between its ends: with the scheme's own interpolation, u^A up to the middle and u^E
  /// after it, the energy of long steps in free flight would rise and fall from one output row to
  /// the next. Half way between the velocities before and after an impact there is less energy than
  /// before and after: systems that were hit have u^A up to the instant at which its positions at
  /// both ends meet best, and u^E after it.
  void between(const MechanicalSystem& s, const State& a, const State& b, double theta,
               State& out) const;
  /// The same with all velocities linear.
  static void linear(const MechanicalSystem& s, const State& a, const State& b, double theta,
                     State& out);

 private:
  static void move(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   const std::vector<double>& hitAt, State& out);
  void findHits(const MechanicalSystem& s, const State& a, const State& b, double h);
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, Effort effort, const State& from,
                  State& x, double h);
  bool bursts(MechanicalSystem& s, const State& a, const State& b) const;
  double error(MechanicalSystem& s, const ErrorNorm& norm, const Islands& islands,
               const std::vector<char>& stepped, const State& a, const State& b, double h);
  EnergyMomentum midpoint_;
  StaggeredMoreau projecting_;
  bool projected_ = false;
  Eigen::VectorXd rate_;
  /// Per system: the fraction of the last step at which an impact has changed its velocities; below
  /// 0: none did.
  std::vector<double> hitAt_;
  double overlap_ = 0.0, reached_ = 0.0;  // overlap at the end of the last step, of the trial [m]
};

}  // namespace dynamy
