/// f′(0) of f: double → VectorXd by central differences with the steps h, h/2, h/4 …, extrapolated
/// to step zero as a polynomial of h² [Neville]. For each entry the value in the table that differs
/// least from its neighbours is taken; `error` grows to the largest of these differences.
///
/// f may have kinks beside 0: a tyre leaves the road. Of a smooth f the second difference over h² is the
/// same for all steps, and the first difference changes by a quarter from step to step of what it changed
/// before. Steps across a kink show in the second one, across two kinks at ± the same place in the first.
/// An entry begins anew where it shows, and steps are halved further where an entry is rough after seven.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dynamy {

class ExtrapolatedDerivative {
 public:
  explicit ExtrapolatedDerivative(Eigen::VectorXd f0) : f0_(std::move(f0)) {
    best_ = Eigen::VectorXd::Zero(f0_.size()), curvature_ = best_, second_ = best_, change_ = best_;
    size_ = f0_.cwiseAbs();
    bound_ = Eigen::VectorXd::Constant(f0_.size(), std::numeric_limits<double>::infinity());
    first_.assign(static_cast<std::size_t>(f0_.size()), 0);
  }
  /// Adds f at ± h, half of the h before.
  void add(const Eigen::VectorXd& after, const Eigen::VectorXd& before, double h) {
    std::vector<Eigen::VectorXd> row(1, (after - before) / (2.0 * h));
    if (levels_ == 0) best_ = row[0];
    size_ = size_.cwiseMax(after.cwiseAbs()).cwiseMax(before.cwiseAbs());
    for (Eigen::Index i = 0; i < best_.size(); ++i)
      judge(i, after[i], before[i], h, levels_ > 0 ? row[0][i] - old_[0][i] : 0.0);
    double power = 1.0;
    for (std::size_t k = 1; k <= old_.size(); ++k) {
      power *= 4.0;
      row.push_back(row[k - 1] + (row[k - 1] - old_[k - 1]) / (power - 1.0));
      for (Eigen::Index i = 0; i < best_.size(); ++i) {
        if (levels_ < first_[static_cast<std::size_t>(i)] + static_cast<int>(k)) continue;
        const double off =
            std::max(std::abs(row[k][i] - row[k - 1][i]), std::abs(row[k][i] - old_[k - 1][i]));
        if (off < bound_[i]) bound_[i] = off, best_[i] = row[k][i];
      }
    }
    old_ = std::move(row), ++levels_;
  }
  bool wantsMore() const {
    return levels_ < kLevels ||
           (levels_ < kMostLevels && error() > kRough * best_.cwiseAbs().maxCoeff());
  }
  const Eigen::VectorXd& best() const { return best_; }
  double error() const { return bound_.size() > 0 ? bound_.maxCoeff() : 0.0; }

 private:
  static constexpr int kLevels = 7, kMostLevels = 18;
  static constexpr double kRough = 1e-9;  ///< of the largest entry
  static constexpr double kSeen = 1e-9;   ///< of f: second differences that are no rounding
  static constexpr double kSmall = 1e-6;  ///< of the largest entry: entries that may be rounding,
  static constexpr double kLeast = 1.0;   ///< and of any size [m/s², rad/s²]
  static constexpr double kSame = 0.5;    ///< change of the curvature from step to step

  /// Begins entry i anew at this step if there is a kink between it and the step before. `change`:
  /// of the difference since that step.
  void judge(Eigen::Index i, double after, double before, double h, double change) {
    const double second = after - 2.0 * f0_[i] + before, curvature = second / (h * h);
    const double scale = std::max({size_[i], kSmall * size_.maxCoeff(), kLeast});
    const bool seen = std::max(std::abs(second), 0.25 * std::abs(second_[i])) > kSeen * scale;
    const double most = std::max(std::abs(curvature), std::abs(curvature_[i]));
    const bool bends = levels_ > 0 && seen && std::abs(curvature - curvature_[i]) > kSame * most;
    const bool turns = levels_ > 1 && h * std::abs(change) > kSeen * scale &&
                       std::abs(change) > std::abs(change_[i]);
    if (bends || turns) {
      first_[static_cast<std::size_t>(i)] = levels_;
      bound_[i] = std::numeric_limits<double>::infinity(), best_[i] = (after - before) / (2.0 * h);
    }
    curvature_[i] = curvature, second_[i] = second, change_[i] = change;
  }

  Eigen::VectorXd f0_, best_, bound_, curvature_, second_, change_;
  Eigen::VectorXd size_;  // largest |f| so far
  std::vector<Eigen::VectorXd> old_;
  std::vector<int> first_;  // the step with which each entry began
  int levels_ = 0;
};

template <class F>
Eigen::VectorXd extrapolatedDerivative(const F& f, double h, double& error) {
  ExtrapolatedDerivative d(f(0.0));
  for (; d.wantsMore(); h *= 0.5) {
    const Eigen::VectorXd after = f(h);
    d.add(after, f(-h), h);
  }
  error = std::max(error, d.error());
  return d.best();
}

}  // namespace dynamy
