// LocatedDormandPrince: contacts that come and go with the features of bodies (theory 50.9).
#include <dynamy/integrator/located_dormand_prince.hpp>

namespace dynamy {
namespace {

constexpr double kOverlap = 1e-3;  ///< of tol L: overlaps that are left as they are
constexpr double kShorter = 0.5;   ///< steps in which bodies sink into one another

}  // namespace

double LocatedDormandPrince::leftOverlap() const {
  return kOverlap * norm_.tolerance() * norm_.length();
}

bool LocatedDormandPrince::widen() {
  if (!probe_.comesAndGoes()) return true;
  trial_.x.memory = from_.x.memory;
  // Each place looks half of the way to the next ones.
  const double ahead = 0.5 * path_.length() / SwitchSearch::kSamples;
  for (int j = 0; j <= SwitchSearch::kSamples; ++j) {
    path_.at(static_cast<double>(j) / SwitchSearch::kSamples, trial_.x);
    probe_.widen(trial_.x, ahead);
  }
  return probe_.settle(from_.x) && search_.watch(probe_, phase_, from_.x);
}

bool LocatedDormandPrince::sinks(const State& x) {
  if (!probe_.comesAndGoes()) return false;
  probe_.widen(x, 0.0);
  const double most = startOverlap_ + leftOverlap();
  return probe_.overlap() > most;
}

bool LocatedDormandPrince::takeShorter(const MechanicalSystem& s, double h,
                                       const std::array<double, 5>& works, StepReport& report) {
  ++report.counts.rejected;
  works_ = works, phase_.held = startHeld_, H_ = kShorter * h;
  book(s, &StepEffort::rejected, report);
  return true;
}

}  // namespace dynamy
