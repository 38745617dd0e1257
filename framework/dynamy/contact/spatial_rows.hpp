/// Kernels for contacts of three rows on free bodies, as in stacks and heaps: W is then one array
/// of 3 × 6 numbers per segment, without gaps.
///
/// Sizes are checked once per pass instead of once per segment, because the checks take as many
/// instructions as the products themselves.
#pragma once
#include <algorithm>
#include <dynamy/contact/contact_set.hpp>

namespace dynamy::spatial {

inline constexpr std::ptrdiff_t kNumbers = 18;  ///< numbers of W per segment
using Rows = Eigen::Map<const Eigen::Matrix<double, 3, 6, Eigen::RowMajor>>;
using Velocity = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;

/// True: all contacts have three rows and all segments six velocities. Contact i then has the rows
/// 3i … 3i + 2, segment k the numbers 18k … 18k + 17 of W.
inline bool all(const ContactSet& c) {
  if (c.size() == 0 || c.segment0.size() != c.row0.size()) return false;
  for (int i = 0; i <= c.size(); ++i)
    if (c.row0[static_cast<std::size_t>(i)] != 3 * i) return false;
  return std::all_of(c.segment.begin(), c.segment.end(),
                     [](const Segment& s) { return s.nu == 6; });
}

/// Calls visit(contact, segment number, segment) in order. \pre c.row0, c.segment0 are filled
template <class Visit>
void forSegments(const ContactSet& c, Visit&& visit) {
  const Segment* segment = c.segment.data();
  const int* first = c.segment0.data();
  for (int i = 0, n = c.size(); i < n; ++i)
    for (int k = first[i]; k < first[i + 1]; ++k) visit(i, k, segment[k]);
}

/// Sum of W v over all segments of a contact. Even and odd columns are summed separately, and their
/// sums added at the end.
class RowSums {
 public:
  void add(const double* W, const double* v) {
    const Pair a = Load(v), b = Load(v + 2), c = Load(v + 4);
    n_ += Load(W) * a + Load(W + 2) * b + Load(W + 4) * c;
    t_ += Load(W + 6) * a + Load(W + 8) * b + Load(W + 10) * c;
    s_ += Load(W + 12) * a + Load(W + 14) * b + Load(W + 16) * c;
  }
  /// Adds |W| v instead of W v.
  void addAbsolute(const double* W, const double* v) {
    const Pair a = Load(v), b = Load(v + 2), c = Load(v + 4);
    n_ += Load(W).abs() * a + Load(W + 2).abs() * b + Load(W + 4).abs() * c;
    t_ += Load(W + 6).abs() * a + Load(W + 8).abs() * b + Load(W + 10).abs() * c;
    s_ += Load(W + 12).abs() * a + Load(W + 14).abs() * b + Load(W + 16).abs() * c;
  }
  /// out = start + W v
  void put(const double* start, double* out) const {
    out[0] = start[0] + (n_[0] + n_[1]);
    out[1] = start[1] + (t_[0] + t_[1]);
    out[2] = start[2] + (s_[0] + s_[1]);
  }

 private:
  using Pair = Eigen::Array2d;
  using Load = Eigen::Map<const Pair>;
  Pair n_ = Pair::Zero(), t_ = Pair::Zero(), s_ = Pair::Zero();
};

/// Calls, for each contact, add(sums, segment number, segment) for its segments and then
/// put(contact, sums).
template <class Add, class Put>
void forContacts(const ContactSet& c, Add&& add, Put&& put) {
  const Segment* segment = c.segment.data();
  const int* first = c.segment0.data();
  for (int i = 0, n = c.size(); i < n; ++i) {
    RowSums sums;
    for (int k = first[i]; k < first[i + 1]; ++k) add(sums, k, segment[k]);
    put(i, sums);
  }
}

/// out += W v
inline void addProduct(const double* W, const double* v, double* out) {
  Eigen::Map<Vec3>{out} += Rows(W).lazyProduct(Velocity(v));
}
/// v += Wᵀ x
inline void addTransposed(const double* W, const double* x, double* v) {
  Eigen::Map<Eigen::Matrix<double, 6, 1>>{v} +=
      Rows(W).transpose().lazyProduct(Eigen::Map<const Vec3>(x));
}

}  // namespace dynamy::spatial
