#include <algorithm>
#include <cmath>
#include <dynamy/stages/problem_scales.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

void roundingOfC(const VelocityScales& s, InclusionProblem& p, Eigen::VectorXd& u) {
  // Rounding of γ = Wᵀu + χ: a few ε of the sum of absolute values.
  constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
  const ContactSet& c = *p.contacts;
  u = s.uA.cwiseAbs().cwiseMax(s.uFree.cwiseAbs());
  p.cNoise.resize(static_cast<std::size_t>(c.rows()));
  for (std::size_t row = 0; row < p.cNoise.size(); ++row) p.cNoise[row] = std::abs(c.chi[row]);
  c.addAbsolute(view(std::as_const(u)), p.cNoise.data());
  for (double& noise : p.cNoise) noise *= kRounding;
  if (s.gapNoise == 0.0) return;
  for (int i = 0; i < c.size(); ++i)
    if (const auto at = static_cast<std::size_t>(i); c.law[at]->unilateral())
      p.cNoise[static_cast<std::size_t>(c.row0[at])] += s.gapNoise;
}

double velocityAskedOf(const InclusionProblem& p, int i, double gTol) {
  // Unilateral contacts: the closing speed, and the change of γ by forces. A contact that leaves
  // requires no velocity, and a slip velocity exists without being required.
  const auto first = static_cast<std::size_t>(p.row0(i));
  const bool unilateral = p.law(i).unilateral();
  double asked = 0.0;
  if (unilateral) {
    const double noise = p.cNoise[first];
    const bool open = p.contacts->position[first] > gTol;  // present by its gap term
    const double closing =
        open ? -p.gammaFree[first] : std::max(-p.gammaFree[first], -p.gammaA[first]);
    if (closing <= noise) return 0.0;
    asked = closing;
  }
  for (std::size_t k = first; k < first + static_cast<std::size_t>(p.dim(i)); ++k) {
    const double change = std::abs(p.gammaFree[k] - p.gammaA[k]);
    const double value = unilateral ? change : std::max(change, std::abs(p.gammaFree[k]));
    if (value > p.cNoise[k]) asked = std::max(asked, value);
  }
  return asked;
}

}  // namespace

bool setScales(const VelocityScales& from, InclusionProblem& p, Eigen::VectorXd& work) {
  roundingOfC(from, p, work);
  double uRef = 0.0;
  for (int i = 0; i < p.size(); ++i) uRef = std::max(uRef, velocityAskedOf(p, i, from.gTol));
  const bool nothing = !(uRef > 0.0);
  if (nothing)
    for (const double gamma : p.gammaFree) uRef = std::max(uRef, std::abs(gamma));
  p.uRef = uRef > 0.0 ? uRef : std::numeric_limits<double>::min();
  return nothing;
}

}  // namespace dynamy
