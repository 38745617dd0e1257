#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/impact_detection.hpp>
#include <dynamy/stages/position_aim.hpp>

namespace dynamy {
namespace {

/// How much the smooth forces of this step can change γ_N of contact i, without cancellation [m/s].
double changeByForces(const ContactSet& c, int i, const Eigen::VectorXd& uA,
                      const Eigen::VectorXd& uFree) {
  const auto at = static_cast<std::size_t>(i);
  double sum = 0.0;
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w;
    for (int j = 0; j < s.nu; ++j) sum += std::abs(w[j]) * std::abs(uFree[s.u0 + j] - uA[s.u0 + j]);
  }
  return sum;
}

}  // namespace

void addAim(const AimedStep& step, const Eigen::VectorXd& uA, const Eigen::VectorXd& uFree,
            InclusionProblem& p, std::vector<ContactKey>& arriving) {
  const PositionAim& aim = step.aim;
  const ContactSet& c = *p.contacts;
  const double dt = p.dt;
  arriving.clear();
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto first = static_cast<std::size_t>(c.row0[at]);
    const SetValuedForceLaw& law = *c.law[at];
    if (law.unilateral()) {
      const double g = c.position[first];
      const bool rough = std::isinf(aim.dead);  // overlaps are corrected, impacts do not wait
      if (!rough && g <= aim.dead) continue;
      // A rebound, and any impact, waits until the contact is closed. In two parts, each with its
      // own slip, an impact with friction would depend on its place in the step.
      double epsilon[kMostRows] = {};
      law.epsilon(c.dim(i), epsilon);
      const bool fast = -p.gammaA[first] > kImpactSteps * changeByForces(c, i, uA, uFree);
      if (rough && (epsilon[0] == 0.0 || (g <= step.gTol && !fast))) {
        // An overlap that bodies did not make in a step takes several to be pushed out.
        const double most = std::max(aim.cap, -p.gammaA[first]);
        p.gammaFree[first] += g < 0.0 ? std::max(g / std::max(dt, step.pushOut), -most) : g / dt;
        continue;
      }
      if (rough && g <= step.gTol) continue;  // its rebound removes the overlap
      const bool impact = (epsilon[0] > 0.0 && p.gammaA[first] < 0.0) || fast;
      const bool arrived =
          g <= step.gTol || std::binary_search(aim.arrived.begin(), aim.arrived.end(), c.key[at]);
      if (impact && arrived) continue;
      if (impact && aim.divide && epsilon[0] == 0.0) {
        p.gammaFree[first] += g / dt;
        continue;
      }
      if (impact && epsilon[0] == 0.0 && g + dt * p.gammaFree[first] < 0.0)
        arriving.push_back(c.key[at]);
      const double away = std::abs(p.gammaFree[first]) + std::abs(p.gammaA[first]);
      p.gammaFree[first] += impact ? g / dt + 4.0 * away : g / dt;
      continue;
    }
    for (int r = 0; r < c.dim(i); ++r) {
      if (!holds(law.rowKind(r))) continue;
      const auto row = first + static_cast<std::size_t>(r);
      const double back = std::clamp(aim.kappa * c.position[row] / dt, -aim.cap, aim.cap);
      p.gammaFree[row] += aim.meanJoints ? p.gammaA[row] : back;
    }
  }
  std::sort(arriving.begin(), arriving.end());
}

}  // namespace dynamy
