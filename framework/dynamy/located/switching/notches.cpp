#include <cmath>
#include <dynamy/located/phase/force_set.hpp>
#include <dynamy/located/switching/notches.hpp>

namespace dynamy {

bool notched(const ContactSet& c, std::size_t i) {
  return hasNotch(*c.law[i], c.dim(static_cast<int>(i)));
}

double notchMiddle(const ErrorNorm& norm) {
  constexpr double kMiddle = 1e-12;  // of L
  return kMiddle * norm.length();
}

double notchSide(const ContactSet& c, std::size_t i, const double* gamma, const OngoingEvent& at) {
  if (!notched(c, i)) return 0.0;
  const double x = c.position[static_cast<std::size_t>(c.row0[i])];
  if (std::abs(x) > notchMiddle(at.norm)) return x > 0.0 ? 1.0 : -1.0;
  return std::abs(gamma[0]) > at.slipSpeed() ? (gamma[0] > 0.0 ? 1.0 : -1.0) : 0.0;
}

void restInNotches(ContactSet& c, const Eigen::VectorXd& gamma, const OngoingEvent& at) {
  // The decision gets exactly x = 0, not the rounding that is left after h_s.
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < c.key.size(); row += c.dim(static_cast<int>(i)), ++i)
    if (double& x = c.position[static_cast<std::size_t>(c.row0[i])];
        notched(c, i) && std::abs(gamma[row]) <= at.slipSpeed() &&
        std::abs(x) <= 2.0 * notchMiddle(at.norm))
      x = 0.0;
}

}  // namespace dynamy
