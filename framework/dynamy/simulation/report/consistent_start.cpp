#include <fmt/format.h>
#include <dynamy/stages/projection.hpp>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Added to the diagonal of G, which is scaled to 1, so that redundant rows share the correction;
/// the iteration removes the error that it causes.
constexpr double kRedundantStart = 1e-11;
constexpr int kMostStartTurns = 25;
constexpr double kPosition = 1e-12;    ///< of the scene's length: g_tol, on the joints
constexpr double kFileNumbers = 1e-6;  ///< changes below it are rounding of numbers in a file
constexpr double kStartNoise = 16.0 * std::numeric_limits<double>::epsilon();

/// The rows of the joints in one evaluation, and the solution δ = M⁻¹WΛ with Wᵀδ = −r.
class JointRows {
 public:
  /// Rows of the joints of `e`; `positions`: only rows that are the rate of a position.
  /// `kept`: velocities that δ leaves as they are.
  JointRows(const Evaluation& e, bool positions, const std::vector<int>& kept);
  bool any() const { return !row_.empty(); }
  /// Index of row k among the rows of all contacts, and the contact that it belongs to.
  int row(std::size_t k) const { return row_[k]; }
  int contact(std::size_t k) const { return contact_[k]; }
  std::size_t size() const { return row_.size(); }
  /// δ for the errors `r` of the rows.
  Eigen::VectorXd solve(const Eigen::VectorXd& r);

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  void factorise();
  const Evaluation& e_;
  const std::vector<int>& kept_;
  std::vector<int> row_, contact_;
  Sparse W_, MInvW_;
  Eigen::VectorXd scale_;
  Eigen::SimplicialLDLT<Sparse> ldlt_;
  bool ready_ = false;
};

JointRows::JointRows(const Evaluation& e, bool positions, const std::vector<int>& kept)
    : e_(e), kept_(kept) {
  const ContactSet& c = e.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (c.law[at]->unilateral()) continue;
    for (int r = 0; r < c.dim(i); ++r) {
      const RowKind kind = c.law[at]->rowKind(r);
      if (!holds(kind) || (positions && kind != RowKind::joint)) continue;
      row_.push_back(c.row0[at] + r), contact_.push_back(i);
    }
  }
}

void JointRows::factorise() {
  const ContactSet& c = e_.contacts;
  const Eigen::Index nu = e_.h.size(), m = static_cast<Eigen::Index>(row_.size());
  std::vector<Eigen::Triplet<double>> w, mw;
  Eigen::VectorXd column(nu), solved(nu);
  for (Eigen::Index k = 0; k < m; ++k) {
    const auto at = static_cast<std::size_t>(contact_[static_cast<std::size_t>(k)]);
    const int r = row_[static_cast<std::size_t>(k)] - c.row0[at];
    column.setZero();
    for (int s = c.segment0[at]; s < c.segment0[at + 1]; ++s) {
      const Segment& segment = c.segment[static_cast<std::size_t>(s)];
      const double* from = c.W.data() + segment.w + static_cast<std::ptrdiff_t>(r) * segment.nu;
      for (int j = 0; j < segment.nu; ++j) column[segment.u0 + j] += from[j];
    }
    for (const int i : kept_) column[i] = 0.0;
    e_.mass.applyInverse(view(std::as_const(column)), view(solved));
    for (const int i : kept_) solved[i] = 0.0;
    for (Eigen::Index j = 0; j < nu; ++j) {
      if (column[j] != 0.0) w.emplace_back(static_cast<int>(j), static_cast<int>(k), column[j]);
      if (solved[j] != 0.0) mw.emplace_back(static_cast<int>(j), static_cast<int>(k), solved[j]);
    }
  }
  W_.resize(nu, m), MInvW_.resize(nu, m);
  W_.setFromTriplets(w.begin(), w.end()), MInvW_.setFromTriplets(mw.begin(), mw.end());
  Sparse G = Sparse(W_.transpose()) * MInvW_;
  scale_.resize(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const double g = G.coeff(k, k);
    scale_[k] = g > 0.0 ? 1.0 / std::sqrt(g) : 0.0;  // a row without effect gets no impulse
  }
  G = scale_.asDiagonal() * G * scale_.asDiagonal();
  Sparse one(m, m);
  one.setIdentity();
  ldlt_.compute(G + kRedundantStart * one);
  ready_ = true;
}

