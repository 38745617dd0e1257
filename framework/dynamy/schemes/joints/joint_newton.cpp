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
/// Share of the velocities of its bodies above which a row has a rate of its own.
constexpr double kStill = 1e-6;
/// Multiplications in the time of a visit of a contact by a solver (theory 37.7).
constexpr double kOfVisit = 150.0;

}  // namespace

bool JointNewton::linearise(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                            Tangent wanted) {
  counted_ = s.limits.work;
  const auto begin = [&] {
    K_.reset(unknowns(), walk().band(), walk().ends());
    addJointColumns(s.slot(0));
  };
  begin();
  tangent_ = wanted;
  if (wanted == Tangent::closedForm && offered_) {
    offered_ = closedForm(s);
    if (!offered_) begin();  // the incomplete matrix is dropped
  }
  if (wanted == Tangent::closedForm && !offered_) tangent_ = Tangent::masses;
  if (tangent_ == Tangent::masses && !masses(s)) begin(), tangent_ = Tangent::differences;
  if (tangent_ == Tangent::differences) {
    differences(s, contactImpulse);
    if (fault_.empty()) fault_ = rowWithoutPosition(s);
  }
  const bool regular = fault_.empty() && K_.factor();
  charge();
  return regular;
}

/// Counts what K did since the last call as visits of contacts. Called after each use of it, so that
/// a resumed run counts the same.
void JointNewton::charge() const {
  const double done = std::ceil((K_.multiplications() - charged_) / kOfVisit);
  charged_ = K_.multiplications();
  if (counted_ != nullptr) counted_->visits += static_cast<long>(done);
}

/// Adds ∂R/∂Λ = −W̃ by unit impulses, joint after joint, since R is linear in Λ.
void JointNewton::addJointColumns(const Evaluation& e) {
  const ContactSet& c = e.contacts;
  const std::vector<int>& joints = equations.joints();
  const Eigen::VectorXd& v = equations.v;
  momentum_.resize(v.size());
  if (!joints.empty()) e.mass.apply(view(v), view(momentum_));
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int i = joints[k], first = walk().joint(k);
    const double* meanRate =
        equations.R.meanRate.data() + equations.graph().row0(static_cast<int>(k));
    for (int r = 0; r < c.dim(i); ++r) {
      double power = c.chi[c.row0[i] + r] - meanRate[r], twiceT = 0.0, stiffness = 0.0;
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
      twiceT = std::max(twiceT, equations.leastTwiceT(static_cast<int>(k)));
      const double share = twiceT > 0.0 ? power / twiceT : 0.0;
      for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
        const Segment& seg = c.segment[m];
        const double* w = c.W.data() + seg.w + static_cast<std::ptrdiff_t>(r) * seg.nu;
        const int row = walk().block(seg.block);
        for (int j = 0; j < seg.nu; ++j)
          K_.at(row + j, first + r) -= w[j] - share * momentum_[seg.u0 + j];
      }
      K_.at(first + r, first + r) = kRegular * stiffness;
    }
  }
}

bool JointNewton::closedForm(const MechanicalSystem& s) {
  const MechanismGraph& graph = equations.graph();
  if (!parts_.begin(s, equations.midpoint, equations.v, equations.dt())) return false;
  for (int b = 0; b < graph.blocks(); ++b) {
    const int first = walk().block(b);
    const JointTangent::Matrix6& K = parts_.ofBlock(b);
    for (int i = 0; i < graph.nu(b); ++i)
      for (int j = 0; j < graph.nu(b); ++j) K_.at(first + i, first + j) += K(i, j);
  }
  addDamped(s);
  const std::vector<int>&joints = equations.joints(), &atEnd = equations.jointsAtEnd();
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int row0 = graph.row0(static_cast<int>(k)),
              rows = graph.row0(static_cast<int>(k) + 1) - row0;
    if (!parts_.joint(s, joints[k], atEnd[k], equations.Lambda.data() + row0,
                      equations.R.meanRate.data() + row0,
                      equations.leastTwiceT(static_cast<int>(k))))
      return false;
    const int firstRow = walk().joint(k);
    for (int b = 0; b < parts_.sides(); ++b) {
      const int column = walk().block(parts_.block(b));
      for (int j = 0; j < parts_.nu(b); ++j) {
        for (int r = 0; r < rows; ++r) K_.at(firstRow + r, column + j) += parts_.ofGap(b)(r, j);
        for (int a = 0; a < parts_.sides(); ++a) {
          const int first = walk().block(parts_.block(a));
          for (int i = 0; i < parts_.nu(a); ++i)
            K_.at(first + i, column + j) -= parts_.ofForce(a, b)(i, j);
        }
      }
    }
  }
  return true;
}

