#include <algorithm>
#include <cmath>
#include <dynamy/contact/spatial_rows.hpp>
#include <dynamy/solver/problem/delassus.hpp>
#include <dynamy/solver/problem/free_bodies.hpp>

namespace dynamy {
namespace {

/// Rows up to which the dense matrix pays: n² numbers stay in the first-level cache.
constexpr int kDenseRows = 64;
/// Rows above which the dense matrix pays only if the bodies have at least as many velocities:
/// otherwise Newton's method works in velocities and needs only W.
constexpr int kFewRows = 16;

/// Six velocities: unrolled and vectorised, where most of the work of a stack is.
using RigidBody = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;

double dot(const double* a, const double* b, int n) {
  if (n == 6) return RigidBody(a).dot(RigidBody(b));
  double s = 0.0;
  for (int j = 0; j < n; ++j) s += a[j] * b[j];
  return s;
}

/// out = A x for `rows` of n numbers: the sums of a contact's rows run side by side, each in the
/// order of dot().
template <int rows>
void dots(const double* A, const double* x, int n, double* out) {
  double s[rows] = {};
  for (int j = 0; j < n; ++j)
    for (int r = 0; r < rows; ++r) s[r] += A[static_cast<std::ptrdiff_t>(r) * n + j] * x[j];
  for (int r = 0; r < rows; ++r) out[r] = s[r];
}

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
              RigidBody(w + 6 * r).cwiseProduct(RigidBody(diagonal));
        continue;
      }
      for (int r = 0; r < contacts.dim(i); ++r, w += s.nu, out += s.nu)
        if (diagonal)
          for (int j = 0; j < s.nu; ++j) out[j] = diagonal[j] * w[j];
        else
          for (int j = 0; j < s.nu; ++j)
            out[j] = dot(A + static_cast<std::ptrdiff_t>(j) * s.nu, w, s.nu);
    }
}

}  // namespace

void Delassus::assemble(const ContactSet& contacts, const MassMatrix& mass, Form form) {
  contacts_ = &contacts, mass_ = &mass, n_ = contacts.rows(), given_ = sparse_ = false;
  minvW_.resize(contacts.W.size());
  linkBlocks();
  if (!freeBodies(contacts, mass, minvW_, diagonal0_, diagonal_)) {
    inverseTimesW(contacts, mass, minvW_);
    fillDiagonal();
  }
  assembled_ = form == Form::assembled || (form == Form::automatic && densePays());
  if (assembled_)
    fillDense();
  else
    v_.resize(static_cast<std::size_t>(
        mass.blocks() == 0 ? 0 : mass.u0(mass.blocks() - 1) + mass.nu(mass.blocks() - 1)));
}

bool Delassus::densePays() const {
  if (n_ <= kFewRows || n_ > kDenseRows) return n_ <= kFewRows;
  int velocities = 0;  // of touched blocks
  for (int b = 0; b < mass_->blocks(); ++b)
    if (blockFirst_[static_cast<std::size_t>(b) + 1] > blockFirst_[static_cast<std::size_t>(b)])
      velocities += mass_->nu(b);
  return n_ <= velocities;
}

void Delassus::given(const ContactSet& contacts, BlockRows G) {
  contacts_ = &contacts, mass_ = nullptr, n_ = contacts.rows(), given_ = true;
  blockRows_ = std::move(G);
  assembled_ = n_ <= kDenseRows;
  // An index per block costs about as much as four numbers.
  sparse_ = 4 * blockRows_.column.size() + blockRows_.value.size() <
            static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_);
  fillDiagonal();
  if (!assembled_) return;
  const auto n = static_cast<std::size_t>(n_);
  G_.assign(n * n, 0.0);
  for (int i = 0; i < contacts.size(); ++i)
    for (int k = blockRows_.first[i]; k < blockRows_.first[i + 1]; ++k) {
      const int j = blockRows_.column[k], dj = contacts.dim(j);
      const double* value = blockRows_.value.data() + blockRows_.value0[k];
      for (int r = 0; r < contacts.dim(i); ++r)
        for (int m = 0; m < dj; ++m)
          G_[static_cast<std::size_t>(contacts.row0[i] + r) * n +
             static_cast<std::size_t>(contacts.row0[j] + m)] = value[r * dj + m];
    }
}

void Delassus::fillDiagonal() {
  const ContactSet& contacts = *contacts_;
  diagonal0_.resize(static_cast<std::size_t>(contacts.size()) + 1);
  std::ptrdiff_t size = 0;
  for (int i = 0; i < contacts.size(); ++i) {
    diagonal0_[static_cast<std::size_t>(i)] = size;
    size += static_cast<std::ptrdiff_t>(contacts.dim(i)) * contacts.dim(i);
  }
  diagonal_.resize(static_cast<std::size_t>(size));
  for (int i = 0; i < contacts.size(); ++i)
    fillBlock(i, diagonal_.data() + diagonal0_[static_cast<std::size_t>(i)]);
}

