#include <algorithm>
#include <cmath>
#include <dynamy/stages/contact_subset.hpp>

namespace dynamy {

void append(const ContactSet& all, int i, int rows, const SetValuedForceLaw& law, ContactSet& out) {
  const auto at = static_cast<std::size_t>(i);
  const auto first = static_cast<std::size_t>(all.row0[at]);
  out.key.push_back(all.key[at]), out.law.push_back(&law), out.element.push_back(all.element[at]);
  out.candidate.push_back(all.candidate[at]), out.scale.push_back(all.scale[at]);
  out.row0.push_back(out.row0.back() + rows), out.segment0.push_back(out.segment0.back());
  for (std::size_t r = first; r < first + static_cast<std::size_t>(rows); ++r)
    out.chi.push_back(all.chi[r]), out.position.push_back(all.position[r]);
  for (int k = all.segment0[at]; k < all.segment0[at + 1]; ++k) {
    Segment s = all.segment[static_cast<std::size_t>(k)];
    const double* w = all.W.data() + s.w;
    s.w = static_cast<std::ptrdiff_t>(out.W.size());
    out.W.insert(out.W.end(), w, w + static_cast<std::ptrdiff_t>(rows) * s.nu);
    out.segment.push_back(s), ++out.segment0.back();
  }
}

GapRate gapRate(const ContactSet& all, int i, ConstVec u) {
  const auto at = static_cast<std::size_t>(i);
  const double chi = all.chi[static_cast<std::size_t>(all.row0[at])];
  GapRate out{chi, chi};
  for (int k = all.segment0[at]; k < all.segment0[at + 1]; ++k) {
    const Segment& s = all.segment[static_cast<std::size_t>(k)];
    const double* w = all.W.data() + s.w;
    double part = 0.0;
    for (int j = 0; j < s.nu; ++j) part += w[j] * u[s.u0 + j];
    out.gamma += part, out.alone = std::min(out.alone, chi + part);
  }
  return out;
}

bool staysOpen(const ContactSet& all, int i, ConstVec u, double dt) {
  const GapRate rate = gapRate(all, i, u);
  const int row = all.row0[static_cast<std::size_t>(i)];
  const double open = all.position[static_cast<std::size_t>(row)] / dt;
  return open + rate.gamma > 0.5 * std::abs(rate.gamma) && open + rate.alone > 0.0;
}

}  // namespace dynamy
