#include <cmath>
#include <dynamy/solver/block_lu.hpp>
#include <dynamy/solver/newton_system.hpp>

namespace dynamy {
namespace {

/// Contacts of fewer than n rows are filled up by rows of the identity.
template <int n>
class System final : public NewtonSystem {
 public:
  bool solve(const InclusionProblem& p, const BlockRows& G, const NewtonBlocks& b,
             std::vector<double>& dLambda) override {
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
  bool tooLarge() const override { return tooLarge_; }
  long entries() const override { return lu_.entries(); }
  long analyses() const override { return lu_.analyses(); }

 private:
  using Matrix = typename BlockLu<n>::Matrix;
  using Vector = typename BlockLu<n>::Vector;

  void chooseActive(const InclusionProblem& p, const NewtonBlocks& b, std::vector<double>& d) {
    active_.clear();
    number_.assign(p.size(), -1);
    for (int i = 0; i < p.size(); ++i) {
      const double* B = b.B.data() + b.block0[i];
      const int size = p.dim(i) * p.dim(i);
      const bool open = std::all_of(B, B + size, [](double x) { return x == 0.0; });
      if (!open) {
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

  BlockLu<n> lu_;
  bool tooLarge_ = false;
  std::vector<int> active_, number_, first_, column_;
  std::vector<Vector> right_;
};

}  // namespace

std::unique_ptr<NewtonSystem> NewtonSystem::make(int dim) {
  if (dim <= 2) return std::make_unique<System<2>>();
  if (dim <= 3) return std::make_unique<System<3>>();
  if (dim <= 6) return std::make_unique<System<6>>();
  return nullptr;
}

}  // namespace dynamy
