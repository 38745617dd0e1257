/// DiagonalBlocks: the blocks G_ii of all contacts, dim_i × dim_i numbers each, row after row.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <vector>

namespace dynamy {

struct DiagonalBlocks {
  std::vector<std::ptrdiff_t> first;  ///< where the numbers of a block begin; size() + 1 entries
  std::vector<double> value;

  /// Makes room for one block per contact; the numbers are not set.
  void resize(const ContactSet& contacts) {
    first.resize(static_cast<std::size_t>(contacts.size()) + 1);
    std::ptrdiff_t size = 0;
    for (int i = 0; i < contacts.size(); ++i) {
      first[static_cast<std::size_t>(i)] = size;
      size += static_cast<std::ptrdiff_t>(contacts.dim(i)) * contacts.dim(i);
    }
    first.back() = size;
    value.resize(static_cast<std::size_t>(size));
  }
  double* block(int i) { return value.data() + first[static_cast<std::size_t>(i)]; }
  const double* block(int i) const { return value.data() + first[static_cast<std::size_t>(i)]; }
};

}  // namespace dynamy
