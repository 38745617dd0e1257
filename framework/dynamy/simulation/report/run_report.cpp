#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

void RunTrust::archive(Archive& a) {
  for (double* x : {&kineticMax, &stepEnergy, &energyError, &energyErrorTime, &energyRise,
                    &energyRiseTime, &energyGain, &energyGainTime, &regain, &gainStep, &omegaDt,
                    &turn, &way, &fall, &leap, &rounding, &slowed.most, &slowed.t, &dampedLoss})
    a(*x);
  a(damped), a(slowed.steps);
}

void CostReport::archive(Archive& a) {
  a(evaluations), a(cpu), a(wall), a(sleep);
  a(effort.smooth), a(effort.rejected), a(effort.switches), a(effort.events), a(effort.stepping);
  a(effort.looks), a(effort.gaps);
}

void RunReport::archive(Archive& a) {
  a.section("report");
  a(t), a(steps), a(rejected);
  a(simpler), a(passing), a(located), a(stepping), a(solver), a(contacts), a(gaps);
  a(trust), a(start), a(cost);
}

}  // namespace dynamy
