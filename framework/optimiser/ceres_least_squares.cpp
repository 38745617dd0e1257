/// The method of Levenberg and Marquardt of Ceres: `minimise` of dynamy/simulation/fit.
#include <ceres/ceres.h>
#include <glog/logging.h>

#include <cmath>
#include <dynamy/simulation/fit/least_squares.hpp>

namespace dynamy {
namespace {

/// Relative change of the unknowns, and slope, below which the search ends. Derivatives of runs are
/// good to about 1e-9.
constexpr double kUnknowns = 1e-10, kSlope = 1e-12;
/// Tries in a row without residuals, each with a quarter of the step before, or less.
constexpr int kTries = 20;

/// A block of residuals; each unknown is a parameter block of Ceres.
class BlockCost final : public ceres::CostFunction {
 public:
  explicit BlockCost(const LeastSquares::Block& block) : block_(block) {
    set_num_residuals(block.residuals);
    mutable_parameter_block_sizes()->assign(block.of.size(), 1);
  }
  bool Evaluate(const double* const* x, double* r, double** J) const override {
    const std::size_t n = block_.of.size();
    std::vector<double> at(n),
        all(J == nullptr ? 0 : n * static_cast<std::size_t>(num_residuals()));
    for (std::size_t i = 0; i < n; ++i) at[i] = *x[i];
    if (!block_.evaluate(at.data(), r, J == nullptr ? nullptr : all.data())) return false;
    for (std::size_t i = 0; J != nullptr && i < n; ++i)
      for (std::size_t k = 0; J[i] != nullptr && k < static_cast<std::size_t>(num_residuals()); ++k)
        J[i][k] = all[k * n + i];
    return true;
  }

 private:
  const LeastSquares::Block& block_;
};

}  // namespace
}  // namespace dynamy

extern "C" void dynamyMinimise(const dynamy::LeastSquares& problem, Eigen::VectorXd& x,
                               dynamy::LeastSquaresEnd& end) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // steps without residuals are no news
  ceres::Problem ceres;
  for (int i = 0; i < x.size(); ++i) {
    ceres.AddParameterBlock(&x[i], 1);
    if (std::isfinite(problem.lower[i])) ceres.SetParameterLowerBound(&x[i], 0, problem.lower[i]);
    if (std::isfinite(problem.upper[i])) ceres.SetParameterUpperBound(&x[i], 0, problem.upper[i]);
    if (!problem.fixed.empty() && problem.fixed[static_cast<std::size_t>(i)])
      ceres.SetParameterBlockConstant(&x[i]);
  }
  for (const dynamy::LeastSquares::Block& block : problem.blocks) {
    std::vector<double*> of;
    for (const int i : block.of) of.push_back(&x[i]);
    ceres.AddResidualBlock(new dynamy::BlockCost(block), nullptr, of);  // the problem owns it
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = problem.iterations;
  options.max_num_consecutive_invalid_steps = dynamy::kTries;
  options.function_tolerance = problem.sum;
  options.parameter_tolerance = dynamy::kUnknowns;
  options.gradient_tolerance = dynamy::kSlope;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceres, &summary);
  end.converged = summary.termination_type == ceres::CONVERGENCE;
  end.iterations = static_cast<int>(summary.iterations.size()) - 1;
  end.why = summary.message;
}
