#include <cmath>
#include <dynamy/contact/spatial_rows.hpp>

namespace dynamy {
namespace {

/// Six velocities: products of fixed size are unrolled and vectorised. Most of the work of a stack
/// is in them.
using Six = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;

}  // namespace

void ContactSet::clear() {
  candidateKey.clear(), g.clear(), candidateElement.clear(), closedIndex.clear();
  key.clear(), law.clear(), element.clear(), candidate.clear();
  row0.assign(1, 0), segment0.assign(1, 0);
  segment.clear(), W.clear(), chi.clear(), bias.clear(), position.clear(), scale.clear();
  places.clear(), features.clear();
}

void ContactSet::gamma(ConstVec u, Vec gamma) const {
  if (spatial::all(*this)) {
    spatial::forContacts(
        *this,
        [&](spatial::RowSums& sums, int k, const Segment& s) {
          sums.add(W.data() + spatial::kNumbers * k, u.data() + s.u0);
        },
        [&](int i, const spatial::RowSums& sums) {
          sums.put(chi.data() + 3 * i, gamma.data() + 3 * i);
        });
    return;
  }
  for (int i = 0; i < size(); ++i) {
    const int first = row0[static_cast<std::size_t>(i)], rows = dim(i);
    for (int r = 0; r < rows; ++r) gamma[first + r] = chi[static_cast<std::size_t>(first + r)];
    for (int k = segment0[static_cast<std::size_t>(i)];
         k < segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      const Segment& s = segment[static_cast<std::size_t>(k)];
      const double* w = W.data() + s.w;
      const double* v = u.data() + s.u0;
      if (s.nu == 6 && rows == 3) {
        spatial::addProduct(w, v, gamma.data() + first);
        continue;
      }
      if (s.nu == 6) {
        for (int r = 0; r < rows; ++r, w += 6) gamma[first + r] += Six(w).dot(Six(v));
        continue;
      }
      for (int r = 0; r < rows; ++r, w += s.nu) {
        double sum = 0.0;
        for (int j = 0; j < s.nu; ++j) sum += w[j] * v[j];
        gamma[first + r] += sum;
      }
    }
  }
}

void ContactSet::addAbsolute(ConstVec v, double* sum) const {
  if (spatial::all(*this)) {
    spatial::forContacts(
        *this,
        [&](spatial::RowSums& sums, int k, const Segment& s) {
          sums.addAbsolute(W.data() + spatial::kNumbers * k, v.data() + s.u0);
        },
        [&](int i, const spatial::RowSums& sums) { sums.put(sum + 3 * i, sum + 3 * i); });
    return;
  }
  for (int i = 0; i < size(); ++i)
    for (int k = segment0[static_cast<std::size_t>(i)];
         k < segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      const Segment& s = segment[static_cast<std::size_t>(k)];
      const double *w = W.data() + s.w, *part = v.data() + s.u0;
      double* out = sum + row0[static_cast<std::size_t>(i)];
      for (int r = 0; r < dim(i); ++r, w += s.nu)
        if (s.nu == 6)
          out[r] += Six(w).cwiseAbs().dot(Six(part));
        else
          for (int j = 0; j < s.nu; ++j) out[r] += std::abs(w[j]) * part[j];
    }
}

int ContactSet::find(int elementIndex, std::uint64_t id) const {
  const ContactKey wanted = contactKey(elementIndex, id);
  for (std::size_t i = 0; i < key.size(); ++i)
    if (key[i] == wanted) return static_cast<int>(i);
  return -1;
}

}  // namespace dynamy
