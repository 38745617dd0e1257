#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

std::string_view OneStep::lackingAtImpact(const MechanicalSystem& s) const {
  if (!s.parts().impactLaw->newtons() && !lacks(Asked::impactLaw).empty())
    return lacks(Asked::impactLaw);
  // An impact is a contact that did not press before and closes faster than forces explain.
  const ImpactProblem& p = s.problem();
  for (int i = 0; i < p.size(); ++i) {
    const auto first = static_cast<std::size_t>(p.row0(i));
    if (!p.law(i).unilateral() || p.Lambda(p.row0(i)) <= 0.0) continue;
    const double closing = -p.gammaA[first];
    if (closing <= 2.0 * std::abs(p.gammaFree[first] + closing)) continue;
    if (p.pressedBefore(i)) continue;
    double epsilon[kMostRows] = {};
    p.law(i).epsilon(p.dim(i), epsilon);
    if (epsilon[0] > 0.0 && !lacks(Asked::rebound).empty()) return lacks(Asked::rebound);
    if (p.dim(i) > 1 && !lacks(Asked::frictionAtImpact).empty())
      return lacks(Asked::frictionAtImpact);
  }
  return {};
}

void OneStep::interpolate(const MechanicalSystem&, const State& a, const State& b, double theta,
                          State& out) const {
  out.t = a.t + theta * (b.t - a.t);
  out.q = a.q + theta * (b.q - a.q);
  out.u = b.u;
}

}  // namespace dynamy
