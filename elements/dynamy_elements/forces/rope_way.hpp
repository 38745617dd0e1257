/// RopeWay: the way of a taut rope past circles with one axis: end, sheaves, end.     (theory 43.5)
///
///   e = C₂ − C₁ = d + h a,   d ⊥ a,   ρ = σ₂ r₂ − σ₁ r₁
///   l = √(|d|² − ρ²),   t = (l d − ρ a × d)/|d|²,   n_i = −σ_i a × t,   L = √(l² + h²)
///
/// for the strand from circle 1 to circle 2 with the common tangent t, which touches circle i at
/// C_i + r_i n_i. a: axis, unit; σ = ±1: sense about a in which the rope runs past a circle. A circle
/// of radius 0 is an end that is fixed to its frame. A strand leans where its ends lie beside each
/// other along the axis, by h, and has the length L. If the circles move, it turns about a with α̇:
///
///   α̇ = (a × t)·ė/l,    L̇ = v·ė + (l/L) ρ α̇,   v = (l t + h a)/L
#pragma once
#include <array>
#include <dynamy/core/types.hpp>
#include <span>
#include <vector>

namespace dynamy {

/// A circle about which the rope runs.
struct RopeCircle {
  Vec3 centre_I = Vec3::Zero();  ///< [m]
  double radius = 0.0;           ///< [m]
  double sense = 1.0;            ///< σ
};

/// The free part of a rope between two circles.
struct RopeStrand {
  Vec3 t = Vec3::Zero();          ///< from the first circle to the second, unit, ⊥ a
  Vec3 across = Vec3::Zero();     ///< a × t
  Vec3 v = Vec3::Zero();          ///< along the strand, unit; t if it does not lean
  Vec3 e = Vec3::Zero();          ///< from centre to centre [m]
  double inPlane = 0.0;           ///< l [m]; 0 where the circles overlap too much for a tangent
  double aside = 0.0, rho = 0.0;  ///< h, ρ [m]
  double length = 0.0;            ///< L [m]; 0 where there is no strand
};

class RopeWay {
 public:
  static constexpr std::size_t kMostCircles = 14;
  /// 2 to kMostCircles circles: ends first and last. Does not allocate.
  RopeWay(const Vec3& axis_I, std::span<const RopeCircle> circles);
  int strands() const { return count_ - 1; }
  const RopeStrand& strand(int i) const { return strands_[static_cast<std::size_t>(i)]; }
  const Vec3& axis() const { return axis_I_; }
  /// Direction from the centre of circle i to where strand j touches it.
  Vec3 contact(int i, int j) const;
  /// Angle of wrap of an inner circle in [0, 2π) [rad].
  double wrap(int i) const;

 private:
  Vec3 axis_I_;
  int count_;  // of circles
  std::array<RopeCircle, kMostCircles> circles_;
  std::array<RopeStrand, kMostCircles> strands_;
};

/// Chooses the senses of all circles of a radius above 0, so that the rope passes circle i at the
/// side sides[i], a direction: of an inner circle the middle of the wrap lies there, of an end the
/// point where the rope leaves it.
void chooseSenses(const Vec3& axis_I, std::vector<RopeCircle>& circles,
                  const std::vector<Vec3>& sides);

}  // namespace dynamy
