/// OneStep: one step of one scheme.
#pragma once
#include <dynamy/integrator/mechanical_system.hpp>

namespace dynamy {

struct StepReport {
  double dt = 0.0;  ///< [s]
  SolveReport solved;
  int contacts = 0;  ///< in the inclusion problem
  /// Why the scheme cannot take this step, whatever Δt is (it knows no impact, …); empty: it can.
  std::string_view refused{};
};

class OneStep : public Element {
 public:
  static constexpr Kind kKind = Kind::scheme;
  using Element::Element;
  virtual int order() const = 0;
  /// Slots of evaluated data the scheme needs at once.
  virtual int evaluations() const { return 1; }
  /// Advances x by dt. Neither prints nor throws.
  virtual StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) = 0;
  /// n sub-steps of a macro step of length H.
  virtual StepReport advance(MechanicalSystem& s, InclusionSolver& solver, State& x, double H,
                             int n);
  /// Positions and velocities at fraction θ ∈ [0,1] of the step from `a` to `b`; default: linear in
  /// q, u of the end.
  virtual void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                           State& out) const;
};

}  // namespace dynamy
