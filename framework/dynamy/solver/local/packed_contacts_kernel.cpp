#include <algorithm>
#include <bit>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/local/local_iteration.hpp>
#include <dynamy/solver/local/packed_contacts.hpp>
#include <dynamy/solver/local/packed_kernels.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <dynamy/solver/prox/relaxation.hpp>

namespace dynamy {
namespace {

/// Batches that are filled at the same time; a contact goes into the first one that it fits. More
/// of them fill the last lanes better; each is a bit of inOpen_.
constexpr int kOpen = 24;
/// Most velocities of a body in a batch.
constexpr int kMostVelocities = 6;
/// The block that never moves.
constexpr int kGround = 0;

const PackedKernels& kernels() { return packedLevels().back(); }

double inverseOf(double x) { return x > 0.0 && std::isfinite(1.0 / x) ? 1.0 / x : 0.0; }

/// The larger eigenvalue of the lower right 2 × 2 of a 3 × 3 block.
double largestOfTangents(const double* D) {
  return 0.5 * (D[4] + D[8]) + std::hypot(0.5 * (D[4] - D[8]), D[5]);
}

/// Appends the lower triangle of S, SSᵀ = A, row after row (Cholesky). False: A is not positive
/// definite.
bool appendRoot(const ConstBlock& A, std::vector<double>& out) {
  const auto n = A.rows();
  const std::size_t first = out.size();
  const auto row = [&](Eigen::Index r) {
    return out.data() + first + static_cast<std::size_t>(r * (r + 1) / 2);
  };
  out.resize(first + static_cast<std::size_t>(n * (n + 1) / 2));
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index k = 0; k <= r; ++k) {
      double sum = A(r, k);
      for (Eigen::Index j = 0; j < k; ++j) sum -= row(r)[j] * row(k)[j];
      if (k < r)
        row(r)[k] = sum / row(k)[k];
      else if (sum > 0.0)
        row(r)[r] = std::sqrt(sum);
      else
        return false;
    }
  return true;
}

}  // namespace

bool PackedContacts::scaleBlocks(const InclusionProblem& p) {
  const ContactSet& c = *p.contacts;
  const MassMatrix& mass = p.G->mass();
  const auto blocks = static_cast<std::size_t>(mass.blocks());
  slot_.assign(blocks, -1), scale0_.assign(blocks, 0), scale_.clear();
  int slots = kGround + 1;
  for (const Segment& s : c.segment) {
    const auto b = static_cast<std::size_t>(s.block);
    if (slot_[b] >= 0) continue;
    slot_[b] = slots, slots += (s.nu + kLanes - 1) / kLanes;
    scale0_[b] = static_cast<std::ptrdiff_t>(scale_.size());
    if (const double* diagonal = mass.inverseDiagonal(s.block)) {
      for (int j = 0; j < s.nu; ++j) scale_.push_back(std::sqrt(diagonal[j]));
      continue;
    }
    if (!appendRoot(mass.inverse(s.block), scale_)) return false;
  }
  v_.assign(static_cast<std::size_t>(slots), {});
  vLast_ = v_;
  inOpen_.assign(static_cast<std::size_t>(slots), 0U);
  return std::all_of(scale_.begin(), scale_.end(), [](double x) { return std::isfinite(x); });
}

void PackedContacts::scaleRow(const Segment& s, const double* w, double* out) const {
  const double* S = scale_.data() + scale0_[static_cast<std::size_t>(s.block)];
  if (mass_->inverseDiagonal(s.block)) {
    for (int j = 0; j < s.nu; ++j) out[j] = S[j] * w[j];
    return;
  }
  std::fill(out, out + s.nu, 0.0);
  for (int r = 0; r < s.nu; ++r)
    for (int k = 0; k <= r; ++k) out[k] += w[r] * *S++;
}

