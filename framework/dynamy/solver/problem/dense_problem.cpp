#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/problem/dense_problem.hpp>

namespace dynamy {
namespace {

constexpr double kRankOfDense = 1e-11;  ///< relative size of an eigenvalue that counts as zero
constexpr double kTouching = 1e-8;      ///< fraction of u_ref: a smaller normal velocity is zero
constexpr double kForce = 1e-12;        ///< fraction of the largest force: a smaller one is none

}  // namespace

DenseProblem::DenseProblem(const InclusionProblem& problem, ConstVec Lambda)
    : problem_(&problem),
      G_(problem.rows(), problem.rows()),
      c_(ConstVec(problem.c.data(), problem.rows())),
      Lambda_(Lambda),
      scale_(problem.rows()) {
  for (int j = 0; j < problem.rows(); ++j) {
    const Eigen::VectorXd e = Eigen::VectorXd::Unit(problem.rows(), j);
    problem.G->apply(e.data(), G_.col(j).data());
  }
  xi_ = G_ * Lambda_ + c_;
  const double largest = problem.rows() > 0 ? Lambda_.lpNorm<Eigen::Infinity>() : 0.0;
  for (int i = 0; i < problem.size(); ++i) {
    const int first = problem.row0(i), dim = problem.dim(i);
    const double lambda = contactLambda(problem.G->diagonalBlock(i), dim);
    scale_.segment(first, dim).setConstant(lambda > 0.0 ? 1.0 / std::sqrt(lambda) : 1.0);
    free_.push_back(anyForceAllowed(i));
    const bool pressed = Lambda_.segment(first, dim).lpNorm<Eigen::Infinity>() > kForce * largest;
    closed_.push_back(!problem.law(i).unilateral() || pressed ||
                      xi_[first] <= kTouching * problem.uRef);
  }
  finite_ = xi_.allFinite() && c_.allFinite() &&
            (scale_.asDiagonal() * G_ * scale_.asDiagonal()).eval().allFinite();
}

bool DenseProblem::hasNormal(int contact) const {
  return problem_->law(contact).rowKind(0) == RowKind::normal;
}

bool DenseProblem::anyForceAllowed(int contact) const {
  // prox of ±z returns z only for C = ℝ^dim, if z is large against everything else.
  const int dim = problem_->dim(contact);
  const double size = 1e9 * (1.0 + (Lambda_.size() > 0 ? Lambda_.lpNorm<Eigen::Infinity>() : 0.0));
  double r[kMostRows], xi[kMostRows] = {}, z[kMostRows];
  std::fill(r, r + kMostRows, 1.0);
  for (int k = 0; k < dim; ++k)
    for (const double sign : {1.0, -1.0}) {
      std::fill(z, z + dim, 0.0);
      z[k] = sign * size;
      problem_->law(contact).prox(problem_->input(contact), r, xi, z);
      if (!(std::abs(z[k] - sign * size) <= 1e-6 * size)) return false;
    }
  return true;
}

Eigen::MatrixXd DenseProblem::proxJacobian(int contact) const {
  const int dim = problem_->dim(contact), first = problem_->row0(contact);
  const double rho = scale_[first] * scale_[first];
  const LawInput in = problem_->input(contact);
  const double *Lambda = Lambda_.data() + first, *xi = xi_.data() + first;
  double A[kMostRows * kMostRows], B[kMostRows * kMostRows];
  if (problem_->law(contact).proxDerivative(in, rho, xi, Lambda, A, B))
    return Eigen::MatrixXd::Identity(dim, dim) - ConstBlock(A, dim, dim);
  // Central differences for a law without derivative.
  Eigen::MatrixXd P(dim, dim);
  double r[kMostRows];
  std::fill(r, r + kMostRows, rho);
  const double h =
      1e-6 * (Eigen::Map<const Eigen::VectorXd>(Lambda, dim).norm() +
              rho * (problem_->uRef + Eigen::Map<const Eigen::VectorXd>(xi, dim).norm()));
  for (int k = 0; k < dim; ++k) {
    double plus[kMostRows], minus[kMostRows];
    std::copy(Lambda, Lambda + dim, plus), std::copy(Lambda, Lambda + dim, minus);
    plus[k] += h, minus[k] -= h;
    problem_->law(contact).prox(in, r, xi, plus);
    problem_->law(contact).prox(in, r, xi, minus);
    for (int m = 0; m < dim; ++m) P(m, k) = (plus[m] - minus[m]) / (2.0 * h);
  }
  return P;
}

Eigen::MatrixXd DenseProblem::kernel(const std::vector<int>& rows) const {
  const auto n = static_cast<Eigen::Index>(rows.size());
  if (n == 0 || !finite_) return Eigen::MatrixXd(n, 0);
  const Eigen::VectorXd s = scale_(rows);
  const Eigen::MatrixXd scaled = s.asDiagonal() * G_(rows, rows) * s.asDiagonal();
  const SymmetricEigenPairs eigen = symmetricEigenPairs(0.5 * (scaled + scaled.transpose()));
  const Eigen::VectorXd& sigma = eigen.values;  // ascending
  Eigen::Index zeros = 0;
  while (zeros < n && sigma[zeros] <= kRankOfDense * sigma[n - 1]) ++zeros;
  return eigen.vectors.leftCols(zeros);
}

Eigen::MatrixXd DenseProblem::reduced(const std::vector<int>& rows,
                                      const std::vector<int>& given) const {
  Eigen::MatrixXd out = G_(rows, rows);
  if (given.empty() || !finite_) return out;
  const Eigen::VectorXd s = scale_(given);
  const Eigen::MatrixXd Ggg = s.asDiagonal() * G_(given, given) * s.asDiagonal();
  PseudoInverse inverse(kRankOfDense);
  inverse.compute(Ggg);
  const Eigen::MatrixXd Ggr = s.asDiagonal() * G_(given, rows);
  const Eigen::MatrixXd Grg = G_(rows, given) * s.asDiagonal();
  return out - Grg * inverse.solve(Ggr);
}

}  // namespace dynamy
