#include <algorithm>
#include <dynamy/located/switching/noted_contacts.hpp>

namespace dynamy {
namespace {

/// `keys`: ascending.
bool hasSorted(const std::vector<ContactKey>& keys, ContactKey key) {
  return std::binary_search(keys.begin(), keys.end(), key);
}

}  // namespace

std::span<const ContactKey> NotedContacts::read(const ContactSet& evaluated,
                                                const std::vector<ContactKey>& followed) {
  overlap_ = evaluated.features.overlap, deepest_ = evaluated.features.deepest;
  jumpingOverlap_ = evaluated.features.jumpingOverlap, jumping_ = evaluated.features.jumping;
  noted_ = evaluated.features.noted, unseen_ = evaluated.features.unseen;
  fresh_ = std::any_of(noted_.begin(), noted_.end(),
                       [&](ContactKey key) { return !hasSorted(followed, key); });
  unknown_.clear();
  for (const ContactKey key : noted_)
    if (!hasSorted(reported_, key) && !hasSorted(unreported_, key)) unknown_.push_back(key);
  std::sort(unknown_.begin(), unknown_.end());
  return unknown_;
}

void NotedContacts::learn(const ContactSet& evaluated) {
  for (const ContactKey key : unknown_) {
    const bool found =
        std::find(evaluated.key.begin(), evaluated.key.end(), key) != evaluated.key.end();
    std::vector<ContactKey>& known = found ? reported_ : unreported_;
    known.insert(std::upper_bound(known.begin(), known.end(), key), key);
  }
}

ContactKey NotedContacts::unreported() const {
  const auto first = std::find_if(noted_.begin(), noted_.end(),
                                  [&](ContactKey key) { return hasSorted(unreported_, key); });
  return first == noted_.end() ? kNoContact : *first;
}

}  // namespace dynamy
