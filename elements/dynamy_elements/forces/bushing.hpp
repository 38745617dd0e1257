/// Bushing: a joint of rubber between two frames, in axes of A:                     (theory 40.5)
///
///   F = −C r_PQ − D ṙ_PQ on B at Q,      M = −T(−θ)⁻ᵀ K θ − E (Ω_B − Ω_A) on B
///   V = ½ r_PQᵀ C r_PQ + ½ θᵀ K θ        C, D, K, E diagonal
///
/// θ is the rotation vector of B relative to A since the start, |θ| < π. T is its tangent, so that
/// the moment derives from V at any angle.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/frame_pair.hpp>

namespace dynamy {

class Bushing final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit Bushing(const Parameters& x);
  void connect(Topology& topology) override;
  void describe(Description& d) const override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool hasPotential() const override { return damping_.isZero(0.0) && turnDamping_.isZero(0.0); }
  double potentialEnergy(const Kinematics& k) const override;
  bool stiff() const override { return stiff_; }
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const override;

 private:
  /// Displacement, rotation vector [rad] and their rates in axes of A.
  struct Strain {
    Mat3 A_IA;
    Vec3 rhoAQ_I, rhoB_I, r_A, rdot_A, theta_A, Omega_A;
  };
  Strain strain(const Kinematics& k) const;
  FramePair frames_;
  Vec3 stiffness_, damping_, turnStiffness_, turnDamping_, at_ = Vec3::Zero();
  Vec3 pointA_ = Vec3::Zero(), pointB_ = Vec3::Zero();
  Mat3 start_ = Mat3::Identity();  // A_AB at the start
  bool atGiven_, stiff_;
};

}  // namespace dynamy
