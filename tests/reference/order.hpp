/// Orders of convergence: slopes of log(error) over log(Δt), and limits by Richardson's
/// elimination.
#pragma once
#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

namespace dynamy::reference {

/// error ≈ constant · Δt^order, least squares in logarithms.
struct Fit {
  double order = 0.0, constant = 0.0;
};
inline std::ostream& operator<<(std::ostream& out, const Fit& f) {
  return out << "order " << f.order << ", constant " << f.constant;
}

inline Fit fitOrder(const std::vector<double>& dt, const std::vector<double>& error) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(dt.size());
  for (std::size_t i = 0; i < dt.size(); ++i) {
    const double x = std::log(dt[i]), y = std::log(error[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double order = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return {order, std::exp((sy - order * sx) / n)};
}

/// `count` steps, each half of the one before.
inline std::vector<double> halvings(double first, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(std::ldexp(first, -i));
  return out;
}

/// The limit of values at steps halved each time, whose error has the powers p, p + q, p + 2q, …
inline double richardson(std::vector<double> values, int p, int q) {
  for (std::size_t level = 1; level < values.size(); ++level) {
    const double factor = std::exp2(p + q * (static_cast<int>(level) - 1));
    for (std::size_t i = values.size() - 1; i >= level; --i)
      values[i] = (factor * values[i] - values[i - 1]) / (factor - 1.0);
  }
  return values.back();
}

/// Largest of f(Δt) over `samples` steps spread over [dt, 1.3 dt): errors across impacts depend on
/// where in a step the impact falls, only their envelope has an order.
template <class F>
double envelope(double dt, int samples, const F& f) {
  double out = 0.0;
  for (int k = 0; k < samples; ++k)
    out = std::max(out, std::abs(f(dt * (1.0 + 0.3 * k / samples))));
  return out;
}

}  // namespace dynamy::reference
