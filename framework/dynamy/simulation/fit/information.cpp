#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <dynamy/simulation/fit/information.hpp>

namespace dynamy {
namespace {

constexpr double kSeen = 10.0;  ///< times its rounding: the column of an unknown that is seen
/// A column shorter than this part of the longest, in typical changes, may be noise of the runs. It
/// is if it changes by kChange with three times the difference.
constexpr double kShort = 1e-5, kWide = 3.0, kChange = 0.1;
/// Singular values of J with columns of length 1 that are zero. Derivatives are good to about 1e-9,
/// those across switches to 1e-4.
constexpr double kRank = 1e-6, kRankAcross = 1e-3;
constexpr double kPart = 1e-3;  ///< of an unknown in the null space

/// "k and m: changes by +1 % and +0.5 % together leave …".
std::string togetherText(const FitProblem& problem, const Eigen::VectorXd& x,
                         const Eigen::VectorXd& direction) {
  std::vector<std::string> names, changes;
  Eigen::VectorXd relative = direction;
  for (int i = 0; i < x.size(); ++i)
    if (x[i] != 0.0) relative[i] /= std::abs(x[i]);
  const double most = relative.cwiseAbs().maxCoeff();
  for (int i = 0; i < x.size(); ++i) {
    const double part = relative[i] / most;
    if (std::abs(part) < kPart) continue;
    names.push_back(unknownName(problem, i));
    changes.push_back(fmt::format("{:+.3g} %", part));
  }
  return fmt::format(
      "{} cannot be told apart: changes by {} together leave all that is measured "
      "as it is",
      fmt::join(names, " and "), fmt::join(changes, " and "));
}

bool anyAcross(const FitProblem& problem) {
  return std::any_of(problem.runs().begin(), problem.runs().end(),
                     [](const RunResiduals& r) { return r.across(); });
}

}  // namespace

std::string unknownName(const FitProblem& problem, int unknown) {
  const FitProblem::Unknown& u = problem.unknowns()[static_cast<std::size_t>(unknown)];
  const FitRequest& request = problem.request();
  const std::string& name = request.parameters[static_cast<std::size_t>(u.parameter)].name;
  if (u.run < 0) return name;
  return name + '[' + request.runs[static_cast<std::size_t>(u.run)].name + ']';
}

std::vector<char> seenUnknowns(FitProblem& problem, const Eigen::VectorXd& x,
                               const Eigen::MatrixXd& J) {
  const int n = problem.size();
  Eigen::VectorXd length(n), inSizes(n);
  std::vector<char> out(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    length[i] = J.col(i).norm(), inSizes[i] = length[i] * problem.unknowns()[k].size;
    out[k] = length[i] > kSeen * problem.rounding(i) ? 1 : 0;
  }
  const double least = n > 0 ? kShort * inSizes.maxCoeff() : 0.0;
  Eigen::MatrixXd wide;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!out[k] || inSizes[i] >= least) continue;
    if (wide.size() == 0) wide = problem.jacobian(x, kWide);
    out[k] = (wide.col(i) - J.col(i)).norm() < kChange * length[i] ? 1 : 0;
  }
  return out;
}

Information informationAt(FitProblem& problem, const Eigen::VectorXd& x) {
  const int n = problem.size();
  Information out;
  out.J = problem.jacobian(x);
  const bool across = anyAcross(problem);
  out.identifiable = out.seen = seenUnknowns(problem, x, out.J);
  std::vector<int> columns;
  for (int i = 0; i < n; ++i)
    if (out.identifiable[static_cast<std::size_t>(i)])
      columns.push_back(i);
    else
      out.open.push_back(unknownName(problem, i) +
                         " itself is not identifiable: nothing that is measured depends on it");
  out.covariance = out.inverse = Eigen::MatrixXd::Zero(n, n);
  const auto m = static_cast<Eigen::Index>(columns.size());
  if (m == 0) return out;
  const Eigen::MatrixXd J = out.J(Eigen::all, columns);
  const Eigen::VectorXd length = J.colwise().norm();
  const Eigen::MatrixXd scaled = J * length.cwiseInverse().asDiagonal();
  // The factor R of J has its singular values, and as few rows as columns.
  const Eigen::MatrixXd R = Eigen::HouseholderQR<Eigen::MatrixXd>(scaled)
                                .matrixQR()
                                .topRows(std::min(J.rows(), m))
                                .triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(R, Eigen::ComputeFullV);
  const Eigen::VectorXd& s = svd.singularValues();
  const double least = (across ? kRankAcross : kRank) * s[0];
  Eigen::VectorXd open = Eigen::VectorXd::Zero(m);
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(m, m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const Eigen::VectorXd v = svd.matrixV().col(k).cwiseQuotient(length);
    if (k < s.size() && s[k] > least) {
      C += v * v.transpose() / (s[k] * s[k]), ++out.rank;
      continue;
    }
    open += svd.matrixV().col(k).cwiseAbs2();
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    direction(columns) = v;
    out.open.push_back(togetherText(problem, x, direction));
  }
  out.inverse(columns, columns) = C;
  for (Eigen::Index i = 0; i < m; ++i)
    if (std::sqrt(open[i]) > kPart) {
      out.identifiable[static_cast<std::size_t>(columns[static_cast<std::size_t>(i)])] = 0;
      C.row(i).setZero(), C.col(i).setZero();
    }
  out.covariance(columns, columns) = C;
  return out;
}

}  // namespace dynamy
