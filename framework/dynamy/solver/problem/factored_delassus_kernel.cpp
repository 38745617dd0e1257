#include <algorithm>
#include <cmath>
#include <dynamy/contact/spatial_rows.hpp>
#include <dynamy/solver/problem/dot_product.hpp>
#include <dynamy/solver/problem/factored_delassus.hpp>
#include <dynamy/solver/problem/free_bodies.hpp>

namespace dynamy {
namespace {

/// minvW ← M⁻¹ w, row after row, in the layout of W.
void inverseTimesW(const ContactSet& contacts, const MassMatrix& mass, std::vector<double>& minvW) {
  for (int i = 0; i < contacts.size(); ++i)
    for (int k = contacts.segment0[static_cast<std::size_t>(i)];
         k < contacts.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      const Segment& s = contacts.segment[static_cast<std::size_t>(k)];
      const double* A = mass.inverse(s.block).data();
      const double* diagonal = mass.inverseDiagonal(s.block);
      const double* w = contacts.W.data() + s.w;
      double* out = minvW.data() + s.w;
      if (diagonal && s.nu == 6 && contacts.dim(i) == 3) {
        for (int r = 0; r < 3; ++r)
          Eigen::Map<Eigen::Matrix<double, 6, 1>>{out + 6 * r} =
              SixVelocities(w + 6 * r).cwiseProduct(SixVelocities(diagonal));
        continue;
      }
      for (int r = 0; r < contacts.dim(i); ++r, w += s.nu, out += s.nu)
        if (diagonal)
          for (int j = 0; j < s.nu; ++j) out[j] = diagonal[j] * w[j];
        else
          for (int j = 0; j < s.nu; ++j)
            out[j] = dotProduct(A + static_cast<std::ptrdiff_t>(j) * s.nu, w, s.nu);
    }
}

}  // namespace

void FactoredDelassus::factor(const ContactSet& contacts, const MassMatrix& mass,
                              DiagonalBlocks& diagonal) {
  contacts_ = &contacts, mass_ = &mass;
  minvW_.resize(contacts.W.size());
  links_.link(contacts, mass.blocks());
  v_.resize(static_cast<std::size_t>(
      mass.blocks() == 0 ? 0 : mass.u0(mass.blocks() - 1) + mass.nu(mass.blocks() - 1)));
  if (freeBodies(contacts, mass, minvW_, diagonal)) return;
  inverseTimesW(contacts, mass, minvW_);
  diagonal.resize(contacts);
  for (int i = 0; i < contacts.size(); ++i) diagonalBlock(i, diagonal.block(i));
}

int FactoredDelassus::touchedVelocities() const {
  int velocities = 0;
  for (int b = 0; b < mass_->blocks(); ++b)
    if (!links_.segments(b).empty()) velocities += mass_->nu(b);
  return velocities;
}

void FactoredDelassus::diagonalBlock(int i, double* out) const {
  const ContactSet& c = *contacts_;
  const int first = c.segment0[static_cast<std::size_t>(i)],
            end = c.segment0[static_cast<std::size_t>(i) + 1];
  bool spatial = c.dim(i) == 3;
  for (int k = first; spatial && k < end; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    spatial =
        s.nu == 6 && (k == first || s.block != c.segment[static_cast<std::size_t>(first)].block);
  }
  if (!spatial || end - first > 2) return block(i, i, out);
  // One or two rigid bodies: G_ii is symmetric, six of nine numbers are computed.
  std::fill(out, out + 9, 0.0);
  for (int k = first; k < end; ++k) {
    const std::ptrdiff_t w = c.segment[static_cast<std::size_t>(k)].w;
    const double *W = c.W.data() + w, *M = minvW_.data() + w;
    for (int r = 0; r < 3; ++r)
      for (int m = r; m < 3; ++m)
        out[3 * r + m] += SixVelocities(W + 6 * r).dot(SixVelocities(M + 6 * m));
  }
  out[3] = out[1], out[6] = out[2], out[7] = out[5];
}

void FactoredDelassus::block(int i, int j, double* out) const {
  const ContactSet& c = *contacts_;
  const int di = c.dim(i), dj = c.dim(j);
  std::fill(out, out + static_cast<std::ptrdiff_t>(di) * dj, 0.0);
  for (int a = c.segment0[static_cast<std::size_t>(i)];
       a < c.segment0[static_cast<std::size_t>(i) + 1]; ++a)
    for (int b = c.segment0[static_cast<std::size_t>(j)];
         b < c.segment0[static_cast<std::size_t>(j) + 1]; ++b) {
      const Segment& s = c.segment[static_cast<std::size_t>(a)];
      const Segment& o = c.segment[static_cast<std::size_t>(b)];
      if (s.block != o.block) continue;
      for (int r = 0; r < di; ++r)
        for (int k = 0; k < dj; ++k)
          out[r * dj + k] +=
              dotProduct(c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu,
                         minvW_.data() + o.w + static_cast<std::ptrdiff_t>(k) * s.nu, s.nu);
    }
}

void FactoredDelassus::addTo(double* G) const {
  const ContactSet& c = *contacts_;
  const int n = c.rows();
  for (int b = 0; b < links_.blocks(); ++b)
    for (const int p : links_.segments(b))
      for (const int q : links_.segments(b)) {
        const Segment &s = c.segment[static_cast<std::size_t>(p)],
                      &o = c.segment[static_cast<std::size_t>(q)];
        const int i = links_.contact(p), j = links_.contact(q);
        const int ri = c.row0[static_cast<std::size_t>(i)],
                  rj = c.row0[static_cast<std::size_t>(j)];
        for (int r = 0; r < c.dim(i); ++r)
          for (int k = 0; k < c.dim(j); ++k)
            G[static_cast<std::size_t>((ri + r) * n + rj + k)] +=
                dotProduct(c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu,
                           minvW_.data() + o.w + static_cast<std::ptrdiff_t>(k) * s.nu, s.nu);
      }
}

void FactoredDelassus::begin(const double* Lambda) {
  std::fill(v_.begin(), v_.end(), 0.0);
  addVelocity(Lambda, {v_.data(), static_cast<Eigen::Index>(v_.size())});
}

void FactoredDelassus::row(int i, double* out) const {
  const ContactSet& c = *contacts_;
  const int dim = c.dim(i);
  for (int r = 0; r < dim; ++r) out[r] = 0.0;
  for (int k = c.segment0[static_cast<std::size_t>(i)];
       k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    if (s.nu == 6 && dim == 3) {
      spatial::addProduct(c.W.data() + s.w, v_.data() + s.u0, out);
      continue;
    }
    for (int r = 0; r < dim; ++r)
      out[r] += dotProduct(c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu,
                           v_.data() + s.u0, s.nu);
  }
}

void FactoredDelassus::addVelocity(int i, const double* delta, double* u) const {
  const ContactSet& c = *contacts_;
  for (int k = c.segment0[static_cast<std::size_t>(i)];
       k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    double* v = u + s.u0;
    if (s.nu == 6 && c.dim(i) == 3) {
      spatial::addTransposed(minvW_.data() + s.w, delta, v);
      continue;
    }
    for (int r = 0; r < c.dim(i); ++r) {
      const double* w = minvW_.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu;
      if (s.nu == 6)
        Eigen::Map<Eigen::Matrix<double, 6, 1>>{v} += delta[r] * SixVelocities(w);
      else
        for (int j = 0; j < s.nu; ++j) v[j] += w[j] * delta[r];
    }
  }
}

void FactoredDelassus::addVelocity(const double* Lambda, Vec u) const {
  if (spatial::all(*contacts_)) {
    spatial::forSegments(*contacts_, [&](int i, int k, const Segment& s) {
      spatial::addTransposed(minvW_.data() + spatial::kNumbers * k, Lambda + 3 * i,
                             u.data() + s.u0);
    });
    return;
  }
  for (int i = 0; i < contacts_->size(); ++i)
    addVelocity(i, Lambda + contacts_->row0[static_cast<std::size_t>(i)], u.data());
}

void FactoredDelassus::apply(const double* x, double* y) {
  begin(x);
  if (spatial::all(*contacts_)) {
    constexpr double kZero[3] = {};
    spatial::forContacts(
        *contacts_,
        [&](spatial::RowSums& sums, int k, const Segment& s) {
          sums.add(contacts_->W.data() + spatial::kNumbers * k, v_.data() + s.u0);
        },
        [&](int i, const spatial::RowSums& sums) { sums.put(kZero, y + 3 * i); });
    return;
  }
  for (int i = 0; i < contacts_->size(); ++i)
    row(i, y + contacts_->row0[static_cast<std::size_t>(i)]);
}

void FactoredDelassus::applyAbsolute(const double* x, double* y) {
  const ContactSet& c = *contacts_;
  absolute_.assign(v_.size(), 0.0);
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
      const Segment& s = c.segment[static_cast<std::size_t>(k)];
      const double* w = minvW_.data() + s.w;
      double* v = absolute_.data() + s.u0;
      for (int r = 0; r < c.dim(i); ++r, w += s.nu)
        if (s.nu == 6)
          Eigen::Map<Eigen::Matrix<double, 6, 1>>{v} +=
              std::abs(x[c.row0[at] + r]) * SixVelocities(w).cwiseAbs();
        else
          for (int j = 0; j < s.nu; ++j) v[j] += std::abs(w[j] * x[c.row0[at] + r]);
    }
  }
  std::fill(y, y + c.rows(), 0.0);
  c.addAbsolute({absolute_.data(), static_cast<Eigen::Index>(absolute_.size())}, y);
}

}  // namespace dynamy
