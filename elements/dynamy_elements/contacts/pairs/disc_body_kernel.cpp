#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>

namespace dynamy {
namespace {

/// Sine of the tilt below which a rim has no lowest point: its
/// direction is known to 1e-16/1e-12 rad.
constexpr double kLevel = 1e-12;

}  // namespace

DiscBody discBody(const Frame& frame, const TouchingShape& shape) {
  using Touch = TouchingShape::Kind;
  DiscBody out;
  const Mat3 R = frame.A_IK * shape.A_KB;
  out.frame = &frame, out.c = frame.r_OS_I + frame.A_IK * shape.p_K;
  out.a = R.col(2), out.x = R.col(0);
  const SupportFeature& first = shape.features[0];
  const bool round = first.kind == SupportFeature::Kind::rim;
  out.rho = round ? first.rho : 0.0, out.r = first.radius;
  const bool one = shape.kind == Touch::torus || shape.kind == Touch::ball;
  out.half = one ? 0.0 : shape.half.z();
  // The origin of a cone is the middle of its base.
  if (shape.kind == Touch::cone) out.tip = true, out.c += out.half * out.a;
  return out;
}

Vec3 DiscBody::nearest(const Vec3& p) const {
  const Vec3 way = p - c;
  const double z = way.dot(a);
  const Vec3 beside = way - z * a;
  const double out = beside.norm();
  if (tip && z > -half && out > 0.0 && out > radiusAt(z)) {
    // Position on a line of the side, from the rim.
    const double s = (z + half) * cosine() - (out - rho) * sine();
    const double on = std::clamp(s, 0.0, slant());
    return middle(0) + on * cosine() * a + (rho - on * sine()) / out * beside;
  }
  const double up = std::clamp(z, -half, half), most = radiusAt(up);
  return c + up * a + (out > most ? most / out : 1.0) * beside;
}

double DiscBody::support(const Vec3& d) const {
  if (tip) {
    const int rim = rimAlong(d);
    return d.dot(middle(rim)) + radius(rim) * acrossAxis(d).norm() + r;
  }
  return d.dot(c) + half * std::abs(d.dot(a)) + rho * acrossAxis(d).norm() + r;
}

Vec3 DiscBody::furthest(const Vec3& d) const {
  const int rim = rimAlong(d);
  const Vec3 beside = acrossAxis(d);
  const double s = beside.norm(), length = d.norm();
  Vec3 out = middle(rim);
  if (s > 0.0) out += radius(rim) / s * beside;
  if (length > 0.0) out += r / length * d;
  return out;
}

DiscBody::Part DiscBody::part(const Vec3& d) const {
  const bool cap = rho > 0.0 && !(tip && d.dot(a) > 0.0);
  if (cap && acrossAxis(d).squaredNorm() < kFlat * kFlat) return Part::cap;
  return half > 0.0 && std::abs(fromSide(d)) < kFlat ? Part::side : Part::rim;
}

bool DiscBody::touches(const Vec3& d, int rim) const {
  return radius(rim) == 0.0 || acrossAxis(d).squaredNorm() > kLevel * kLevel;
}

int DiscBody::crossings(int which, const Vec3& o, const Vec3& e, const Vec3& n,
                        BodyCurve* out) const {
  // The line projected along n into the plane of the rim: |o + s e|² = ρ² from the rim's middle.
  const double along = n.dot(a);
  if (std::abs(along) < kLikeFace) return 0;
  const auto seen = [&](const Vec3& v) { return Vec3(v - a.dot(v) / along * n); };
  const Vec3 p = seen(o - middle(which)), u = seen(e);
  const double uu = u.squaredNorm(), up = u.dot(p);
  const double R2 = radius(which) * radius(which);
  const double root = up * up - uu * (p.squaredNorm() - R2);
  // A line tangent to the circle has no common normal with it.
  if (!(root > kCross * kCross * uu * R2)) return 0;
  for (const int k : {0, 1}) {
    const double s = (-up + (k == 0 ? -1.0 : 1.0) * std::sqrt(root)) / uu;
    out[k] = rim(which, p + s * u);
  }
  return 2;
}

Vec3 DiscBody::point(int rim, int k) const {
  const Vec3 d = k % 2 == 0 ? x : Vec3(a.cross(x));
  return middle(rim) + (k < 2 ? radius(rim) : -radius(rim)) * d;
}

void wander(const DiscBody& B, int rim, ContactPoint& at) {
  const Vec3 &n = at.d[0], turn = B.frame->Omega_I.cross(n) - at.ddot[0];
  at.P = B.middle(rim) - B.r * n, at.Pdot = B.r * turn;
  if (const double rho = B.radius(rim); rho > 0.0) {
    // H ḋ with H = ρ t tᵀ/s + r (I − n nᵀ), d = −n.
    const Vec3 v = B.acrossAxis(-n);
    const double s = v.norm();
    const Vec3 e = unitAcross(v, B.a), t = B.a.cross(e);
    at.P += rho * e, at.Pdot += rho / s * t.dot(turn) * t;
  }
  at.Pdot += B.frame->velocity(at.P - B.frame->r_OS_I);
}

}  // namespace dynamy
