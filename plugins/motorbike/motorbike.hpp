/// Motorbike: a single-track vehicle in minimal coordinates, four rigid bodies, 9 or 11 velocities.
///
///   q = (r_OB, p, φ_r, δ, φ_f [, s_r, s_f])   B: of the frame, at the rear contact when upright
///   u = (v_B, Ω, φ̇_r, δ̇, φ̇_f [, ṡ_r, ṡ_f])    v_B, Ω in axes of the frame
///
///   frame ─ s_r along z, φ_r about y ─ rear wheel
///         └ δ about the steering axis ─ fork ─ s_f along it, φ_f about y ─ front wheel
///
///   M = Σ m J_Sᵀ J_S + J_Rᵀ J J_R,   h = −Σ J_Sᵀ m β_S + J_Rᵀ (J β_R + Ω × JΩ) + springs
///
/// Of the coordinates, M and h depend on δ, s_r and s_f alone. So a steady turn has constant u, and
/// its linear equations have constant coefficients. Yaw, lean and pitch angles as coordinates were
/// rejected: their rates are not constant in a turn, and the pitch angle is undefined in a wheelie
/// past the vertical. <Gravity> adds the weight.
#pragma once
#include <memory>

#include "geometry.hpp"

namespace dynamy::motorbike {

/// Velocities by index.
enum Index : int {
  kSpeed = 0,
  kOmega = 3,
  kRear = 6,
  kSteer = 7,
  kFront = 8,
  kRearTravel = 9,
  kFrontTravel = 10
};
inline constexpr int kMost = 11;

/// Frames of the bodies by index.
enum FrameId : int { kFrameId = 0, kRearWheelId = 1, kForkId = 2, kFrontWheelId = 3 };

/// Motion of one body: position r, velocity v and Jacobian JS of its point of reference, rotation A
/// with Omega and JR, and the bias accelerations betaS and betaR.
struct Moving {
  Vec3 r = Vec3::Zero(), v = Vec3::Zero(), Omega = Vec3::Zero();
  Vec3 betaS = Vec3::Zero(), betaR = Vec3::Zero();
  Mat3 A = Mat3::Identity();
  Eigen::Matrix<double, 3, kMost> JS = Eigen::Matrix<double, 3, kMost>::Zero();
  Eigen::Matrix<double, 3, kMost> JR = Eigen::Matrix<double, 3, kMost>::Zero();

  /// Moves the point of reference by ρ_K, in axes of the body.
  void shift(const Vec3& rho_K);
  /// Passes to the next body, which slides by s along the unit vector e_K; j: index of ṡ in u.
  void slide(const Vec3& e_K, double s, double rate, int j);
  /// Passes to the next body, which turns by φ about the unit vector e_K through the point of
  /// reference; j: index of φ̇ in u.
  void turn(const Vec3& e_K, double phi, double rate, int j);
};

class Picture;

class Motorbike final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a);
  explicit Motorbike(const Parameters& x);
  ~Motorbike() override;

  Blocks blocks() const override { return {nu() + 1, nu(), 1, false}; }
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  void qdot(double t, ConstVec q, ConstVec u, Vec qdot) const override;
  void move(double t, Vec q, ConstVec u, double dt) const override;
  void normalise(Vec q) const override;
  double potentialEnergy(double t, ConstVec q) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  void nonPotentialForce(double t, ConstVec q, ConstVec u, Vec h) const override;
  /// Frames by id: 0 the vehicle frame at B, 1 the centre of the rear wheel, 2 the fork at the foot
  /// of the steering axis, 3 the centre of the front wheel.
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return 4; }
  void describe(Description& d) const override;

 private:
  int nu() const { return data_.suspended ? 11 : 9; }
  /// Motion of the points of reference of all four bodies.
  std::array<Moving, 4> motion(ConstVec q, const double* u) const;
  Vec3 centreOfMass(ConstVec q) const;

  Geometry data_;
  Vec3 r_OB_;
  double speed_, leanRate_;
  std::unique_ptr<Picture> picture_;
};

}  // namespace dynamy::motorbike
