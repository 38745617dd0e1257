/// Round bodies for contact: all points nearer than r to the convex hull of
/// two equal discs with a common axis.
///
///   cylinder: r = 0      torus: one disc, nothing passes through its hole
///   capsule:  ρ = 0      ball:  one disc, ρ = 0
///   cone:     r = 0, the upper disc is a point, its tip
///
///   h(d) = d·c + ℓ |d·a| + ρ s + r,   s = |d − (a·d) a|,   |d| = 1
///   cone: h(d) = d·c + max(ℓ d·a, ρ s − ℓ d·a)
///
/// Features that can touch are a rim (circle of radius ρ, tube r), a cap at the height ℓ + r, and
/// the side. The side is a line between the rims' middles with a tube of radius ρ + r. The side of
/// a cone consists of all lines from its rim to its tip, with the normals cos β e + sin β a, e ⟂ a,
/// tan β = ρ/2ℓ (cone_side.hpp).
#pragma once
#include <dynamy_elements/contacts/pairs/curve_contact.hpp>

namespace dynamy {

/// A round body in the world, with the motion of its frame.
struct DiscBody {
  /// A direction selects all of a cap or side if the sine of its angle to
  /// the normal is smaller: 38.1.
  static constexpr double kFlat = 0.1;
  /// The part of the body that faces a direction.
  enum class Part : std::uint8_t { cap, side, rim };

  const Frame* frame = nullptr;
  Vec3 c = Vec3::Zero(), a = Vec3::UnitZ();  ///< middle [m], axis
  Vec3 x = Vec3::UnitX();                    ///< across the axis, fixed in the body
  double half = 0.0, rho = 0.0, r = 0.0;     ///< ℓ, ρ, r [m]
  bool tip = false;                          ///< rim 1 is a point

  int rims() const { return half > 0.0 ? 2 : 1; }
  double radius(int rim) const { return tip && rim == 1 ? 0.0 : rho; }  ///< [m]
  /// Length of a cone's side from the rim to the tip [m], and its sin β and cos β.
  double slant() const { return std::sqrt(rho * rho + 4.0 * half * half); }
  double sine() const { return tip ? rho / slant() : 0.0; }
  double cosine() const { return tip ? 2.0 * half / slant() : 1.0; }
  /// Sine of the angle from the side to d, positive towards rim 1.
  double fromSide(const Vec3& d) const {
    return tip ? cosine() * d.dot(a) - sine() * acrossAxis(d).norm() : d.dot(a);
  }
  /// Rim on the side of d.
  int rimAlong(const Vec3& d) const { return half > 0.0 && fromSide(d) > 0.0 ? 1 : 0; }
  Vec3 middle(int rim) const { return c + (rim == 1 ? half : -half) * a; }
  Vec3 acrossAxis(const Vec3& d) const { return d - a.dot(d) * a; }
  double thickness() const {
    if (tip) return half * sine();
    return half > 0.0 && rho > 0.0 ? std::min(half, rho) + r : rho + r;
  }

  /// Radius of the hull of the two discs at the height z over the middle [m].
  double radiusAt(double z) const { return tip ? rho * (0.5 - 0.5 * z / half) : rho; }
  /// The point of the hull of the two discs that is nearest to p.
  Vec3 nearest(const Vec3& p) const;
  double support(const Vec3& d) const;
  /// A point of the body with the largest d·x.
  Vec3 furthest(const Vec3& d) const;
  Part part(const Vec3& d) const;
  /// Has the rim a unique outermost point along d? A tip always has.
  bool touches(const Vec3& d, int rim = 0) const;
  BodyCurve axis() const { return BodyCurve::line(*frame, c, a, rho + r); }
  /// The rim, at its outermost point along d.
  BodyCurve rim(int rim, const Vec3& d) const {
    return BodyCurve::circle(*frame, middle(rim), a, radius(rim), r, d);
  }
  /// Finds where the line through o along e crosses the rim, seen along n;
  /// returns the number of crossings.
  int crossings(int rim, const Vec3& o, const Vec3& e, const Vec3& n, BodyCurve* out) const;
  /// Middle of the tube at point k = 0 … 3 of a rim, fixed in the body.
  Vec3 point(int rim, int k) const;
};

DiscBody discBody(const Frame& frame, const TouchingShape& shape);

/// Fills P and Ṗ of `at`, a contact of a rim of B with a plane that moves with A and has the
/// directions of `at`. P is the lowest point of the rim over this plane.
void wander(const DiscBody& B, int rim, ContactPoint& at);

}  // namespace dynamy
