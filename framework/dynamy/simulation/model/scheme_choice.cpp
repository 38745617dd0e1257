#include <fmt/format.h>

#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/schemes/energy_momentum.hpp>
#include <dynamy/simulation/model/scheme_choice.hpp>
#include <utility>

namespace dynamy {
namespace {

/// Makes a T with its declared defaults, and with a type name that reports can show.
template <class T>
std::unique_ptr<T> defaultScheme(const char* type) {
  return std::make_unique<T>(Parameters::of<T>(type, "", {}));
}

/// True if the scheme works to a tolerance. AugmentedMoreau does not: it locates switches within
/// steps of given length.
bool takesTolerance(const OneStep& scheme) { return scheme.choosesSteps() && !scheme.needsStep(); }

/// Throws ModelError if steps are so short that t + Δt rounds to t: such a run never ends. A step
/// that is halved six times, because it is not solved, must still change t.
void refuseStepsWithoutWay(const SimulationSettings& s) {
  const double least = 64.0 * kEpsilon * s.until;
  if (!(s.step > 0.0) || s.step >= least) return;
  throw ModelError(Diagnostic{
      .place = s.place,
      .element = std::string(s.place.line == 0 ? "" : "simulation"),
      .text = fmt::format("a step of {} s does not move t near {} s, where the run ends", s.step,
                          s.until),
      .hint = fmt::format(
          "take a step of {:.1g} s or more; with a tolerance the program chooses the steps",
          2.0 * least)});
}

/// Throws ModelError for a tolerance below the rounding of numbers, or as large as the scene.
void refuseSenselessTolerance(const SimulationSettings& s) {
  if (!(s.tolerance > 0.0) || (s.tolerance >= kEpsilon && s.tolerance < 1.0)) return;
  const bool small = s.tolerance < 1.0;
  throw ModelError(
      Diagnostic{.place = s.place,
                 .element = std::string(s.place.line == 0 ? "" : "simulation"),
                 .text = fmt::format("a tolerance of {:g} is {}", s.tolerance,
                                     small ? "below the rounding of numbers"
                                           : "no accuracy: errors may be as large as the scene"),
                 .hint = small ? "take 1e-12 or more" : "take 1e-3 or less"});
}

}  // namespace

void SchemeChoice::name(std::unique_ptr<OneStep> scheme) {
  scheme_ = std::move(scheme), isDefault_ = false;
}

void SchemeChoice::begin(const SimulationSettings& s) {
  isDefault_ = isDefault_ || !scheme_;
  choose(s);
}

void SchemeChoice::askStep(double dt, SimulationSettings& s) {
  const bool longest = scheme_ && scheme_->choosesSteps() && !isDefault_;
  s.step = dt;
  if (!longest) s.tolerance = 0.0;
  choose(s);
}

void SchemeChoice::askTolerance(double tolerance, SimulationSettings& s) {
  s.tolerance = tolerance, s.step = 0.0;
  if (scheme_ && !takesTolerance(*scheme_)) isDefault_ = true;
  choose(s);
}

bool SchemeChoice::runsToTolerance(const SimulationSettings& s) const {
  return scheme_ && !isDefault_ ? takesTolerance(*scheme_) : s.tolerance > 0.0;
}

void SchemeChoice::ready(double length, SimulationSettings& s) {
  refuseStepsWithoutWay(s), refuseSenselessTolerance(s);
  choose(s);
  if (!takesTolerance(*scheme_)) return;
  if (!(s.tolerance > 0.0)) s.tolerance = Accuracy{}.tolerance;
  scheme_->aim({s.tolerance, length});
}

void SchemeChoice::choose(const SimulationSettings& s) {
  if (!isDefault_) return;
  const bool own = s.tolerance > 0.0;
  if (scheme_ && takesTolerance(*scheme_) == own) return;
  if (own)
    scheme_ = defaultScheme<LocatedDormandPrince>("LocatedDormandPrince");
  else
    scheme_ = defaultScheme<EnergyMomentum>("EnergyMomentum");
}

}  // namespace dynamy
