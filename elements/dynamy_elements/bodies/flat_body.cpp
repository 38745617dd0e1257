#include <array>
#include <dynamy/core/rotation.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy_elements/bodies/flat_body.hpp>

namespace dynamy {

FlatBody::FlatBody(const Parameters& x, std::unique_ptr<PartialMechanicalSystem> body,
                   const Plane& plane)
    : PartialMechanicalSystem(x),
      body_(std::move(body)),
      plane_(plane),
      part_(body_->abilities().rigid->rigidPart()),
      own_(body_->blocks()) {
  expects(own_.nq <= kMostOwn && own_.nu <= kMostOwn, "a rigid body has few coordinates");
  Eigen::VectorXd q(own_.nq), u(own_.nu);
  body_->initialState(view(q), view(u));
  std::vector<double> jacobians(static_cast<std::size_t>(6 * own_.nu));
  for (int id = 0; id < body_->frames(); ++id) {
    Frame f;
    new (&f.J_S_I) Mat3X(jacobians.data(), 3, own_.nu);
    new (&f.J_R_I) Mat3X(jacobians.data() + 3 * own_.nu, 3, own_.nu);
    body_->frame(0.0, view(std::as_const(q)), view(std::as_const(u)), id, f);
    if (id == 0) {
      const Vec3 rho = f.A_IK * part_.r_BS_K, n = f.A_IK.transpose() * plane_.n;
      S_ = f.r_OS_I + rho, v_ = f.velocity(rho), Omega_ = f.Omega_I;
      J_ = n.dot(part_.J_S_K * n);
    }
    frames_.push_back({f.r_OS_I - S_, f.A_IK});
  }
}

Mat3 FlatBody::turn(double phi) const {
  double p[4];
  axisQuaternion(plane_.n, phi, p);
  return rotationMatrix(p);
}

RigidMotion FlatBody::motion(ConstVec q, ConstVec u) const {
  RigidMotion out;
  out.r_OS_I = S_;
  out.r_OS_I[plane_.a] = q[0], out.r_OS_I[plane_.b] = q[1];
  axisQuaternion(plane_.n, q[2], out.p.data());
  out.angle = q[2];
  out.v_S_I = u[0] * plane_.e1 + u[1] * plane_.e2;
  out.Omega_I = u[2] * plane_.n;
  return out;
}

double FlatBody::signal(const SignalFunction& f, const SignalView& v) const {
  const std::array<double, 6> at{v.q[0], v.q[1], v.q[2], v.u[0], v.u[1], v.u[2]};
  if (shown_.at != at) {
    shown_.at = at;
    body_->abilities().rigid->ownState(motion(v.q, v.u), {shown_.q.data(), own_.nq},
                                       {shown_.u.data(), own_.nu});
  }
  SignalView own = v;
  new (&own.q) ConstVec(shown_.q.data(), own_.nq);
  new (&own.u) ConstVec(shown_.u.data(), own_.nu);
  return f(own);
}

void FlatBody::describe(Description& d) const {
  Description own;
  body_->describe(own);
  d.timeless = own.timeless;
  d.shapes = own.shapes, d.links = own.links, d.frames = own.frames;
  for (Signal& s : own.signals) {
    s.value = [this, f = std::move(s.value)](const SignalView& v) { return signal(f, v); };
    d.signals.push_back(std::move(s));
  }
  const std::string first{plane_.first}, second{plane_.second};
  d.coordinates = {{first, 0}, {second, 1}};
  d.velocities = {{"v" + first, 0}, {"v" + second, 1}};
}

void FlatBody::initialState(Vec q, Vec u) const {
  q << S_[plane_.a], S_[plane_.b], 0.0;
  u << v_[plane_.a], v_[plane_.b], Omega_.dot(plane_.n);
}

void FlatBody::M(double, ConstVec, MassBlocks M) const {
  Block block = M[0];
  block.setZero();
  block.diagonal() << part_.m, part_.m, J_;
}

void FlatBody::h(double, ConstVec, ConstVec, Vec h) const { h.setZero(); }

double FlatBody::gravity(double, ConstVec q, const Vec3& g_I, Vec h) const {
  h << part_.m * g_I[plane_.a], part_.m * g_I[plane_.b], 0.0;
  return -part_.m *
         (g_I[plane_.a] * q[0] + g_I[plane_.b] * q[1] + g_I[plane_.rest()] * S_[plane_.rest()]);
}

void FlatBody::ownState(const RigidMotion& motion, Vec q, Vec u) const {
  q << motion.r_OS_I[plane_.a], motion.r_OS_I[plane_.b], motion.angle;
  u << motion.v_S_I[plane_.a], motion.v_S_I[plane_.b], motion.Omega_I.dot(plane_.n);
}

void FlatBody::frameStiffness(double, ConstVec q, int id, const Vec3& F_I, const Vec3&,
                              Block K) const {
  turningArm(plane_, turn(q[2]) * frames_[static_cast<std::size_t>(id)].rho, F_I, K);
}

void FlatBody::frame(double, ConstVec q, ConstVec u, int id, Frame& out) const {
  const Fixed& fixed = frames_[static_cast<std::size_t>(id)];
  placeInPlane(plane_, q, u, S_[plane_.rest()], turn(q[2]), out);
  shiftFrame(out, out.A_IK * fixed.rho, fixed.A);
}

}  // namespace dynamy
