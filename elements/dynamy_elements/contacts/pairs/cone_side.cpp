#include <cmath>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>

namespace dynamy {
namespace {

/// Part of the radius; a point nearer to the rim than this touches the base instead.
constexpr double kOnConeEdge = 1e-9;
/// Most steps of Newton's method on a circle; from a good start about five are enough.
constexpr int kConeSteps = 50;
/// Step, as a part of the radius, below which the point is found.
constexpr double kConeFound = 1e-15;

}  // namespace

ContactPoint pointOnSide(const DiscBody& B, const Frame& frame, const Vec3& p, double R,
                         double& s) {
  const Vec3 way = p - B.middle(0), beside = B.acrossAxis(way);
  const double out = beside.norm(), z = way.dot(B.a), sine = B.sine(), cosine = B.cosine();
  const Vec3 e = out > 0.0 ? Vec3(beside / out) : B.x;
  const Vec3 v = frame.velocity(p - frame.r_OS_I), w = v - B.frame->velocity(p - B.frame->r_OS_I);
  Vec3 edot = B.frame->Omega_I.cross(e);
  if (out > 0.0) edot += (B.acrossAxis(w) - w.dot(e) * e) / out;
  const Vec3 m = cosine * e + sine * B.a;
  const Vec3 mdot = cosine * edot + sine * B.frame->Omega_I.cross(B.a);
  s = z * cosine - (out - B.rho) * sine;
  ContactPoint at;
  at.g = (out - B.rho) * cosine + z * sine - B.r - R;
  setDirections(at, m, mdot, Vec3::Zero());
  at.P = p - R * m, at.Pdot = v - R * mdot;
  return at;
}

ContactPoint ballOnCone(const DiscBody& A, const Frame& B, const RoundFeature& ball) {
  const Vec3 c = B.r_OS_I + B.A_IK * ball.c_K, way = c - A.middle(0);
  const double z = way.dot(A.a), out = A.acrossAxis(way).norm();
  double s = 0.0;
  ContactPoint beside = pointOnSide(A, B, c, ball.radius, s);
  // The ball is over the base, or inside and nearest to the base.
  const bool outside = out > A.rho, below = z <= 0.0;
  if (below ? !outside || out - A.rho < kOnConeEdge * A.rho : -z > beside.g + ball.radius) {
    const PlacedFace base(*A.frame, -A.a, A.middle(0), 0.0, A.x, 1.0, true);
    ContactPoint at;
    base.contact(B, c, at);
    const Vec3 n = at.d[0], ndot = at.ddot[0];
    at.g -= ball.radius, at.P -= ball.radius * n, at.Pdot -= ball.radius * ndot;
    return at;
  }
  if (s <= 0.0) return pointOnCurve(A.rim(0, way), B, c, ball.radius, way);
  if (s < A.slant()) return beside;
  const Vec3 tip = A.middle(1), v = A.frame->velocity(tip - A.frame->r_OS_I);
  return fromWay(c - tip, B.velocity(c - B.r_OS_I) - v, 0.0, ball.radius, tip, v, A.a,
                 Vec3::Zero());
}

bool circleOnSide(const DiscBody& B, BodyCurve circle, double& s, ContactPoint& out) {
  const double sine = B.sine(), cosine = B.cosine();
  const Vec3 middle = B.middle(0);
  Vec3 e, across;
  double reach = 0.0, K = 0.0;
  // Slope m·t along the circle of its height over the side, and K, the derivative of the slope.
  const auto slope = [&] {
    const Vec3 beside = B.acrossAxis(circle.x - middle);
    reach = beside.norm();
    if (!(reach > 0.0)) return 0.0;
    e = beside / reach, across = B.acrossAxis(circle.t);
    const Vec3 m = cosine * e + sine * B.a, turned = (across - across.dot(e) * e) / reach;
    K = cosine * turned.dot(circle.t) + m.dot(circle.curvature());
    return m.dot(circle.t);
  };
  bool found = false;
  for (int i = 0; i < kConeSteps && !found; ++i) {
    const double f = slope();
    if (!(reach > 0.0)) return false;
    // Where the height has no minimum nearby, the step goes downwards, by at most half a radius.
    const double most = 0.5 * circle.rho, way = K > 0.0 ? -f / K : std::copysign(most, -f);
    circle.go(std::clamp(way, -most, most));
    found = std::abs(way) <= kConeFound * circle.rho;
  }
  if (const double f = slope(); !(K * circle.rho > kCross * kCross) || std::abs(f) > 1e-12)
    return false;
  return placeOnSide(B, circle, 1.0, s, out);
}

bool placeOnSide(const DiscBody& B, const BodyCurve& circle, double nappe, double& s,
                 ContactPoint& out) {
  const double sine = B.sine(), cosine = B.cosine(), z = B.a.dot(circle.x - B.middle(0));
  const Vec3 beside = B.acrossAxis(circle.x - B.middle(0)), across = B.acrossAxis(circle.t);
  // Along the line of the side, which passes to the other side of the axis at the tip.
  const double reach = nappe * beside.norm();
  if (reach == 0.0) return false;
  const Vec3 e = beside / reach, turned = (across - across.dot(e) * e) / reach,
             m = cosine * e + sine * B.a;
  const double K = cosine * turned.dot(circle.t) + m.dot(circle.curvature());
  if (K == 0.0) return false;
  // ṡ follows from ẋ = v + ṡ t, and from m·t = 0 for all times.
  const Vec3 &Omega = B.frame->Omega_I, adot = Omega.cross(B.a), v = circle.velocity();
  const Vec3 w = v - B.frame->velocity(circle.x - B.frame->r_OS_I), aside = B.acrossAxis(w);
  const Vec3 resting = cosine * (Omega.cross(e) + (aside - aside.dot(e) * e) / reach) + sine * adot;
  const double sdot = -(resting.dot(circle.t) + m.dot(circle.frame->Omega_I.cross(circle.t))) / K;
  const Vec3 mdot = resting + sdot * cosine * turned;
  s = z * cosine - (reach - B.rho) * sine;
  out.g = (reach - B.rho) * cosine + z * sine - B.r - circle.r;
  setDirections(out, m, mdot, Vec3::Zero());
  out.P = circle.x - circle.r * m, out.Pdot = v + sdot * circle.t - circle.r * mdot;
  return true;
}

namespace {

/// The line of a side with the normal m, and its rate.
struct SideLine {
  Vec3 p, g, pdot, gdot;  ///< on the rim [m], along the line
  SideLine(const DiscBody& D, const Vec3& m, const Vec3& mdot) {
    const double sine = D.sine(), cosine = D.cosine();
    const Vec3 adot = D.frame->Omega_I.cross(D.a), middle = D.middle(0);
    const Vec3 e = (m - sine * D.a) / cosine, edot = (mdot - sine * adot) / cosine;
    p = middle + D.rho * e, g = cosine * D.a - sine * e;
    pdot = D.frame->velocity(middle - D.frame->r_OS_I) + D.rho * edot;
    gdot = cosine * adot - sine * edot;
  }
};

}  // namespace

bool sideOnSide(const DiscBody& A, const DiscBody& B, const Vec3& towards, double& sA, double& sB,
                ContactPoint& out, double parallel) {
  // n = x a_A + y b + z b × a_A, b = −a_B; z follows from |n| = 1.
  const Vec3 b = -B.a, third = b.cross(A.a);
  const double sineA = A.sine(), sineB = B.sine(), along = A.a.dot(b);
  const double square = third.squaredNorm();
  if (!(square > 0.0)) return false;
  const double x = (sineA - along * sineB) / square, y = (sineB - along * sineA) / square;
  const double left = 1.0 - x * sineA - y * sineB;
  if (!(left > kCross * kCross)) return false;
  const double z = std::copysign(std::sqrt(left / square), towards.dot(third));
  const Vec3 n = x * A.a + y * b + z * third;

  // Rate of the normal, and with it the rates of the lines of the sides.
  Mat3 K;
  K << A.a.transpose(), b.transpose(), n.transpose();
  const Vec3 ndot = K.inverse() * Vec3(-n.dot(A.frame->Omega_I.cross(A.a)),
                                       -n.dot(B.frame->Omega_I.cross(b)), 0.0);
  const SideLine a(A, n, ndot), of(B, -n, -ndot);
  const double c = a.g.dot(of.g), det = 1.0 - c * c;
  if (!(det > parallel)) return false;

  // d ⟂ both lines: closest points.
  const Vec3 way = of.p - a.p;
  const double wayA = way.dot(a.g), wayB = way.dot(of.g);
  sA = (wayA - c * wayB) / det, sB = (c * wayA - wayB) / det;
  const Vec3 xA = a.p + sA * a.g, xB = of.p + sB * of.g, d = xB - xA;
  // For all times ḋ·g + d·ġ = 0 with ḋ = w + ṡ_B g_B − ṡ_A g_A.
  const Vec3 vB = of.pdot + sB * of.gdot, w = vB - a.pdot - sA * a.gdot;
  const double ra = w.dot(a.g) + d.dot(a.gdot), rb = w.dot(of.g) + d.dot(of.gdot);
  out.g = n.dot(d) - A.r - B.r;
  setDirections(out, n, ndot, Vec3::Zero());
  out.P = xB - B.r * n, out.Pdot = vB + (c * ra - rb) / det * of.g - B.r * ndot;
  return true;
}

bool lineOnSide(const DiscBody& B, const Frame& frame, const Vec3& o, const Vec3& t,
                const Vec3& towards, double& s, double& sLine, ContactPoint& out, double parallel) {
  DiscBody line;
  line.frame = &frame, line.c = o, line.a = t;
  return sideOnSide(line, B, -towards, sLine, s, out, parallel);
}

}  // namespace dynamy
