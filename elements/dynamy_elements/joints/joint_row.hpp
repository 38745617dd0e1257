/// One row between two frames: position, rate and bias, all exact, also away from where the joint
/// holds. P on A, Q on B, r_PQ = r_Q − r_P:
///
///   point     g = d·r_PQ                    d fixed in A
///   angle     g = d·b                       d fixed in A, b fixed in B
///   distance  g = |r_PQ| − l
///   spin      no position;  γ = d·(Ω_B − Ω_A)
///   turn      g = atan2(b·(d × e), b·e)     angle about d from e (fixed in A) to b (fixed in B)
///   screw     g = d·r_PQ − h ψ              ψ the angle of `turn`, of the turn nearest to g = 0
///
/// A unit force of the row acts on B with a force f at Q and a moment m. It acts with the opposite
/// on the point AQ of A that coincides with Q, so that
///   γ = f·(v_Q − v_AQ) + m·(Ω_B − Ω_A).                                     (theory 40.1, 40.2)
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <span>

namespace dynamy {

struct JointRow {
  enum class Kind : std::uint8_t { point, angle, distance, spin, turn, screw } kind = Kind::point;
  Vec3 d_A = Vec3::Zero();  ///< direction or axis in axes of A
  Vec3 b_B = Vec3::Zero();  ///< angle, turn, screw: direction in axes of B
  double length = 0.0;      ///< distance [m]; screw: advance h per angle [m/rad]
  Vec3 e_A = Vec3::Zero();  ///< turn, screw: unit vector across d, in axes of A
};

/// Both frames of a joint and the line between its two points.
struct JointPose {
  const Frame &A, &B;
  Vec3 rhoA_I, rhoB_I, r_PQ;  ///< lever arms of P and Q, and the line between them
  JointPose(const Frame& a, const Frame& b, const Vec3& pointA, const Vec3& pointB)
      : A(a),
        B(b),
        rhoA_I(a.A_IK * pointA),
        rhoB_I(b.A_IK * pointB),
        r_PQ(b.r_OS_I + rhoB_I - a.r_OS_I - rhoA_I) {}
  Vec3 rhoAQ_I() const { return rhoA_I + r_PQ; }  ///< lever arm of A's point that is now at Q
};

/// Force and moment on B of a unit force of a row.
struct RowWrench {
  bool force = false, moment = false;
  Vec3 f = Vec3::Zero(), m = Vec3::Zero();
};

/// Position and wrench of turns and screws, whose angle needs more computation than other rows.
double turnPosition(const JointPose& p, const JointRow& row);
void turnWrench(const JointPose& p, const JointRow& row, RowWrench& out);

/// g of the row [m, – or rad].
inline double rowPosition(const JointPose& p, const JointRow& row) {
  switch (row.kind) {
    case JointRow::Kind::point:
      return (p.A.A_IK * row.d_A).dot(p.r_PQ);
    case JointRow::Kind::angle:
      return (p.A.A_IK * row.d_A).dot(p.B.A_IK * row.b_B);
    case JointRow::Kind::distance:
      return p.r_PQ.norm() - row.length;
    case JointRow::Kind::spin:
      return 0.0;
    default:
      return turnPosition(p, row);
  }
}

inline RowWrench rowWrench(const JointPose& p, const JointRow& row) {
  RowWrench w;
  switch (row.kind) {
    case JointRow::Kind::point:
      w.force = true, w.f = p.A.A_IK * row.d_A;
      break;
    case JointRow::Kind::distance:
      w.force = true, w.f = p.r_PQ.normalized();
      break;
    case JointRow::Kind::angle:
      w.moment = true, w.m = (p.B.A_IK * row.b_B).cross(p.A.A_IK * row.d_A);
      break;
    case JointRow::Kind::spin:
      w.moment = true, w.m = p.A.A_IK * row.d_A;
      break;
    default:
      turnWrench(p, row, w);
  }
  return w;
}

/// γ [m/s, rad/s].
double rowRate(const JointPose& p, const RowWrench& w);
/// Bias of the row, γ̇ − Wᵀu̇ [m/s², rad/s²].
double rowBias(const JointPose& p, const JointRow& row);

/// Adds sign (f·v(ρ) + m·Ω) of frame f to row `row` of its segment.
inline void addWrench(Block W, int row, const Frame& f, const Vec3& rho_I, const RowWrench& w,
                      double sign) {
  if (w.force) addPointRow(W, row, f, rho_I, w.f, sign);
  if (!w.moment) return;
  for (int j = 0; j < f.nu(); ++j) W(row, j) += sign * f.J_R_I.col(j).dot(w.m);
}
/// f·v(ρ) + m·Ω of the part of the velocities that is prescribed and not from u.
inline double drivenRate(const Frame& f, const Vec3& rho_I, const RowWrench& w) {
  double chi = 0.0;
  if (w.force) chi += w.f.dot(f.nu_S_I + f.nu_R_I.cross(rho_I));
  if (w.moment) chi += w.m.dot(f.nu_R_I);
  return chi;
}

/// Contribution of one frame to γ: sign (f·v(ρ) + m·Ω).
struct RateTerm {
  const Frame* frame = nullptr;
  Vec3 rho_I = Vec3::Zero();
  RowWrench wrench;
  double sign = 1.0;
};
/// Writes segments and χ of a contact of one row. Terms of one block share a segment.
void emitRow(std::span<const RateTerm> terms, ContactRows& out);

}  // namespace dynamy
