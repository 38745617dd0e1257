#include <algorithm>
#include <dynamy/located/step/held_state.hpp>

namespace dynamy {

bool HeldState::fits(const SystemParts& parts, Eigen::Index numbers) const {
  const auto elements = static_cast<int>(parts.contacts.size());
  const auto known = [&](const Held& h) {
    return elementOf(h.key) < elements && h.first >= 0 && h.first < kMostRows && h.rows >= 0 &&
           h.rows <= kMostRows;
  };
  const Eigen::Index placed = 1 + 2 * numbers;
  return std::all_of(held.begin(), held.end(), known) &&
         std::all_of(missing.begin(), missing.end(),
                     [&](int e) { return e >= 0 && e < elements; }) &&
         (jacobian.size() == 0 || jacobian.size() == placed) && pace.empty >= 0 &&
         pace.searches.possible();
}

}  // namespace dynamy
