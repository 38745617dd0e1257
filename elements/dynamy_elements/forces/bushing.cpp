#include <Eigen/Geometry>
#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy_elements/forces/bushing.hpp>

namespace dynamy {
namespace {

/// Rotation vector of a rotation matrix, of length up to π.
Vec3 turnVector(const Mat3& R) {
  const Eigen::Quaterniond p(R);
  const double sine = p.vec().norm(), sign = p.w() < 0.0 ? -1.0 : 1.0;
  const double angle = 2.0 * std::atan2(sine, sign * p.w());
  // θ/sin(θ/2) → 2 for small angles.
  return (sine > 1e-9 ? angle / sine : 2.0) * sign * p.vec();
}

void readDiagonal(Attributes& a, const char* name, Unit unit, const char* text) {
  a.vector(name, unit, 3, "0 0 0", text).nonNegative();
}

}  // namespace

void Bushing::declare(Attributes& a) {
  a.about(
      "Bushing between two frames: springs and dampers along the three axes of A and about them, "
      "without force as the frames are at the start. The rotation is taken as a vector theta, V = "
      "theta K theta/2, up to half a turn. Signals: displacement, angle.");
  FramePair::declare(a);
  Attribute& at = a.add(AttributeType::vector, "at", std::nullopt,
                        "place at the start, in the world; default: origin of B");
  at.unit = Unit::length;
  at.size = 3;
  at.mayBeAbsent();
  readDiagonal(a, "stiffness", Unit::stiffness, "stiffness along the axes of A");
  readDiagonal(a, "damping", Unit::damping, "damping along the axes of A");
  readDiagonal(a, "turnStiffness", Unit::rotationalStiffness, "stiffness about the axes of A");
  readDiagonal(a, "turnDamping", Unit::rotationalDamping, "damping about the axes of A");
  a.add(AttributeType::flag, "stiff", "false",
        "true: taken linearly implicitly by the schemes, which keeps its energy where steps are "
        "beyond its periods; else it is found, and damped");
  a.example(
      "<Bushing between=\"world rod\" stiffness=\"1e4 1e4 5e3\" turnStiffness=\"50 50 20\"/>");
}

Bushing::Bushing(const Parameters& x)
    : ExternalForce(x),
      frames_(x),
      stiffness_(x["stiffness"].vec3()),
      damping_(x["damping"].vec3()),
      turnStiffness_(x["turnStiffness"].vec3()),
      turnDamping_(x["turnDamping"].vec3()),
      atGiven_(x.has("at")),
      stiff_(x["stiff"].flag()) {
  if (atGiven_) at_ = x["at"].vec3();
}

void Bushing::connect(Topology& topology) {
  frames_.connect(topology, *this);
  const StartKinematics start(topology, {frames_.A, frames_.B});
  const Frame &A = start.frame(frames_.A), &B = start.frame(frames_.B);
  const Vec3 at = atGiven_ ? at_ : B.r_OS_I;
  pointA_ = A.A_IK.transpose() * (at - A.r_OS_I);
  pointB_ = B.A_IK.transpose() * (at - B.r_OS_I);
  start_ = A.A_IK.transpose() * B.A_IK;
}

Bushing::Strain Bushing::strain(const Kinematics& k) const {
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  Strain s;
  s.A_IA = A.A_IK;
  s.rhoB_I = B.A_IK * pointB_;
  s.rhoAQ_I = B.r_OS_I + s.rhoB_I - A.r_OS_I;  // lever arm of A's point that is now at Q
  const Mat3 A_AI = A.A_IK.transpose();
  s.r_A = A_AI * s.rhoAQ_I - pointA_;
  s.rdot_A = A_AI * (B.velocity(s.rhoB_I) - A.velocity(s.rhoAQ_I));
  s.theta_A = turnVector(A_AI * B.A_IK * start_.transpose());
  s.Omega_A = A_AI * (B.Omega_I - A.Omega_I);
  return s;
}

void Bushing::addTo(const Kinematics& k, ForceSink& sink) const {
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  const Strain s = strain(k);
  const auto add = [&](const Vec3& F_A, const Vec3& M_A) {
    const Vec3 F = s.A_IA * F_A, M = s.A_IA * M_A;
    sink.force(B, s.rhoB_I, F), sink.moment(B, M);
    sink.force(A, s.rhoAQ_I, -F), sink.moment(A, -M);
  };
  // exp(θ + δ) = exp(δ′) exp(θ) with δ′ = T(−θ) δ, and δ′ = Ω_A dt:  θ̇ = T(−θ)⁻¹ Ω.
  const Mat3 T = rotationTangent(-s.theta_A);
  sink.hasPotential(true);
  add(-stiffness_.cwiseProduct(s.r_A),
      -T.transpose().inverse() * turnStiffness_.cwiseProduct(s.theta_A));
  if (hasPotential()) return;
  sink.hasPotential(false);
  add(-damping_.cwiseProduct(s.rdot_A), -turnDamping_.cwiseProduct(s.Omega_A));
}

void Bushing::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  const Frame &A = k.frame(frames_.A), &B = k.frame(frames_.B);
  const Strain s = strain(k);
  for (int i = 0; i < 3; ++i) {
    const Vec3 e = s.A_IA.col(i);
    sink.spring(A, s.rhoAQ_I, B, s.rhoB_I, e, stiffness_[i], damping_[i]);
    sink.torsion(A, B, e, turnStiffness_[i], turnDamping_[i]);
  }
}

double Bushing::potentialEnergy(const Kinematics& k) const {
  const Strain s = strain(k);
  return 0.5 * stiffness_.dot(s.r_A.cwiseAbs2()) + 0.5 * turnStiffness_.dot(s.theta_A.cwiseAbs2());
}

void Bushing::describe(Description& d) const {
  d.timeless = true;
  d.signal("displacement", Unit::length, "distance of its two points",
           [this](const SignalView& v) { return strain(*v.kinematics).r_A.norm(); });
  d.signal("angle", Unit::angle, "angle of B against A since the start",
           [this](const SignalView& v) { return strain(*v.kinematics).theta_A.norm(); });
}

}  // namespace dynamy
