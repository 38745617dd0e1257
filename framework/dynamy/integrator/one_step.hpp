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

/// What a model may ask of a scheme that not every scheme is defined for.
enum class Asked : std::uint8_t {
  contact,           ///< a unilateral contact closes
  rebound,           ///< an impact with ε_N > 0
  frictionAtImpact,  ///< an impact with friction
  impactLaw,         ///< a law of several inclusions: Poisson's, the energetic, the sequential one
  stiffForces        ///< stiff elements whose period or decay Δt does not resolve
};

class OneStep : public Element {
 public:
  static constexpr Kind kKind = Kind::scheme;
  using Element::Element;
  virtual int order() const = 0;
  /// Slots of evaluated data the scheme needs at once.
  virtual int evaluations() const { return 1; }
  /// Why the definition of the scheme leaves this out; empty: it does not. A step that is asked for
  /// it is refused with these words.
  virtual std::string_view lacks(Asked /*what*/) const { return {}; }
  /// Advances x by dt. Neither prints nor throws.
  virtual StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) = 0;
  /// n sub-steps of a macro step of length H.
  virtual StepReport advance(MechanicalSystem& s, InclusionSolver& solver, State& x, double H,
                             int n);
  /// Positions and velocities at fraction θ ∈ [0,1] of the step from `a` to `b`; default: linear in
  /// q, u of the end.
  virtual void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                           State& out) const;

 protected:
  /// For schemes with laws of their own: what an impact in the problem just solved asks of them and
  /// they lack; empty: nothing. `last`: impulses of the step before.
  std::string_view lackingAtImpact(const MechanicalSystem& s, const RememberedImpulses& last) const;
};

}  // namespace dynamy
