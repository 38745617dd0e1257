#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/diagnosis/diagnosis_parts.hpp>

namespace dynamy::diagnosis {
namespace {

/// Friction per unit of normal force that opposes the direction `d` most: argmin b·d, b ∈ B.
Eigen::VectorXd friction(const DenseProblem& dense, int contact, const Eigen::VectorXd& d) {
  const InclusionProblem& p = dense.problem();
  const int dim = p.dim(contact);
  double r[kMostRows], zero[kMostRows] = {}, x[kMostRows];
  std::fill(r, r + dim, 1.0);
  x[0] = 1.0;
  // The projection of a far point on B is the support point of its direction.
  for (int k = 1; k < dim; ++k) x[k] = -1e8 * d[k - 1] / d.norm();
  p.law(contact).prox(p.input(contact), r, zero, x);
  return Eigen::Map<Eigen::VectorXd>(x + 1, dim - 1);
}

std::string directionText(const Eigen::VectorXd& d) {
  std::string out = "(";
  for (Eigen::Index k = 0; k < d.size(); ++k)
    out += (k > 0 ? ", " : "") + number(std::abs(d[k]) < 1e-12 ? 0.0 : d[k]);
  return out + ")";
}

std::optional<Finding> single(const DenseProblem& dense, const std::vector<int>& joints, int i,
                              const Names& names) {
  const int dim = dense.problem().dim(i);
  const Eigen::MatrixXd G = dense.reduced(dense.rowsOf([i](int k) { return k == i; }), joints);
  const Eigen::VectorXd GNT = G.row(0).tail(dim - 1).transpose();
  // Joints may leave the contact no normal motion at all.
  if (!(G(0, 0) > 1e-9 * dense.problem().G->diagonalBlock(i)[0]) || GNT.isZero(0.0))
    return std::nullopt;
  const Eigen::VectorXd b = friction(dense, i, GNT);
  const double indicator = -GNT.dot(b) / G(0, 0);
  if (!(indicator >= 1.0)) return std::nullopt;
  const Eigen::VectorXd slip = -b / b.norm();
  return Finding{
      FindingKind::painleve,
      {i},
      indicator,
      "Painleve's paradox is possible at " + names(i) + ": when it slides along " +
          directionText(slip) +
          ", friction presses it more than the normal force opens it (mu |G_NT| / G_NN = " +
          number(indicator) +
          ", the limit is 1). Sliding that way may have no solution, or the contact may as well "
          "stay open or catch at once.",
      "The outcome depends on the start of the solver. Lower the friction there, move the "
      "contact, or let it give way (a compliant contact), where the motion is definite."};
}

}  // namespace

std::vector<Finding> painleve(const DenseProblem& dense, const Names& names) {
  const InclusionProblem& p = dense.problem();
  std::vector<Finding> out;
  const std::vector<int> joints = dense.rowsOf([&](int i) { return dense.isFree(i); });
  std::vector<int> sliding, still = joints;
  for (int i = 0; i < p.size(); ++i) {
    if (!dense.hasNormal(i) || p.dim(i) < 2) continue;
    if (auto f = single(dense, joints, i, names)) out.push_back(std::move(*f));
    const int first = p.row0(i), dim = p.dim(i);
    if (!(dense.Lambda()[first] > 0.0)) continue;
    const bool slides = dense.xi().segment(first + 1, dim - 1).norm() > 1e-6 * p.uRef;
    if (slides) sliding.push_back(i);
    if (!slides)
      for (int k = 0; k < dim; ++k) still.push_back(first + k);
  }
  std::sort(out.begin(), out.end(),
            [](const Finding& a, const Finding& b) { return a.value > b.value; });
  if (out.size() > 3) out.resize(3);
  if (!out.empty() || sliding.size() < 2) return out;
  // All sliding contacts together, with their present directions: H = G_NN + G_NT diag(Λ_T/Λ_N).
  const auto rows = dense.rowsOf(
      [&](int i) { return std::find(sliding.begin(), sliding.end(), i) != sliding.end(); });
  const Eigen::MatrixXd G = dense.reduced(rows, still);
  const auto n = static_cast<Eigen::Index>(sliding.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, G.rows()), along = normal;
  for (Eigen::Index k = 0, at = 0; k < n; ++k) {
    const int i = sliding[static_cast<std::size_t>(k)], first = p.row0(i), dim = p.dim(i);
    normal(k, at) = 1.0;
    along.row(k).segment(at, dim) =
        dense.Lambda().segment(first, dim).transpose() / dense.Lambda()[first];
    at += dim;
  }
  const Eigen::VectorXcd values = eigenvalues(normal * G * along.transpose());
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::complex<double> value = values[k];
    if (std::abs(value.imag()) > 1e-9 * std::abs(value) ||
        value.real() > -1e-9 * G.cwiseAbs().maxCoeff())
      continue;
    out.push_back(
        {FindingKind::painleve, sliding, value.real(),
         "Painleve's paradox is possible at contacts that slide together: " + names(sliding) +
             ". Their friction presses them more than their normal forces open them, "
             "though none does so alone.",
         "Lower the friction there, or let one of them give way."});
    break;
  }
  return out;
}

}  // namespace dynamy::diagnosis
