/// SchemeChoice: the scheme of a model. If no scheme was named, the accuracy decides: a tolerance
/// asks for LocatedDormandPrince, a step for EnergyMomentum.
#pragma once
#include <dynamy/simulation/model/settings.hpp>
#include <dynamy/stages/one_step.hpp>
#include <memory>

namespace dynamy {

class SchemeChoice {
 public:
  /// Takes this scheme, whatever the accuracy is.
  void name(std::unique_ptr<OneStep> scheme);
  /// When the model is built: without a named scheme, chooses one.
  void begin(const SimulationSettings& s);
  /// Model::askStep, askTolerance and readyScheme; `length` of the scene [m]. ready() throws
  /// ModelError if steps are so short that t does not change.
  void askStep(double dt, SimulationSettings& s);
  void askTolerance(double tolerance, SimulationSettings& s);
  void ready(double length, SimulationSettings& s);
  /// There is one as soon as one was named or begin() was called.
  OneStep& scheme() const { return *scheme_; }
  /// True: the scheme works to a tolerance, or will if none is named.
  bool runsToTolerance(const SimulationSettings& s) const;
  /// True: no scheme was named.
  bool isDefault() const { return isDefault_ || !scheme_; }

 private:
  void choose(const SimulationSettings& s);
  std::unique_ptr<OneStep> scheme_;
  bool isDefault_ = false;  // the program chose scheme_
};

}  // namespace dynamy