bool PackedContacts::inBatch(const InclusionProblem& p, int i, const SimpleSet& set) const {
  const ContactSet& c = *p.contacts;
  const int dim = p.dim(i);
  const bool cone = set.shape == SimpleSet::Shape::friction && (dim == 2 || dim == 3);
  const bool pushes = set.shape == SimpleSet::Shape::interval && dim == 1 && set.lower == 0.0 &&
                      std::isinf(set.upper);
  const auto at = static_cast<std::size_t>(i);
  const int first = c.segment0[at], count = c.segment0[at + 1] - first;
  if ((!cone && !pushes) || count < 1 || count > 2) return false;
  const Segment* s = c.segment.data() + first;
  if (count == 2 && s[0].block == s[1].block) return false;
  for (int k = 0; k < count; ++k)
    if (s[k].nu > kMostVelocities) return false;
  const double* D = p.G->diagonalBlock(i);
  for (int r = 0; r < dim; ++r)
    if (!(inverseOf(D[r * dim + r]) > 0.0)) return false;  // left to the exact local solution
  return true;
}

PackedBatch& PackedContacts::openBatch(int slotA, int slotB, int& lane) {
  const auto of = [&](int slot) -> std::uint32_t& {
    return inOpen_[static_cast<std::size_t>(slot)];
  };
  constexpr std::uint32_t kAll = (1U << kOpen) - 1U;
  std::uint32_t taken = 0U;
  for (const int slot : {slotA, slotB})
    if (slot != kGround) taken |= of(slot);
  if ((taken & kAll) == kAll)  // the bodies are in all open batches: the fullest is closed
    close(static_cast<int>(std::max_element(openLanes_.begin(), openLanes_.end()) -
                           openLanes_.begin())),
        taken = of(slotA) | of(slotB);
  const int at = std::countr_one(taken & kAll);
  for (const int slot : {slotA, slotB})
    if (slot != kGround) of(slot) |= 1U << at;
  lane = openLanes_[static_cast<std::size_t>(at)]++;
  return open_[static_cast<std::size_t>(at)];
}

void PackedContacts::close(int at) {
  PackedBatch& batch = open_[static_cast<std::size_t>(at)];
  for (int k = 0; k < openLanes_[static_cast<std::size_t>(at)]; ++k)
    for (const int slot : {batch.bodyA[k], batch.bodyB[k]})
      inOpen_[static_cast<std::size_t>(slot)] &= ~(1U << at);
  batches_.push_back(batch);
  batch = {};
  openLanes_[static_cast<std::size_t>(at)] = 0;
}

void PackedContacts::batch(const InclusionProblem& p, int i, const SimpleSet& set) {
  const ContactSet& c = *p.contacts;
  const auto at = static_cast<std::size_t>(i);
  const int first = c.segment0[at], count = c.segment0[at + 1] - first;
  const auto slotOf = [&](int k) {
    return slot_[static_cast<std::size_t>(c.segment[static_cast<std::size_t>(k)].block)];
  };
  int lane = 0;
  PackedBatch& batch = openBatch(slotOf(first), count == 2 ? slotOf(first + 1) : kGround, lane);
  fillLane(p, i, set, batch, lane);
  if (lane + 1 == kLanes) close(static_cast<int>(&batch - open_.data()));
}

void PackedContacts::fillLane(const InclusionProblem& p, int i, const SimpleSet& set,
                              PackedBatch& batch, int lane) {
  const ContactSet& c = *p.contacts;
  const auto at = static_cast<std::size_t>(i);
  const int first = c.segment0[at], count = c.segment0[at + 1] - first, dim = p.dim(i);
  for (int k = 0; k < count; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(first + k)];
    Lanes* rows = k == 0 ? batch.a : batch.b;
    (k == 0 ? batch.bodyA : batch.bodyB)[lane] = slot_[static_cast<std::size_t>(s.block)];
    for (int r = 0; r < dim; ++r) {
      double scaled[kMostVelocities];
      scaleRow(s, c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu, scaled);
      for (int j = 0; j < s.nu; ++j) rows[6 * r + j][lane] = scaled[j];
    }
  }
  const double* D = p.G->diagonalBlock(i);
  const int row = p.row0(i);
  for (int r = 0; r < dim; ++r) batch.c[r][lane] = p.c[static_cast<std::size_t>(row + r)];
  batch.rN[lane] = 1.0 / D[0];
  if (dim > 1) {
    batch.rT[lane] = inverseOf(dim == 2 ? D[3] : largestOfTangents(D));
    batch.dT[lane] = D[dim], batch.dS[lane] = dim == 3 ? D[6] : 0.0;
    batch.mu[lane] = set.upper;
  }
  batch.rho[lane] = inverseOf(contactLambda(D, dim));
  largestRho_ = std::max(largestRho_, batch.rho[lane]);
  batch.row[lane] = row, batch.dim[lane] = dim;
}

