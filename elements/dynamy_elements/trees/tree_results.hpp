/// TreeResults: the last results of a Tree, kept with their q and u. During one evaluation most
/// calls have the same q and u.
#pragma once
#include <algorithm>
#include <cstring>
#include <dynamy_elements/trees/tree.hpp>

namespace dynamy {

class TreeResults {
 public:
  void resize(const Tree& tree) {
    const auto n = static_cast<std::size_t>(tree.size());
    x_.resize(n), factors_.resize(n);
    inertia.resize(n), wrench.resize(2 * n);
    q_.assign(static_cast<std::size_t>(tree.nq()), 0.0);
    u_.assign(static_cast<std::size_t>(tree.nu()), 0.0);
  }
  const Tree::Motions& at(const Tree& tree, ConstVec q) {
    if (posed_ && same(q, q_)) return x_;
    std::copy(q.data(), q.data() + q.size(), q_.data());
    posed_ = true, moves_ = factored_ = false, ++changes_;
    tree.pose(q_.data(), x_);
    return x_;
  }
  const Tree::Motions& at(const Tree& tree, ConstVec q, ConstVec u) {
    at(tree, q);
    if (moves_ && same(u, u_)) return x_;
    std::copy(u.data(), u.data() + u.size(), u_.data());
    moves_ = true, ++changes_;
    tree.rates(u_.data(), x_);
    return x_;
  }
  /// Articulated inertias at the q of the last at().
  const std::vector<Tree::Articulated>& factors(const Tree& tree) {
    if (!factored_) tree.factor(x_, factors_);
    factored_ = true;
    return factors_;
  }
  /// Number of times that q or u have changed.
  long changes() const { return changes_; }

  std::vector<Mat3> inertia;  ///< workspaces, one and two per node
  std::vector<Vec3> wrench;
  /// Workspaces of a step at the mean velocity, one number per velocity.
  struct Mean {
    Eigen::VectorXd f, u, before, mean, h, change, sum;
  } step;

 private:
  /// Bitwise comparison, so that results for NaN are not computed again.
  static bool same(ConstVec a, const std::vector<double>& b) {
    return b.empty() || std::memcmp(a.data(), b.data(), b.size() * sizeof(double)) == 0;
  }
  std::vector<double> q_, u_;
  long changes_ = 0;
  bool posed_ = false, moves_ = false, factored_ = false;
  Tree::Motions x_;
  std::vector<Tree::Articulated> factors_;
};

}  // namespace dynamy
