/// NearContacts: the contacts that can close on a path, as ranges of keys.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <span>
#include <vector>

namespace dynamy {

class NearContacts {
 public:
  void clear() { ranges_.clear(), some_ = false; }
  /// Adds the contacts `first` … `end` − 1 of an element.
  void add(int element, std::uint64_t first, std::uint64_t end) {
    ranges_.push_back({contactKey(element, first), contactKey(element, end)});
    some_ = true;
  }
  /// Adds all contacts of an element that cannot tell which of them are near.
  void addAll(int element) {
    ranges_.push_back({contactKey(element, 0), contactKey(element + 1, 0)});
  }
  /// Adds what is near there.
  void add(const NearContacts& other) {
    ranges_.insert(ranges_.end(), other.ranges_.begin(), other.ranges_.end());
    some_ = some_ || other.some_;
  }
  /// Orders what was added; to be called before the functions below.
  void order();
  /// True: there are contacts of elements that can tell which of theirs are near.
  bool some() const { return some_; }
  bool has(ContactKey key) const;
  /// Of `keys`, ascending, the near ones.
  void select(std::span<const ContactKey> keys, std::vector<ContactKey>& out) const;
  /// Calls f(first) for the first number of each range of an element.
  template <class F>
  void forEach(int element, F&& f) const {
    for (auto r = startOf(element); r != ranges_.end() && r->first < contactKey(element + 1, 0);
         ++r)
      f(contactNumber(r->first));
  }

 private:
  struct Range {
    ContactKey first, end;
    bool operator==(const Range& other) const = default;
  };
  std::vector<Range>::const_iterator startOf(int element) const;
  std::vector<Range> ranges_;
  bool some_ = false;
};

}  // namespace dynamy
