#include <algorithm>
#include <cmath>
#include <dynamy/schemes/joints/joint_newton.hpp>

namespace dynamy {
namespace {

/// Change of positions for the differences of K [m, rad]: truncation and rounding balance near the
/// square root of 2e-16.
constexpr double kTangentDifference = 1e-7;
/// Share of a joint's own stiffness on the diagonal of its rows. It makes K regular with redundant
/// joints; Newton's residual does not contain it.
constexpr double kRegular = 1e-10;

bool massDependsOnPosition(const Topology& topology) {
  return std::any_of(topology.systems().begin(), topology.systems().end(), [](const auto* system) {
    const Blocks blocks = system->blocks();
    return blocks.nu > 0 && !blocks.constantMass;
  });
}

}  // namespace

void JointNewton::findJoints(const ContactSet& c, std::vector<int>& out) const {
  out.clear();
  for (int i = 0; i < c.size(); ++i)
    if (!c.law[i]->unilateral() && c.law[i]->rowKind(0) == RowKind::joint) out.push_back(i);
}

bool JointNewton::begin(MechanicalSystem& s, const State& x, double dt) {
  xA_ = &x, dt_ = dt;
  const bool coupled = damped_.begin(s, x, dt);
  const ContactSet& c = s.slot(0).contacts;
  findJoints(c, joints_);
  if (joints_.empty() && !massDependsOnPosition(*s.parts().topology)) {
    s.release();
    return false;
  }
  bool same = !blockNu_.empty() && !coupled && keys_.size() == joints_.size();
  for (std::size_t k = 0; same && k < joints_.size(); ++k) same = keys_[k] == c.key[joints_[k]];
  if (!same) connect(s, c);
  elements_.assign(s.parts().contacts.size(), 0);
  for (const int i : joints_) elements_[c.element[i]] = 1;
  for (std::size_t k = 0; k < joints_.size(); ++k)
    for (int r = 0; r < c.dim(joints_[k]); ++r)
      gA_[jointRow_[k] + r] = c.position[c.row0[joints_[k]] + r];
  v = x.u;
  std::fill(Lambda.begin(), Lambda.end(), 0.0);
  const RememberedImpulses& old = x.impulses;
  for (std::size_t k = 0; k < joints_.size() && old.dt > 0.0; ++k) {
    const auto found = std::find(old.key.begin(), old.key.end(), keys_[k]);
    if (found == old.key.end()) continue;
    const auto i = static_cast<std::size_t>(found - old.key.begin());
    if (old.first[i + 1] - old.first[i] != c.dim(joints_[k])) continue;
    for (int r = 0; r < c.dim(joints_[k]); ++r)
      Lambda[jointRow_[k] + r] = dt / old.dt * old.Lambda[old.first[i] + r];
  }
  return true;
}

void JointNewton::connect(const MechanicalSystem& s, const ContactSet& c) {
  const MassMatrix& mass = s.slot(0).mass;
  const int blocks = mass.blocks(), joints = static_cast<int>(joints_.size());
  keys_.clear(), jointRow_.assign(1, 0), blockU0_.clear(), blockNu_.clear(), mostNu_ = 0;
  for (int b = 0; b < blocks; ++b) {
    blockU0_.push_back(mass.u0(b)), blockNu_.push_back(mass.nu(b));
    mostNu_ = std::max(mostNu_, mass.nu(b));
  }
  // Nodes are blocks, then joints; a joint makes its blocks neighbours of each other.
  std::vector<int> jointRows;
  std::vector<std::vector<int>> near(static_cast<std::size_t>(blocks + joints));
  nearBlocks_.assign(static_cast<std::size_t>(blocks), {}),
      nearJoints_.assign(static_cast<std::size_t>(blocks), {});
  for (int b = 0; b < blocks; ++b) nearBlocks_[b].push_back(b);
  for (int k = 0; k < joints; ++k) {
    const int i = joints_[k];
    keys_.push_back(c.key[i]);
    jointRows.push_back(c.dim(i)), jointRow_.push_back(jointRow_.back() + c.dim(i));
    std::vector<int> of;
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) of.push_back(c.segment[m].block);
    for (const int b : of) {
      near[b].push_back(blocks + k), near[blocks + k].push_back(b);
      nearJoints_[b].push_back(k);
      for (const int other : of)
        if (other != b) near[b].push_back(other), nearBlocks_[b].push_back(other);
    }
  }
  for (const auto& [a, b] : damped_.pairs()) near[a].push_back(b), nearBlocks_[a].push_back(b);
  for (std::vector<int>& list : nearBlocks_) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  Lambda.assign(static_cast<std::size_t>(jointRow_.back()), 0.0), dLambda = Lambda, Rg_ = Lambda,
                                                                  g0_ = Lambda;
  gA_ = Lambda, gRate_ = Lambda, gRate0_ = Lambda;
  walk_.order(near, blockNu_, jointRows), colour();
  work_.resize(static_cast<std::size_t>(unknowns()));
}

