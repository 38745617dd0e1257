#include <algorithm>
#include <cmath>
#include <cstdio>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/solver/diagnosis/diagnosis_parts.hpp>
#include <dynamy/solver/diagnosis/jam.hpp>
#include <limits>

namespace dynamy::diagnosis {
namespace {

constexpr double kTakesPart = 1e-3;  ///< fraction of the largest entry: below, not concerned

/// The contacts whose part of x is not small, in their order.
std::vector<int> concerned(const InclusionProblem& p, const Eigen::VectorXd& x) {
  const auto part = [&](int i) { return x.segment(p.row0(i), p.dim(i)).norm(); };
  double largest = 0.0;
  for (int i = 0; i < p.size(); ++i) largest = std::max(largest, part(i));
  std::vector<int> out;
  for (int i = 0; i < p.size(); ++i)
    if (part(i) > kTakesPart * largest) out.push_back(i);
  return out;
}

/// How much each row takes part in the kernel Z of G_JJ; zero for rows outside `rows`.
Eigen::VectorXd participation(const InclusionProblem& p, const std::vector<int>& rows,
                              const Eigen::MatrixXd& Z) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(p.rows());
  out(rows) = Z.rowwise().norm();
  return out;
}

}  // namespace

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

std::string Names::operator()(int contact) const {
  return given ? given(contact) : "contact " + std::to_string(contact);
}

std::string Names::operator()(const std::vector<int>& contacts) const {
  constexpr std::size_t kMost = 6;
  std::string out;
  const std::size_t told = contacts.size() > kMost ? kMost - 1 : contacts.size();
  for (std::size_t k = 0; k < told; ++k) {
    if (k > 0) out += k + 1 == contacts.size() ? " and " : ", ";
    out += (*this)(contacts[k]);
  }
  if (told < contacts.size()) out += " and " + std::to_string(contacts.size() - told) + " more";
  return out;
}

std::optional<Finding> unsolved(const SolveReport& r, const Names& names) {
  if (r.ok()) return std::nullopt;
  Finding f;
  f.value = r.residuals.largest();
  f.text =
      "Not solved (" + std::string(solveStatusText(r.status)) + "): residual " + number(f.value);
  if (r.residuals.worst >= 0) {
    f.contacts = {r.residuals.worst};
    f.text += ", the largest at " + names(r.residuals.worst);
  }
  f.text += ". Tried: " + attemptsText(r) + ".";
  f.advice =
      r.status == SolveStatus::notFinite
          ? "A velocity or a mass is not finite: look at the forces and the state before this step."
          : "Give the solver more iterations or a coarser tolerance, or take a smaller step; what "
            "follows may tell the cause.";
  return f;
}

std::optional<Finding> tooLarge(int rows, int most) {
  return Finding{FindingKind::tooLarge,
                 {},
                 static_cast<double>(rows),
                 std::to_string(rows) + " rows are too many for rank, jam and other solutions (" +
                     std::to_string(most) + " at most).",
                 ""};
}

std::optional<Finding> rounding(const DenseProblem& dense, double tolerance, const Names& names) {
  const InclusionProblem& p = dense.problem();
  const Eigen::VectorXd noise = 4.0 * std::numeric_limits<double>::epsilon() *
                                (dense.G().cwiseAbs() * dense.Lambda().cwiseAbs());
  if (noise.size() == 0 || !(p.uRef > 0.0)) return std::nullopt;
  Eigen::Index row = 0;
  const double floor = noise.maxCoeff(&row) / p.uRef;
  if (floor <= tolerance) return std::nullopt;
  int contact = 0;
  while (p.row0(contact) + p.dim(contact) <= row) ++contact;
  return Finding{FindingKind::rounding,
                 {contact},
                 floor,
                 "Rounding alone leaves a residual of about " + number(floor) + " at " +
                     names(contact) +
                     ": its velocity is the difference of numbers that are much larger.",
                 "Ask for no tolerance below " + number(floor) +
                     ", or bring masses and lengths of the bodies there closer to each other."};
}

std::optional<Finding> contradictingJoints(const DenseProblem& dense, const Names& names) {
  const InclusionProblem& p = dense.problem();
  const std::vector<int> rows = dense.rowsOf([&](int i) { return dense.isFree(i); });
  const Eigen::MatrixXd Z = dense.kernel(rows);
  if (Z.cols() == 0) return std::nullopt;
  const Eigen::VectorXd c = dense.scale()(rows).cwiseProduct(
      Eigen::Map<const Eigen::VectorXd>(p.c.data(), p.rows())(rows));
  const Eigen::VectorXd part = Z * (Z.transpose() * c);
  const double missed = part.norm() / std::max(c.norm(), std::numeric_limits<double>::min());
  if (!(missed > 1e-8)) return std::nullopt;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(p.rows());
  all(rows) = part;
  const std::vector<int> who = concerned(p, all);
  return Finding{FindingKind::contradiction, who, missed,
                 "No motion fulfils all joints: " + names(who) +
                     " ask for velocities that contradict each other (" + number(missed) +
                     " of what they ask).",
                 "Remove one of them, or correct its prescribed motion or position."};
}

