// M⁻¹ of a tree by articulated bodies: from the leaves to the roots, at every node with columns
// S = (v, w) and the inertia (m, C, I) of all that hangs on it,
//
//   U = I_A S,  D = Sᵀ U,  I_A ← I_A − U D⁻¹ Uᵀ,  moved to the parent's origin and added there
//   out = D⁻¹ (in − Sᵀ p − Uᵀ a_P),  p the forces that are left for the parent, a_P its
//   acceleration
#include <Eigen/LU>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/trees/tree.hpp>

namespace dynamy {

void Tree::factor(const Motions& x, std::vector<Articulated>& out) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const TreeNode& node = nodes_[k];
    const Vec3 c = x[k].A * node.centre;
    Articulated& a = out[k];
    a.m = node.m * Mat3::Identity();
    a.C = -node.m * skew(c);
    a.I = x[k].A * node.J * x[k].A.transpose() +
          node.m * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
  }
  for (int k = size() - 1; k >= 0; --k) {
    Articulated& a = out[static_cast<std::size_t>(k)];
    const Columns s = columns(x, k);
    Mat3 D = Mat3::Identity();
    for (int j = 0; j < s.n; ++j) {
      a.Uf[j] = a.m * s.v[j] + a.C * s.w[j];
      a.Un[j] = a.C.transpose() * s.v[j] + a.I * s.w[j];
    }
    for (int i = 0; i < s.n; ++i)
      for (int j = 0; j < s.n; ++j) D(i, j) = s.v[i].dot(a.Uf[j]) + s.w[i].dot(a.Un[j]);
    if (s.n == 1)
      a.inverse(0, 0) = 1.0 / D(0, 0);
    else
      a.inverse = D.inverse();
    const int parent = node(k).parent;
    if (parent < 0) continue;

    // What is left once the node follows, at the parent's origin: d × on both sides.
    Mat3 m = a.m, C = a.C, I = a.I;
    for (int j = 0; j < s.n; ++j) {
      Vec3 f = Vec3::Zero(), n = Vec3::Zero();
      for (int i = 0; i < s.n; ++i) f += a.inverse(j, i) * a.Uf[i], n += a.inverse(j, i) * a.Un[i];
      m -= a.Uf[j] * f.transpose();
      C -= a.Uf[j] * n.transpose();
      I -= a.Un[j] * n.transpose();
    }
    Articulated& P = out[static_cast<std::size_t>(parent)];
    const Mat3 d = skew(x[static_cast<std::size_t>(k)].d);
    const Mat3 CtD = C.transpose() * d;
    P.m += m;
    P.C += C - m * d;
    P.I += I - CtD - CtD.transpose() - d * m * d;
  }
}

void Tree::solve(const Motions& x, const std::vector<Articulated>& factors, ConstVec in,
                 std::vector<Vec3>& work, Vec out) const {
  // Forces p = (f, n) from the leaves to the roots; `out` holds in − Sᵀ p until the way back.
  for (Vec3& w : work) w.setZero();
  for (int k = size() - 1; k >= 0; --k) {
    const auto at = static_cast<std::size_t>(k);
    const Articulated& a = factors[at];
    const Columns s = columns(x, k);
    Vec3 f = work[2 * at], n = work[2 * at + 1];
    double left[3];
    for (int j = 0; j < s.n; ++j) {
      const int u = node(k).u0 + j;
      left[j] = out[u] = in[u] - s.v[j].dot(f) - s.w[j].dot(n);
    }
    if (node(k).parent < 0) continue;
    for (int j = 0; j < s.n; ++j) {
      double r = 0.0;
      for (int i = 0; i < s.n; ++i) r += a.inverse(j, i) * left[i];
      f += r * a.Uf[j], n += r * a.Un[j];
    }
    const auto P = 2 * static_cast<std::size_t>(node(k).parent);
    work[P] += f, work[P + 1] += n + x[at].d.cross(f);
  }
  // Accelerations (a, α) from the roots to the leaves.
  for (std::size_t at = 0; at < nodes_.size(); ++at) {
    const int k = static_cast<int>(at), parent = node(k).parent;
    const Articulated& a = factors[at];
    const Columns s = columns(x, k);
    Vec3 acceleration = Vec3::Zero(), alpha = Vec3::Zero();
    if (parent >= 0) {
      const auto P = 2 * static_cast<std::size_t>(parent);
      alpha = work[P + 1], acceleration = work[P] + alpha.cross(x[at].d);
    }
    double right[3];
    for (int j = 0; j < s.n; ++j)
      right[j] = out[node(k).u0 + j] - a.Uf[j].dot(acceleration) - a.Un[j].dot(alpha);
    for (int j = 0; j < s.n; ++j) {
      double r = 0.0;
      for (int i = 0; i < s.n; ++i) r += a.inverse(j, i) * right[i];
      out[node(k).u0 + j] = r;
    }
    for (int j = 0; j < s.n; ++j) {
      const double r = out[node(k).u0 + j];
      acceleration += r * s.v[j], alpha += r * s.w[j];
    }
    work[2 * at] = acceleration, work[2 * at + 1] = alpha;
  }
}

}  // namespace dynamy
