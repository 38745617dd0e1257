/// BeltFriction: a rope or belt on a drum, after Euler and Eytelwein.                (theory 42.5)
///
///   e^{−μα} S₂ ≤ S₁ ≤ e^{μα} S₂,   S₁, S₂ ≥ 0
///
/// With the mean force S = (S₁ + S₂)/2 and the traction T = S₁ − S₂ the wedge is |T| ≤ 2 tanh(μα/2)
/// S. Its law is planar Coulomb friction with the coefficient 2 tanh(μα/2). Row 0 is the slack (Λ_N
/// = S Δt, γ_N its rate), row 1 the slip (Λ_T = T Δt, γ_T half the sum of both strands' slips).
/// Rejected: the normal cone of the wedge in (S₁, S₂), which makes a slipping rope longer.
#pragma once
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {

class BeltFriction final : public UnilateralCoulomb {
 public:
  explicit BeltFriction(const Parameters& x);
  static void declare(Attributes& a);
  bool isMirrored(const MirrorPlane&) const override { return false; }
  /// 2 tanh(μα/2): traction over mean force at which the belt slips  [–].
  static double coefficient(double mu, double wrap);
};

}  // namespace dynamy
