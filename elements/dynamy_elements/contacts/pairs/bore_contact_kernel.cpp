#include <array>
#include <cmath>
#include <dynamy_elements/contacts/pairs/bore_contact.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>

namespace dynamy {
namespace {

/// Square of the cosine between two axes below which a cylinder counts as lying across the bore.
constexpr double kAcross = 0.5;
/// A circle about the axis itself, up to this part of its radius, touches nowhere in particular.
constexpr double kConcentric = 1e-14;
/// Newton's method from the best of eight points halves its error at least, and ends quadratically.
constexpr int kMostTurns = 30;

/// A circle that moves with a frame.
struct MovingCircle {
  const Frame& frame;
  Vec3 c, b;  ///< centre, unit axis
  double rho;
};

/// x(φ) in axes across the line: y = (u + ρ cos φ, v + κ ρ sin φ).
struct Shadow {
  double u, v, kappa, rho;
  double square(double s, double c) const {
    const double x = u + rho * c, y = v + kappa * rho * s;
    return x * x + y * y;
  }
  /// Derivatives of ½ |y|²/ρ by φ.
  double slope(double s, double c) const {
    return -(u + rho * c) * s + kappa * (v + kappa * rho * s) * c;
  }
  double bend(double s, double c) const {
    return rho * s * s - (u + rho * c) * c + kappa * kappa * rho * c * c -
           kappa * (v + kappa * rho * s) * s;
  }
  /// φ of the extreme point near `phi`: sign 1 furthest, −1 nearest.
  double extreme(double phi, double sign) const {
    for (int i = 0; i < kMostTurns; ++i) {
      const double s = std::sin(phi), c = std::cos(phi), f = slope(s, c), b = bend(s, c);
      // Where the curve bends the other way a step of bounded length goes uphill.
      double step = sign * b < 0.0 ? -f / b : sign * std::copysign(0.3, f);
      step = std::clamp(step, -0.5, 0.5);
      phi += step;
      if (!(std::abs(step) > 1e-15)) break;
    }
    return phi;
  }
};

/// The point of a circle whose distance from a line is extreme, with rates.
class CircleAndLine {
 public:
  CircleAndLine(const MovingCircle& circle, const LineSegment& line)
      : circle_(circle), line_(line) {
    Vec3 e1 = line.e.cross(circle.b);
    const double sine = e1.norm();
    // Parallel axes: any direction across them will do, since the shadow is a circle.
    e1 = sine > 1e-8 ? Vec3(e1 / sine) : Vec3(circle.b.unitOrthogonal());
    e1_ = (e1 - circle.b.dot(e1) * circle.b).normalized(), e2_ = circle.b.cross(e1_);
    const Vec3 y = across(circle.c - line.o), q = across(e2_);
    const double kappa = q.norm();
    f1_ = across(e1_).normalized();
    // A circle seen from its edge has a shadow of no width.
    const Vec3 f2 = kappa > 1e-12 ? Vec3(q / kappa) : Vec3(line.e.cross(f1_));
    shadow_ = {f1_.dot(y), f2.dot(y), kappa, circle.rho};
  }
  /// Turns to the extreme point of all: sign 1 furthest from the line, −1 nearest.
  void toBest(double sign) {
    static constexpr double h = 0.70710678118654752;
    static constexpr std::array<std::array<double, 2>, 8> kSamples{
        {{0, 1}, {h, h}, {1, 0}, {h, -h}, {0, -1}, {-h, -h}, {-1, 0}, {-h, h}}};
    sign_ = sign;
    std::size_t best = 0;
    for (std::size_t i = 1; i < 8; ++i)
      if (sign * shadow_.square(kSamples[i][0], kSamples[i][1]) >
          sign * shadow_.square(kSamples[best][0], kSamples[best][1]))
        best = i;
    set(shadow_.extreme(std::atan2(kSamples[best][0], kSamples[best][1]), sign));
  }
  /// Turns to the other point that is locally furthest; false: there is none.
  bool toOther() {
    const double first = phi_,
                 other = shadow_.extreme(
                     std::remainder(-2.0 * first, 2.0 * kHalfTurn) + first + kHalfTurn, sign_);
    set(other);
    const double apart = std::abs(std::remainder(other - first, 2.0 * kHalfTurn));
    return apart > 1e-3 && shadow_.bend(std::sin(other), std::cos(other)) < 0.0;
  }
  const Vec3& x() const { return x_; }
  /// Distance from the line.
  double distance() const { return y_.norm(); }
  /// Contact with the normal −y/|y| and the point x.
  ContactPoint contact(double g) const {
    ContactPoint out;
    out.g = g;
    const double distance = y_.norm();
    const bool concentric = !(distance > kConcentric * circle_.rho);
    const Vec3 e = concentric ? f1_ : Vec3(y_ / distance);
    // Rates seen from the line's body: w of the point of the circle, Ω of the circle.
    const Vec3 r = x_ - circle_.c, tau = circle_.b.cross(r) / circle_.rho;
    const Vec3 v = circle_.frame.velocity(x_ - circle_.frame.r_OS_I);
    const Vec3 w = v - line_.velocity(x_);
    const Vec3 turn = circle_.frame.Omega_I - line_.frame->Omega_I;
    // y·x′ = 0 for all times gives the speed s of the point along the circle.
    const Vec3 acrossTau = across(tau);
    const double bend = tau.dot(acrossTau) - y_.dot(r) / (circle_.rho * circle_.rho);
    const double f = tau.dot(across(w)) + y_.dot(turn.cross(tau));
    const double s = std::abs(bend) > kConcentric ? -f / bend : 0.0;
    const Vec3 ydot = across(w) + s * acrossTau;
    Vec3 edot = line_.frame->Omega_I.cross(e);
    if (!concentric) edot += (ydot - e.dot(ydot) * e) / distance;
    setDirections(out, -e, -edot, Vec3::Zero());
    out.P = x_, out.Pdot = v + s * tau;
    return out;
  }