void PackedContacts::setApart(const InclusionProblem& p, int i) {
  const ContactSet& c = *p.contacts;
  const auto at = static_cast<std::size_t>(i);
  const int dim = p.dim(i);
  const double* D = p.G->diagonalBlock(i);
  Apart contact{i,
                p.row0(i),
                dim,
                static_cast<int>(apartSegment_.size()),
                c.segment0[at + 1] - c.segment0[at],
                inverseOf(contactLambda(D, dim))};
  largestRho_ = std::max(largestRho_, contact.rho);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const auto w = static_cast<std::ptrdiff_t>(apartW_.size());
    apartSegment_.push_back({slot_[static_cast<std::size_t>(s.block)], s.nu, w});
    apartW_.resize(apartW_.size() + static_cast<std::size_t>(dim * s.nu));
    for (int r = 0; r < dim; ++r)
      scaleRow(s, c.W.data() + s.w + static_cast<std::ptrdiff_t>(r) * s.nu,
               apartW_.data() + w + static_cast<std::ptrdiff_t>(r) * s.nu);
  }
  apart_.push_back(contact);
  local_.add(D, dim, p.law(i).simpleSet(p.input(i)));
}

bool PackedContacts::prepare(const InclusionProblem& p, const double* Lambda) {
  batches_.clear(), apart_.clear(), apartSegment_.clear(), apartW_.clear(), local_.clear();
  largestRho_ = 0.0;
  if (!p.G->hasBodies()) return false;
  mass_ = &p.G->mass();
  if (!scaleBlocks(p)) return false;
  open_.assign(kOpen, {}), openLanes_.assign(kOpen, 0);
  for (const bool carries : {true, false}) {
    for (int i = 0; i < p.size(); ++i) {
      if ((Lambda[p.row0(i)] != 0.0) != carries) continue;
      const SimpleSet set = p.law(i).simpleSet(p.input(i));
      inBatch(p, i, set) ? batch(p, i, set) : setApart(p, i);
    }
    for (int k = 0; k < kOpen; ++k)
      if (openLanes_[static_cast<std::size_t>(k)] > 0) close(k);
  }
  std::size_t rows = 0;
  for (const Apart& contact : apart_) rows += static_cast<std::size_t>(contact.dim);
  apartLambda_.assign(rows, 0.0), apartLast_.assign(rows, 0.0), apartR_.clear();
  if (apart_.empty()) return true;
  relaxation(p, Relaxation::exact, 1.0, apartAll_);
  for (const Apart& contact : apart_)
    apartR_.insert(apartR_.end(), apartAll_.begin() + contact.row,
                   apartAll_.begin() + contact.row + contact.dim);
  return true;
}

void PackedContacts::load(const double* Lambda) {
  for (PackedBatch& batch : batches_)
    for (int k = 0; k < kLanes; ++k)
      for (int r = 0; r < batch.dim[k]; ++r)
        batch.Lambda[r][k] = batch.last[r][k] = Lambda[batch.row[k] + r];
  double* out = apartLambda_.data();
  for (const Apart& contact : apart_)
    out = std::copy(Lambda + contact.row, Lambda + contact.row + contact.dim, out);
  apartLast_ = apartLambda_;
  renew();
  vLast_ = v_;
}

void PackedContacts::store(double* Lambda) const {
  for (const PackedBatch& batch : batches_)
    for (int k = 0; k < kLanes; ++k)
      for (int r = 0; r < batch.dim[k]; ++r) Lambda[batch.row[k] + r] = batch.Lambda[r][k];
  const double* from = apartLambda_.data();
  for (const Apart& contact : apart_)
    std::copy(from, from + contact.dim, Lambda + contact.row), from += contact.dim;
}

void PackedContacts::renew() {
  std::fill(v_.begin(), v_.end(), PackedVelocity{});
  kernels().impulses(batches_.data(), batches(), v_.data());
  const double* Lambda = apartLambda_.data();
  for (const Apart& contact : apart_) apartImpulse(contact, Lambda), Lambda += contact.dim;
}

