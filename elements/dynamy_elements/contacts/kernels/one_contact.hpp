/// OneContact: the kernel of a pair that makes one contact, which moves without jumps.
#pragma once
#include <dynamy_elements/contacts/kernels/pair_report.hpp>

namespace dynamy {

/// `kAt(pair)`: the contact. A function given as an argument of the template is compiled into
/// the kernel, so that the innermost pairs cost one indirect call.
template <auto kAt, Following kFollowing = Following::gaps>
class OneContact : public PairKernel {
 public:
  void contacts(PairReport& report) const override { report.add(0, kAt(report.pair())); }
  double gap(const PosedPair& pair, std::size_t) const override { return kAt(pair).g; }
  Following following(const TouchingShape&, const TouchingShape&) const override {
    return kFollowing;
  }
};

/// Least gap of the first n of some contacts [m].
template <class Contacts>
double leastGap(const Contacts& found, int n) {
  double least = std::numeric_limits<double>::infinity();
  for (int c = 0; c < n; ++c) least = std::min(least, found[static_cast<std::size_t>(c)].at.g);
  return least;
}

}  // namespace dynamy