 private:
  static constexpr double kHalfTurn = 3.14159265358979323846;
  Vec3 across(const Vec3& v) const { return v - line_.e.dot(v) * line_.e; }
  void set(double phi) {
    phi_ = phi;
    x_ = circle_.c + circle_.rho * (std::cos(phi) * e1_ + std::sin(phi) * e2_);
    y_ = across(x_ - line_.o);
  }
  MovingCircle circle_;
  LineSegment line_;
  Vec3 e1_, e2_, f1_;
  Shadow shadow_{};
  double sign_ = 1.0, phi_ = 0.0;
  Vec3 x_ = Vec3::Zero(), y_ = Vec3::Zero();
};

}  // namespace

bool ballInBore(const Frame& A, const TouchingShape& bore, const Frame& B, const RoundFeature& ball,
                const Vec3& plane, ContactPoint& out) {
  const LineSegment axis = capsuleAxis(A, bore);
  const double R = bore.half.x();
  const Vec3 rhoB = B.A_IK * ball.c_K, c = B.r_OS_I + rhoB, v = B.velocity(rhoB);
  const double z = axis.e.dot(c - axis.o);
  const Vec3 p = axis.o + z * axis.e, d = c - p, vp = axis.velocity(p);
  const double r = d.norm(), beyond = std::abs(z) - axis.half;
  const bool open = plane.isZero(0.0) && beyond > 0.0;
  if (open && r >= R) return false;
  const double zdot = (v - vp).dot(axis.e) + d.dot(axis.edot);
  const Vec3 ddot = v - vp - zdot * axis.e;
  const Vec3 aside = plane.isZero(0.0) ? axis.e.unitOrthogonal() : plane.unitOrthogonal();
  const bool onAxis = !(r > kConcentric * R);
  const Vec3 e = onAxis ? aside : Vec3(d / r);
  const Vec3 edot = onAxis ? Vec3(A.Omega_I.cross(aside)) : Vec3((ddot - e.dot(ddot) * e) / r);
  if (open) {  // the edge of the bore
    const double side = z < 0.0 ? -1.0 : 1.0;
    const Vec3 end = axis.o + side * axis.half * axis.e, edge = end + R * e;
    const Vec3 edgedot = axis.velocity(end) + R * edot;
    out = fromWay(c - edge, v - edgedot, 0.0, ball.radius, edge, edgedot, -e, plane);
    return true;
  }
  out = {};
  out.g = R - r - ball.radius;
  setDirections(out, -e, -edot, plane);
  out.P = p + R * e, out.Pdot = vp + zdot * axis.e + R * edot;
  return true;
}

int cylinderInBore(const Frame& A, const TouchingShape& bore, const Frame& B,
                   const TouchingShape& cylinder, BoreContacts& out) {
  const LineSegment hole = capsuleAxis(A, bore), shaft = capsuleAxis(B, cylinder);
  const double R = bore.half.x(), r = cylinder.half.x(), along = hole.e.dot(shaft.e);
  int n = 0;
  for (const int end : {0, 1}) {
    const double side = end == 0 ? -1.0 : 1.0, own = along < 0.0 ? -side : side;
    const Vec3 top = shaft.o + own * shaft.half * shaft.e;
    CircleAndLine rim({B, top, shaft.e, r}, hole);
    rim.toBest(1.0);
    const double z = side * hole.e.dot(rim.x() - hole.o);
    if (z < -hole.half) continue;  // the cylinder ends before the bore begins
    auto& found = out[static_cast<std::size_t>(n)];
    if (z > hole.half) {
      CircleAndLine edge({A, hole.o + side * hole.half * hole.e, hole.e, R}, shaft);
      edge.toBest(-1.0);
      if (std::abs(shaft.e.dot(edge.x() - shaft.o)) > shaft.half) continue;
      found = {end, edge.contact(edge.distance() - r)}, ++n;
      continue;
    }
    found = {end, rim.contact(R - rim.distance())}, ++n;
    if (along * along > kAcross || !rim.toOther()) continue;
    if (std::abs(hole.e.dot(rim.x() - hole.o)) > hole.half) continue;
    out[static_cast<std::size_t>(n)] = {2 + end, rim.contact(R - rim.distance())}, ++n;
  }
  return n;
}

}  // namespace dynamy
