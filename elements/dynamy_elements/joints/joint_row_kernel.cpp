#include <cmath>
#include <dynamy_elements/joints/joint_row.hpp>
#include <numbers>

namespace dynamy {
namespace {

/// Acceleration at u̇ = 0 of the body point at rho_I.
Vec3 pointBias(const Frame& f, const Vec3& rho_I) {
  return f.bias_S_I + f.bias_R_I.cross(rho_I) + f.Omega_I.cross(f.Omega_I.cross(rho_I));
}

/// Directions that define the angle: ψ = atan2(y, x), ψ̇ = (Ω_B − Ω_A)·w, w = b × n/(x² + y²).
struct Turn {
  Vec3 d, e, c, b, n;  // c = d × e, n = x c − y e
  double x, y, square;
  Turn(const JointPose& p, const JointRow& row)
      : d(p.A.A_IK * row.d_A),
        e(p.A.A_IK * row.e_A),
        c(d.cross(e)),
        b(p.B.A_IK * row.b_B),
        x(e.dot(b)),
        y(c.dot(b)),
        square(x * x + y * y) {
    n = x * c - y * e;
  }
  double angle() const { return std::atan2(y, x); }
  Vec3 w() const { return b.cross(n) / square; }
  double bias(const JointPose& p) const {
    const Vec3 Omega = p.B.Omega_I - p.A.Omega_I, bdot = p.B.Omega_I.cross(b),
               edot = p.A.Omega_I.cross(e), cdot = p.A.Omega_I.cross(c);
    const double xdot = edot.dot(b) + e.dot(bdot), ydot = cdot.dot(b) + c.dot(bdot);
    const Vec3 ndot = xdot * c + x * cdot - ydot * e - y * edot;
    const Vec3 wdot = (bdot.cross(n) + b.cross(ndot) - 2.0 * (x * xdot + y * ydot) * w()) / square;
    return w().dot(p.B.bias_R_I - p.A.bias_R_I) + wdot.dot(Omega);
  }
};

double pointRowBias(const JointPose& p, const Vec3& d) {
  const Vec3 ddot = p.A.Omega_I.cross(d);
  const Vec3 v_PQ = p.B.velocity(p.rhoB_I) - p.A.velocity(p.rhoA_I);
  return d.dot(pointBias(p.B, p.rhoB_I) - pointBias(p.A, p.rhoA_I)) + 2.0 * ddot.dot(v_PQ) +
         (p.A.bias_R_I.cross(d) + p.A.Omega_I.cross(ddot)).dot(p.r_PQ);
}

double distanceBias(const JointPose& p) {
  const double l = p.r_PQ.norm();
  if (!(l > 0.0)) return 0.0;  // no direction: the row is zero there
  const Vec3 e = p.r_PQ.normalized();
  const Vec3 v_PQ = p.B.velocity(p.rhoB_I) - p.A.velocity(p.rhoA_I);
  const double along = e.dot(v_PQ);
  return e.dot(pointBias(p.B, p.rhoB_I) - pointBias(p.A, p.rhoA_I)) +
         (v_PQ.squaredNorm() - along * along) / l;
}

double screwPosition(const JointPose& p, const JointRow& row) {
  const double z = (p.A.A_IK * row.d_A).dot(p.r_PQ), psi = Turn(p, row).angle();
  return row.length * std::remainder(z / row.length - psi, 2.0 * std::numbers::pi);
}

}  // namespace

double turnPosition(const JointPose& p, const JointRow& row) {
  if (row.kind == JointRow::Kind::screw) return screwPosition(p, row);
  return Turn(p, row).angle();
}

void turnWrench(const JointPose& p, const JointRow& row, RowWrench& out) {
  const Turn turn(p, row);
  out.moment = true, out.m = turn.w();
  if (row.kind != JointRow::Kind::screw) return;
  out.m *= -row.length;
  out.force = true, out.f = turn.d;
}

double rowRate(const JointPose& p, const RowWrench& w) {
  double rate = 0.0;
  if (w.force) rate += w.f.dot(p.B.velocity(p.rhoB_I) - p.A.velocity(p.rhoAQ_I()));
  if (w.moment) rate += w.m.dot(p.B.Omega_I - p.A.Omega_I);
  return rate;
}

double rowBias(const JointPose& p, const JointRow& row) {
  const Vec3 d = p.A.A_IK * row.d_A, ddot = p.A.Omega_I.cross(d);
  const Vec3 Omega = p.B.Omega_I - p.A.Omega_I, betaR = p.B.bias_R_I - p.A.bias_R_I;
  switch (row.kind) {
    case JointRow::Kind::point:
      return pointRowBias(p, d);
    case JointRow::Kind::distance:
      return distanceBias(p);
    case JointRow::Kind::angle: {
      const Vec3 b = p.B.A_IK * row.b_B;
      return b.cross(d).dot(betaR) + (p.B.Omega_I.cross(b).cross(d) + b.cross(ddot)).dot(Omega);
    }
    case JointRow::Kind::spin:
      return d.dot(betaR) + ddot.dot(Omega);
    case JointRow::Kind::turn:
      return Turn(p, row).bias(p);
    case JointRow::Kind::screw:
      return pointRowBias(p, d) - row.length * Turn(p, row).bias(p);
  }
  return 0.0;
}

void emitRow(std::span<const RateTerm> terms, ContactRows& out) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const RateTerm& x = terms[i];
    out.chi(0) += x.sign * drivenRate(*x.frame, x.rho_I, x.wrench);
    const int block = terms[i].frame->block;
    if (block < 0) continue;
    const auto sameBlock = [block](const RateTerm& y) { return y.frame->block == block; };
    bool done = false;
    for (std::size_t k = 0; k < i && !done; ++k) done = sameBlock(terms[k]);
    if (done) continue;
    const Block W = out.segment(*x.frame);
    for (std::size_t k = i; k < terms.size(); ++k)
      if (const RateTerm& y = terms[k]; sameBlock(y))
        addWrench(W, 0, *y.frame, y.rho_I, y.wrench, y.sign);
  }
}

}  // namespace dynamy