void JointNewton::colour() {
  // No two blocks of a colour have a common neighbour.
  const int blocks = static_cast<int>(blockNu_.size());
  colour_.assign(static_cast<std::size_t>(blocks), -1), colours_ = 0;
  for (int b = 0; b < blocks; ++b) {
    std::vector<bool> used(static_cast<std::size_t>(blocks) + 1, false);
    for (const int a : nearBlocks_[b])
      for (const int o : nearBlocks_[a])
        if (colour_[o] >= 0) used[colour_[o]] = true;
    int c = 0;
    while (used[c]) ++c;
    colour_[b] = c;
    colours_ = std::max(colours_, c + 1);
  }
}

void JointNewton::jointForces(const Evaluation& e, Eigen::VectorXd& out) {
  const ContactSet& c = e.contacts;
  out.setZero();
  e.mass.apply(view(std::as_const(v)), view(momentum_));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const int i = joints_[k], dim = c.dim(i);
    const double* lambda = Lambda.data() + jointRow_[k];
    double power = 0.0, twiceT = 0.0;
    for (int r = 0; r < dim; ++r)
      power += lambda[r] * (c.chi[c.row0[i] + r] - gRate_[jointRow_[k] + r]);
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
      const Segment& seg = c.segment[m];
      for (int j = 0; j < seg.nu; ++j) twiceT += v[seg.u0 + j] * momentum_[seg.u0 + j];
      const double* w = c.W.data() + seg.w;
      for (int r = 0; r < dim; ++r, w += seg.nu)
        for (int j = 0; j < seg.nu; ++j) {
          const double f = lambda[r] * w[j];
          out[seg.u0 + j] += f, power += f * v[seg.u0 + j];
        }
    }
    if (!(twiceT > 0.0)) continue;
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
      const Segment& seg = c.segment[m];
      for (int j = 0; j < seg.nu; ++j) out[seg.u0 + j] -= power / twiceT * momentum_[seg.u0 + j];
    }
  }
}

void JointNewton::residual(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                           Search search) {
  const Eigen::Index nu = v.size();
  momentum_.resize(nu), force_.resize(nu), uE_.resize(nu), Rv_.resize(nu);
  midpoint.t = end.t = xA_->t;
  midpoint.q = end.q = xA_->q;
  midpoint.memory = end.memory = xA_->memory;
  s.move(midpoint, v, 0.5 * dt_), s.move(end, v, dt_);
  midpoint.u = v, end.u = 2.0 * v - xA_->u;
  const Evaluation& e = search == Search::all ? s.evaluateAhead(midpoint, dt_, 0)
                                              : s.evaluateOf(elements_, midpoint, 0);
  const ContactSet& atEnd = s.evaluateOf(elements_, end, 1).contacts;
  findJoints(e.contacts, joints_), findJoints(atEnd, endJoints_);
  for (std::size_t k = 0; k < endJoints_.size(); ++k)
    for (int r = 0; r < atEnd.dim(endJoints_[k]); ++r) {
      const std::size_t row = static_cast<std::size_t>(jointRow_[k] + r);
      Rg_[row] = atEnd.position[atEnd.row0[endJoints_[k]] + r] / dt_;
      gRate_[row] = Rg_[row] - gA_[row] / dt_;
    }
  jointForces(e, force_);
  uE_ = 2.0 * (v - xA_->u);
  e.mass.apply(view(std::as_const(uE_)), view(momentum_));
  Rv_ = momentum_ - dt_ * e.h - force_ - contactImpulse;
  if (!damped_.any()) return;
  h_.setZero(nu), hNonPotential_.setZero(nu);
  damped_.addTo(v, xA_->u, h_, hNonPotential_);
  Rv_ -= dt_ * h_;
}

void JointNewton::finish(MechanicalSystem& s) {
  s.release();
  if (!damped_.any()) return;
  h_ = s.slot(0).h, hNonPotential_ = s.slot(0).hNonPotential;
  damped_.addTo(v, xA_->u, h_, hNonPotential_);
  s.usedForce(h_, hNonPotential_);
}

void JointNewton::addColumn(int block, int j, const Eigen::VectorXd& R0, double perturbation) {
  const int column = walk_.block(block) + j;
  for (const int b : nearBlocks_[block]) {
    const int row = walk_.block(b), u0 = blockU0_[b];
    for (int i = 0; i < blockNu_[b]; ++i)
      K_.at(row + i, column) = (Rv_[u0 + i] - R0[u0 + i]) / perturbation;
  }
  for (const int k : nearJoints_[block]) {
    const int row = walk_.joint(k);
    for (int r = 0; r < jointRow_[k + 1] - jointRow_[k]; ++r)
      K_.at(row + r, column) = (Rg_[jointRow_[k] + r] - g0_[jointRow_[k] + r]) / perturbation;
  }
}