Eigen::VectorXd JointRows::solve(const Eigen::VectorXd& r) {
  if (!ready_) factorise();
  const Eigen::VectorXd scaled = scale_.cwiseProduct(r);
  const Eigen::VectorXd Lambda = -scale_.cwiseProduct(ldlt_.solve(scaled));
  return MInvW_ * Lambda;
}

/// Errors of rows, and the rounding error of each.
struct Errors {
  Eigen::VectorXd value, noise;
  double largest = 0.0;    // beyond rounding
  std::ptrdiff_t at = -1;  // row of the largest
  void look() {
    largest = 0.0, at = -1;
    for (Eigen::Index k = 0; k < value.size(); ++k)
      if (const double e = std::abs(value[k]); e > noise[k] && e > largest) largest = e, at = k;
  }
};

/// Scale for the rounding of Wᵀu in row r of contact i: the sum of |w| |u| over its segments.
/// Single entries are no scale, because zeros of W may be rounding of rotations.
double sizeOfRow(const ContactSet& c, int i, int r, const Eigen::VectorXd& u) {
  const auto at = static_cast<std::size_t>(i);
  double size = 0.0;
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu;
    size += ConstVec(w, s.nu).norm() * u.segment(s.u0, s.nu).norm();
  }
  return size;
}

Errors velocityErrors(const Evaluation& e, const JointRows& rows, const Eigen::VectorXd& u) {
  const ContactSet& c = e.contacts;
  Eigen::VectorXd gamma(c.rows());
  c.gamma(view(u), view(gamma));
  Errors out;
  out.value.resize(static_cast<Eigen::Index>(rows.size())), out.noise.resize(out.value.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int row = rows.row(k), i = rows.contact(k);
    const double size = sizeOfRow(c, i, row - c.row0[static_cast<std::size_t>(i)], u);
    out.value[static_cast<Eigen::Index>(k)] = gamma[row];
    out.noise[static_cast<Eigen::Index>(k)] =
        kStartNoise * (size + std::abs(c.chi[static_cast<std::size_t>(row)]));
  }
  out.look();
  return out;
}

Errors positionErrors(const Evaluation& e, const JointRows& rows, double tolerance) {
  Errors out;
  out.value.resize(static_cast<Eigen::Index>(rows.size()));
  out.noise.setConstant(out.value.size(), tolerance);
  for (std::size_t k = 0; k < rows.size(); ++k)
    out.value[static_cast<Eigen::Index>(k)] =
        e.contacts.position[static_cast<std::size_t>(rows.row(k))];
  out.look();
  return out;
}

/// Number of joints with an error beyond `limit`.
long countJoints(const JointRows& rows, const Errors& errors, double limit) {
  long count = 0;
  int last = -1;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!(std::abs(errors.value[static_cast<Eigen::Index>(k)]) > limit)) continue;
    if (rows.contact(k) != last) ++count;
    last = rows.contact(k);
  }
  return count;
}

std::string jointText(const Model& model, const Evaluation& e, const JointRows& rows,
                      const Errors& errors) {
  if (errors.at < 0) return {};
  const int i = rows.contact(static_cast<std::size_t>(errors.at));
  return contactText(model, e.contacts.key[static_cast<std::size_t>(i)]);
}

double kineticOf(const Evaluation& e, const Eigen::VectorXd& u) {
  Eigen::VectorXd p(u.size());
  e.mass.apply(view(u), view(p));
  return 0.5 * u.dot(p);
}

