#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/trees/tree.hpp>

namespace dynamy {
namespace {

using Free = FreeMotion::Kind;

/// A exp(φ a~) for the unit vector a.
Mat3 turned(const Mat3& A, const Vec3& a, double phi) {
  const double c = std::cos(phi), s = std::sin(phi);
  Mat3 R = (1.0 - c) * a * a.transpose();
  R.diagonal().array() += c;
  R(0, 1) -= s * a.z(), R(1, 0) += s * a.z();
  R(0, 2) += s * a.y(), R(2, 0) -= s * a.y();
  R(1, 2) -= s * a.x(), R(2, 1) += s * a.x();
  return A * R;
}

}  // namespace

const Mat3& turnAxes(const Tree::Motions& x, const TreeNode& node) {
  static const Mat3 world = Mat3::Identity();
  return node.parent < 0 ? world : x[static_cast<std::size_t>(node.parent)].A;
}

int Tree::add(TreeNode node) {
  expects(node.parent < size(), "a node comes after its parent");
  node.q0 = nq_, node.u0 = nu_;
  nq_ += node.nq(), nu_ += node.nu();
  nodes_.push_back(node);
  return size() - 1;
}

void Tree::addMass(int k, double m, const Vec3& centre, const Mat3& J) {
  TreeNode& node = nodes_[static_cast<std::size_t>(k)];
  const double sum = node.m + m;
  if (!(sum > 0.0)) return;
  const Vec3 S = (node.m * node.centre + m * centre) / sum;
  const auto moved = [&S](double mass, const Vec3& from) {
    const Vec3 d = from - S;
    return Mat3(mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose()));
  };
  node.J += moved(node.m, node.centre) + J + moved(m, centre);
  node.m = sum, node.centre = S;
}

bool Tree::constantMass() const {
  if (size() <= 1) return size() == 0 || nodes_.front().kind != Free::ball;
  for (const TreeNode& node : nodes_)
    if (node.kind != Free::slide) return false;
  return true;
}

void Tree::pose(const double* q, Motions& out) const {
  const Mat3 none = Mat3::Identity();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const TreeNode& node = nodes_[k];
    const bool root = node.parent < 0;
    const NodeMotion* P = root ? nullptr : &out[static_cast<std::size_t>(node.parent)];
    const Mat3& A_P = root ? none : P->A;
    NodeMotion& x = out[k];
    const double* p = q + node.q0;
    x.d = A_P * node.arm;
    x.a = A_P * node.axis;
    switch (node.kind) {
      case Free::screw:
        x.d += node.pitch * p[0] * x.a;
        [[fallthrough]];
      case Free::turn:
        x.A = turned(A_P, node.axis, p[0]);
        break;
      case Free::slide:
        x.A = A_P, x.d += p[0] * x.a;
        break;
      case Free::ball:
        x.A = A_P * rotationMatrix(p);
        break;
    }
    x.r = root ? x.d : Vec3(P->r + x.d);
    x.mass = node.m, x.moment = node.m * (x.A * node.centre);
  }
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    if (nodes_[k].parent < 0) continue;
    const NodeMotion& x = out[k];
    NodeMotion& P = out[static_cast<std::size_t>(nodes_[k].parent)];
    P.mass += x.mass, P.moment += x.moment + x.mass * x.d;
  }
}

void Tree::rates(const double* u, Motions& out) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const TreeNode& node = nodes_[k];
    NodeMotion& x = out[k];
    const double* w = u + node.u0;
    Vec3 turn = Vec3::Zero(), way = Vec3::Zero();
    switch (node.kind) {
      case Free::screw:
        way = node.pitch * w[0] * x.a;
        [[fallthrough]];
      case Free::turn:
        turn = w[0] * x.a;
        break;
      case Free::slide:
        way = w[0] * x.a;
        break;
      case Free::ball:
        turn = turnAxes(out, node) * Vec3(w[0], w[1], w[2]);
        break;
    }
    if (node.parent < 0) {
      x.Omega = turn, x.v = way;
      x.biasR.setZero(), x.biasS.setZero();
      continue;
    }
    const NodeMotion& P = out[static_cast<std::size_t>(node.parent)];
    const Vec3 drag = P.Omega.cross(x.d);
    x.Omega = P.Omega + turn, x.v = P.v + drag + way;
    x.biasR = P.biasR + P.Omega.cross(turn);
    x.biasS = P.biasS + P.biasR.cross(x.d) + P.Omega.cross(drag + 2.0 * way);
  }
}

Tree::Columns Tree::columns(const Motions& x, int k) const {
  const TreeNode& node = nodes_[static_cast<std::size_t>(k)];
  const NodeMotion& at = x[static_cast<std::size_t>(k)];
  Columns out;
  switch (node.kind) {
    case Free::turn:
      out.w[0] = at.a, out.v[0].setZero();
      break;
    case Free::slide:
      out.w[0].setZero(), out.v[0] = at.a;
      break;
    case Free::screw:
      out.w[0] = at.a, out.v[0] = node.pitch * at.a;
      break;
    case Free::ball:
      out.n = 3;
      for (int i = 0; i < 3; ++i) out.w[i] = turnAxes(x, node).col(i), out.v[i].setZero();
      break;
  }
  return out;
}