/// Adds ∂R/∂Λ = −W̃ by unit impulses, joint after joint, since R is linear in Λ.
void JointNewton::addJointColumns(const Evaluation& e) {
  const ContactSet& c = e.contacts;
  e.mass.apply(view(std::as_const(v)), view(momentum_));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const int i = joints_[k], first = walk_.joint(k);
    for (int r = 0; r < c.dim(i); ++r) {
      double power = c.chi[c.row0[i] + r] - gRate_[jointRow_[k] + r], twiceT = 0.0, stiffness = 0.0;
      for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
        const Segment& seg = c.segment[m];
        const double* w = c.W.data() + seg.w + static_cast<std::ptrdiff_t>(r) * seg.nu;
        const ConstBlock inverse = e.mass.inverse(seg.block);
        for (int j = 0; j < seg.nu; ++j) {
          power += w[j] * v[seg.u0 + j];
          twiceT += v[seg.u0 + j] * momentum_[seg.u0 + j];
          stiffness += w[j] * w[j] * inverse(j, j);
        }
      }
      const double share = twiceT > 0.0 ? power / twiceT : 0.0;
      for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
        const Segment& seg = c.segment[m];
        const double* w = c.W.data() + seg.w + static_cast<std::ptrdiff_t>(r) * seg.nu;
        const int row = walk_.block(seg.block);
        for (int j = 0; j < seg.nu; ++j)
          K_.at(row + j, first + r) -= w[j] - share * momentum_[seg.u0 + j];
      }
      K_.at(first + r, first + r) = kRegular * stiffness;
    }
  }
}

bool JointNewton::linearise(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                            Tangent wanted) {
  K_.reset(unknowns(), walk_.band(), walk_.ends());
  addJointColumns(s.slot(0));
  if (wanted == Tangent::closedForm && offered_) {
    offered_ = closedForm(s);
    if (!offered_) {  // the incomplete matrix is dropped
      K_.reset(unknowns(), walk_.band(), walk_.ends());
      addJointColumns(s.slot(0));
    }
  }
  tangent_ = wanted == Tangent::closedForm && offered_ ? wanted : Tangent::differences;
  if (tangent_ == Tangent::differences) {
    differences(s, contactImpulse);
    checkPositions(s);
  }
  return fault_.empty() && K_.factor();
}

bool JointNewton::closedForm(const MechanicalSystem& s) {
  if (!parts_.begin(s, midpoint, v, dt_)) return false;
  for (std::size_t b = 0; b < blockNu_.size(); ++b) {
    const int first = walk_.block(b);
    const JointTangent::Matrix6& K = parts_.ofBlock(static_cast<int>(b));
    for (int i = 0; i < blockNu_[b]; ++i)
      for (int j = 0; j < blockNu_[b]; ++j) K_.at(first + i, first + j) += K(i, j);
  }
  damped_.forEach(s.slot(0).mass, [this](int a, int i, int b, int j, double value) {
    K_.at(walk_.block(a) + i, walk_.block(b) + j) += value;
  });
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const std::size_t row = static_cast<std::size_t>(jointRow_[k]);
    if (!parts_.joint(s, joints_[k], endJoints_[k], Lambda.data() + row, gRate_.data() + row))
      return false;
    const int rows = jointRow_[k + 1] - jointRow_[k], firstRow = walk_.joint(k);
    for (int b = 0; b < parts_.sides(); ++b) {
      const int column = walk_.block(parts_.block(b));
      for (int j = 0; j < parts_.nu(b); ++j) {
        for (int r = 0; r < rows; ++r) K_.at(firstRow + r, column + j) += parts_.ofGap(b)(r, j);
        for (int a = 0; a < parts_.sides(); ++a) {
          const int first = walk_.block(parts_.block(a));
          for (int i = 0; i < parts_.nu(a); ++i)
            K_.at(first + i, column + j) -= parts_.ofForce(a, b)(i, j);
        }
      }
    }
  }
  return true;
}

void JointNewton::differences(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse) {
  force0_ = Rv_, g0_ = Rg_, gRate0_ = gRate_;
  base_ = v;
  const double d = kTangentDifference / dt_;
  for (int colour = 0; colour < colours_; ++colour)
    for (int j = 0; j < mostNu_; ++j) {
      bool any = false;
      for (std::size_t b = 0; b < colour_.size(); ++b)
        if (colour_[b] == colour && j < blockNu_[b]) v[blockU0_[b] + j] += d, any = true;
      if (!any) continue;
      residual(s, contactImpulse, Search::joints);
      for (std::size_t b = 0; b < colour_.size(); ++b)
        if (colour_[b] == colour && j < blockNu_[b]) addColumn(static_cast<int>(b), j, force0_, d);
      v = base_;
    }
  Rv_ = force0_, Rg_ = g0_, gRate_ = gRate0_;
}

