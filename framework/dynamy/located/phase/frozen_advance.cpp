// FrozenPhase: sub-steps that meet the constraint on velocities at the next position.
#include <algorithm>
#include <dynamy/located/phase/frozen_phase.hpp>

namespace dynamy {

bool FrozenPhase::rowsAhead(const ContactSet& next, const Eigen::VectorXd& before, double tau) {
  ahead_.setZero(before.size(), rows());
  biasAhead_.resize(rows());
  for (std::size_t i = 0; i < held.size(); ++i) {
    // The same contacts were requested at both positions, in the same order.
    const int at = index_[i];
    if (at >= next.size() || next.key[static_cast<std::size_t>(at)] != held[i].key) {
      fault_ = kLost, lost_ = held[i].key;
      return false;
    }
    for (int r = 0; r < dim(i); ++r) {
      const int row = row0_[i] + r, of = held[i].first + r;
      addRow(next, at, of, ahead_, row);
      const auto from = static_cast<std::size_t>(next.row0[static_cast<std::size_t>(at)] + of);
      biasAhead_[row] = (ahead_.col(row).dot(before) + next.chi[from]) / tau;
    }
  }
  return true;
}

bool FrozenPhase::advance(const Evaluation& e, const Eigen::VectorXd& u, const ContactSet& next,
                          const Eigen::VectorXd& before, double tau, Eigen::VectorXd& a) {
  fault_ = {};
  if (!gather(e, u) || !shapes(e) || !rowsAhead(next, before, tau)) return false;
  if (std::any_of(held.begin(), held.end(), [](const Held& h) { return h.starts; })) {
    solve(e, W_, bias_);
    startDirections(e);
  }
  // Wᵀ(q_{k+1}) (u_{k−1} + τ a) + χ = 0.
  solve(e, ahead_, biasAhead_);
  a = free_;
  finish(e, u);
  return true;
}

}  // namespace dynamy
