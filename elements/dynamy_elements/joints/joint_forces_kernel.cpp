// Forces of a joint on its frames for given percussions, and their
// derivatives by motions of the frames:
//
//   point     f = Σ Λ d, d fixed in A      on B (f, ρ_B × f), on A (−f, −ρ_AQ × f)
//   distance  f = Λ e, e = r_PQ/|r_PQ|     the same; ρ_AQ: lever arm of A's point now at Q
//   angle     m = Λ b × d                  on B (0, m), on A (0, −m)
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/joints/joint.hpp>

namespace dynamy {
namespace {

/// First row of a force or moment in (F_A, M_A, F_B, M_B), first column of a displacement or
/// rotation in (δr_A, δθ_A, δr_B, δθ_B).
enum RowPart { kA = 0, kTurnA = 3, kB = 6, kTurnB = 9 };

/// Adds a force f that acts on B at Q, and its opposite on A's point that is at Q; `turn`:
/// derivative of f by the four displacements.
void addForce(const Vec3& f, const Vec3& rhoAQ_I, const Vec3& rhoB_I,
              const Eigen::Matrix<double, 3, 12>& turn, JointForces& out) {
  out.F[0] -= f, out.M[0] -= rhoAQ_I.cross(f);
  out.F[1] += f, out.M[1] += rhoB_I.cross(f);
  out.D.middleRows<3>(kA) -= turn;
  out.D.middleRows<3>(kTurnA) -= skew(rhoAQ_I) * turn;
  out.D.middleRows<3>(kB) += turn;
  out.D.middleRows<3>(kTurnB) += skew(rhoB_I) * turn;
  // δρ_B = δθ_B × ρ_B,  δρ_AQ = δr_B + δθ_B × ρ_B − δr_A;  δρ × f = −f × δρ.
  const Mat3 F = skew(f), arm = F * skew(rhoB_I);
  out.D.block<3, 3>(kTurnB, kTurnB) += arm;
  out.D.block<3, 3>(kTurnA, kTurnB) -= arm;
  out.D.block<3, 3>(kTurnA, kB) += F;
  out.D.block<3, 3>(kTurnA, kA) -= F;
}

}  // namespace

bool Joint::jointForces(const Kinematics& k, std::uint64_t id, const double* Lambda,
                        JointForces& out) const {
  if (id > 1) return false;  // friction, screws
  const JointPose p = pose(k);
  out.frame[0] = frames_.A, out.frame[1] = frames_.B;
  for (int side = 0; side < 2; ++side) out.F[side].setZero(), out.M[side].setZero();
  out.D.setZero();
  Vec3 fixedInA = Vec3::Zero();
  for (const JointRow& row : id == 0 ? rows_.points : rows_.angles) {
    const double L = *Lambda++;
    const Vec3 d = p.A.A_IK * row.d_A;
    if (row.kind == JointRow::Kind::point) {
      fixedInA += L * d;
    } else if (row.kind == JointRow::Kind::distance) {
      // δe = (I − e eᵀ) δr_PQ/|r_PQ|,  δr_PQ = δr_B + δθ_B × ρ_B − δr_A − δθ_A × ρ_A.
      const double length = p.r_PQ.norm();
      const Vec3 e = p.r_PQ / length;
      const Mat3 across = L / length * (Mat3::Identity() - e * e.transpose());
      Eigen::Matrix<double, 3, 12> turn;
      turn << -across, across * skew(p.rhoA_I), across, -across * skew(p.rhoB_I);
      addForce(L * e, p.rhoA_I + p.r_PQ, p.rhoB_I, turn, out);
    } else {
      const Vec3 b = p.B.A_IK * row.b_B, m = L * b.cross(d);
      // δ(b × d) = (δθ_B × b) × d + b × (δθ_A × d).
      const Mat3 byB = L * skew(d) * skew(b), byA = -L * skew(b) * skew(d);
      out.M[0] -= m, out.M[1] += m;
      out.D.block<3, 3>(kTurnA, kTurnA) -= byA, out.D.block<3, 3>(kTurnA, kTurnB) -= byB;
      out.D.block<3, 3>(kTurnB, kTurnA) += byA, out.D.block<3, 3>(kTurnB, kTurnB) += byB;
    }
  }
  if (id == 1 || rows_.points[0].kind == JointRow::Kind::distance) return true;
  Eigen::Matrix<double, 3, 12> turn = Eigen::Matrix<double, 3, 12>::Zero();
  turn.middleCols<3>(kTurnA) = -skew(fixedInA);
  addForce(fixedInA, p.rhoA_I + p.r_PQ, p.rhoB_I, turn, out);
  return true;
}

}  // namespace dynamy
