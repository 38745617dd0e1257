/// ContactsOfBlocks: for every mass block the contacts that act on it, by their segments. Contacts
/// that share a block are coupled: their block of G is not zero.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <span>
#include <vector>

namespace dynamy {

class ContactsOfBlocks {
 public:
  /// Lists the segments of every block. Nothing is allocated once the arrays are large enough.
  void link(const ContactSet& contacts, int blocks);
  /// Number of the blocks.
  int blocks() const { return static_cast<int>(first_.size()) - 1; }
  /// Segments on `block`, as indices of ContactSet::segment, ascending.
  std::span<const int> segments(int block) const {
    const auto b = static_cast<std::size_t>(block);
    return {segments_.data() + first_[b], static_cast<std::size_t>(first_[b + 1] - first_[b])};
  }
  /// Contact that a segment belongs to.
  int contact(int segment) const { return contact_[static_cast<std::size_t>(segment)]; }
  /// Contacts that share a block with contact i, i included, ascending. `contacts`: those linked.
  void neighbours(const ContactSet& contacts, int i, std::vector<int>& out) const;

 private:
  std::vector<int> first_{0};  // block b has the entries first_[b] … first_[b + 1] − 1
  std::vector<int> segments_, contact_, fill_;
};

}  // namespace dynamy
