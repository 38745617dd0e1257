/// PhaseFault: why no smooth phase with the present statuses holds at some state.
#pragma once
#include <dynamy/core/types.hpp>
#include <string>
#include <string_view>

namespace dynamy {

struct PhaseFault {
  /// The fault where `contact` is held but not reported.
  static constexpr std::string_view kLost = "a contact that is held is no longer reported";
  /// The fault where `contact` slips and its set has no bounds at this slip: a set that depends on
  /// γ^A has become another one, without a gap or the end of a slip as a switch before it.
  static constexpr std::string_view kOtherSet =
      "the set of a law that slips loses its bounds at some slip: no smooth phase holds past it";
  std::string why;     ///< empty: no fault
  ContactKey contact;  ///< of the last fault kLost or kOtherSet
};

}  // namespace dynamy