void fitPositions(const Model& model, MechanicalSystem& s, const std::vector<int>& kept, State& x,
                  StartReport::Part& out) {
  const double tolerance = kPosition * model.length();
  const State given = x;
  double before = 0.0;
  for (int turn = 0; turn <= kMostStartTurns; ++turn) {
    const Evaluation& e = turn == 0 ? s.slot(0) : s.evaluate(x);
    JointRows rows(e, true, kept);
    const Errors errors = positionErrors(e, rows, tolerance);
    if (turn == 0) {
      out.off = errors.largest, out.joint = jointText(model, e, rows, errors);
      out.joints = countJoints(rows, errors, kFileNumbers * model.length());
    }
    out.left = errors.largest;
    if (!(errors.largest > 0.0)) return;  // also if it is not a number
    const bool worse = turn > 3 && errors.largest > 0.9 * before;
    if (turn == kMostStartTurns || worse || !std::isfinite(errors.largest)) {
      out.against = jointText(model, e, rows, errors);
      break;
    }
    before = errors.largest;
    const Eigen::VectorXd delta = rows.solve(errors.value) / kDisplacementTime;
    if (!delta.allFinite()) break;
    const double t = x.t;
    s.move(x, delta, kDisplacementTime);
    x.t = t;
  }
  // Accepted: the remaining error is rounding that the tolerance does not cover (long arms, steep
  // formulas).
  if (out.left <= kFileNumbers * model.length()) {
    out.against.clear();
    return;
  }
  x = given, out.left = out.off;
  s.evaluate(x);
}

void fitVelocities(const Model& model, MechanicalSystem& s, const std::vector<int>& kept, State& x,
                   StartReport& out) {
  const Evaluation& e = s.slot(0);
  JointRows rows(e, false, kept);
  StartReport::Part& part = out.velocities;
  if (!rows.any()) return;
  const Eigen::VectorXd given = x.u;
  out.kineticBefore = out.kineticAfter = kineticOf(e, given);
  for (int turn = 0; turn <= kMostStartTurns; ++turn) {
    const Errors errors = velocityErrors(e, rows, x.u);
    if (turn == 0) {
      part.off = errors.largest, part.joint = jointText(model, e, rows, errors);
      part.joints = countJoints(rows, errors, kFileNumbers * errors.largest);
    }
    const bool met = !(errors.largest > 0.0);
    const bool stuck = turn > 1 && errors.largest > 0.5 * part.left;
    part.left = errors.largest;
    if (met || stuck || turn == kMostStartTurns) {
      part.against = part.left > kFileNumbers * part.off ? jointText(model, e, rows, errors) : "";
      break;
    }
    const Eigen::VectorXd delta = rows.solve(errors.value);
    if (!delta.allFinite()) break;
    x.u += delta;
  }
  if (part.off <= 0.0) return;
  out.kineticAfter = kineticOf(e, x.u);
  const double changed = kineticOf(e, x.u - given);
  const double most = std::max(out.kineticBefore, out.kineticAfter);
  part.share = most > 0.0 ? std::sqrt(changed / most) : 0.0;
  s.evaluate(x);
}

/// Adds what joints that became coordinates changed of the velocities of their bodies.
void addTrees(const Composition::Start& trees, double kinetic, StartReport& out) {
  StartReport::Part& part = out.velocities;
  if (!(trees.off > 0.0)) return;
  if (!(out.kineticAfter > 0.0)) out.kineticBefore = out.kineticAfter = kinetic;
  const double lost = trees.kineticBefore - trees.kineticAfter;
  out.kineticBefore += lost;
  // T of the change is that which is lost: the new velocities are orthogonal to it in the metric.
  if (out.kineticBefore > 0.0)
    part.share = std::max(part.share, std::sqrt(std::max(0.0, lost) / out.kineticBefore));
  part.joints += trees.joints;
  if (trees.off > part.off) part.off = trees.off, part.joint = trees.joint;
}

}  // namespace

