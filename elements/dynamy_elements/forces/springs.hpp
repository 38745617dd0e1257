/// Springs with dampers between two frames.
///
///   SpringDamper   l = |r_PQ|, e = r_PQ/l
///                  F = (c (l − l0) + d l̇) e on P, −F on Q;   V = ½ c (l − l0)²
///   TorsionSpring  ψ angle of B about the axis a of A
///                  M = −(c (ψ − ψ0) + d ψ̇) a on B, −M on A;   V = ½ c (ψ − ψ0)²
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/frame_pair.hpp>

namespace dynamy {

class SpringDamper final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit SpringDamper(const Parameters& x);
  void connect(Topology& topology) override;
  void describe(Description& d) const override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool hasPotential() const override { return damping_ == 0.0; }
  double potentialEnergy(const Kinematics& k) const override;
  bool stiff() const override { return stiff_; }
  bool isMirrored(const MirrorPlane& plane) const override;
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const override;

 private:
  struct Line {
    Vec3 rhoA_I, rhoB_I, e;
    double l, ldot;
  };
  Line line(const Kinematics& k) const;
  FramePair frames_;
  Vec3 pointA_, pointB_;
  double stiffness_, damping_, length_;
  bool lengthGiven_, stiff_;
};

class TorsionSpring final : public ExternalForce {
 public:
  static void declare(Attributes& a);
  explicit TorsionSpring(const Parameters& x);
  void connect(Topology& topology) override { frames_.connect(topology, *this); }
  void describe(Description& d) const override;
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool hasPotential() const override { return damping_ == 0.0; }
  double potentialEnergy(const Kinematics& k) const override;
  bool stiff() const override { return stiff_; }
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const override;

 private:
  /// Angle ψ of B relative to A about the axis, in (−π, π] [rad]; ψ̇ = gradient · (Ω_B − Ω_A), in I. Where
  /// B has turned about the axis alone the gradient is the axis.
  double angle(const Kinematics& k, Vec3* gradient_I = nullptr) const;
  FramePair frames_;
  Vec3 axis_A_;
  double stiffness_, damping_, angle_;
  bool stiff_;
};

}  // namespace dynamy
