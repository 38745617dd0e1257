#include <dynamy/located/step/located_settings.hpp>

namespace dynamy {
namespace {

constexpr double kLoose = 1e-2;  ///< from this tolerance up the method of order 5 is used

}  // namespace

const ButcherTableau& LocatedSettings::table() const {
  if (method != nullptr) return *method;
  return accuracy.tolerance >= kLoose ? dormandPrince5() : dormandPrince8();
}

}  // namespace dynamy
