// M⁻¹ of a tree by articulated bodies. From the leaves to the roots, each node has the columns
// S = (v, w) and the inertia (m, C, I) of all that it carries:
//
//   U = I_A S,  D = Sᵀ U,  I_A ← I_A − U D⁻¹ Uᵀ,  moved to the parent's origin and added there
//   out = D⁻¹ (in − Sᵀ p − Uᵀ a_P),  p the forces left for the parent, a_P its acceleration
//
// A ball joint transmits no moment: only m − C I⁻¹ Cᵀ remains for the parent, and
// the node's own acceleration is α = I⁻¹ (A (in − Sᵀ p) − Cᵀ a). This explicit
// form takes a fifth of the operations.
#include <Eigen/LU>
#include <dynamy_elements/trees/tree.hpp>

namespace dynamy {
namespace {

using FreeBlock = FreeMotion::Kind;

/// X d~ and d~ X, d~ y = d × y.
Mat3 timesSkew(const Mat3& X, const Vec3& d) {
  Mat3 out;
  for (int i = 0; i < 3; ++i) out.row(i) = Vec3(X.row(i)).cross(d);
  return out;
}
Mat3 skewTimes(const Vec3& d, const Mat3& X) {
  Mat3 out;
  for (int j = 0; j < 3; ++j) out.col(j) = d.cross(X.col(j));
  return out;
}

/// The inertia of the bodies that are fixed to the node itself.
void own(const TreeNode& node, const NodeMotion& x, Tree::Articulated& out) {
  out.m.setZero(), out.C.setZero(), out.I.setZero();
  if (node.m == 0.0 && node.J.isZero(0.0)) return;
  const Vec3 c = x.A * node.centre, mc = node.m * c;
  out.m.diagonal().setConstant(node.m);
  out.C << 0.0, mc.z(), -mc.y(), -mc.z(), 0.0, mc.x(), mc.y(), -mc.x(), 0.0;  // −m c~
  const Mat3 AJ = x.A * node.J;
  out.I.noalias() = AJ * x.A.transpose();
  out.I.noalias() -= mc * c.transpose();
  out.I.diagonal().array() += mc.dot(c);
}

/// Computes U, 1/D and the remaining (m, C, I) once the one motion of the node follows freely.
void follow(const TreeNode& node, const Vec3& axis, Tree::Articulated& a) {
  switch (node.kind) {
    case FreeBlock::slide:
      a.Uf = a.m * axis, a.Un = a.C.transpose() * axis;
      a.inverse = 1.0 / (axis.dot(a.Uf) + node.rotor);
      break;
    case FreeBlock::screw: {
      const Vec3 v = node.pitch * axis;
      a.Uf = a.m * v + a.C * axis, a.Un = a.C.transpose() * v + a.I * axis;
      a.inverse = 1.0 / (v.dot(a.Uf) + axis.dot(a.Un));
      break;
    }
    default:
      a.Uf = a.C * axis, a.Un = a.I * axis;
      a.inverse = 1.0 / (axis.dot(a.Un) + node.rotor);
  }
}

}  // namespace

void Tree::factor(const Motions& x, std::vector<Articulated>& out) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) own(nodes_[k], x[k], out[k]);
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const TreeNode& node = nodes_[k];
    Articulated& a = out[k];
    const bool ball = node.kind == FreeBlock::ball;
    if (ball)
      a.inverseOfI = a.I.inverse();
    else
      follow(node, x[k].a, a);
    if (node.parent < 0) continue;
    // The remaining inertia is moved to the parent's origin: d × on both sides.
    Articulated& P = out[static_cast<std::size_t>(node.parent)];
    const Vec3& d = x[k].d;
    if (ball) {
      const Mat3 CI = a.C * a.inverseOfI;
      Mat3 m = a.m;
      m.noalias() -= CI * a.C.transpose();
      const Mat3 md = timesSkew(m, d);
      P.m += m, P.C -= md, P.I -= skewTimes(d, md);
      continue;
    }
    const Vec3 f = a.inverse * a.Uf, n = a.inverse * a.Un;
    const Mat3 m = a.m - a.Uf * f.transpose(), C = a.C - a.Uf * n.transpose();
    const Mat3 md = timesSkew(m, d), CtD = timesSkew(C.transpose(), d);
    P.m += m;
    P.C += C - md;
    P.I += a.I - a.Un * n.transpose() - CtD - CtD.transpose() - skewTimes(d, md);
  }
}

void Tree::solve(const Motions& x, const std::vector<Articulated>& factors, ConstVec in,
                 std::vector<Vec3>& work, Vec out) const {
  // Forces p = (f, n) from the leaves to the roots; `out` holds in − Sᵀ p until the way back.
  for (Vec3& w : work) w.setZero();
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const TreeNode& node = nodes_[k];
    const Articulated& a = factors[k];
    Vec3 f = work[2 * k], n = work[2 * k + 1];
    if (node.kind == FreeBlock::ball) {
      const Mat3& axes = turnAxes(x, node);
      const Vec3 left = in.segment<3>(node.u0) - axes.transpose() * n;
      out.segment<3>(node.u0) = left;
      if (node.parent < 0) continue;
      const Vec3 moment = axes * left;
      f += a.C * (a.inverseOfI * moment), n += moment;
    } else {
      const Vec3& axis = x[k].a;
      double left = in[node.u0];
      if (node.kind != FreeBlock::slide) left -= axis.dot(n);
      if (node.kind == FreeBlock::slide) left -= axis.dot(f);
      if (node.kind == FreeBlock::screw) left -= node.pitch * axis.dot(f);
      out[node.u0] = left;
      if (node.parent < 0) continue;
      const double r = a.inverse * left;
      f += r * a.Uf, n += r * a.Un;
    }
    const auto P = 2 * static_cast<std::size_t>(node.parent);
    work[P] += f, work[P + 1] += n + x[k].d.cross(f);
  }
  // Accelerations (a, α) from the roots to the leaves.
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const TreeNode& node = nodes_[k];
    const Articulated& a = factors[k];
    Vec3 acceleration = Vec3::Zero(), alpha = Vec3::Zero();
    if (node.parent >= 0) {
      const auto P = 2 * static_cast<std::size_t>(node.parent);
      alpha = work[P + 1], acceleration = work[P] + alpha.cross(x[k].d);
    }
    if (node.kind == FreeBlock::ball) {
      const Mat3& axes = turnAxes(x, node);
      const Vec3 left = axes * Vec3(out.segment<3>(node.u0));
      const Vec3 turn = a.inverseOfI * (left - a.C.transpose() * acceleration);
      out.segment<3>(node.u0) = axes.transpose() * (turn - alpha);
      alpha = turn;
    } else {
      const double r = a.inverse * (out[node.u0] - a.Uf.dot(acceleration) - a.Un.dot(alpha));
      out[node.u0] = r;
      if (node.kind != FreeBlock::slide) alpha += r * x[k].a;
      if (node.kind == FreeBlock::slide) acceleration += r * x[k].a;
      if (node.kind == FreeBlock::screw) acceleration += r * node.pitch * x[k].a;
    }
    work[2 * k] = acceleration, work[2 * k + 1] = alpha;
  }
}

}  // namespace dynamy
