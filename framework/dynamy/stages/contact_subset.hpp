/// Part of a contact set as a contact set: chosen contacts, with their first rows and another law.
#pragma once
#include <dynamy/contact/contact_set.hpp>

namespace dynamy {

/// Appends the closed contact `i` of `all` to `out`, which has been cleared once: its first `rows`
/// rows under `law`.
void append(const ContactSet& all, int i, int rows, const SetValuedForceLaw& law, ContactSet& out);

}  // namespace dynamy