void Tree::mass(const Motions& x, std::vector<Mat3>& work, Block M) const {
  // Inertia of all that each node carries, about its origin.
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const TreeNode& node = nodes_[k];
    const Vec3 c = x[k].A * node.centre;
    work[k] = x[k].A * node.J * x[k].A.transpose();
    work[k] += node.m * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
  }
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    if (nodes_[k].parent < 0) continue;
    const Vec3 &d = x[k].d, &s = x[k].moment;
    const Mat3 ds = d * s.transpose();
    Mat3& P = work[static_cast<std::size_t>(nodes_[k].parent)];
    P += work[k] - ds - ds.transpose() - x[k].mass * d * d.transpose();
    P.diagonal().array() += 2.0 * d.dot(s) + x[k].mass * d.squaredNorm();
  }

  // Momentum of unit velocities, projected onto the columns on the way to the root.
  M.setZero();
  for (int k = 0; k < size(); ++k) {
    const Columns own = columns(x, k);
    const NodeMotion& at = x[static_cast<std::size_t>(k)];
    for (int j = 0; j < own.n; ++j) {
      const Vec3 p = at.mass * own.v[j] + own.w[j].cross(at.moment);
      Vec3 L = work[static_cast<std::size_t>(k)] * own.w[j] + at.moment.cross(own.v[j]);
      const int column = node(k).u0 + j;
      for (int i = k; i >= 0; i = node(i).parent) {
        const TreeNode& other = node(i);
        const NodeMotion& of = x[static_cast<std::size_t>(i)];
        double entry[3];
        if (other.kind == Free::ball)
          Eigen::Map<Vec3>{entry} = turnAxes(x, other).transpose() * L;
        else
          entry[0] = other.kind == Free::slide  ? of.a.dot(p)
                     : other.kind == Free::turn ? of.a.dot(L)
                                                : of.a.dot(L + other.pitch * p);
        for (int r = 0; r < other.nu(); ++r)
          M(other.u0 + r, column) = M(column, other.u0 + r) = entry[r];
        L += of.d.cross(p);
      }
    }
    if (own.n == 1) M(node(k).u0, node(k).u0) += node(k).rotor;
  }
}

void Tree::along(const Motions& x, int k, const Vec3& f, const Vec3& n, Vec out) const {
  const TreeNode& of = node(k);
  const NodeMotion& at = x[static_cast<std::size_t>(k)];
  switch (of.kind) {
    case Free::turn:
      out[of.u0] = at.a.dot(n);
      break;
    case Free::slide:
      out[of.u0] = at.a.dot(f);
      break;
    case Free::screw:
      out[of.u0] = at.a.dot(n) + of.pitch * at.a.dot(f);
      break;
    case Free::ball:
      out.segment<3>(of.u0) = turnAxes(x, of).transpose() * n;
      break;
  }
}

void Tree::project(const Motions& x, std::vector<Vec3>& work, Vec out) const {
  for (int k = size() - 1; k >= 0; --k) {
    const auto at = 2 * static_cast<std::size_t>(k);
    along(x, k, work[at], work[at + 1], out);
    if (node(k).parent < 0) continue;
    const auto P = 2 * static_cast<std::size_t>(node(k).parent);
    work[P] += work[at];
    work[P + 1] += work[at + 1] + x[static_cast<std::size_t>(k)].d.cross(work[at]);
  }
}

void Tree::gyroscopic(const Motions& x, std::vector<Vec3>& work, Vec h) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const TreeNode& node = nodes_[k];
    const NodeMotion& at = x[k];
    const Vec3 c = at.A * node.centre;
    const Vec3 a = at.biasS + at.biasR.cross(c) + at.Omega.cross(at.Omega.cross(c));
    const Vec3 Omega_K = at.A.transpose() * at.Omega, beta_K = at.A.transpose() * at.biasR;
    work[2 * k] = -node.m * a;
    work[2 * k + 1] =
        c.cross(work[2 * k]) - at.A * (node.J * beta_K + Omega_K.cross(node.J * Omega_K));
  }
  project(x, work, h);
}

double Tree::gravity(const Motions& x, const Vec3& g_I, Vec h) const {
  double V = 0.0;
  for (int k = 0; k < size(); ++k) {
    const NodeMotion& at = x[static_cast<std::size_t>(k)];
    const Vec3 f = at.mass * g_I, n = at.moment.cross(g_I);
    along(x, k, f, n, h);
    if (node(k).parent < 0) V -= g_I.dot(at.moment + at.mass * at.r);
  }
  return V;
}

}  // namespace dynamy
