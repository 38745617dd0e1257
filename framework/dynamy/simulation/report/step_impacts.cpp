#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/step_impacts.hpp>
#include <dynamy/stages/impact_detection.hpp>
#include <dynamy/stages/islands.hpp>

namespace dynamy {

bool isReported(const StepView& view, int contact) {
  if (view.report.ownStatuses) return true;
  if (view.report.apart.empty()) return false;
  const ContactSet& c = view.system.slot(0).contacts;
  const Topology& topology = *view.system.parts().topology;
  const auto at = static_cast<std::size_t>(contact);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const int system =
        Islands::systemOfVelocity(topology, c.segment[static_cast<std::size_t>(k)].u0);
    if (view.report.apart[static_cast<std::size_t>(system)] != 0) return true;
  }
  return false;
}

bool StepImpacts::operator()(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  if (isReported(view, contact))
    return std::any_of(view.report.impacts.begin(), view.report.impacts.end(),
                       [&](const LocatedImpact& i) { return i.key == c.key[at]; });
  if (c.law[at]->rowKind(0) != RowKind::normal) return false;
  const auto row = static_cast<std::size_t>(c.row0[at]);
  const InclusionProblem& p = view.system.problem();
  if (p.gammaA.size() <= row || view.Lambda.size() != c.rows()) return false;
  const double smooth = std::abs(p.gammaFree[row] - p.gammaA[row]);
  const double floor = 1e-9 * view.model.length();
  if (!(-p.gammaA[row] > std::max(smooth, floor) && view.Lambda[c.row0[at]] > 0.0)) return false;
  // A contact that carried a force before and moves over a curved surface closes because its normal
  // turns.
  const RememberedImpulses& old = view.before.impulses;
  if (change_ < 0.0) before_.build(old.key), change_ = largestChange(view.system, view.report.dt);
  const int found = before_.find(c.key[at]);
  if (found < 0) return true;
  const int first = old.first[static_cast<std::size_t>(found)];
  if (old.first[static_cast<std::size_t>(found) + 1] == first) return true;
  return !(old.Lambda[static_cast<std::size_t>(first)] > 0.0) ||
         -p.gammaA[row] > kImpactSteps * change_;
}

}  // namespace dynamy
