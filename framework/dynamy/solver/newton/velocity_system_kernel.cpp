// Newton steps in velocities:  (M + W C Wᵀ) Δv = −W f,  ΔΛ = −f − C WᵀΔv, block-sparse for bodies
// of up to 6 velocities, dense for larger mass blocks. The pattern depends on which bodies touch,
// not on which contacts are open: it stays while the contacts do.
#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/newton/block_lu.hpp>
#include <dynamy/solver/newton/elimination.hpp>
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/newton/velocity_parts.hpp>

namespace dynamy {
namespace {

// ---- sparse ------------------------------------------------------------------------------------

/// Bodies of fewer than n velocities are filled up by rows of the identity.
template <int n>
class SparseVelocities final : public NewtonSystem {
 public:
  bool prepare(const InclusionProblem& p) override {
    if (touched_.changed(p)) {
      tooLarge_ = !analyse(p);
      if (tooLarge_) touched_.forget();
    }
    return !tooLarge_;
  }
  void multiply(const InclusionProblem& p, const double* x, double* y) override {
    p.G->apply(x, y);
  }
  bool solve(const InclusionProblem& p, const NewtonBlocks& b,
             std::vector<double>& dLambda) override {
    if (!compliance_.evaluate(p, b)) return false;
    assemble(p);
    if (!lu_.factor()) return false;
    return back(p, dLambda.data());
  }
  bool factorShifted(const InclusionProblem& p, const std::vector<double>& a) override {
    compliance_.shifted(p, a);
    assemble(p, true);
    return lu_.factor();
  }
  bool solveShifted(const InclusionProblem& p, const double* r, std::vector<double>& x) override {
    compliance_.right(p, r);
    return back(p, x.data());
  }
  bool tooLarge() const override { return tooLarge_; }
  long entries() const override { return lu_.entries(); }
  long analyses() const override { return lu_.analyses(); }

 private:
  using Matrix = typename BlockLu<n>::Matrix;
  using Vector = typename BlockLu<n>::Vector;
  template <int d>
  using Rows = Eigen::Matrix<double, d, n, Eigen::RowMajor>;
  /// A contact with three rows on a full body: unrolled.
  using Three = Eigen::Map<const Rows<3>>;
  using Force = Eigen::Map<const Eigen::Vector3d>;

  bool analyse(const InclusionProblem& p) {
    const ContactSet& c = *p.contacts;
    pairs_.clear();
    for (int i = 0; i < c.size(); ++i)
      for (int a = c.segment0[i]; a < c.segment0[i + 1]; ++a)
        for (int b = c.segment0[i]; b < c.segment0[i + 1]; ++b)
          pairs_.emplace_back(body(c.segment[a]), body(c.segment[b]));
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    first_.assign(touched_.touched.size() + 1, 0), column_.clear();
    for (const auto& [i, j] : pairs_) ++first_[i + 1], column_.push_back(j);
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    if (!lu_.analyse(first_, column_)) return false;
    // Positions of the blocks of every contact.
    place_.clear();
    for (int i = 0; i < c.size(); ++i)
      for (int a = c.segment0[i]; a < c.segment0[i + 1]; ++a)
        for (int b = c.segment0[i]; b < c.segment0[i + 1]; ++b)
          place_.push_back(&lu_.at(body(c.segment[a]), body(c.segment[b])));
    return true;
  }
  int body(const Segment& s) const { return touched_.number[s.block]; }

  /// Δv = −(M + W C Wᵀ)⁻¹ W f and from it ΔΛ.
  bool back(const InclusionProblem& p, double* dLambda) {
    const ContactSet& c = *p.contacts;
    v_.assign(touched_.touched.size(), Vector::Zero());
    for (int i = 0; i < c.size(); ++i)
      for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
        const Segment& s = c.segment[k];
        double* v = v_[body(s)].data();
        const double *W = c.W.data() + s.w, *f = compliance_.f.data() + c.row0[i];
        if (s.nu == n && c.dim(i) == 3) {
          Eigen::Map<Vector>{v} -= Three(W).transpose().lazyProduct(Force(f));
          continue;
        }
        for (int r = 0; r < c.dim(i); ++r)
          for (int j = 0; j < s.nu; ++j) v[j] -= W[r * s.nu + j] * f[r];
      }
    lu_.solve(v_);
    return percussions(p, dLambda);
  }

