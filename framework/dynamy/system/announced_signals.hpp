/// Signals by which elements announce what no state shows, for schemes that locate switches:
///
///   nextInstant   first instant after t at which a formula jumps or has a kink because of the time
///                 alone, a rope breaks at a given time, a feeder adds a grain [s]; a step ends
///                 there
///   nextSample    first instant after t at which remember() takes a sample of the motion [s]; with
///                 every scheme, also one of fixed steps, a step ends there
///   switching     positive where remember() would switch the element, smooth along a motion; a
///                 step ends where it passes zero, and remember() is called there; of systems,
///                 positive where renew() would change them
///
/// Any element may have the signals nextInstant and nextSample, contact elements and systems that
/// renew themselves also switching; elements of users may, too. All are recorded only if the model
/// names them. Rejected: virtual functions in their place, because few elements announce anything,
/// and signals can be plotted like any other.
#pragma once
#include <dynamy/core/declared/element.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

inline constexpr const char* kNextInstant = "nextInstant";
inline constexpr const char* kNextSample = "nextSample";
inline constexpr const char* kSwitching = "switching";

/// Adds the signal nextInstant if next(0) is finite. next(t): the first instant after t [s].
void announceInstants(Description& d, std::function<double(double)> next);

/// Adds the signals nextSample and nextInstant. next(t): the first sample after t [s].
void announceSamples(Description& d, const std::function<double(double)>& next);

/// Throws a ModelError if `e`, which is neither a contact element nor renews itself, has the signal
/// `switching`. `scheme`: type of the scheme that locates switches; it does not read this signal.
void refuseSwitching(const Element& e, const std::string& scheme);

}  // namespace dynamy
