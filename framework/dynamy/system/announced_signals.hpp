/// Signals by which elements tell in advance what no state shows, for schemes that locate switches:
///
///   nextInstant   after t: when a formula jumps or has a kink because of the time alone, a rope
///                 breaks as told, a feeder brings a grain [s]; a step ends there
///   switching     positive where remember() would switch the element, smooth along a motion; a
///                 step ends where it passes zero, and remember() is called there
///
/// Any element may have the first, contact elements the second, those of users too. They are not
/// recorded unless they are named. Virtual functions of their own were rejected: few elements have
/// something to tell, and signals can be looked at like any other.
#pragma once
#include <dynamy/core/declared/element.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

inline constexpr const char* kNextInstant = "nextInstant";
inline constexpr const char* kSwitching = "switching";

/// Adds nextInstant if `next`, the first instant after t [s], finds any after the start at 0.
void announceInstants(Description& d, std::function<double(double)> next);

/// Schemes that locate switches ask contact elements alone for `switching`: throws a ModelError if
/// `e`, of another kind, has it and `scheme` is such a scheme's type.
void refuseSwitching(const Element& e, const std::string& scheme);

}  // namespace dynamy
