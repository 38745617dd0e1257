#include <dynamy_elements/bodies/point_mass.hpp>

namespace dynamy {

void PointMass::declare(Attributes& a) {
  a.about(
      "Mass without rotation: m v' = f. Signals: x y z, vx vy vz (in a plane: its two axes), "
      "kineticEnergy.");
  a.choice("plane", {"none", "xz", "xy", "yz"}, "none", "plane of motion; none: in space");
  a.vector("position", Unit::length, 3, "0 0 0", "place at the start");
  a.vector("velocity", Unit::velocity, 3, "0 0 0", "velocity at the start");
  Attribute& mass =
      a.add(AttributeType::number, "mass", std::nullopt, "mass; default: of the shapes");
  mass.unit = Unit::mass;
  mass.mayBeAbsent().positive();
  BodyParts::declare(a);
  a.example("<PointMass name=\"bob\" mass=\"1\" position=\"1 0 0\"/>");
}

PointMass::PointMass(const Parameters& x)
    : PartialMechanicalSystem(x),
      parts_(x),
      axes_{0, 1, 2},
      m_(x.has("mass") ? double(x["mass"]) : parts_.mass(0.0).m),
      r_OS_I_(x["position"].vec3()),
      v_S_I_(x["velocity"].vec3()) {
  if (x.has("mass")) parts_.refuseMass("the point has a mass of its own");
  if (!(m_ > 0.0))
    throw ModelError("the point mass has no mass", "add mass=\"…\", or give its shapes a mass");
  if (x["plane"].text == "none") return;
  const Plane plane(x["plane"].text);
  expectInPlane(x["velocity"], plane);
  axes_ = {plane.a, plane.b};
  planeNormal_ = plane.n;
}

Blocks PointMass::blocks() const {
  const int n = static_cast<int>(axes_.size());
  return {n, n, 1, true, planeNormal_};
}

void PointMass::describe(Description& d) const {
  d.timeless = true;
  const char* const name[3] = {"x", "y", "z"};
  for (std::size_t i = 0; i < axes_.size(); ++i)
    d.coordinate(name[axes_[i]], Unit::length, static_cast<int>(i), "position");
  for (std::size_t i = 0; i < axes_.size(); ++i)
    d.velocity(std::string("v") + name[axes_[i]], Unit::velocity, static_cast<int>(i), "velocity");
  d.signal("kineticEnergy", Unit::energy, "½ m v²",
           [m = m_](const SignalView& s) { return 0.5 * m * s.u.squaredNorm(); });
  std::string moving;
  for (const int axis : axes_) moving += name[axis];
  parts_.describe(d, moving, Vec3::Zero(), [this](const SignalView& s) {
    BodyMotion m{r_OS_I_, Vec3::Zero(), Vec3::Zero(), Mat3::Identity()};
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      m.r_OS_I[axes_[i]] = s.q[at], m.v_S_I[axes_[i]] = s.u[at];
    }
    return m;
  });
}

void PointMass::initialState(Vec q, Vec u) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    q[at] = r_OS_I_[axes_[i]], u[at] = v_S_I_[axes_[i]];
  }
}

void PointMass::M(double, ConstVec, MassBlocks M) const {
  Block block = M[0];
  block.setZero();
  block.diagonal().setConstant(m_);
}

void PointMass::h(double, ConstVec, ConstVec, Vec h) const { h.setZero(); }

void PointMass::moveTangent(ConstVec, double, Block T) const { T.setIdentity(); }

void PointMass::frameStiffness(double, ConstVec, int, const Vec3&, const Vec3&, Block K) const {
  K.setZero();
}

double PointMass::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  double V = 0.0;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    h[at] = m_ * g_I[axes_[i]];
    V -= h[at] * q[at];
  }
  return V;
}

void PointMass::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  out.block = 0;
  out.r_OS_I = r_OS_I_;
  out.A_IK.setIdentity();
  out.v_S_I.setZero(), out.Omega_I.setZero();
  out.nu_S_I.setZero(), out.nu_R_I.setZero();
  out.bias_S_I.setZero(), out.bias_R_I.setZero();
  out.J_S_I.setZero(), out.J_R_I.setZero();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    out.r_OS_I[axes_[i]] = q[at], out.v_S_I[axes_[i]] = u[at];
    out.J_S_I(axes_[i], at) = 1.0;
  }
  shiftFrame(out, parts_.position(id), parts_.axes(id));
}

}  // namespace dynamy
