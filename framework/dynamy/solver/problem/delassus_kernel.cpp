#include <algorithm>
#include <cmath>
#include <dynamy/solver/problem/delassus.hpp>
#include <dynamy/solver/problem/dot_product.hpp>

namespace dynamy {
namespace {

/// Rows up to which the dense matrix pays: n² numbers stay in the first-level cache.
constexpr int kDenseRows = 64;
/// Rows above which the dense matrix pays only if the bodies have at least as many velocities:
/// otherwise Newton's method works in velocities and needs only W.
constexpr int kFewRows = 16;

/// out = A x for `rows` of n numbers: the sums of a contact's rows run side by side, each in the
/// order of dotProduct().
template <int rows>
void dots(const double* A, const double* x, int n, double* out) {
  double s[rows] = {};
  for (int j = 0; j < n; ++j)
    for (int r = 0; r < rows; ++r) s[r] += A[static_cast<std::ptrdiff_t>(r) * n + j] * x[j];
  for (int r = 0; r < rows; ++r) out[r] = s[r];
}

/// True: the dense matrix of n rows costs less than its factors.
bool densePays(int n, const FactoredDelassus& bodies) {
  if (n <= kFewRows || n > kDenseRows) return n <= kFewRows;
  return n <= bodies.touchedVelocities();
}

}  // namespace

void Delassus::assemble(const ContactSet& contacts, const MassMatrix& mass, Form form) {
  contacts_ = &contacts, n_ = contacts.rows(), given_ = sparse_ = false;
  bodies_.factor(contacts, mass, diagonal_);
  assembled_ = form == Form::assembled || (form == Form::automatic && densePays(n_, bodies_));
  if (!assembled_) return;
  G_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_), 0.0);
  bodies_.addTo(G_.data());
}

void Delassus::given(const ContactSet& contacts, BlockRows G) {
  contacts_ = &contacts, n_ = contacts.rows(), given_ = true;
  blockRows_ = std::move(G);
  assembled_ = n_ <= kDenseRows;
  // An index per block costs about as much as four numbers.
  sparse_ = 4 * blockRows_.column.size() + blockRows_.value.size() <
            static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_);
  diagonal_.resize(contacts);
  for (int i = 0; i < contacts.size(); ++i) block(i, i, diagonal_.block(i));
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

void Delassus::block(int i, int j, double* out) const {
  if (!given_) return bodies_.block(i, j, out);
  const auto size = static_cast<std::ptrdiff_t>(contacts_->dim(i)) * contacts_->dim(j);
  const int k = blockRows_.find(i, j);
  if (k < 0) {
    std::fill(out, out + size, 0.0);
    return;
  }
  const double* value = blockRows_.value.data() + blockRows_.value0[k];
  std::copy(value, value + size, out);
}

void Delassus::begin(const double* Lambda) {
  if (!assembled_ && !given_) bodies_.begin(Lambda);
}

void Delassus::row(int i, const double* Lambda, double* out) const {
  const ContactSet& c = *contacts_;
  const int first = c.row0[static_cast<std::size_t>(i)], dim = c.dim(i);
  if (assembled_ && !sparse_) {
    const double* G = G_.data() + static_cast<std::ptrdiff_t>(first) * n_;
    if (dim == 3) return dots<3>(G, Lambda, n_, out);
    if (dim == 2) return dots<2>(G, Lambda, n_, out);
    for (int r = 0; r < dim; ++r)
      out[r] = dotProduct(G + static_cast<std::ptrdiff_t>(r) * n_, Lambda, n_);
    return;
  }
  if (given_)
    blockRows_.multiplyRow(i, c.row0.data(), Lambda, out);
  else
    bodies_.row(i, out);
}

void Delassus::changed(int i, const double* delta) {
  if (!assembled_ && !given_) bodies_.changed(i, delta);
}

void Delassus::apply(const double* x, double* y) {
  if (!assembled_ && !given_) return bodies_.apply(x, y);
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
  if (!given_) return bodies_.applyAbsolute(x, y);
  for (int i = 0; i < c.size(); ++i)
    blockRows_.multiplyRowAbsolute(i, c.row0.data(), x, y + c.row0[i]);
}

void Delassus::neighbours(int i, std::vector<int>& out) const {
  if (!given_) return bodies_.neighbours(i, out);
  out.assign(blockRows_.column.begin() + blockRows_.first[i],
             blockRows_.column.begin() + blockRows_.first[i + 1]);
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
