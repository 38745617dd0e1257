#include <cmath>
#include <dynamy_elements/contacts/pairs/rim_places.hpp>
#include <numbers>

namespace dynamy {
namespace {

constexpr int kPlaces = 16;  ///< of a circle, between which its distance to a curve has one minimum
constexpr double kBesideFoot = 0.01;  ///< [rad], less than between two places that have a normal
constexpr int kMostHalvings = 60;

/// A function of an angle at a place, and its rate.
struct Slope {
  double angle, value, rate;
};

/// Does f(angle) rise through zero between l and r? Two places may come together between them: then
/// f has an extremum there, on the other side of zero. If so, l and r become a bracket.
template <class F>
bool risesThroughZero(const F& f, Slope& l, Slope& r) {
  if (l.value < 0.0 && r.value >= 0.0) return true;
  const bool positive = l.value > 0.0;
  if (!(l.value * r.value > 0.0) || (l.rate < 0.0) != positive || (r.rate > 0.0) != positive)
    return false;
  double from = l.angle, to = r.angle;
  for (int k = 0; k < kMostHalvings && to - from > 1e-12; ++k) {
    const Slope m = f(0.5 * (from + to));
    if (m.value * l.value < 0.0) {
      (positive ? l : r) = m;
      return true;
    }
    ((m.rate < 0.0) == positive ? from : to) = m.angle;
  }
  return false;
}

/// The root of f between l and r, where it is below and above zero.
template <class F>
double rootBetween(const F& f, Slope l, Slope r) {
  for (int k = 0; k < kMostHalvings && r.angle - l.angle > 1e-16; ++k) {
    const double secant = (l.angle * r.value - r.angle * l.value) / (r.value - l.value);
    const double m =
        k % 3 == 2 || !(secant > l.angle && secant < r.angle) ? 0.5 * (l.angle + r.angle) : secant;
    if (!(m > l.angle && m < r.angle)) break;
    const Slope at = f(m);
    if (at.value == 0.0) return m;
    (at.value < 0.0 ? l : r) = at;
  }
  return std::abs(l.value) < std::abs(r.value) ? l.angle : r.angle;
}

/// Places of a rim where `slope(out, t, angle)`, of the direction out of its middle and the tangent,
/// rises through zero. The samples begin beside the direction `foot`.
template <class F>
RimPlaces placesOf(const DiscBody& B, int rim, const Vec3& foot, const F& slope) {
  const Vec3 X = B.x, Y = B.a.cross(B.x);
  const auto along = [&](double c, double s, double angle) {
    return slope(Vec3(c * X + s * Y), Vec3(c * Y - s * X), angle);
  };
  const auto at = [&](double angle) { return along(std::cos(angle), std::sin(angle), angle); };
  RimPlaces out;
  const double width = 2.0 * std::numbers::pi / kPlaces,
               first = std::atan2(foot.dot(Y), foot.dot(X)) + kBesideFoot, stepC = std::cos(width),
               stepS = std::sin(width);
  double c = std::cos(first), s = std::sin(first);
  Slope a = along(c, s, first);
  for (int i = 1; i <= kPlaces && out.count < 2; ++i) {
    const double turned = c * stepC - s * stepS;
    s = s * stepC + c * stepS, c = turned;
    const Slope b = along(c, s, first + i * width);
    if (Slope l = a, r = b; risesThroughZero(at, l, r)) {
      const double root = rootBetween(at, l, r);
      out.at[out.count++] = B.rim(rim, std::cos(root) * X + std::sin(root) * Y);
    }
    a = b;
  }
  return out;
}

}  // namespace

/// The square of the distance has the derivative 2 ρ d·t, with d across the line: a trigonometric
/// polynomial of degree 2.
RimPlaces rimPlaces(const DiscBody& B, int rim, const PlacedEdge& e) {
  const Vec3 middle = B.middle(rim);
  const double rho = B.radius(rim);
  const Vec3 foot = e.o - middle - e.e.dot(e.o - middle) * e.e;
  return placesOf(B, rim, foot, [&](const Vec3& out, const Vec3& t, double angle) {
    const Vec3 way = middle - e.o + rho * out;
    const Vec3 d = way - e.e.dot(way) * e.e;
    const double along = e.e.dot(t);
    return Slope{angle, d.dot(t), rho * (1.0 - along * along) - d.dot(out)};
  });
}

/// The height over the side has the derivative ρ m·t, with m = cos β e ± sin β a, e across the axis;
/// beyond the tip the sign is negative. Each nappe is searched on its own, since the slope jumps
/// from one to the other.
RimPlaces rimPlacesOverCone(const DiscBody& B, int rim, const DiscBody& A) {
  const Vec3 middle = B.middle(rim), tip = A.middle(1), foot = -A.acrossAxis(middle - A.c);
  const double rho = B.radius(rim);
  RimPlaces out;
  for (const double nappe : {1.0, -1.0}) {
    const RimPlaces found =
        placesOf(B, rim, foot, [&](const Vec3& radial, const Vec3& t, double angle) {
          const Vec3 beside = A.acrossAxis(middle + rho * radial - tip), side = A.acrossAxis(t);
          const double R = std::max(beside.norm(), 1e-300);
          const Vec3 e = beside / R, m = A.cosine() * e + nappe * A.sine() * A.a;
          const double across = e.dot(side), turned = (side.squaredNorm() - across * across) / R;
          return Slope{angle, m.dot(t), A.cosine() * rho * turned - m.dot(radial)};
        });
    for (int k = 0; k < found.count && out.count < 2; ++k)
      if (nappeAt(A, B, found.at[k].x - tip) == nappe) out.at[out.count++] = found.at[k];
  }
  return out;
}

/// With p from the middle of the other circle, h along its axis and R across it, the square of the
/// distance is h² + (R − ρ_A)²; its half has the derivative ρ (h h′ + (R − ρ_A) R′).
RimPlaces rimPlaces(const DiscBody& B, int rim, const DiscBody& A, int other) {
  const Vec3 way = B.middle(rim) - A.middle(other);
  const double rho = B.radius(rim), radius = A.radius(other);
  return placesOf(B, rim, -way, [&](const Vec3& out, const Vec3& t, double angle) {
    const Vec3 p = way + rho * out, across = A.acrossAxis(p), side = A.acrossAxis(t);
    const double h = p.dot(A.a), dh = t.dot(A.a), R = std::max(across.norm(), 1e-300),
                 dR = across.dot(side) / R, beyond = R - radius;
    const double ddh = -out.dot(A.a),
                 ddR =
                     (rho * side.squaredNorm() - across.dot(A.acrossAxis(out)) - rho * dR * dR) / R;
    return Slope{angle, h * dh + beyond * dR, rho * (dh * dh + dR * dR) + h * ddh + beyond * ddR};
  });
}

FollowedPair pointOverPlane(const PlacedFace& on, const Vec3& n, const DiscBody& B, int rim, int k,
                            double flat) {
  FollowedPair out;
  on.contact(*B.frame, B.point(rim, k) - B.r * n, out.at);
  // The contact of a tube with the plane stays below the middle of the tube.
  out.at.Pdot += B.r * (B.frame->Omega_I.cross(n) - out.at.ddot[0]);
  out.presence = flat - liftOf(B, rim, n);
  return out;
}

double withinRim(const DiscBody& B, const BodyCurve& at, int rim, const Vec3& m, double cap) {
  const double out = cap + m.dot(at.x - at.c) / at.rho;
  if (B.half == 0.0) return out;
  const Vec3 along =
      B.tip ? Vec3((B.middle(1) - at.x) / B.slant()) : Vec3((rim == 1 ? -1.0 : 1.0) * B.a);
  return std::min(out, kBeyondEnd - m.dot(along));
}

}  // namespace dynamy
