/// LocatedDormandPrince: integrates to any requested tolerance, also across switches (theory 50).
///
///   smooth phases   Dormand and Prince's order 8(5,3), at tolerances from 1e-3 up 5(4), on
///                   M u̇ = h + Wλ,  Wᵀu̇ + w̄ = 0  with the status of every contact held; Radau IIA
///                   of order 5 while the motion is stiff
///   switches        where a gap, a slip or the reserve of a force reaches zero: found on the path
///                   through the step; the step is repeated up to there, and Newton's method
///                   covers the small distance left to the root
///   at a switch     impact, decision of the new status by an inclusion, projection
///   islands         have clocks of their own (LocatedIslands)
///   no bias         HalfExplicitGragg where an element that is held reports no bias
///   dense switches  steps of EnergyMomentum, as long as the tolerance permits (SwitchGovernor)
///
/// LocatedMotion does the rest. This class chooses between it and steps in time, for each island.
///
/// Gragg's extrapolation in place of Dormand and Prince needs 1.2 to 1.8 times the evaluations at
/// equal error. Taking the state at the switch from the dense output was rejected: errors grow up
/// to tenfold.
#pragma once
#include <dynamy/located/governed/stepped_islands.hpp>
#include <dynamy/located/islands/located_islands.hpp>

namespace dynamy {

class LocatedDormandPrince : public OneStep {
 public:
  LocatedDormandPrince() = default;
  explicit LocatedDormandPrince(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return governed_.motion().settings().table().order; }
  bool choosesSteps() const override { return true; }
  bool findsContacts() const override { return !stepped_; }
  void aim(const Accuracy& accuracy) override { governed_.motion().aim(accuracy); }
  double nextStep(const State& x) const override { return x.scheme.size() > 0 ? x.scheme[0] : 0.0; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;
  bool contactsAt(const MechanicalSystem& s, const State& at, bool after,
                  ContactInstant& out) const override;

  /// As LocatedParts::endedByMotion.
  bool endedByMotion() const {
    return apart_ ? clocks_.endedByMotion() : !stepped_ && governed_.motion().parts().endedByMotion;
  }

  /// The attribute `stiff`, and what it says.
  static void declareStiff(Attributes& a);
  static StiffSteps stiffOf(const Parameters& x);

 protected:
  /// Integrates with these settings, whatever the tolerance.
  LocatedDormandPrince(const Parameters& x, const LocatedSettings& settings);

 private:
  /// A step in time that was taken.
  struct InTime {
    StepReport report;
    double h = 0.0, tE = 0.0;  // its length and end [s]
    double error = 0.0;        // in units of the tolerance
    int rejected = 0, newton = 0;
    long again = 0;  // evaluations that a resumed run makes once more
    std::string refused{};
  };
  WorkAllowance allowance(const MechanicalSystem& s, double t);
  StepReport stepApart(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  InTime tryInTime(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  StepReport stepInTime(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                        long before);
  /// Interpolation evaluates stages of the last step when it is first requested.
  mutable GovernedMotion governed_{LocatedSettings{}};
  SteppedIslands steps_;
  mutable LocatedIslands clocks_;
  Islands islands_;
  State steppedFrom_;
  std::string refusal_;
  MechanicalSystem* system_ = nullptr;  // of the last step
  bool stepped_ = false;                // the last step was one in time
  bool apart_ = false;                  // in the last step islands had clocks, and none was stepped
};

}  // namespace dynamy