void Delassus::fillBlock(int i, double* out) const {
  const ContactSet& c = *contacts_;
  const int first = c.segment0[static_cast<std::size_t>(i)],
            end = c.segment0[static_cast<std::size_t>(i) + 1];
  bool spatial = !given_ && c.dim(i) == 3;
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
      for (int m = r; m < 3; ++m) out[3 * r + m] += RigidBody(W + 6 * r).dot(RigidBody(M + 6 * m));
  }
  out[3] = out[1], out[6] = out[2], out[7] = out[5];
}

const BlockRows& Delassus::blockRows() {
  if (given_) return blockRows_;
  const ContactSet& c = *contacts_;
  blockRows_.clear();
  for (int i = 0; i < c.size(); ++i) {
    neighbours(i, near_);
    for (const int j : near_) {
      blockRows_.column.push_back(j);
      const auto at = blockRows_.value.size();
      blockRows_.value0.push_back(static_cast<std::ptrdiff_t>(at));
      blockRows_.value.resize(at + static_cast<std::size_t>(c.dim(i) * c.dim(j)));
      block(i, j, blockRows_.value.data() + at);
    }
    blockRows_.first.push_back(static_cast<int>(blockRows_.column.size()));
  }
  return blockRows_;
}

void Delassus::linkBlocks() {
  // List the segments of every mass block, by counting.
  const ContactSet& c = *contacts_;
  blockFirst_.assign(static_cast<std::size_t>(mass_->blocks()) + 1, 0);
  for (const Segment& s : c.segment) ++blockFirst_[static_cast<std::size_t>(s.block) + 1];
  for (std::size_t b = 1; b < blockFirst_.size(); ++b) blockFirst_[b] += blockFirst_[b - 1];
  blockSegments_.resize(c.segment.size());
  segmentContact_.resize(c.segment.size());
  fill_.assign(blockFirst_.begin(), blockFirst_.end());
  for (int i = 0; i < c.size(); ++i)
    for (int k = c.segment0[static_cast<std::size_t>(i)];
         k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      segmentContact_[static_cast<std::size_t>(k)] = i;
      blockSegments_[static_cast<std::size_t>(
          fill_[static_cast<std::size_t>(c.segment[static_cast<std::size_t>(k)].block)]++)] = k;
    }
}

void Delassus::block(int i, int j, double* out) const {
  const ContactSet& c = *contacts_;
  const int di = c.dim(i), dj = c.dim(j);
  std::fill(out, out + static_cast<std::ptrdiff_t>(di) * dj, 0.0);
  if (given_) {
    const int k = blockRows_.find(i, j);
    if (k < 0) return;
    const double* value = blockRows_.value.data() + blockRows_.value0[k];
    std::copy(value, value + static_cast<std::ptrdiff_t>(di) * dj, out);
    return;
  }
  for (int a = c.segment0[static_cast<std::size_t>(i)];
       a < c.segment0[static_cast<std::size_t>(i) + 1]; ++a)
    for (int b = c.segment0[static_cast<std::size_t>(j)];
         b < c.segment0[static_cast<std::size_t>(j) + 1]; ++b) {
      const Segment& s = c.segment[static_cast<std::size_t>(a)];
      const Segment& o = c.segment[static_cast<std::size_t>(b)];
      if (s.block != o.block) continue;
      for (int r = 0; r < di; ++r)
        for (int k = 0; k < dj; ++k)
          out[r * dj + k] += dot(c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu,
                                 minvW_.data() + o.w + static_cast<std::ptrdiff_t>(k) * s.nu, s.nu);
    }
}

void Delassus::fillDense() {
  const ContactSet& c = *contacts_;
  G_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_), 0.0);
  for (int b = 0; b + 1 < static_cast<int>(blockFirst_.size()); ++b)
    for (int p = blockFirst_[static_cast<std::size_t>(b)];
         p < blockFirst_[static_cast<std::size_t>(b) + 1]; ++p)
      for (int q = blockFirst_[static_cast<std::size_t>(b)];
           q < blockFirst_[static_cast<std::size_t>(b) + 1]; ++q) {
        const auto ks = static_cast<std::size_t>(blockSegments_[static_cast<std::size_t>(p)]);
        const auto ko = static_cast<std::size_t>(blockSegments_[static_cast<std::size_t>(q)]);
        const Segment &s = c.segment[ks], &o = c.segment[ko];
        const int i = segmentContact_[ks], j = segmentContact_[ko];
        const int ri = c.row0[static_cast<std::size_t>(i)],
                  rj = c.row0[static_cast<std::size_t>(j)];
        for (int r = 0; r < c.dim(i); ++r)
          for (int k = 0; k < c.dim(j); ++k)
            G_[static_cast<std::size_t>((ri + r) * n_ + rj + k)] +=
                dot(c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu,
                    minvW_.data() + o.w + static_cast<std::ptrdiff_t>(k) * s.nu, s.nu);
      }
}

void Delassus::begin(const double* Lambda) {
  if (assembled_ || given_) return;
  std::fill(v_.begin(), v_.end(), 0.0);
  addVelocity(Lambda, {v_.data(), static_cast<Eigen::Index>(v_.size())});
}

