// LocatedDormandPrince: elements that leave out the bias γ̇ − Wᵀu̇ of their rows (theory 52.4).
#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

/// Columns of the half-explicit rule at loose and at tight tolerances, which begin below kTight.
constexpr int kLooseColumns = 3, kTightColumns = 4;
constexpr double kTight = 1e-6;
constexpr double kNoRate = 1e-9;   ///< of L/T² and 1/T²: differences that count as zero
constexpr double kOneSided = 3.0;  ///< offset of a one-sided difference, in its own lengths

/// True: contact i leaves the bias of all its rows zero.
bool isSilent(const ContactSet& c, int i) {
  const auto first = c.bias.begin() + c.row0[static_cast<std::size_t>(i)];
  return std::all_of(first, first + c.dim(i), [](double w) { return w == 0.0; });
}

}  // namespace

void LocatedDormandPrince::useDifferences(MechanicalSystem& s) {
  s.differences(untold_, norm_.velocityScales(), norm_.time());
}

bool LocatedDormandPrince::untold(int element) const {
  return std::binary_search(untold_.begin(), untold_.end(), element);
}

bool LocatedDormandPrince::findUntold(MechanicalSystem& s, const State& x, bool held) {
  // Checks contacts that report a zero bias: those that have just closed, and held contacts where a
  // projection had to make a large correction.
  const ContactSet& c = s.slot(0).contacts;
  const auto asks = [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    return isSilent(c, i) && !untold(c.element[at]) &&
           (held || !std::binary_search(phaseKeys_.begin(), phaseKeys_.end(), c.key[at]));
  };
  bool any = false;
  for (int i = 0; i < c.size() && !any; ++i) any = asks(i);
  if (!any) return false;
  asked_.assign(c.key.begin(), c.key.end());
  std::sort(asked_.begin(), asked_.end());
  s.hold(asked_);
  if (!s.differenceBias(x, rates_) || rates_.size() != c.rows()) return false;
  const double T = norm_.time(), least = kNoRate * std::max(1.0, norm_.length()) / (T * T);
  std::vector<int> found;
  const auto note = [&](auto&& counts) {
    found.clear();
    for (int i = 0; i < c.size(); ++i) {
      const int first = c.row0[static_cast<std::size_t>(i)];
      for (int r = first; asks(i) && r < first + c.dim(i); ++r)
        if (counts(r)) found.push_back(c.element[static_cast<std::size_t>(i)]);
    }
    return !found.empty();
  };
  if (!note([&](int r) { return std::abs(rates_[r]) > least; })) return false;
  // A rate that appears only with a kink within the difference (an edge that a ball rolls over) is
  // no missing bias.
  Eigen::VectorXd before, after;
  if (!s.differenceBias(x, before, -kOneSided) || !s.differenceBias(x, after, kOneSided))
    return false;
  if (!note([&](int r) {
        return std::abs(rates_[r]) > least && std::abs(before[r]) > least &&
               std::abs(after[r]) > least;
      }))
    return false;
  untold_.insert(untold_.end(), found.begin(), found.end());
  std::sort(untold_.begin(), untold_.end());
  untold_.erase(std::unique(untold_.begin(), untold_.end()), untold_.end());
  useDifferences(s);
  return true;
}

bool LocatedDormandPrince::decideUntold(MechanicalSystem& s, InclusionSolver& solver,
                                        StepReport& report) {
  foundUntold_ = false;
  phase_.held = startHeld_;
  stepKeys_.clear(), impulse_.resize(0);
  release({});
  const bool good = event(s, solver, from_, report, {});
  book(s, &StepEffort::events, report);
  return good;
}

void LocatedDormandPrince::chooseMethod() {
  int columns = columns_;
  for (std::size_t i = 0; columns == 0 && i < phase_.held.size(); ++i)
    if (untold(static_cast<int>(phase_.held[i].key.value >> 40)))
      columns = norm_.tolerance() < kTight ? kTightColumns : kLooseColumns;
  smooth_.halfExplicit(columns), smoothOwn_.halfExplicit(columns);
}

}  // namespace dynamy
