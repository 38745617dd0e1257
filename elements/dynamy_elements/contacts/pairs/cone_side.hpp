/// Contacts on the side of a cone, which consists of all lines from its rim to its tip.
///
///   m = cos β e + sin β a,  e ⟂ a:  outward normal of the line at e     tan β = ρ/2ℓ
///   point p over it     g = m·(p − rim)            e along p − axis
///   side A on side B      n·a_A = sin β_A, n·a_B = −sin β_B: two normals, g between the closest
///                         points of two lines; an edge or the side of a cylinder has β = 0
///   circle x over it      m ⟂ t, the tangent of the circle: found by Newton's method
///
/// The line of the side that touches changes while the bodies move. Its normal turns by ṁ, which
/// follows from m·a = sin β, |m| = 1 and one more condition: from the motion of p, from the other
/// side, or from m·t = 0.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>

namespace dynamy {

/// Contact of a ball of radius R about the point p of `frame` with the side of B; the normal points
/// away from B. `s`: position on the line from the rim to the tip, [0, slant] [m].
ContactPoint pointOnSide(const DiscBody& B, const Frame& frame, const Vec3& p, double R, double& s);

/// Contact of a circle with the side of B; the search begins at the current point of the circle,
/// and the normal points away from B. `s`: as in pointOnSide. False: there is no contact.
bool circleOnSide(const DiscBody& B, BodyCurve circle, double& s, ContactPoint& out);

/// The same at the current point of the circle, which is such a place. `nappe`: −1 beyond the tip of
/// B, where the line of the side goes on with its normal; else 1.
bool placeOnSide(const DiscBody& B, const BodyCurve& circle, double nappe, double& s,
                 ContactPoint& out);

/// Contact of a round feature of B with the cone A; for centres inside, the
/// nearest of side and base counts.
ContactPoint ballOnCone(const DiscBody& A, const Frame& B, const RoundFeature& ball);

/// Contact of the sides of A and B, with the normal nearest to `towards`, which
/// points away from A; false: their lines are parallel, with a sine whose square is not above
/// `parallel`. `sA`, `sB`: positions on the lines, from rim 0 along the axes [m].
bool sideOnSide(const DiscBody& A, const DiscBody& B, const Vec3& towards, double& sA, double& sB,
                ContactPoint& out, double parallel = kCross * kCross);

/// Contact of the line through o along t, fixed in `frame`, with the side of B, with the normal
/// nearest to `towards`, which points away from B. False: the line is parallel to a line of the
/// side. `s`: as in pointOnSide; `sLine`: position on the line, from o [m]. The normal of `out`
/// points from the line to B.
bool lineOnSide(const DiscBody& B, const Frame& frame, const Vec3& o, const Vec3& t,
                const Vec3& towards, double& s, double& sLine, ContactPoint& out,
                double parallel = kCross * kCross);

}  // namespace dynamy
