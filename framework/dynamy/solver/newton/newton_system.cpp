#include <cmath>
#include <dynamy/solver/newton/block_lu.hpp>
#include <dynamy/solver/newton/newton_system.hpp>

namespace dynamy {
namespace {

/// Largest ratio of contacts in the equations to contacts that are not open.
constexpr double kIdle = 1.2;

/// Contacts of fewer than n rows are filled up by rows of the identity.
template <int n>
class System final : public NewtonSystem {
 public:
  bool prepare(const InclusionProblem& p) override {
    G_ = &p.G->blockRows();
    kept_.assign(static_cast<std::size_t>(p.size()), 0);  // forget the last problem: same bits
    return true;
  }
  void multiply(const InclusionProblem& p, const double* x, double* y) override {
    const int* row0 = p.contacts->row0.data();
    for (int i = 0; i < p.size(); ++i) G_->multiplyRow(i, row0, x, y + row0[i]);
  }
  bool solve(const InclusionProblem& p, const NewtonBlocks& b,
             std::vector<double>& dLambda) override {
    const BlockRows& G = *G_;
    chooseActive(p, b, dLambda);
    pattern(G);
    tooLarge_ = !lu_.analyse(first_, column_);
    if (tooLarge_) return false;
    lu_.setZero();
    right_.resize(active_.size());
    for (std::size_t k = 0; k < active_.size(); ++k)
      equation(p, G, b, static_cast<int>(k), dLambda);
    if (!lu_.factor()) return false;
    lu_.solve(right_);
    for (std::size_t k = 0; k < active_.size(); ++k)
      for (int r = 0; r < p.dim(active_[k]); ++r) {
        dLambda[p.row0(active_[k]) + r] = right_[k][r];
        if (!std::isfinite(right_[k][r])) return false;
      }
    return true;
  }
  bool factorShifted(const InclusionProblem& p, const std::vector<double>& a) override {
    const BlockRows& G = *G_;
    active_.resize(static_cast<std::size_t>(p.size()));
    for (int i = 0; i < p.size(); ++i) active_[i] = i;
    number_ = active_;
    pattern(G);
    tooLarge_ = !lu_.analyse(first_, column_);
    if (tooLarge_) return false;
    lu_.setZero();
    for (int i = 0; i < p.size(); ++i)
      for (int e = G.first[i]; e < G.first[i + 1]; ++e) {
        const int j = G.column[e], dim = p.dim(i);
        Matrix K = padded(G.value.data() + G.value0[e], dim, p.dim(j));
        for (int r = 0; j == i && r < n; ++r) K(r, r) += r < dim ? a[i] : 1.0;
        lu_.at(i, j) = K;
      }
    return lu_.factor();
  }
  bool solveShifted(const InclusionProblem& p, const double* r, std::vector<double>& x) override {
    right_.resize(static_cast<std::size_t>(p.size()));
    for (int i = 0; i < p.size(); ++i) {
      right_[i].setZero();
      for (int k = 0; k < p.dim(i); ++k) right_[i][k] = r[p.row0(i) + k];
    }
    lu_.solve(right_);
    double sum = 0.0;
    for (int i = 0; i < p.size(); ++i)
      for (int k = 0; k < p.dim(i); ++k) sum += x[p.row0(i) + k] = right_[i][k];
    return std::isfinite(sum);
  }
  bool tooLarge() const override { return tooLarge_; }
  long entries() const override { return lu_.entries(); }
  long analyses() const override { return lu_.analyses(); }

 private:
  using Matrix = typename BlockLu<n>::Matrix;
  using Vector = typename BlockLu<n>::Vector;

  /// Chooses contacts that are not open, and some of the last analysis: open contacts cost little,
  /// a new analysis costs more than a factorisation and allocates memory.
  void chooseActive(const InclusionProblem& p, const NewtonBlocks& b, std::vector<double>& d) {
    const auto size = static_cast<std::size_t>(p.size());
    wanted_.assign(size, 0);
    std::size_t wanted = 0, both = 0;
    for (int i = 0; i < p.size(); ++i) {
      const double* B = b.B.data() + b.block0[i];
      const int entries = p.dim(i) * p.dim(i);
      wanted_[i] = std::any_of(B, B + entries, [](double x) { return x != 0.0; });
      wanted += wanted_[i], both += wanted_[i] || kept_[i];
    }
    if (static_cast<double>(size) <= kIdle * static_cast<double>(wanted))
      kept_.assign(size, 1);
    else if (static_cast<double>(both) <= kIdle * static_cast<double>(wanted))
      for (std::size_t i = 0; i < size; ++i) kept_[i] = kept_[i] || wanted_[i];
    else
      kept_ = wanted_;
    active_.clear();
    number_.assign(size, -1);
    for (int i = 0; i < p.size(); ++i) {
      if (kept_[i]) {
        number_[i] = static_cast<int>(active_.size());
        active_.push_back(i);
        continue;
      }
      for (int r = p.row0(i); r < p.row0(i) + p.dim(i); ++r) d[r] = -b.F[r];
    }
  }
  void pattern(const BlockRows& G) {
    first_.assign(1, 0), column_.clear();
    for (const int i : active_) {
      for (int e = G.first[i]; e < G.first[i + 1]; ++e)
        if (number_[G.column[e]] >= 0) column_.push_back(number_[G.column[e]]);
      first_.push_back(static_cast<int>(column_.size()));
    }
  }
  /// Block row k of the equations, and its right-hand side.
  void equation(const InclusionProblem& p, const BlockRows& G, const NewtonBlocks& b, int k,
                const std::vector<double>& dLambda) {
    const int i = active_[k], dim = p.dim(i), row0 = p.row0(i);
    const Matrix A = padded(b.A.data() + b.block0[i], dim, dim);
    const Matrix B = padded(b.B.data() + b.block0[i], dim, dim);
    Vector g = Vector::Zero();
    for (int r = 0; r < dim; ++r) g[r] = -b.F[row0 + r];
    for (int e = G.first[i]; e < G.first[i + 1]; ++e) {
      const int j = G.column[e];
      Matrix K = B * padded(G.value.data() + G.value0[e], dim, p.dim(j));
      if (j == i) {
        K += A + b.a[i] * B;
        for (int r = dim; r < n; ++r) K(r, r) = 1.0;
      }
      if (number_[j] >= 0) {
        lu_.at(k, number_[j]) = K;
        continue;
      }
      for (int m = 0; m < p.dim(j); ++m) g -= K.col(m) * dLambda[p.row0(j) + m];
    }
    right_[k] = g;
  }
  static Matrix padded(const double* value, int rows, int columns) {
    if (rows == n && columns == n)
      return Eigen::Map<const Eigen::Matrix<double, n, n, Eigen::RowMajor>>(value);
    Matrix out = Matrix::Zero();
    for (int r = 0; r < rows; ++r)
      for (int k = 0; k < columns; ++k) out(r, k) = value[r * columns + k];
    return out;
  }

  const BlockRows* G_ = nullptr;
  BlockLu<n> lu_;
  bool tooLarge_ = false;
  std::vector<int> active_, number_, first_, column_;
  std::vector<char> wanted_, kept_;
  std::vector<Vector> right_;
};

}  // namespace

std::unique_ptr<NewtonSystem> NewtonSystem::inPercussions(int dim) {
  if (dim <= 2) return std::make_unique<System<2>>();
  if (dim <= 3) return std::make_unique<System<3>>();
  if (dim <= 6) return std::make_unique<System<6>>();
  return nullptr;
}

}  // namespace dynamy