  void assemble(const InclusionProblem& p, bool shifted = false) {
    const ContactSet& c = *p.contacts;
    lu_.setZero();
    for (std::size_t k = 0; k < touched_.touched.size(); ++k) {
      const ConstBlock M = p.G->mass().M(touched_.touched[k]);
      const int nu = static_cast<int>(M.rows());
      Matrix& D = lu_.at(static_cast<int>(k), static_cast<int>(k));
      if (nu == n) {
        D = M;
      } else {
        D.setIdentity();
        D.topLeftCorner(nu, nu) = M;
      }
    }
    Matrix* const* place = place_.data();
    for (int i = 0; i < c.size(); ++i) {
      const int segments = c.segment0[i + 1] - c.segment0[i];
      if (compliance_.open[i]) {
        place += static_cast<std::ptrdiff_t>(segments) * segments;
        continue;
      }
      switch (c.dim(i)) {
        case 1:
          add<1>(c, i, place);
          break;
        case 2:
          add<2>(c, i, place);
          break;
        case 3:
          shifted ? addShifted<3>(c, i, place) : add<3>(c, i, place);
          break;
        default:
          addGeneral(c, i, place);
      }
      place += static_cast<std::ptrdiff_t>(segments) * segments;
    }
  }
  template <int d>
  static Rows<d> rows(const ContactSet& c, const Segment& s) {
    if (s.nu == n) return Eigen::Map<const Rows<d>>(c.W.data() + s.w);
    Rows<d> out = Rows<d>::Zero();
    for (int r = 0; r < d; ++r)
      for (int k = 0; k < s.nu; ++k) out(r, k) = c.W[s.w + r * s.nu + k];
    return out;
  }
  /// Adds W C Wᵀ with C = I/a, as in factorShifted(): it is symmetric, and half of it is computed.
  template <int d>
  void addShifted(const ContactSet& c, int i, Matrix* const* place) {
    const int m = c.segment0[i + 1] - c.segment0[i];
    const double C = compliance_.C[compliance_.block0[i]];
    for (int a = 0; a < m; ++a) {
      const Rows<d> Wa = rows<d>(c, c.segment[c.segment0[i] + a]) * C;
      for (int b = a; b < m; ++b) {
        const Matrix WCW = Wa.transpose().lazyProduct(rows<d>(c, c.segment[c.segment0[i] + b]));
        *place[a * m + b] += WCW;
        if (b > a) *place[b * m + a] += WCW.transpose();
      }
    }
  }
  /// Adds W C Wᵀ of a contact with d rows.
  template <int d>
  void add(const ContactSet& c, int i, Matrix* const* place) {
    using Square = Eigen::Matrix<double, d, d, d == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
    const Eigen::Map<const Square> C(compliance_.C.data() + compliance_.block0[i]);
    for (int a = c.segment0[i]; a < c.segment0[i + 1]; ++a) {
      const Eigen::Matrix<double, n, d> WC = rows<d>(c, c.segment[a]).transpose() * C;
      for (int b = c.segment0[i]; b < c.segment0[i + 1]; ++b)
        (*place++)->noalias() += WC * rows<d>(c, c.segment[b]);
    }
  }
  void addGeneral(const ContactSet& c, int i, Matrix* const* place) {
    const int d = c.dim(i);
    const double* C = compliance_.C.data() + compliance_.block0[i];
    for (int a = c.segment0[i]; a < c.segment0[i + 1]; ++a)
      for (int b = c.segment0[i]; b < c.segment0[i + 1]; ++b, ++place) {
        const Segment &s = c.segment[a], &o = c.segment[b];
        const double *Wa = c.W.data() + s.w, *Wb = c.W.data() + o.w;
        for (int r = 0; r < d; ++r)
          for (int m = 0; m < d; ++m)
            for (int k = 0; k < s.nu; ++k)
              for (int l = 0; l < o.nu; ++l)
                (**place)(k, l) += Wa[r * s.nu + k] * C[r * d + m] * Wb[m * o.nu + l];
      }
  }
  bool percussions(const InclusionProblem& p, double* dLambda) const {
    const ContactSet& c = *p.contacts;
    double g[kMostRows];
    for (int i = 0; i < c.size(); ++i) {
      const int d = c.dim(i);
      std::fill(g, g + d, 0.0);
      for (int k = c.segment0[i]; k < c.segment0[i + 1] && !compliance_.open[i]; ++k) {
        const Segment& s = c.segment[k];
        const double *W = c.W.data() + s.w, *v = v_[body(s)].data();
        if (s.nu == n && d == 3) {
          Eigen::Map<Eigen::Vector3d>{g} += Three(W).lazyProduct(v_[body(s)]);
          continue;
        }
        for (int r = 0; r < d; ++r)
          for (int j = 0; j < s.nu; ++j) g[r] += W[r * s.nu + j] * v[j];
      }
      if (!compliance_.percussion(d, c.row0[i], i, g, dLambda + c.row0[i])) return false;
    }
    return true;
  }

