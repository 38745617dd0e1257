/// Part of a contact set as a contact set: chosen contacts, with their first rows and another law.
#pragma once
#include <dynamy/contact/contact_set.hpp>

namespace dynamy {

/// Appends the closed contact `i` of `all` to `out`, which has been cleared once: its first `rows`
/// rows under `law`.
void append(const ContactSet& all, int i, int rows, const SetValuedForceLaw& law, ContactSet& out);

/// Rate of the gap of contact `i` at the velocities u, and the least one if all of its bodies but one
/// were stopped [m/s].
struct GapRate {
  double gamma = 0.0, alone = 0.0;
};
GapRate gapRate(const ContactSet& all, int i, ConstVec u);

/// Whether the gap of contact `i` stays open within dt [s] at the velocities u, with half of its rate
/// to spare, and also if one of its bodies were stopped.
bool staysOpen(const ContactSet& all, int i, ConstVec u, double dt);

/// Whether `aside` of `all` contacts that stay open are worth leaving out: 36 and more, and three of
/// four. Then the reach of one fast body covers what it does not meet; in a heap most gaps within
/// reach are soon asked.
inline bool worthLeavingOut(int aside, int all) {
  constexpr int kFew = 36;
  return aside >= kFew && 4 * aside >= 3 * all;
}

}  // namespace dynamy
