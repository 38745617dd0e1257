// Checks of the forces of a built model.
#include <fmt/format.h>
#include <dynamy/core/constants.hpp>

#include <cmath>
#include <dynamy/testing/difference.hpp>
#include <dynamy/testing/random_motion.hpp>
#include <limits>

namespace dynamy {

namespace {

using testing::RandomMotion, testing::labelOf;

}  // namespace

Verdict checkForces(Model& model, const CheckOptions& options) {
  Verdict result;
  RandomMotion motion(model, options);
  const int nu = model.topology().nu();
  Eigen::VectorXd h(nu), nonPotential(nu);
  for (int i = 0; i < options.states && result; ++i) {
    motion.sample(i);
    const State x = motion.x();
    for (const auto& force : model.forces()) {
      h.setZero(), nonPotential.setZero();
      ForceSink sink(view(h), view(nonPotential));
      sink.hasPotential(force->hasPotential());
      force->addTo(motion.kinematics(x), sink);
      const std::string name = labelOf(*force, "force");
      if (!h.allFinite()) result.fault(name + ": a force is not finite");
      if (!force->hasPotential()) {
        result.leftOut(name + ": it states no potential with which its force could be compared");
        continue;
      }
      const double V = force->potentialEnergy(motion.kinematics(x));
      State later = x;
      later.t += 0.37;
      // If the force is driven through t, its power is not all of dV/dt.
      if (force->potentialEnergy(motion.kinematics(later)) != V) {
        result.leftOut(name + ": its power, since its potential changes with time by itself");
        continue;
      }
      const testing::Difference D = testing::differentiate([&](double s) {
        return Eigen::VectorXd::Constant(1,
                                         force->potentialEnergy(motion.kinematics(motion.after(s))))
            .eval();
      });
      const double power = h.dot(x.u),
                   rounding = 64.0 * kEpsilon * h.cwiseAbs().dot(x.u.cwiseAbs());
      // Forces of stiff springs are small differences of lengths: a billionth of their power.
      const double small = 1e-9 * std::max(std::abs(power), std::abs(D.value[0]));
      if (!(std::abs(power + D.value[0]) <= D.error + rounding + small))
        result.fault(
            fmt::format("{}: force·u = {:.9g} W, but -dV/dt = {:.9g} W", name, power, -D.value[0]));
    }
  }
  return result;
}

}  // namespace dynamy