void JointNewton::addDamped(const MechanicalSystem& s) {
  equations.damped().forEach(s.slot(0).mass, [this](int a, int i, int b, int j, double value) {
    K_.at(walk().block(a) + i, walk().block(b) + j) += value;
  });
}

/// 2M, and W of the joints at q^E: what is left when forces and W are held. False: a row moves
/// without its position, which differences look at.
bool JointNewton::masses(const MechanicalSystem& s) {
  const MechanismGraph& graph = equations.graph();
  for (int b = 0; b < graph.blocks(); ++b) {
    const int first = walk().block(b);
    const ConstBlock M = s.slot(0).mass.M(b);
    for (int i = 0; i < graph.nu(b); ++i)
      for (int j = 0; j < graph.nu(b); ++j) K_.at(first + i, first + j) += 2.0 * M(i, j);
  }
  addDamped(s);
  const ContactSet& c = s.slot(1).contacts;
  const std::vector<int>& atEnd = equations.jointsAtEnd();
  for (std::size_t k = 0; k < atEnd.size(); ++k) {
    const auto i = static_cast<std::size_t>(atEnd[k]);
    for (int r = 0; r < c.dim(atEnd[k]); ++r) {
      const int row = walk().joint(static_cast<int>(k)) + r;
      double rate = c.chi[static_cast<std::size_t>(c.row0[i] + r)], size = std::abs(rate);
      for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
        const Segment& seg = c.segment[static_cast<std::size_t>(m)];
        const double* w = c.W.data() + seg.w + static_cast<std::ptrdiff_t>(r) * seg.nu;
        for (int j = 0; j < seg.nu; ++j) {
          K_.at(row, walk().block(seg.block) + j) += w[j];
          const double part = w[j] * equations.v[seg.u0 + j];
          rate += part, size += std::abs(part);
        }
      }
      const double moved =
          equations.R.meanRate[static_cast<std::size_t>(graph.row0(static_cast<int>(k)) + r)];
      if (moved == 0.0 && std::abs(rate) > kStill * size) return false;
    }
  }
  return true;
}

void JointNewton::differences(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse) {
  const MechanismGraph& graph = equations.graph();
  Eigen::VectorXd& v = equations.v;
  base_ = v, baseR_ = equations.R;
  const double d = kTangentDifference / equations.dt();
  for (int colour = 0; colour < graph.colours(); ++colour)
    for (int j = 0; j < graph.mostNu(); ++j) {
      bool any = false;
      for (int b = 0; b < graph.blocks(); ++b)
        if (graph.colour(b) == colour && j < graph.nu(b)) v[graph.u0(b) + j] += d, any = true;
      if (!any) continue;
      equations.evaluate(s, contactImpulse, JointEquations::Search::joints);
      for (int b = 0; b < graph.blocks(); ++b)
        if (graph.colour(b) == colour && j < graph.nu(b)) addColumn(b, j, d);
      v = base_;
    }
  equations.R = baseR_;
}

/// Column of velocity j of a block, which was moved by `perturbation`.
void JointNewton::addColumn(int block, int j, double perturbation) {
  const MechanismGraph& graph = equations.graph();
  const JointResidual& R = equations.R;
  const int column = walk().block(block) + j;
  for (const int b : graph.nearBlocks(block)) {
    const int row = walk().block(b), u0 = graph.u0(b);
    for (int i = 0; i < graph.nu(b); ++i)
      K_.at(row + i, column) = (R.v[u0 + i] - baseR_.v[u0 + i]) / perturbation;
  }
  for (const int k : graph.nearJoints(block)) {
    const int row = walk().joint(k), row0 = graph.row0(k);
    for (int r = row0; r < graph.row0(k + 1); ++r)
      K_.at(row + r - row0, column) = (R.g[r] - baseR_.g[r]) / perturbation;
  }
}

