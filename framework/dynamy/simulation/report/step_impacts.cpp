#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/step_impacts.hpp>
#include <dynamy/stages/impact_detection.hpp>

namespace dynamy {
namespace {}  // namespace

bool StepImpacts::operator()(const StepView& view, int contact) {
  const ContactSet& c = view.system.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  if (view.report.ownStatuses)
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
