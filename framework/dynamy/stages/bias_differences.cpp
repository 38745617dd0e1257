#include <algorithm>
#include <cmath>
#include <dynamy/stages/bias_differences.hpp>
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {
namespace {

/// Length of the difference over the time in which x passes through its scales: truncation 3e-14,
/// rounding 1e-13 of the rate of γ.
constexpr double kBesideState = 1e-3;
/// Number of shorter differences where contacts come or go within the difference, and the factor of
/// each: the last one has a rounding of 3e-11.
constexpr int kShorterLooks = 2;
constexpr double kShorten = 1.0 / 16.0;

/// Rate at which x passes through `scales`, at least 1/time [1/s].
double goesThrough(const State& x, const Eigen::VectorXd* scales, double time) {
  double rate = 1.0 / time;
  for (Eigen::Index i = 0; scales && i < x.u.size(); ++i)
    rate = std::max(rate, std::abs(x.u[i]) / (*scales)[i]);
  return rate;
}

}  // namespace

bool BiasDifferences::rates(const MechanicalSystem& s, const State& x,
                            const std::optional<HeldContacts>& held, Eigen::VectorXd& out,
                            double aside) {
  return ratesOver(kBesideState / goesThrough(x, scales_, time_), s, x, held, out, aside);
}

bool BiasDifferences::ratesOver(double d, const MechanicalSystem& s, const State& x,
                                const std::optional<HeldContacts>& held, Eigen::VectorXd& out,
                                double aside) {
  const double weight[4] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0},
               at[4] = {-2.0, -1.0, 1.0, 2.0};
  std::optional<HeldContacts> asked = held;
  if (asked) asked->alone = true;  // rates of closed contacts do not depend on open ones
  for (int p = 0; p < 4; ++p) {
    beside_.t = x.t, beside_.q = x.q, beside_.u = x.u, beside_.memory = x.memory;
    s.move(beside_, x.u, (at[p] + aside) * d);
    const ContactSet& c = look_.at(s, beside_, asked);
    if (p == 0) out.setZero(c.rows());
    if (out.size() != c.rows()) return false;
    gamma_.resize(c.rows());
    c.gamma(view(x.u), view(gamma_));
    out += weight[p] / d * gamma_;
  }
  return true;
}

bool BiasDifferences::has(const ContactSet& c, int i) const {
  return std::binary_search(elements_.begin(), elements_.end(),
                            c.element[static_cast<std::size_t>(i)]);
}

void BiasDifferences::fill(const MechanicalSystem& s, const State& x,
                           const std::optional<HeldContacts>& held, ContactSet& c) {
  bool any = false;
  for (int i = 0; i < c.size() && !any && !elements_.empty(); ++i) any = has(c, i);
  if (!any) return;
  double time = time_;
  const auto known = [&] {
    const double d = kBesideState / goesThrough(x, scales_, time);
    return ratesOver(d, s, x, held, bias_, 0.0) && bias_.size() == c.rows();
  };
  bool found = known();
  for (int i = 0; i < kShorterLooks && !found; ++i) {
    time = kShorten / goesThrough(x, scales_, time);
    found = known();
  }
  if (!found) return;
  for (int i = 0; i < c.size(); ++i)
    for (int r = 0; has(c, i) && r < c.dim(i); ++r) {
      const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)] + r);
      c.bias[row] = bias_[static_cast<Eigen::Index>(row)];
    }
}

}  // namespace dynamy
