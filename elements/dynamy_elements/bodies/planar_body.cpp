#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>

namespace dynamy {

void PlanarBody::declare(Attributes& a) {
  a.about(
      "Rigid body in a plane: m c'' = f, J phi'' = M. Signals (plane xz): x z of the centre of "
      "mass "
      "S, phi, vx vz, omega, kineticEnergy. The angle turns the first axis of the plane towards "
      "the second. Mass and inertia are given, or follow from the shapes.");
  a.choice("plane", {"xz", "xy", "yz"}, "xz", "plane of motion");
  a.vector("position", Unit::length, 3, "0 0 0",
           "origin of the body; the component out of the plane stays");
  a.optional("angle", Unit::angle, 0.0, "angle at the start; at 0 the body axes are x, y, z");
  a.vector("velocity", Unit::velocity, 3, "0 0 0", "velocity of the centre of mass at the start");
  a.optional("angularVelocity", Unit::angularVelocity, 0.0, "angular velocity at the start");
  BodyParts::declareMass(
      a, AttributeType::number,
      "moment of inertia about S = position, normal to the plane; default: of the shapes")
      .positive();
  BodyParts::declare(a);
  a.example(
      "<PlanarBody name=\"rod\" position=\"0 0 1\"><Box size=\"1 0.1 0.1\" "
      "mass=\"1\"/></PlanarBody>");
}

PlanarBody::PlanarBody(const Parameters& x)
    : PartialMechanicalSystem(x),
      plane_(x["plane"].text),
      parts_(x),
      r_OB_I_(x["position"].vec3()),
      v_S_I_(x["velocity"].vec3()),
      phi_(x["angle"]),
      omega_(x["angularVelocity"]) {
  expectInPlane(x["velocity"], plane_);
  const BodyMass mass =
      parts_.mass(x, [](const ParameterValue& J) -> Mat3 { return double(J) * Mat3::Identity(); });
  m_ = mass.m, J_ = plane_.n.dot(mass.J_S_K * plane_.n), r_BS_K_ = mass.r_BS_K;
  if (!(J_ > 0.0))
    throw ModelError("the body's shapes have mass but no inertia",
                     "add inertia=\"…\", or use PointMass for a body that does not turn");
}

Mat3 PlanarBody::axes(double phi) const {
  double p[4];
  axisQuaternion(plane_.n, phi, p);
  return rotationMatrix(p);
}

void PlanarBody::describe(Description& d) const {
  d.timeless = true;
  const std::string first{plane_.first}, second{plane_.second};
  d.coordinate(first, Unit::length, 0, "position of S");
  d.coordinate(second, Unit::length, 1, "position of S");
  d.coordinate("phi", Unit::angle, 2, "angle");
  d.velocity("v" + first, Unit::velocity, 0, "velocity of S");
  d.velocity("v" + second, Unit::velocity, 1, "velocity of S");
  d.velocity("omega", Unit::angularVelocity, 2, "angular velocity");
  d.signal("kineticEnergy", Unit::energy, "½ m v² + ½ J ω²", [m = m_, J = J_](const SignalView& s) {
    return 0.5 * m * (s.u[0] * s.u[0] + s.u[1] * s.u[1]) + 0.5 * J * s.u[2] * s.u[2];
  });
  parts_.describe(d, first + second, r_BS_K_, [this](const SignalView& s) {
    BodyMotion m{Vec3::Zero(), Vec3::Zero(), s.u[2] * plane_.n, axes(s.q[2])};
    m.r_OS_I[plane_.a] = s.q[0], m.r_OS_I[plane_.b] = s.q[1];
    m.v_S_I[plane_.a] = s.u[0], m.v_S_I[plane_.b] = s.u[1];
    return m;
  });
}

void PlanarBody::initialState(Vec q, Vec u) const {
  const Vec3 r_OS_I = r_OB_I_ + axes(phi_) * r_BS_K_;
  q << r_OS_I[plane_.a], r_OS_I[plane_.b], phi_;
  u << v_S_I_[plane_.a], v_S_I_[plane_.b], omega_;
}

void PlanarBody::M(double, ConstVec, MassBlocks M) const {
  Block block = M[0];
  block.setZero();
  block.diagonal() << m_, m_, J_;
}

void PlanarBody::h(double, ConstVec, ConstVec, Vec h) const { h.setZero(); }

double PlanarBody::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  h << m_ * g_I[plane_.a], m_ * g_I[plane_.b], 0.0;
  return -m_ * (g_I[plane_.a] * q[0] + g_I[plane_.b] * q[1]);
}

void PlanarBody::moveTangent(ConstVec, double, Block T) const { T.setIdentity(); }

void PlanarBody::frameStiffness(double, ConstVec q, int id, const Vec3& F_I, const Vec3&,
                                Block K) const {
  turningArm(plane_, axes(q[2]) * (parts_.position(id) - r_BS_K_), F_I, K);
}

RigidPart PlanarBody::rigidPart() const {
  // Normal to the plane, S counts as being at B: the body turns about no other axis than n.
  return {false, m_, r_BS_K_, J_ * Mat3::Identity()};
}

void PlanarBody::ownState(const RigidMotion& motion, Vec q, Vec u) const {
  q << motion.r_OS_I[plane_.a], motion.r_OS_I[plane_.b], phi_ + motion.angle;
  u << motion.v_S_I[plane_.a], motion.v_S_I[plane_.b], motion.Omega_I.dot(plane_.n);
}

void PlanarBody::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  // Normal to the plane, S stays where the body's origin was put; its offset has no effect there.
  placeInPlane(plane_, q, u, r_OB_I_[plane_.rest()] + r_BS_K_[plane_.rest()], axes(q[2]), out);
  shiftFrame(out, out.A_IK * (parts_.position(id) - r_BS_K_), parts_.axes(id));
}

}  // namespace dynamy
