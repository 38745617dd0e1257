/// The side of a cone: all lines from its rim to its tip.
///
///   m = cos β e + sin β a,  e ⟂ a:  outward normal of the line at e     tan β = ρ/2ℓ
///   point p over it     g = m·(p − rim)            e along p − axis
///   side A on side B      n·a_A = sin β_A, n·a_B = −sin β_B: two normals, g between the closest
///                         points of two lines; an edge or the side of a cylinder has β = 0
///   circle x over it      m ⟂ t, the tangent of the circle: found by Newton's method
///
/// Which of its lines touches turns with the bodies: ṁ follows from m·a = sin β, |m| = 1 and from
/// how p moves, from the other side, or from m·t = 0.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>

namespace dynamy {

/// Point p of `frame` with a ball of radius R over the side of B; normal from B. `s`: where on the
/// line from the rim to the tip, [0, slant] [m].
ContactPoint pointOnSide(const DiscBody& B, const Frame& frame, const Vec3& p, double R, double& s);

/// The circle over the side of B at its point nearest to where it is; normal from B. `s`: as above.
/// False: there is none.
bool circleOnSide(const DiscBody& B, BodyCurve circle, double& s, ContactPoint& out);

/// Feature of B on the cone A; inside the nearest of side and base counts.
ContactPoint ballOnCone(const DiscBody& A, const Frame& B, const RoundFeature& ball);

/// The sides of A and B with the normal nearest to `towards`, which is from A; false: their lines
/// are parallel. `sA`, `sB`: where on the lines from rim 0 along the axes [m].
bool sideOnSide(const DiscBody& A, const DiscBody& B, const Vec3& towards, double& sA, double& sB,
                ContactPoint& out);

/// The line through o along t, fixed in `frame`, over the side of B, with the normal nearest to
/// `towards`, which is from B; false: it lies along a line of the side. `s`: as above; `sLine`: on
/// the line, from o [m]. The normal of `out` is from the line to B.
bool lineOnSide(const DiscBody& B, const Frame& frame, const Vec3& o, const Vec3& t,
                const Vec3& towards, double& s, double& sLine, ContactPoint& out);

}  // namespace dynamy
