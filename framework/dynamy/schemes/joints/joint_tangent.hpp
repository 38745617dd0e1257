/// JointTangent: the parts of K of JointNewton in closed form (theory 34.4), for one block and for
/// the blocks a, b of one joint. T_M, T_E are the tangents of the half and the whole step
/// (q_A ⊕ Δt (v + δ) = q_E ⊕ Δt T_E δ):
///
///   ∂R_v/∂v        2M − Δt D − Δt²/2 K T_M               K = ∂h/∂q F, D = ∂h/∂v
///   ∂(WΛ)_a/∂v_b   Δt/2 (J_aᵀ D_ab J_b + δ_ab S_a) T_M   D_ab: jointForces, S: frameStiffness
///   ∂R_g/∂v_b      W_E,bᵀ T_E
///
/// with the derivatives of the quotient in W̃Λ = WΛ − p/s Mv, p = vᵀWΛ + (χ − Δg/Δt)ᵀΛ, s = vᵀMv.
/// Forces of ExternalForce elements count as constant. Those that the step does not resolve are not
/// part of h (DampedForces). Where others change so much that Newton's iteration is slow, K is
/// taken by differences. All matrices are padded with zeros to size six.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class JointTangent {
 public:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  /// Computes the tangents of the blocks at the mean velocity v; slot 0 was evaluated at
  /// `midpoint`. False: a system does not offer its part.
  bool begin(const MechanicalSystem& s, const State& midpoint, const Eigen::VectorXd& v, double dt);
  const Matrix6& ofBlock(int block) const { return blocks_[static_cast<std::size_t>(block)].K; }
  /// Computes the parts of the joint that is contact `i` of slot 0 and `iEnd` of slot 1; gRate:
  /// Δg/Δt; leastTwiceT: JointEquations::leastTwiceT. False: the joint does not offer its part.
  bool joint(const MechanicalSystem& s, int i, int iEnd, const double* Lambda, const double* gRate,
             double leastTwiceT);
  /// Number of blocks that the joint of the last call of joint() moves, 1 or 2.
  int sides() const { return sides_; }
  int block(int side) const { return side_[side].block; }
  int nu(int side) const { return side_[side].nu; }
  /// ∂(W̃Λ)_a/∂v_b; ofGap(b): ∂R_g/∂v_b, with as many rows as the joint has.
  const Matrix6& ofForce(int a, int b) const { return force_[a][b]; }
  const Matrix6& ofGap(int b) const { return side_[b].gap; }

 private:
  struct BlockTangent {
    const PositionTangents* system = nullptr;
    Matrix6 half = Matrix6::Zero(), whole = Matrix6::Zero(), K = Matrix6::Zero();
  };
  struct Side {
    int number = 0;  ///< 0: A, 1: B
    int block = 0, nu = 0;
    Matrix6 J, gap;          ///< [J_S; J_R], W_Eᵀ T_E
    Vector6 v, momentum, W;  ///< v, Mv, WΛ
    Vector6 powerByV;        ///< ∂p/∂v
  };
  bool findSides(const Evaluation& e, const ContactSet& atEnd, int i, int iEnd,
                 const double* Lambda);
  void turn(const MechanicalSystem& s);
  void addQuotient(const MechanicalSystem& s, double power, double leastTwiceT);

  double dt_ = 0.0;
  const Eigen::VectorXd* v_ = nullptr;
  std::vector<BlockTangent> blocks_;
  JointForces forces_;
  Side side_[2];
  int sides_ = 0;
  Matrix6 force_[2][2];
};

}  // namespace dynamy