void Delassus::row(int i, const double* Lambda, double* out) const {
  const ContactSet& c = *contacts_;
  const int first = c.row0[static_cast<std::size_t>(i)], dim = c.dim(i);
  if (assembled_ && !sparse_) {
    const double* G = G_.data() + static_cast<std::ptrdiff_t>(first) * n_;
    if (dim == 3) return dots<3>(G, Lambda, n_, out);
    if (dim == 2) return dots<2>(G, Lambda, n_, out);
    for (int r = 0; r < dim; ++r) out[r] = dot(G + static_cast<std::ptrdiff_t>(r) * n_, Lambda, n_);
    return;
  }
  if (given_) {
    blockRows_.multiplyRow(i, c.row0.data(), Lambda, out);
    return;
  }
  for (int r = 0; r < dim; ++r) out[r] = 0.0;
  for (int k = c.segment0[static_cast<std::size_t>(i)];
       k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    if (s.nu == 6 && dim == 3) {
      spatial::addProduct(c.W.data() + s.w, v_.data() + s.u0, out);
      continue;
    }
    for (int r = 0; r < dim; ++r)
      out[r] +=
          dot(c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu, v_.data() + s.u0, s.nu);
  }
}

void Delassus::changed(int i, const double* delta) {
  if (assembled_ || given_) return;
  addTo(i, delta, v_.data());
}

void Delassus::addTo(int i, const double* delta, double* u) const {
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
        Eigen::Map<Eigen::Matrix<double, 6, 1>>{v} += delta[r] * RigidBody(w);
      else
        for (int j = 0; j < s.nu; ++j) v[j] += w[j] * delta[r];
    }
  }
}

void Delassus::addVelocity(const double* Lambda, Vec u) const {
  if (spatial::all(*contacts_)) {
    spatial::forSegments(*contacts_, [&](int i, int k, const Segment& s) {
      spatial::addTransposed(minvW_.data() + spatial::kNumbers * k, Lambda + 3 * i,
                             u.data() + s.u0);
    });
    return;
  }
  for (int i = 0; i < contacts_->size(); ++i)
    addTo(i, Lambda + contacts_->row0[static_cast<std::size_t>(i)], u.data());
}

void Delassus::apply(const double* x, double* y) {
  begin(x);
  if (!assembled_ && !given_ && spatial::all(*contacts_)) {
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
    row(i, x, y + contacts_->row0[static_cast<std::size_t>(i)]);
}

void Delassus::applyAbsolute(const double* x, double* y) {
  const ContactSet& c = *contacts_;
  if (assembled_) {
    for (int i = 0; i < n_; ++i) {
      y[i] = 0.0;
      for (int j = 0; j < n_; ++j)
        y[i] += std::abs(G_[static_cast<std::size_t>(i) * static_cast<std::size_t>(n_) +
                            static_cast<std::size_t>(j)] *
                         x[j]);
    }
    return;
  }
  if (given_) {
    for (int i = 0; i < c.size(); ++i)
      blockRows_.multiplyRowAbsolute(i, c.row0.data(), x, y + c.row0[i]);
    return;
  }
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
              std::abs(x[c.row0[at] + r]) * RigidBody(w).cwiseAbs();
        else
          for (int j = 0; j < s.nu; ++j) v[j] += std::abs(w[j] * x[c.row0[at] + r]);
    }
  }
  std::fill(y, y + n_, 0.0);
  c.addAbsolute({absolute_.data(), static_cast<Eigen::Index>(absolute_.size())}, y);
}

void Delassus::neighbours(int i, std::vector<int>& out) const {
  const ContactSet& c = *contacts_;
  out.clear();
  if (given_) {
    out.assign(blockRows_.column.begin() + blockRows_.first[i],
               blockRows_.column.begin() + blockRows_.first[i + 1]);
    return;
  }
  for (int k = c.segment0[static_cast<std::size_t>(i)];
       k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
    const auto b = static_cast<std::size_t>(c.segment[static_cast<std::size_t>(k)].block);
    for (int p = blockFirst_[b]; p < blockFirst_[b + 1]; ++p)
      out.push_back(
          segmentContact_[static_cast<std::size_t>(blockSegments_[static_cast<std::size_t>(p)])]);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

void Delassus::rowSums(double* sums) {
  const ContactSet& c = *contacts_;
  std::fill(sums, sums + n_, 0.0);
  for (int i = 0; i < c.size(); ++i) {
    neighbours(i, near_);
    for (const int j : near_) {
      const int di = c.dim(i), dj = c.dim(j);
      scratch_.resize(static_cast<std::size_t>(di) * static_cast<std::size_t>(dj));
      block(i, j, scratch_.data());
      for (int r = 0; r < di; ++r)
        for (int k = 0; k < dj; ++k)
          sums[c.row0[static_cast<std::size_t>(i)] + r] +=
              std::abs(scratch_[static_cast<std::size_t>(r * dj + k)]);
    }
  }
}

}  // namespace dynamy
