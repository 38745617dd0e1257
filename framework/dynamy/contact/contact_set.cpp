#include <dynamy/contact/contact_set.hpp>

namespace dynamy {

void ContactSet::clear() {
  candidateKey.clear(), g.clear(), candidateElement.clear(), closedIndex.clear();
  key.clear(), law.clear(), element.clear(), candidate.clear();
  row0.assign(1, 0), segment0.assign(1, 0);
  segment.clear(), W.clear(), chi.clear(), bias.clear(), position.clear();
  point.clear(), normal.clear(), t1.clear(), t2.clear();
}

void ContactSet::gamma(ConstVec u, Vec gamma) const {
  for (int i = 0; i < size(); ++i) {
    const int first = row0[static_cast<std::size_t>(i)], rows = dim(i);
    for (int r = 0; r < rows; ++r) gamma[first + r] = chi[static_cast<std::size_t>(first + r)];
    for (int k = segment0[static_cast<std::size_t>(i)];
         k < segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      const Segment& s = segment[static_cast<std::size_t>(k)];
      const double* w = W.data() + s.w;
      const double* v = u.data() + s.u0;
      for (int r = 0; r < rows; ++r, w += s.nu) {
        double sum = 0.0;
        for (int j = 0; j < s.nu; ++j) sum += w[j] * v[j];
        gamma[first + r] += sum;
      }
    }
  }
}

int ContactSet::find(int elementIndex, std::uint64_t id) const {
  const ContactKey wanted = contactKey(elementIndex, id);
  for (std::size_t i = 0; i < key.size(); ++i)
    if (key[i] == wanted) return static_cast<int>(i);
  return -1;
}

}  // namespace dynamy
