#include <algorithm>
#include <dynamy/contact/near_contacts.hpp>

namespace dynamy {

void NearContacts::order() {
  std::sort(ranges_.begin(), ranges_.end(),
            [](const Range& a, const Range& b) { return a.first < b.first; });
  ranges_.erase(std::unique(ranges_.begin(), ranges_.end()), ranges_.end());
}

bool NearContacts::has(ContactKey key) const {
  const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), key,
                                      [](ContactKey k, const Range& r) { return k < r.first; });
  return after != ranges_.begin() && key < std::prev(after)->end;
}

void NearContacts::select(std::span<const ContactKey> keys, std::vector<ContactKey>& out) const {
  out.clear();
  auto key = keys.begin();
  for (const Range& r : ranges_) {
    key = std::lower_bound(key, keys.end(), r.first);
    for (; key != keys.end() && *key < r.end; ++key) out.push_back(*key);
  }
}

std::vector<NearContacts::Range>::const_iterator NearContacts::startOf(int element) const {
  return std::lower_bound(ranges_.begin(), ranges_.end(), contactKey(element, 0),
                          [](const Range& r, ContactKey k) { return r.first < k; });
}

}  // namespace dynamy