void PackedContacts::apartVelocity(const Apart& contact, double* gamma) const {
  for (int k = 0; k < contact.segments; ++k) {
    const ApartSegment& s = apartSegment_[static_cast<std::size_t>(contact.segment0 + k)];
    const double *w = apartW_.data() + s.w, *v = v_[static_cast<std::size_t>(s.slot)].v;
    for (int r = 0; r < contact.dim; ++r, w += s.nu)
      for (int j = 0; j < s.nu; ++j) gamma[r] += w[j] * v[j];
  }
}

void PackedContacts::apartImpulse(const Apart& contact, const double* delta) {
  for (int k = 0; k < contact.segments; ++k) {
    const ApartSegment& s = apartSegment_[static_cast<std::size_t>(contact.segment0 + k)];
    const double* w = apartW_.data() + s.w;
    double* v = v_[static_cast<std::size_t>(s.slot)].v;
    for (int r = 0; r < contact.dim; ++r, w += s.nu)
      for (int j = 0; j < s.nu; ++j) v[j] += w[j] * delta[r];
  }
}

double PackedContacts::sweep(const InclusionProblem& p, double beta, bool all) {
  if (beta > 0.0) {
    for (std::size_t b = 0; b < v_.size(); ++b)
      for (int k = 0; k < kLanes; ++k) {
        const double now = v_[b].v[k];
        v_[b].v[k] = now + beta * (now - vLast_[b].v[k]);
        vLast_[b].v[k] = now;
      }
  } else {
    vLast_ = v_;
  }
  const double uphill = kernels().sweep(batches_.data(), batches(), v_.data(), beta, all);
  return uphill + sweepApart(p, beta);
}

double PackedContacts::sweepApart(const InclusionProblem& p, double beta) {
  double uphill = 0.0;
  double *Lambda = apartLambda_.data(), *last = apartLast_.data();
  const double* r = apartR_.data();
  for (std::size_t at = 0; at < apart_.size(); ++at) {
    const Apart& x = apart_[at];
    const double* D = p.G->diagonalBlock(x.contact);
    double b[kMostRows] = {}, from[kMostRows], next[kMostRows], delta[kMostRows];
    apartVelocity(x, b);
    for (int k = 0; k < x.dim; ++k) from[k] = next[k] = Lambda[k] + beta * (Lambda[k] - last[k]);
    for (int k = 0; k < x.dim; ++k) {
      b[k] += p.c[static_cast<std::size_t>(x.row + k)];
      for (int m = 0; m < x.dim; ++m) b[k] -= D[k * x.dim + m] * from[m];
    }
    const LocalCase found = local_.solve(static_cast<int>(at), b, next).found;
    const bool finite = std::all_of(next, next + x.dim, [](double y) { return std::isfinite(y); });
    if (!finite) std::copy(from, from + x.dim, next);
    if (!finite || found == LocalCase::notSimple || found == LocalCase::noSolution)
      iterateContact(p.law(x.contact), p.input(x.contact), D, b, r, next);
    for (int k = 0; k < x.dim; ++k) {
      delta[k] = next[k] - from[k];
      if (r[k] > 0.0) uphill -= delta[k] * (next[k] - Lambda[k]) / r[k];
      last[k] = Lambda[k], Lambda[k] = next[k];
    }
    apartImpulse(x, delta);
    Lambda += x.dim, last += x.dim, r += x.dim;
  }
  return uphill;
}

PackedMeasure PackedContacts::measure(const InclusionProblem& p) {
  renew();
  PackedMeasure out;
  kernels().measure(batches_.data(), batches(), v_.data(), out);
  const double* Lambda = apartLambda_.data();
  for (const Apart& x : apart_) {
    double xi[kMostRows] = {}, e[kMostRows] = {}, e2 = 0.0, Lambda2 = 0.0;
    apartVelocity(x, xi);
    for (int k = 0; k < x.dim; ++k) xi[k] += p.c[static_cast<std::size_t>(x.row + k)];
    if (x.rho > 0.0) p.law(x.contact).naturalMap(p.input(x.contact), x.rho, xi, Lambda, e);
    for (int k = 0; k < x.dim; ++k) e2 += e[k] * e[k], Lambda2 += Lambda[k] * Lambda[k];
    if (x.rho > 0.0) out.velocity2 = std::max(out.velocity2, e2 / (x.rho * x.rho));
    out.force2 = std::max(out.force2, e2), out.Lambda2 = std::max(out.Lambda2, Lambda2);
    Lambda += x.dim;
  }
  return out;
}

}  // namespace dynamy
