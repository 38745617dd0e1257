#include <algorithm>
#include <dynamy/solver/problem/contacts_of_blocks.hpp>

namespace dynamy {

void ContactsOfBlocks::link(const ContactSet& c, int blocks) {
  // By counting.
  first_.assign(static_cast<std::size_t>(blocks) + 1, 0);
  for (const Segment& s : c.segment) ++first_[static_cast<std::size_t>(s.block) + 1];
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  segments_.resize(c.segment.size());
  contact_.resize(c.segment.size());
  fill_.assign(first_.begin(), first_.end());
  for (int i = 0; i < c.size(); ++i)
    for (int k = c.segment0[static_cast<std::size_t>(i)];
         k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      contact_[static_cast<std::size_t>(k)] = i;
      segments_[static_cast<std::size_t>(
          fill_[static_cast<std::size_t>(c.segment[static_cast<std::size_t>(k)].block)]++)] = k;
    }
}

void ContactsOfBlocks::neighbours(const ContactSet& c, int i, std::vector<int>& out) const {
  out.clear();
  for (int k = c.segment0[static_cast<std::size_t>(i)];
       k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k)
    for (const int other : segments(c.segment[static_cast<std::size_t>(k)].block))
      out.push_back(contact(other));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

}  // namespace dynamy
