/// FlatBody: a rigid body in space whose motion stays in a plane, in the coordinates of the plane. It
/// owns the body; frames, shapes and signals keep their names and values (theory 39.10).
///
///   q = (c1, c2, φ),  u = (v1, v2, ω)   S along the plane's axes; φ since the start, about n
///   M = diag(m, m, nᵀJn) is constant
///
/// It is made by flattenBodies(), never by an XML tag.
#pragma once
#include <array>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/position_tangents.hpp>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>
#include <limits>
#include <memory>

namespace dynamy {

class FlatBody final : public PartialMechanicalSystem, public PositionTangents, public RigidSystem {
 public:
  /// `x`: name, type and place of the body. \pre the body is one rigid body
  FlatBody(const Parameters& x, std::unique_ptr<PartialMechanicalSystem> body, const Plane& plane);

  Blocks blocks() const override { return {3, 3, 1, true, plane_.n}; }
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return static_cast<int>(frames_.size()); }
  Abilities abilities() const override { return {.positionTangents = this, .rigid = this}; }
  RigidPart rigidPart() const override { return part_; }
  void ownState(const RigidMotion& motion, Vec q, Vec u) const override;
  void moveTangent(ConstVec u, double dt, Block T) const override {
    (void)u, (void)dt, T.setIdentity();
  }
  void frameStiffness(double t, ConstVec q, int id, const Vec3& F_I, const Vec3& M_I,
                      Block K) const override;

 private:
  static constexpr int kMostOwn = 16;  // most coordinates of the body
  struct Fixed {
    Vec3 rho;  // from S, at the start [m]
    Mat3 A;
  };
  Mat3 turn(double phi) const;
  RigidMotion motion(ConstVec q, ConstVec u) const;
  double signal(const SignalFunction& f, const SignalView& v) const;
  std::unique_ptr<PartialMechanicalSystem> body_;
  Plane plane_;
  RigidPart part_;
  Blocks own_;
  std::vector<Fixed> frames_;
  Vec3 S_ = Vec3::Zero(), v_ = Vec3::Zero(), Omega_ = Vec3::Zero();  // at the start
  /// Where signals were requested last, and the body's own q and u there.
  struct Shown {
    std::array<double, 6> at{std::numeric_limits<double>::quiet_NaN()};
    std::array<double, kMostOwn> q{}, u{};
  };
  mutable Shown shown_;
  double J_ = 0.0;  // about n [kg m²]
};

}  // namespace dynamy