  Touched touched_;
  Compliances compliance_;
  BlockLu<n> lu_;
  bool tooLarge_ = false;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<int> first_, column_;
  std::vector<Matrix*> place_;
  std::vector<Vector> v_;
};

// ---- dense -------------------------------------------------------------------------------------

class DenseVelocities final : public NewtonSystem {
 public:
  bool prepare(const InclusionProblem& p) override {
    if (!touched_.changed(p)) return true;
    u0_.clear();
    size_ = 0;
    for (const int b : touched_.touched) u0_.push_back(size_), size_ += p.G->mass().nu(b);
    return true;
  }
  void multiply(const InclusionProblem& p, const double* x, double* y) override {
    p.G->apply(x, y);
  }
  bool solve(const InclusionProblem& p, const NewtonBlocks& b,
             std::vector<double>& dLambda) override {
    return compliance_.evaluate(p, b) && assembleAndSolve(p, dLambda.data());
  }
  /// With few velocities, the matrix is factored again for every right-hand side.
  bool factorShifted(const InclusionProblem& p, const std::vector<double>& a) override {
    compliance_.shifted(p, a);
    return true;
  }
  bool solveShifted(const InclusionProblem& p, const double* r, std::vector<double>& x) override {
    compliance_.right(p, r);
    return assembleAndSolve(p, x.data());
  }
  bool tooLarge() const override { return false; }
  long entries() const override { return static_cast<long>(size_) * size_; }
  long analyses() const override { return 0; }

 private:
  bool assembleAndSolve(const InclusionProblem& p, double* dLambda) {
    const auto n = static_cast<std::size_t>(size_);
    K_.assign(n * n, 0.0), v_.assign(n, 0.0);
    for (std::size_t k = 0; k < u0_.size(); ++k) {
      const ConstBlock M = p.G->mass().M(touched_.touched[k]);
      for (int r = 0; r < M.rows(); ++r)
        for (int m = 0; m < M.cols(); ++m) K_[(u0_[k] + r) * size_ + u0_[k] + m] = M(r, m);
    }
    // Velocities of different units: powers of two near 1/√M_rr make their rows comparable.
    scale_.resize(n);
    for (std::size_t r = 0; r < n; ++r)
      scale_[r] = std::ldexp(1.0, -std::ilogb(K_[r * (n + 1)]) / 2);
    for (int i = 0; i < p.size(); ++i) add(*p.contacts, i);
    for (std::size_t r = 0; r < n; ++r) {
      v_[r] *= scale_[r];
      for (std::size_t m = 0; m < n; ++m) K_[r * n + m] *= scale_[r] * scale_[m];
    }
    if (!eliminate(K_.data(), v_.data(), size_, 1)) return false;
    for (std::size_t r = 0; r < n; ++r) v_[r] *= scale_[r];
    return percussions(*p.contacts, dLambda);
  }
  int first(const Segment& s) const { return u0_[touched_.number[s.block]]; }
  void add(const ContactSet& c, int i) {
    const int d = c.dim(i);
    const double *f = compliance_.f.data() + c.row0[i],
                 *C = compliance_.C.data() + compliance_.block0[i];
    for (int a = c.segment0[i]; a < c.segment0[i + 1]; ++a) {
      const Segment& s = c.segment[a];
      const double* Wa = c.W.data() + s.w;
      for (int r = 0; r < d; ++r)
        for (int k = 0; k < s.nu; ++k) v_[first(s) + k] -= Wa[r * s.nu + k] * f[r];
      for (int b = c.segment0[i]; b < c.segment0[i + 1] && !compliance_.open[i]; ++b)
        addPair(c, s, c.segment[b], C, d);
    }
  }
  /// K += W_s C W_oᵀ, by way of the rows of C W_oᵀ.
  void addPair(const ContactSet& c, const Segment& s, const Segment& o, const double* C, int d) {
    for (int r = 0; r < d; ++r) {
      row_.assign(static_cast<std::size_t>(o.nu), 0.0);
      for (int m = 0; m < d; ++m)
        for (int l = 0; l < o.nu; ++l) row_[l] += C[r * d + m] * c.W[o.w + m * o.nu + l];
      for (int k = 0; k < s.nu; ++k) {
        const double w = c.W[s.w + r * s.nu + k];
        double* out = K_.data() + static_cast<std::ptrdiff_t>(first(s) + k) * size_ + first(o);
        for (int l = 0; l < o.nu; ++l) out[l] += w * row_[l];
      }
    }
  }
  bool percussions(const ContactSet& c, double* dLambda) const {
    double g[kMostRows];
    for (int i = 0; i < c.size(); ++i) {
      const int d = c.dim(i);
      std::fill(g, g + d, 0.0);
      for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
        const Segment& s = c.segment[k];
        for (int r = 0; r < d; ++r)
          for (int j = 0; j < s.nu; ++j) g[r] += c.W[s.w + r * s.nu + j] * v_[first(s) + j];
      }
      if (!compliance_.percussion(d, c.row0[i], i, g, dLambda + c.row0[i])) return false;
    }
    return true;
  }

  Touched touched_;
  Compliances compliance_;
  int size_ = 0;
  std::vector<int> u0_;
  std::vector<double> K_, v_, row_, scale_;
};

}  // namespace

std::unique_ptr<NewtonSystem> NewtonSystem::inVelocities(int nu) {
  if (nu <= 3) return std::make_unique<SparseVelocities<3>>();
  if (nu <= 6) return std::make_unique<SparseVelocities<6>>();
  return std::make_unique<DenseVelocities>();
}

}  // namespace dynamy
