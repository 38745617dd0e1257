#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/local/local_solution.hpp>
#include <dynamy/solver/local/slip_equation.hpp>

namespace dynamy {
namespace {

using SetShape = SimpleSet::Shape;
/// Pivots below this part of the diagonal are rounding: singular.
constexpr double kSingularMatrix = 1e-13;

/// D⁻¹, rows and columns scaled by the diagonal: rows of joints may have different units.
bool invertLocal(const double* D, int n, double* out) {
  using Small =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostRows, kMostRows>;
  using Scale = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;
  const Eigen::Map<const RowMatrix> A(D, n, n);
  if (!(A.diagonal().minCoeff() > 0.0)) return false;
  const Scale scale = A.diagonal().cwiseSqrt().cwiseInverse();
  const Small scaled = scale.asDiagonal() * A * scale.asDiagonal();
  const Eigen::PartialPivLU<Small> lu(scaled);
  if (!(lu.matrixLU().diagonal().cwiseAbs().minCoeff() > kSingularMatrix)) return false;
  Eigen::Map<RowMatrix>(out, n, n) = scale.asDiagonal() * lu.inverse() * scale.asDiagonal();
  return true;
}

/// Solves a contact with two rows and |Λ| ≤ radius.
LocalReport ballOfTwo(const double* D, double radius, const double* b, double* Lambda) {
  SlipEquation e;
  e.d0 = D[0] * D[3] - D[1] * D[2], e.d1 = D[0] + D[3];
  e.p0[0] = D[1] * b[1] - D[3] * b[0], e.p0[1] = D[2] * b[0] - D[0] * b[1];
  e.p1[0] = -b[0], e.p1[1] = -b[1];
  const double x = e.p0[0] / e.d0, y = e.p0[1] / e.d0;
  if (x * x + y * y <= radius * radius) {
    Lambda[0] = x, Lambda[1] = y;
    return {LocalCase::stick, 1, 0.0};
  }
  if (radius == 0.0) {
    Lambda[0] = Lambda[1] = 0.0;
    return {LocalCase::slip, 1, 0.0};
  }
  e.q0 = e.d0, e.q1 = e.d1, e.q2 = 1.0, e.s = radius;
  const double a = e.onlyRoot();
  for (int i = 0; i < 2; ++i) Lambda[i] = e.p0[i] + e.p1[i] * a;
  const double part = radius / std::sqrt(Lambda[0] * Lambda[0] + Lambda[1] * Lambda[1]);
  Lambda[0] *= part, Lambda[1] *= part;
  return {LocalCase::slip, 1, a};
}

LocalReport interval(double D, double lower, double upper, double b, double* Lambda) {
  if (!(D > 0.0)) return {};
  const double free = -b / D;
  Lambda[0] = std::min(std::max(free, lower), upper);
  const bool inside = Lambda[0] == free;
  return {inside ? LocalCase::stick : (Lambda[0] == 0.0 ? LocalCase::takeOff : LocalCase::slip)};
}

}  // namespace

void LocalSolutions::clear() {
  contacts_.clear(), numbers_.clear(), planar_.clear(), spatial_.clear();
}

void LocalSolutions::prepare(const InclusionProblem& p) {
  clear();
  for (int i = 0; i < p.size(); ++i)
    add(p.G->diagonalBlock(i), p.dim(i), p.law(i).simpleSet(p.input(i)));
}

void LocalSolutions::add(const double* D, int dim, const SimpleSet& set) {
  Contact contact{set.shape, dim, false, 0};
  switch (set.shape) {
    case SetShape::friction:
      if (dim == 2) {
        contact.at = planar_.size();
        contact.simple = planar_.emplace_back().prepare(D, set.upper);
      } else if (dim == 3) {
        contact.at = spatial_.size();
        contact.simple = spatial_.emplace_back().prepare(D, set.upper);
      }
      break;
    case SetShape::all:
      contact.at = numbers_.size();
      numbers_.resize(contact.at + static_cast<std::size_t>(dim * dim));
      contact.simple = invertLocal(D, dim, numbers_.data() + contact.at);
      break;
    case SetShape::interval:
    case SetShape::ball: {
      const int n = dim == 1 ? 1 : 4;
      const bool ball = set.shape == SetShape::ball;
      contact.at = numbers_.size();
      contact.simple =
          dim == 1 ? D[0] > 0.0
                   : ball && dim == 2 && D[0] * D[3] - D[1] * D[2] > kSingularMatrix * D[0] * D[3];
      if (!contact.simple) break;
      numbers_.insert(numbers_.end(), D, D + n);
      numbers_.insert(numbers_.end(), {ball ? -set.upper : set.lower, set.upper});
      break;
    }
    case SetShape::other:
      break;
  }
  contacts_.push_back(contact);
}

LocalReport LocalSolutions::solve(int i, const double* b, double* Lambda) const {
  const Contact& contact = contacts_[static_cast<std::size_t>(i)];
  if (!contact.simple) return {};
  if (contact.shape == SetShape::friction) {
    return contact.dim == 2 ? planar_[contact.at].solve(b, Lambda)
                            : spatial_[contact.at].solve(b, Lambda);
  }
  const double* numbers = numbers_.data() + contact.at;
  if (contact.shape == SetShape::all) {
    for (int r = 0; r < contact.dim; ++r) {
      double sum = 0.0;
      for (int k = 0; k < contact.dim; ++k) sum -= numbers[r * contact.dim + k] * b[k];
      Lambda[r] = sum;
    }
    return {LocalCase::stick, 1, 0.0};
  }
  if (contact.dim == 1) return interval(numbers[0], numbers[1], numbers[2], b[0], Lambda);
  return ballOfTwo(numbers, numbers[5], b, Lambda);
}

int LocalSolutions::all(int i, const double* b, LocalReport* reports, double* Lambda) const {
  const Contact& contact = contacts_[static_cast<std::size_t>(i)];
  if (!contact.simple || contact.shape != SimpleSet::Shape::friction) {
    reports[0] = solve(i, b, Lambda);
    return contact.simple ? 1 : 0;
  }
  return contact.dim == 2 ? planar_[contact.at].solutions(b, reports, Lambda)
                          : spatial_[contact.at].solutions(b, reports, Lambda);
}

}  // namespace dynamy
