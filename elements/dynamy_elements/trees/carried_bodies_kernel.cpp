#include <algorithm>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>
#include <dynamy_elements/trees/carried_bodies.hpp>

namespace dynamy {

using Free = FreeMotion::Kind;

RigidMotion CarriedBodies::motion(const TreeBody& body, const double* q,
                                  const Tree::Motions& x) const {
  RigidMotion out;
  if (body.node < 0) {
    out.r_OS_I = body.S;
    return out;
  }
  const NodeMotion& node = x[static_cast<std::size_t>(body.node)];
  const Vec3 rho = node.A * body.S;
  out.r_OS_I = node.r + rho;
  out.v_S_I = node.v + node.Omega.cross(rho), out.Omega_I = node.Omega;
  for (int k = body.node; k >= 0; k = tree_.node(k).parent) {
    const TreeNode& n = tree_.node(k);
    const double* at = q + n.q0;
    if (n.kind == Free::slide) continue;
    double turn[4], product[4];
    if (n.kind == Free::ball)
      std::copy(at, at + 4, turn);
    else
      axisQuaternion(n.axis, *at, turn), out.angle += n.axis.dot(planeNormal_) * *at;
    quaternionProduct(turn, out.p.data(), product);
    std::copy(product, product + 4, out.p.begin());
  }
  return out;
}

void CarriedBodies::ownState(int i, ConstVec q, ConstVec u, Vec qOwn, Vec uOwn) const {
  const TreeBody& body = bodies_[static_cast<std::size_t>(i)];
  body.system->abilities().rigid->ownState(motion(body, q.data(), results_.at(tree_, q, u)), qOwn,
                                           uOwn);
}

void CarriedBodies::ownVelocities(int i, ConstVec q, ConstVec u, Block J, Vec bias) const {
  const TreeBody& body = bodies_[static_cast<std::size_t>(i)];
  J.setZero(), bias.setZero();
  if (body.node < 0) return;
  const Tree::Motions& x = results_.at(tree_, q, u);
  const NodeMotion& node = x[static_cast<std::size_t>(body.node)];
  RigidMotion moved = motion(body, q.data(), x);
  const Vec3 rho = node.A * body.S;
  // Own velocities are linear in those of the body; (39.2) gives the part of their rates without u̇.
  std::array<double, kMostOwn> own{};
  const Vec qOwn(own.data(), body.blocks.nq);
  moved.v_S_I = node.biasS + node.biasR.cross(rho) + node.Omega.cross(node.Omega.cross(rho));
  moved.Omega_I = node.biasR;
  body.system->abilities().rigid->ownState(moved, qOwn, bias);
  std::vector<double> columns(static_cast<std::size_t>(6 * tree_.nu()), 0.0);
  Frame f;
  new (&f.J_S_I) Mat3X(columns.data(), 3, tree_.nu());
  new (&f.J_R_I) Mat3X(columns.data() + 3 * tree_.nu(), 3, tree_.nu());
  f.r_OS_I = node.r + rho;
  for (int k = body.node; k >= 0; k = tree_.node(k).parent)
    addColumns(x, tree_.node(k), x[static_cast<std::size_t>(k)], f);
  Eigen::VectorXd column(body.blocks.nu);
  for (int j = 0; j < tree_.nu(); ++j) {
    moved.v_S_I = f.J_S_I.col(j), moved.Omega_I = f.J_R_I.col(j);
    body.system->abilities().rigid->ownState(moved, qOwn, view(column));
    J.col(j) = column;
  }
}

double CarriedBodies::signal(const TreeBody& body, const SignalFunction& f,
                             const SignalView& v) const {
  const Tree::Motions& x = results_.at(tree_, v.q, v.u);
  const Vec q(shown_.q.data(), body.blocks.nq), u(shown_.u.data(), body.blocks.nu);
  if (shown_.body != &body || shown_.changes != results_.changes()) {
    body.system->abilities().rigid->ownState(motion(body, v.q.data(), x), q, u);
    shown_.body = &body, shown_.changes = results_.changes();
  }
  return f({.t = v.t,
            .q = {q.data(), q.size()},
            .u = {u.data(), u.size()},
            .kinematics = v.kinematics,
            .contacts = v.contacts,
            .Lambda = v.Lambda,
            .gammaE = v.gammaE,
            .stepContacts = v.stepContacts,
            .stepLambda = v.stepLambda,
            .memory = v.memory,
            .dt = v.dt,
            .element = v.element});
}

void addColumns(const Tree::Motions& x, const TreeNode& node, const NodeMotion& at, Frame& f) {
  const Vec3 arm = f.r_OS_I - at.r;
  double *S = f.J_S_I.data() + 3 * node.u0, *R = f.J_R_I.data() + 3 * node.u0;
  using Column = Eigen::Map<Vec3>;
  switch (node.kind) {
    case Free::turn:
      Column{R} = at.a, Column{S} = at.a.cross(arm);
      break;
    case Free::slide:
      Column{R}.setZero(), Column{S} = at.a;
      break;
    case Free::screw:
      Column{R} = at.a, Column{S} = at.a.cross(arm) + node.pitch * at.a;
      break;
    case Free::ball:
      for (int i = 0; i < 3; ++i) {
        const Vec3 axis = turnAxes(x, node).col(i);
        Column{R + 3 * i} = axis, Column{S + 3 * i} = axis.cross(arm);
      }
      break;
  }
}

}  // namespace dynamy
