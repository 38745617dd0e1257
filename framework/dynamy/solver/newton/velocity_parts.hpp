/// Parts shared by the sparse and the dense form of Newton steps in velocities: C and f of the
/// contacts, and the mass blocks they touch (theory 7.8).
#pragma once
#include <cmath>
#include <dynamy/solver/newton/contact_compliance.hpp>
#include <dynamy/solver/newton/newton_system.hpp>

namespace dynamy {

/// Computes C and f of all contacts, and ΔΛ from Δv.
class Compliances {
 public:
  /// False: singular.
  bool evaluate(const InclusionProblem& p, const NewtonBlocks& b) {
    block0 = b.block0;
    C.resize(b.B.size()), f.resize(b.F.size()), open.resize(static_cast<std::size_t>(p.size()));
    for (int i = 0; i < p.size(); ++i) {
      const std::ptrdiff_t at = b.block0[i];
      const double *A = b.A.data() + at, *B = b.B.data() + at, *F = b.F.data() + p.row0(i);
      double *Ci = C.data() + at, *fi = f.data() + p.row0(i);
      bool isOpen = false, good = false;
      switch (p.dim(i)) {
        case 1:
          good = contactCompliance<1>(A, B, F, b.a[i], 1, Ci, fi, isOpen);
          break;
        case 2:
          good = contactCompliance<2>(A, B, F, b.a[i], 2, Ci, fi, isOpen);
          break;
        case 3:
          good = contactCompliance<3>(A, B, F, b.a[i], 3, Ci, fi, isOpen);
          break;
        default:
          good = contactCompliance<0>(A, B, F, b.a[i], p.dim(i), Ci, fi, isOpen);
      }
      if (!good) return false;
      open[i] = isOpen ? 1 : 0;
    }
    return true;
  }
  /// Sets C = I/a for the equations (G + diag(a)) x = r; right() sets f = −r/a. x_i = 0 if a_i is
  /// infinite.
  void shifted(const InclusionProblem& p, const std::vector<double>& a) {
    open.resize(static_cast<std::size_t>(p.size())), block0.clear(), C.clear();
    shift = a;
    for (int i = 0; i < p.size(); ++i) {
      const int d = p.dim(i);
      open[i] = std::isinf(a[i]) ? 1 : 0;
      block0.push_back(static_cast<std::ptrdiff_t>(C.size()));
      C.resize(C.size() + static_cast<std::size_t>(d * d), 0.0);
      for (int k = 0; k < d; ++k) C[block0[i] + k * (d + 1)] = 1.0 / a[i];
    }
    f.assign(static_cast<std::size_t>(p.rows()), 0.0);
  }
  void right(const InclusionProblem& p, const double* r) {
    for (int i = 0; i < p.size(); ++i)
      for (int k = p.row0(i); k < p.row0(i) + p.dim(i); ++k) f[k] = -r[k] / shift[i];
  }
  /// ΔΛ_i = −f_i − C_i g with g = (WᵀΔv)_i; false: not finite.
  bool percussion(int dim, int row0, int contact, const double* g, double* out) const {
    const double* c = C.data() + block0[contact];
    double sum = 0.0;
    for (int r = 0; r < dim; ++r) {
      out[r] = -f[row0 + r];
      for (int k = 0; k < dim; ++k) out[r] -= c[r * dim + k] * g[k];
      sum += out[r];
    }
    return std::isfinite(sum);
  }

  std::vector<double> C, f, shift;
  std::vector<std::ptrdiff_t> block0;
  std::vector<char> open;
};

/// Mass blocks that contacts touch, numbered in ascending order.
class Touched {
 public:
  /// False: the segments and their mass blocks are the same as in the last call.
  bool changed(const InclusionProblem& p) {
    const ContactSet& c = *p.contacts;
    bool same = segment0_ == c.segment0 && block_.size() == c.segment.size();
    for (std::size_t k = 0; same && k < block_.size(); ++k) same = block_[k] == c.segment[k].block;
    if (same) return false;
    segment0_ = c.segment0;
    block_.clear();
    for (const Segment& s : c.segment) block_.push_back(s.block);
    number.assign(static_cast<std::size_t>(p.G->mass().blocks()), -1);
    for (const int b : block_) number[b] = 0;
    touched.clear();
    for (int b = 0; b < p.G->mass().blocks(); ++b)
      if (number[b] == 0) number[b] = static_cast<int>(touched.size()), touched.push_back(b);
    return true;
  }
  void forget() { segment0_.clear(), block_.clear(); }
  std::vector<int> number, touched;

 private:
  std::vector<int> segment0_, block_;
};

}  // namespace dynamy