StartReport makeConsistent(const Model& model, MechanicalSystem& s, State& x) {
  StartReport out;
  if (s.indefiniteMass() >= 0 || !x.q.allFinite() || !x.u.allFinite()) return out;
  std::vector<int> kept;
  for (const std::string& name : model.simulation.keep) {
    const std::vector<int> some = velocitiesNamed(model, name);
    kept.insert(kept.end(), some.begin(), some.end());
    out.kept += (out.kept.empty() ? "" : " ") + name;
  }
  if (JointRows(s.slot(0), false, kept).any()) {
    fitPositions(model, s, kept, x, out.positions);
    fitVelocities(model, s, kept, x, out);
    if (out.positions.off > 0.0) s.remember(x);
  }
  addTrees(model.composed.start, kineticOf(s.slot(0), x.u), out);
  return out;
}

std::vector<int> velocitiesNamed(const Model& model, std::string_view name) {
  std::vector<int> out;
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const std::string& system = model.systems()[i]->name();
    if (system.empty() || !name.starts_with(system)) continue;
    const SystemHandle& h = model.topology().system(static_cast<int>(i));
    if (name == system)
      for (int k = 0; k < h.nu; ++k) out.push_back(h.u0 + k);
    if (name.size() <= system.size() + 1 || name[system.size()] != '.') continue;
    const std::string_view own = name.substr(system.size() + 1);
    const Description& d = model.description(static_cast<int>(i));
    for (const auto& [velocity, k] : d.velocities)
      if (velocity == own) out.push_back(h.u0 + k);
    if (h.nq != h.nu || !out.empty()) continue;
    for (const auto& [coordinate, k] : d.coordinates)
      if (coordinate == own) out.push_back(h.u0 + k);
  }
  return out;
}

std::vector<std::string> keptNames(const Model& model) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const std::string& system = model.systems()[i]->name();
    if (system.empty() || model.topology().system(static_cast<int>(i)).nu == 0) continue;
    out.push_back(system);
    for (const auto& each : model.description(static_cast<int>(i)).velocities)
      out.push_back(system + "." + each.first);
  }
  return out;
}

std::vector<Warning> startWarnings(const StartReport& start, double sceneLength) {
  std::vector<Warning> out;
  const StartReport::Part &p = start.positions, &v = start.velocities;
  const auto others = [](const StartReport::Part& part) {
    return part.joints > 1
               ? fmt::format(" and {} other{}", part.joints - 1, part.joints > 2 ? "s" : "")
               : std::string();
  };
  const std::string kept = start.kept.empty() ? "" : ", with " + start.kept + " kept";
  if (!p.against.empty())
    out.push_back({"contradiction",
                   fmt::format("no positions fulfil all joints{}: {} stays off by {:.3g} m; check "
                               "its length or its place against the other joints of its bodies",
                               kept, p.against, p.left),
                   std::max(1L, p.joints), 0.0, p.against});
  else if (p.off > kFileNumbers * sceneLength)
    out.push_back({"start positions",
                   fmt::format("joint {}{} did not fit at the start, by {:.3g} m: the bodies were "
                               "moved onto their joints in the metric of the mass{}",
                               p.joint, others(p), p.off, kept),
                   std::max(1L, p.joints), 0.0, p.joint});
  if (!v.against.empty())
    out.push_back({"contradiction",
                   fmt::format("no velocities fulfil all joints and drives at the start{}: {} is "
                               "left with {:.3g} (m/s or rad/s)",
                               kept, v.against, v.left),
                   std::max(1L, v.joints), 0.0, v.against});
  if (v.share > kFileNumbers)
    out.push_back(
        {"start velocities",
         fmt::format(
             "joint {}{} {} not allow the velocities at the start, by {:.3g} (m/s or "
             "rad/s): they were projected in the metric of the mass{}, T {:.6g} -> {:.6g} J",
             v.joint, others(v), v.joints > 1 ? "do" : "does", v.off, kept, start.kineticBefore,
             start.kineticAfter),
         std::max(1L, v.joints), 0.0, v.joint});
  return out;
}

}  // namespace dynamy