/// Finds a row that has velocities but a constant position: it would hold nothing without notice.
void JointNewton::checkPositions(const MechanicalSystem& s) {
  const ContactSet& c = s.slot(0).contacts;
  for (std::size_t k = 0; k < joints_.size(); ++k)
    for (int r = 0; r < c.dim(joints_[k]); ++r) {
      double moves = 0.0, follows = 0.0;
      const int row = walk_.joint(k) + r, i = joints_[k];
      for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
        const Segment& seg = c.segment[m];
        const int column = walk_.block(seg.block);
        for (int j = 0; j < seg.nu; ++j) {
          moves = std::max(moves, std::abs(c.W[static_cast<int>(seg.w) + r * seg.nu + j]));
          follows = std::max(follows, std::abs(K_.at(row, column + j)));
        }
      }
      if (moves == 0.0 || follows > 0.0) continue;
      const Element& element = *s.parts().contacts[c.element[i]];
      fault_ = "the scheme holds joints by their positions, and row " + std::to_string(r) + " of " +
               (element.name().empty() ? "an element of type " + element.type()
                                       : '"' + element.name() + '"') +
               " has none: write its position, or give it a BilateralRate";
      return;
    }
}

void JointNewton::newtonStep() {
  for (const MechanismWalk::Node& n : walk_.nodes())
    if (n.joint)
      for (int r = jointRow_[n.index]; r < jointRow_[n.index + 1]; ++r)
        work_[n.first + r - jointRow_[n.index]] = -Rg_[r];
    else
      for (int j = 0; j < blockNu_[n.index]; ++j) work_[n.first + j] = -Rv_[blockU0_[n.index] + j];
  K_.solve(work_.data());
  dv.setZero(v.size());
  std::fill(dLambda.begin(), dLambda.end(), 0.0);
  for (const MechanismWalk::Node& n : walk_.nodes()) add(n, work_.data(), 1, 1.0);
}

void JointNewton::respond(const ContactSet& c, int i, ContactResponse& out) const {
  const int rows = out.rows = c.dim(i);
  out.parts.clear();
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k)
    out.parts.push_back(walk_.partOfBlock(c.segment[k].block));
  std::sort(out.parts.begin(), out.parts.end());
  out.parts.erase(std::unique(out.parts.begin(), out.parts.end()), out.parts.end());
  out.value.resize(static_cast<std::size_t>(unknowns() * rows));
  const auto row = [&](int unknown) { return out.value.data() + unknown * rows; };
  for (const int p : out.parts) std::fill(row(walk_.part(p).first), row(walk_.part(p).last), 0.0);
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& s = c.segment[k];
    for (int r = 0; r < rows; ++r)
      for (int j = 0; j < s.nu; ++j)
        row(walk_.block(s.block) + j)[r] = c.W[static_cast<int>(s.w) + r * s.nu + j];
  }
  for (const int p : out.parts)
    K_.solve(out.value.data(), walk_.part(p).first, walk_.part(p).last, rows);
}

void JointNewton::add(const ContactResponse& response, int r, double factor) {
  for (const int p : response.parts)
    for (int n = walk_.part(p).firstNode; n < walk_.part(p).lastNode; ++n)
      add(walk_.nodes()[n], response.value.data() + r, response.rows, factor);
}

/// (dv, dΛ) of one node += factor · x[stride · unknown].
void JointNewton::add(const MechanismWalk::Node& n, const double* x, int stride, double factor) {
  x += n.first * stride;
  if (n.joint)
    for (int r = jointRow_[n.index]; r < jointRow_[n.index + 1]; ++r, x += stride)
      dLambda[r] += factor * *x;
  else
    for (int j = 0; j < blockNu_[n.index]; ++j, x += stride)
      dv[blockU0_[n.index] + j] += factor * *x;
}

double JointNewton::along(const ContactSet& c, int i, int r, const ContactResponse& response,
                          int column) const {
  double sum = 0.0;
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& s = c.segment[k];
    if (!response.moves(walk_.partOfBlock(s.block))) continue;
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu;
    const double* x = response.value.data() + walk_.block(s.block) * response.rows + column;
    double part = 0.0;
    for (int j = 0; j < s.nu; ++j, x += response.rows) part += w[j] * *x;
    sum += part;
  }
  return sum;
}

void JointNewton::take() {
  v += dv;
  for (std::size_t r = 0; r < Lambda.size(); ++r) Lambda[r] += dLambda[r];
}

}  // namespace dynamy