/// Names a row that has velocities but a constant position: it would hold nothing without notice.
std::string JointNewton::rowWithoutPosition(const MechanicalSystem& s) {
  const ContactSet& c = s.slot(0).contacts;
  const std::vector<int>& joints = equations.joints();
  for (std::size_t k = 0; k < joints.size(); ++k)
    for (int r = 0; r < c.dim(joints[k]); ++r) {
      double moves = 0.0, follows = 0.0;
      const int row = walk().joint(k) + r, i = joints[k];
      for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
        const Segment& seg = c.segment[m];
        const int column = walk().block(seg.block);
        for (int j = 0; j < seg.nu; ++j) {
          moves = std::max(moves, std::abs(c.W[static_cast<int>(seg.w) + r * seg.nu + j]));
          follows = std::max(follows, std::abs(K_.at(row, column + j)));
        }
      }
      if (moves == 0.0 || follows > 0.0) continue;
      const Element& element = *s.parts().contacts[c.element[i]];
      return "the scheme holds joints by their positions, and row " + std::to_string(r) + " of " +
             (element.name().empty() ? "an element of type " + element.type()
                                     : '"' + element.name() + '"') +
             " has none: write its position, or give it a BilateralRate";
    }
  return {};
}

void JointNewton::newtonStep() {
  const MechanismGraph& graph = equations.graph();
  const JointResidual& R = equations.R;
  work_.resize(static_cast<std::size_t>(unknowns()));
  for (const MechanismWalk::Node& n : walk().nodes())
    if (n.joint)
      for (int r = graph.row0(n.index); r < graph.row0(n.index + 1); ++r)
        work_[n.first + r - graph.row0(n.index)] = -R.g[r];
    else
      for (int j = 0; j < graph.nu(n.index); ++j) work_[n.first + j] = -R.v[graph.u0(n.index) + j];
  K_.solve(work_.data());
  charge();
  dv.setZero(equations.v.size());
  dLambda.assign(equations.Lambda.size(), 0.0);
  for (const MechanismWalk::Node& n : walk().nodes()) add(n, work_.data(), 1, 1.0);
}

void JointNewton::respond(const ContactSet& c, int i, ContactResponse& out) const {
  const int rows = out.rows = c.dim(i);
  out.parts.clear();
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k)
    out.parts.push_back(walk().partOfBlock(c.segment[k].block));
  std::sort(out.parts.begin(), out.parts.end());
  out.parts.erase(std::unique(out.parts.begin(), out.parts.end()), out.parts.end());
  out.value.resize(static_cast<std::size_t>(unknowns() * rows));
  const auto row = [&](int unknown) { return out.value.data() + unknown * rows; };
  for (const int p : out.parts) std::fill(row(walk().part(p).first), row(walk().part(p).last), 0.0);
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& s = c.segment[k];
    for (int r = 0; r < rows; ++r)
      for (int j = 0; j < s.nu; ++j)
        row(walk().block(s.block) + j)[r] = c.W[static_cast<int>(s.w) + r * s.nu + j];
  }
  for (const int p : out.parts)
    K_.solve(out.value.data(), walk().part(p).first, walk().part(p).last, rows);
  charge();
}

void JointNewton::add(const ContactResponse& response, int r, double factor) {
  for (const int p : response.parts)
    for (int n = walk().part(p).firstNode; n < walk().part(p).lastNode; ++n)
      add(walk().nodes()[n], response.value.data() + r, response.rows, factor);
}

/// (dv, dΛ) of one node += factor · x[stride · unknown].
void JointNewton::add(const MechanismWalk::Node& n, const double* x, int stride, double factor) {
  const MechanismGraph& graph = equations.graph();
  x += n.first * stride;
  if (n.joint)
    for (int r = graph.row0(n.index); r < graph.row0(n.index + 1); ++r, x += stride)
      dLambda[r] += factor * *x;
  else
    for (int j = 0; j < graph.nu(n.index); ++j, x += stride)
      dv[graph.u0(n.index) + j] += factor * *x;
}

double JointNewton::along(const ContactSet& c, int i, int r, const ContactResponse& response,
                          int column) const {
  double sum = 0.0;
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& s = c.segment[k];
    if (!response.moves(walk().partOfBlock(s.block))) continue;
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu;
    const double* x = response.value.data() + walk().block(s.block) * response.rows + column;
    double part = 0.0;
    for (int j = 0; j < s.nu; ++j, x += response.rows) part += w[j] * *x;
    sum += part;
  }
  return sum;
}

void JointNewton::take() {
  equations.v += dv;
  for (std::size_t r = 0; r < dLambda.size(); ++r) equations.Lambda[r] += dLambda[r];
}

}  // namespace dynamy
