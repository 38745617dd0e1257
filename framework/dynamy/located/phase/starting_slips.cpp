#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/starting_slips.hpp>

namespace dynamy {
namespace {

constexpr double kTurned = 1e-14;  ///< change of a direction that ends the iteration
constexpr int kPlain = 10;         ///< turns without a factor
constexpr double kLeastAitken = 0.05, kMostAitken = 3.0;

bool isOne(const Held& h, std::size_t i, const HeldRows& rows) {
  return h.starts && rows.slipRows(i) > 1;
}

}  // namespace

bool StartingSlips::turn(std::vector<Held>& held, const HeldRows& rows, const HeldForces& forces) {
  double change = 0.0;
  required_.resize(rows.size()), size_ = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (isOne(held[i], i, rows)) change = std::max(change, require(held[i], i, rows, forces));
  // The forces are those of the directions as they are: a run that goes on from here finds the same.
  if (!(change > kTurned)) return false;
  last_.swap(change_);
  change_ = required_.head(size_);
  int first = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    for (int n = 0; isOne(held[i], i, rows) && n < rows.slipRows(i); ++n)
      change_[first++] -= held[i].direction[static_cast<std::size_t>(n)];
  if (turns_++ >= kPlain && last_.size() == size_) {
    const double squared = (change_ - last_).squaredNorm();
    const double factor = squared > 0.0 ? -factor_ * last_.dot(change_ - last_) / squared : 1.0;
    factor_ = std::clamp(factor, kLeastAitken, kMostAitken);
  }
  first = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (isOne(held[i], i, rows)) turnTo(held[i], i, rows, first), first += rows.slipRows(i);
  return true;
}

/// Adds the direction that the force of held[i] requires to required_. Returns how far it differs.
double StartingSlips::require(const Held& h, std::size_t i, const HeldRows& rows,
                              const HeldForces& forces) {
  const ForceSet& set = rows.set(i);
  const Eigen::VectorXd& lambda = forces.lambda();
  const int first = rows.slip0(i), k = rows.slipRows(i), row0 = rows.row0(i);
  const bool reservoir = set.form == ForceSet::Form::reservoir;
  double r[kMostRows], z[kMostRows], y[kMostRows];
  double G = 0.0;
  for (int n = 0; n < k; ++n) {
    r[n] = 1.0 / rows.W().col(first + n).dot(rows.MInvW().col(first + n));
    G += 1.0 / (r[n] * k);
  }
  for (int n = 0; n < k; ++n) {
    if (!reservoir) r[n] = 1.0 / G;
    const double gammaDot = rows.along(first + n, forces.a()) + rows.present().r[first + n];
    y[n] = z[n] = lambda[first + n] - r[n] * gammaDot;
  }
  if (reservoir)
    set.set->project({rows.dim(i), 1.0, rows.gamma().data() + row0}, lambda[row0], r, k, y);
  for (int n = 0; n < k; ++n) y[n] = reservoir ? (y[n] - z[n]) / r[n] : -z[n];
  const double length = set.speed(k, y);
  double change = 0.0;
  for (int n = 0; n < k; ++n, ++size_) {
    const auto at = static_cast<std::size_t>(n);
    required_[size_] = length > 0.0 ? y[n] / length : h.direction[at];
    change = std::max(change, set.weight[at] * std::abs(required_[size_] - h.direction[at]));
  }
  return change;
}

/// Turns held[i] towards its entries of required_, which begin at `first`.
void StartingSlips::turnTo(Held& h, std::size_t i, const HeldRows& rows, int first) const {
  const int k = rows.slipRows(i);
  double t[kMostRows] = {};
  for (int n = 0; n < k; ++n)
    t[n] = h.direction[static_cast<std::size_t>(n)] + factor_ * change_[first + n];
  const double length = rows.set(i).speed(k, t);
  const bool plain = factor_ == 1.0 || !(length > kLeastAitken);
  for (int n = 0; n < k; ++n)
    h.direction[static_cast<std::size_t>(n)] = plain ? required_[first + n] : t[n] / length;
}

}  // namespace dynamy
