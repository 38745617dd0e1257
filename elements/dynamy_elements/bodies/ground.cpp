#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/ground.hpp>

namespace dynamy {
namespace {

Attribute& absentFormula(Attributes& a, AttributeType type, const char* name, const char* text) {
  return a.add(type, name, std::nullopt, text).mayBeAbsent();
}

}  // namespace

void Ground::declare(Attributes& a) {
  a.about(
      "Carries shapes and frames that stand still or move as told: r = position + motion(t), "
      "turned by rotation(t) about axis. Velocities and accelerations follow exactly from the "
      "formulas. Signals, if its shapes touch others: Fx Fy Fz, the sum of all contact forces on "
      "this ground, along the axes of the world. Walls whose forces are wanted one by one are "
      "grounds of their own.");
  declarePose(a, "ground");
  absentFormula(a, AttributeType::expressions, "motion",
                "x; y; z: displacement from position as formulas of t")
      .in(Unit::length);
  absentFormula(a, AttributeType::expression, "rotation", "angle as a formula of t")
      .in(Unit::angle);
  a.vector("axis", Unit::none, 3, "0 0 1", "axis of the rotation, in the ground's axes").notZero();
  BodyParts::declare(a);
  a.example(
      "<Ground name=\"table\" motion=\"0; 0; 0.01*sin(50*t)\"><HalfSpace "
      "material=\"steel\"/></Ground>");
}

Ground::Ground(const Parameters& x)
    : PartialMechanicalSystem(x),
      parts_(x),
      r_OB_I_(x["position"].vec3()),
      A_IK_(rotationMatrix(orientation(x).data())),
      motion_(x, "motion", 3),
      rotation_(x, "rotation", 1),
      axis_K_(x["axis"].vec3().normalized()) {
  parts_.refuseMass("forces do not move a ground");
}

void Ground::describe(Description& d) const {
  d.timeless = motion_.empty() && rotation_.empty();
  parts_.describe(d);
  TimeFormulas::announce(d, {&motion_, &rotation_});
}

bool Ground::isMirrored(const MirrorPlane& plane) const {
  return motion_.empty() && rotation_.empty() && parts_.areMirrored(plane.in(r_OB_I_, A_IK_));
}

void Ground::frame(double t, ConstVec, ConstVec, int id, Frame& out) const {
  out.block = -1;
  Vec3 s = Vec3::Zero(), ds = Vec3::Zero(), dds = Vec3::Zero();
  double phi = 0.0, dphi = 0.0, ddphi = 0.0;
  if (!motion_.empty()) motion_.eval(t, s.data(), ds.data(), dds.data());
  if (!rotation_.empty()) rotation_.eval(t, &phi, &dphi, &ddphi);
  double p[4];
  axisQuaternion(axis_K_, phi, p);
  const Vec3 axis_I = A_IK_ * axis_K_;
  out.r_OS_I = r_OB_I_ + s;
  out.A_IK = A_IK_ * rotationMatrix(p);
  out.v_S_I = out.nu_S_I = ds;
  out.Omega_I = out.nu_R_I = dphi * axis_I;
  out.bias_S_I = dds;
  out.bias_R_I = ddphi * axis_I;
  shiftFrame(out, out.A_IK * parts_.position(id), parts_.axes(id));
}

}  // namespace dynamy
