/// Chosen contacts of a set as a contact set of their own, with their first rows and another law.
#pragma once
#include <dynamy/contact/contact_set.hpp>

namespace dynamy {

/// Appends the first `rows` rows of the closed contact `i` of `all` to `out`, with the law `law`.
/// `out` has been cleared once before.
void append(const ContactSet& all, int i, int rows, const SetValuedForceLaw& law, ContactSet& out);

/// Rate of the gap of contact `i` at the velocities u (gamma), and the least rate if all of its
/// bodies but one were stopped (alone) [m/s].
struct GapRate {
  double gamma = 0.0, alone = 0.0;
};
GapRate gapRate(const ContactSet& all, int i, ConstVec u);

/// Whether the gap of contact `i` stays open within dt [s] at the velocities u, with half of its rate
/// to spare, and also if one of its bodies were stopped.
bool staysOpen(const ContactSet& all, int i, ConstVec u, double dt);

/// True: leaving out `aside` of `all` contacts pays, since they are at least 36 and at least three
/// of four. Then the reach of one fast body covers contacts that it does not meet; in a heap, most
/// gaps within reach would soon have to be added again.
inline bool worthLeavingOut(int aside, int all) {
  constexpr int kFew = 36;
  return aside >= kFew && 4 * aside >= 3 * all;
}

}  // namespace dynamy
