#include <dynamy/integrator/one_step.hpp>

namespace dynamy {

StepReport OneStep::advance(MechanicalSystem& s, InclusionSolver& solver, State& x, double H,
                            int n) {
  StepReport total;
  for (int k = 0; k < n; ++k) {
    const StepReport report = step(s, solver, x, H / n);
    total.contacts = report.contacts;
    if (total.refused.empty()) total.refused = report.refused;
    if (!report.solved.ok()) total.solved.status = report.solved.status;
    total.solved.iterations += report.solved.iterations;
    if (report.solved.residuals.largest() > total.solved.residuals.largest())
      total.solved.residuals = report.solved.residuals;
  }
  total.dt = H;
  return total;
}

void OneStep::interpolate(const MechanicalSystem&, const State& a, const State& b, double theta,
                          State& out) const {
  out.t = a.t + theta * (b.t - a.t);
  out.q = a.q + theta * (b.q - a.q);
  out.u = b.u;
}

}  // namespace dynamy
