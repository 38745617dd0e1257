/// PhaseProjection: removes what held contacts have drifted by within a step:
///
///   δq = M⁻¹W Λ,  g + Wᵀδq = 0,      δu = M⁻¹W Λ,  γ + Wᵀδu = 0
///
/// again at the corrected positions, until both are far below the tolerance. A large drift is a sign
/// of a missing or wrong bias, which is then checked.
#pragma once
#include <dynamy/located/phase/held_projection.hpp>
#include <dynamy/located/step/located_parts.hpp>

namespace dynamy {

class PhaseProjection {
 public:
  explicit PhaseProjection(LocatedParts& parts) : parts_(parts) {}
  /// Projects p, evaluated in slot 0. `missing`: nothing was changed, since an element that is held
  /// reports no bias.
  Refusal take(LocatedStep& step, PhasePoint& p, bool& missing);

 private:
  double measure(LocatedStep& step, const PhasePoint& p);
  Refusal checkBias(LocatedStep& step, const PhasePoint& p, bool& missing);
  void correct(LocatedStep& step, PhasePoint& p);
  LocatedParts& parts_;
  HeldProjection projection_;
  Eigen::VectorXd position_, velocity_;
  double moved_ = 0.0;  // size of the correction of positions, in units of the tolerance
  bool turns_ = false;  // velocities are corrected
};

}  // namespace dynamy