std::optional<Finding> redundantJoints(const DenseProblem& dense, const Names& names) {
  const std::vector<int> rows = dense.rowsOf([&](int i) { return dense.isFree(i); });
  const Eigen::MatrixXd Z = dense.kernel(rows);
  if (Z.cols() == 0) return std::nullopt;
  const std::vector<int> who = concerned(dense.problem(), participation(dense.problem(), rows, Z));
  return Finding{FindingKind::redundantJoints, who, static_cast<double>(Z.cols()),
                 "Over-constrained: " + std::to_string(Z.cols()) + " of " +
                     std::to_string(rows.size()) + " joint equations follow from the others (" +
                     names(who) +
                     "). The motion is determined, the forces in these joints are not.",
                 "Read sums of these forces only, or free as many directions of the joints."};
}

std::optional<Finding> jam(const DenseProblem& dense, const Names& names) {
  const InclusionProblem& p = dense.problem();
  const Eigen::VectorXd held = jammedForces(dense);
  if (held.isZero(0.0)) return std::nullopt;
  const std::vector<int> who = concerned(p, held);
  // Power of the held forces at any velocity the bodies can have: Λ·ξ = Λ·c.
  const Eigen::Map<const Eigen::VectorXd> c(p.c.data(), p.rows());
  const double power = held.dot(c), scale = held.cwiseAbs().dot(c.cwiseAbs());
  const bool squeezed = power < -1e-8 * scale;
  // Without friction among the held forces sliding is no way out either.
  bool normalOnly = true;
  for (int i = 0; i < p.size(); ++i)
    normalOnly = normalOnly && held.segment(p.row0(i) + 1, p.dim(i) - 1).isZero(1e-9);
  Finding f{squeezed ? FindingKind::contradiction : FindingKind::jam, who, power, "", ""};
  f.text = squeezed ? "Jammed and squeezed: " + names(who) +
                          " close further, but their forces hold each other and move no body. " +
                          (normalOnly ? "No motion opens all of them: there is no solution."
                                      : "Only sliding could open them: there may be no solution.")
                    : "Jam: " + names(who) +
                          " can hold each other by forces of any size. How large they are does not "
                          "follow from the laws of rigid bodies.";
  f.advice = squeezed
                 ? "Make room for the body between them, let one of them give way (a spring or a "
                   "compliant contact), or lower the friction there."
                 : "Do not read these forces; a compliant contact or lower friction makes them "
                   "definite.";
  return f;
}

int freeDirections(const DenseProblem& dense, const Eigen::MatrixXd& kernel) {
  if (kernel.cols() == 0) return 0;
  const InclusionProblem& p = dense.problem();
  Eigen::MatrixXd left(kernel.rows(), kernel.cols());  // (I − P) Z, contact by contact
  Eigen::Index at = 0;
  for (int i = 0; i < p.size(); ++i) {
    if (!dense.isClosed(i)) continue;
    const int dim = p.dim(i);
    left.middleRows(at, dim) = kernel.middleRows(at, dim);
    left.middleRows(at, dim) -= dense.proxJacobian(i) * kernel.middleRows(at, dim);
    at += dim;
  }
  if (!left.allFinite()) return 0;  // pivoting by size reads out of bounds where nothing compares
  PivotedQr qr(1e-9);
  qr.compute(left);
  return static_cast<int>(kernel.cols() - (left.norm() > 1e-9 ? qr.rank() : 0));
}

std::optional<Finding> forcesNotUnique(const Diagnosis& d, const Names&) {
  if (d.rank >= d.rows || d.freedom == 0) return std::nullopt;
  return Finding{FindingKind::forcesNotUnique,
                 {},
                 static_cast<double>(d.freedom),
                 "Forces not unique: rank " + std::to_string(d.rank) + " of " +
                     std::to_string(d.rows) + " rows, " + std::to_string(d.freedom) +
                     (d.freedom == 1 ? " direction" : " directions") +
                     " in which they may change without changing any velocity.",
                 "Automatic with minimalNorm=\"true\" gives the smallest ones, which share loads "
                 "evenly."};
}

}  // namespace dynamy::diagnosis
