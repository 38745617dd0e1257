#include <algorithm>
#include <dynamy/schemes/joints/joint_tangent.hpp>
#include <dynamy/system/position_tangents.hpp>

namespace dynamy {

bool JointTangent::begin(const MechanicalSystem& s, const State& midpoint, const Eigen::VectorXd& v,
                         double dt) {
  for (const ExternalForce* f : s.parts().forces)
    if (f->stiff()) return false;
  const Topology& topology = *s.parts().topology;
  dt_ = dt, v_ = &v;
  blocks_.resize(static_cast<std::size_t>(topology.blocks()));
  double T[36], K[36], D[36];
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& h = topology.system(static_cast<int>(i));
    if (h.nu == 0) continue;
    const PartialMechanicalSystem& system = *topology.systems()[i];
    if (h.blocks != 1 || h.nu > 6 || !system.blocks().constantMass) return false;
    BlockTangent& b = blocks_[h.block0];
    const ConstVec q = slice(midpoint.q, h.q0, h.nq), u = slice(v, h.u0, h.nu);
    const Block Tb(T, h.nu, h.nu), Kb(K, h.nu, h.nu), Db(D, h.nu, h.nu);
    b.system = system.abilities().positionTangents;
    if (!b.system) return false;
    b.system->moveTangent(u, 0.5 * dt, Tb);
    b.half.topLeftCorner(h.nu, h.nu) = Tb;
    b.system->moveTangent(u, dt, Tb);
    b.whole.topLeftCorner(h.nu, h.nu) = Tb;
    auto own = b.K.topLeftCorner(h.nu, h.nu);
    own = 2.0 * s.slot(0).mass.M(h.block0);
    if (system.dh(midpoint.t, q, u, 0, Kb, Db))
      own -= dt * Db + 0.5 * dt * dt * Kb.lazyProduct(b.half.topLeftCorner(h.nu, h.nu));
  }
  return true;
}

bool JointTangent::joint(const MechanicalSystem& s, int i, int iEnd, const double* Lambda,
                         const double* gRate, double leastTwiceT) {
  const Evaluation& e = s.slot(0);
  const ContactSet& c = e.contacts;
  const NonSmoothElement& element = *s.parts().contacts[c.element[i]];
  if (!element.jointForces(e.kinematics, contactNumber(c.key[i]), Lambda, forces_)) return false;
  if (!findSides(e, s.slot(1).contacts, i, iEnd, Lambda)) return false;
  turn(s);
  double power = 0.0;
  for (int r = 0; r < c.dim(i); ++r) power += Lambda[r] * (c.chi[c.row0[i] + r] - gRate[r]);
  addQuotient(s, power, leastTwiceT);
  return true;
}

/// Finds the sides that move, in the order of their segments; W, W_E, and the terms that depend on
/// these alone.
bool JointTangent::findSides(const Evaluation& e, const ContactSet& atEnd, int i, int iEnd,
                             const double* Lambda) {
  const ContactSet& c = e.contacts;
  const int rows = c.dim(i);
  sides_ = 0;
  if (rows > 6 || atEnd.dim(iEnd) != rows) return false;
  for (int n = 0; n < 2; ++n) {
    const Frame& f = e.kinematics.frame(forces_.frame[n]);
    if (f.block < 0) continue;
    const int m = c.segment0[i] + sides_, mEnd = atEnd.segment0[iEnd] + sides_;
    if (m == c.segment0[i + 1] || c.segment[m].block != f.block) return false;
    if (sides_ == 1 && side_[0].block == f.block) return false;
    Side& x = side_[sides_++];
    const int nu = f.nu(), u0 = f.u0;
    x.number = n, x.block = f.block, x.nu = nu;
    x.J.setZero(), x.W.setZero(), x.v.setZero(), x.momentum.setZero(), x.gap.setZero();
    x.J.topLeftCorner(3, nu) = f.J_S_I, x.J.bottomLeftCorner(3, nu) = f.J_R_I;
    x.v.head(nu) = v_->segment(u0, nu);
    x.momentum.head(nu) = e.mass.M(f.block).lazyProduct(x.v.head(nu));
    const double* W = c.W.data() + c.segment[m].w;
    const double* WEnd = atEnd.W.data() + atEnd.segment[mEnd].w;
    Matrix6 atE = Matrix6::Zero();
    Vector6 WLambdaEnd = Vector6::Zero();
    for (int r = 0; r < rows; ++r)
      for (int j = 0; j < nu; ++j) {
        x.W[j] += W[r * nu + j] * Lambda[r], WLambdaEnd[j] += WEnd[r * nu + j] * Lambda[r];
        atE(r, j) = WEnd[r * nu + j];
      }
    const Matrix6& T = blocks_[f.block].whole;
    x.gap = atE.lazyProduct(T);
    x.powerByV = x.W - T.transpose().lazyProduct(WLambdaEnd);
  }
  return true;
}

/// Computes ∂(WΛ)_a/∂v_b, and its share in ∂p/∂v_b.
void JointTangent::turn(const MechanicalSystem& s) {
  const Topology& topology = *s.parts().topology;
  const Kinematics& k = s.slot(0).kinematics;
  for (int b = 0; b < sides_; ++b) {
    Side& y = side_[b];
    for (int a = 0; a < sides_; ++a) {
      const Side& x = side_[a];
      const Matrix6 DJ = forces_.D.block<6, 6>(6 * x.number, 6 * y.number).lazyProduct(y.J);
      Matrix6 G = x.J.transpose().lazyProduct(DJ);
      if (a == b) {
        const auto& [system, id] = topology.requestedFrames()[forces_.frame[x.number].index];
        double S[36];
        const Block stiffness(S, x.nu, x.nu);
        blocks_[x.block].system->frameStiffness(k.t(), k.q(topology.system(system)), id,
                                                forces_.F[x.number], forces_.M[x.number],
                                                stiffness);
        G.topLeftCorner(x.nu, x.nu) += stiffness;
      }
      force_[a][b] = 0.5 * dt_ * G.lazyProduct(blocks_[y.block].half);
      y.powerByV += force_[a][b].transpose().lazyProduct(x.v);
    }
  }
}

/// Adds −∂(p/s Mv)/∂v: the derivatives of p, of Mv, and of 1/s.
void JointTangent::addQuotient(const MechanicalSystem& s, double power, double leastTwiceT) {
  double twiceT = 0.0;
  for (int a = 0; a < sides_; ++a)
    power += side_[a].v.dot(side_[a].W), twiceT += side_[a].v.dot(side_[a].momentum);
  // At rest the denominator is a constant.
  const double ofT = twiceT > leastTwiceT ? 2.0 : 0.0;
  twiceT = std::max(twiceT, leastTwiceT);
  if (!(twiceT > 0.0)) return;
  const double share = power / twiceT;
  for (int a = 0; a < sides_; ++a) {
    const Side& x = side_[a];
    for (int b = 0; b < sides_; ++b) {
      const Side& y = side_[b];
      force_[a][b] -= x.momentum * (y.powerByV - ofT * share * y.momentum).transpose() / twiceT;
    }
    force_[a][a].topLeftCorner(x.nu, x.nu) -= share * s.slot(0).mass.M(x.block);
  }
}

}  // namespace dynamy
