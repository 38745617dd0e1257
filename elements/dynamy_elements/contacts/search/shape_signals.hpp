/// Signals of the contacts between shapes: each contact if they are few, sums of many, loads on the
/// ground.
#pragma once
#include <dynamy_elements/contacts/search/pair_rules.hpp>

namespace dynamy {

/// `shapes`, `rules`: borrowed by the signals.
void describeContacts(Description& d, const ShapeSet& shapes, const PairRules& rules);

}  // namespace dynamy
