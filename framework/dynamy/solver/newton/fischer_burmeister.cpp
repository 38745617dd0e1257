#include <algorithm>
#include <cmath>
#include <dynamy/solver/newton/fischer_burmeister.hpp>

namespace dynamy {
namespace {

/// Derivatives divide by the small eigenvalue of (x² + y²)^½, but at least by this fraction of the
/// large one.
constexpr double kKink = 1e-8;

template <int n>
using PairPoint = Eigen::Matrix<double, n, 1>;
template <int n>
using Square = Eigen::Matrix<double, n, n>;

/// x ∘ y = L_x y.
template <int n>
Square<n> arrow(const PairPoint<n>& x) {
  Square<n> L = x[0] * Square<n>::Identity();
  L.row(0) = x.transpose();
  L.col(0) = x;
  return L;
}

/// φ and its derivatives with respect to x and y.
template <int n>
struct Function {
  PairPoint<n> value;
  Square<n> dx, dy;

  Function(const PairPoint<n>& x, const PairPoint<n>& y, bool derivative) {
    const double w0 = x.squaredNorm() + y.squaredNorm();
    PairPoint<n> w = 2.0 * (x[0] * x + y[0] * y);  // the entries after the first
    w[0] = 0.0;
    const double length = w.norm();
    const double s2 = std::sqrt(w0 + length), s1 = std::sqrt(std::max(0.0, w0 - length));
    const PairPoint<n> direction = length > 0.0 ? PairPoint<n>(w / length) : PairPoint<n>::Zero();
    PairPoint<n> root = 0.5 * (s2 - s1) * direction;
    root[0] = 0.5 * (s1 + s2);
    value = x + y - root;
    if (!derivative) return;
    if (!(s2 > 0.0)) {
      dx = dy = (1.0 - std::sqrt(0.5)) * Square<n>::Identity();
      return;
    }
    const Square<n> inverse = invertArrow(std::max(s1, kKink * s2), s2, direction);
    dx = Square<n>::Identity() - inverse * arrow<n>(x);
    dy = Square<n>::Identity() - inverse * arrow<n>(y);
  }

 private:
  /// L_z⁻¹ of z with eigenvalues s1, s2 along the direction (0, e).
  static Square<n> invertArrow(double s1, double s2, const PairPoint<n>& e) {
    const double z0 = 0.5 * (s1 + s2), z1 = 0.5 * (s2 - s1), det = s1 * s2;
    Square<n> out = Square<n>::Identity() / z0;
    out += (z1 * z1 / (z0 * det)) * e * e.transpose();
    out(0, 0) = z0 / det;
    for (int k = 1; k < n; ++k) out(0, k) = out(k, 0) = -z1 / det * e[k];
    return out;
  }
};

template <int n>
void evaluate(double mu, double rho, const double* xi, const double* Lambda, double* F, double* A,
              double* B) {
  using Row = Eigen::Matrix<double, n, n, n == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
  const double scale = n == 1 ? 1.0 : mu;
  PairPoint<n> x = Eigen::Map<const PairPoint<n>>(Lambda), y = Eigen::Map<const PairPoint<n>>(xi),
               turn;
  x[0] *= scale;
  turn = y;
  turn[0] = 0.0;
  const double slip = turn.norm();
  if (slip > 0.0) turn /= slip;
  y *= rho * scale;
  y[0] = rho * (xi[0] + (n == 1 ? 0.0 : mu * slip));
  const Function<n> phi(x, y, A != nullptr);
  Eigen::Map<PairPoint<n>>{F} = phi.value;
  if (!A) return;
  Eigen::Map<Row> a(A), b(B);
  a = phi.dx;
  a.col(0) *= scale;
  Square<n> dy = rho * scale * Square<n>::Identity();
  dy.row(0) = rho * scale * turn.transpose();
  dy(0, 0) = rho;
  b = phi.dy * dy;
}

}  // namespace

LawCone coneOf(const SetValuedForceLaw& law, const LawInput& in) {
  const SimpleSet set = law.simpleSet(in);
  switch (set.shape) {
    case SimpleSet::Shape::all:
      return {LawCone::Kind::line, 0.0};
    case SimpleSet::Shape::interval:
      return {set.lower == 0.0 && std::isinf(set.upper) ? LawCone::Kind::halfLine
                                                        : LawCone::Kind::other,
              0.0};
    case SimpleSet::Shape::friction:
      return {LawCone::Kind::cone, set.upper};
    default:
      return {};
  }
}

void fischerBurmeister(const LawCone& cone, int dim, double rho, const double* xi,
                       const double* Lambda, double* F, double* A, double* B) {
  if (A) {
    std::fill(A, A + dim * dim, 0.0);
    std::fill(B, B + dim * dim, 0.0);
  }
  if (cone.kind == LawCone::Kind::line) {
    for (int k = 0; k < dim; ++k) F[k] = rho * xi[k];
    for (int k = 0; A && k < dim; ++k) B[k * dim + k] = rho;
    return;
  }
  if (cone.kind == LawCone::Kind::cone && cone.mu > 0.0) {
    if (dim == 2)
      evaluate<2>(cone.mu, rho, xi, Lambda, F, A, B);
    else
      evaluate<3>(cone.mu, rho, xi, Lambda, F, A, B);
    return;
  }
  // No friction: the normal row alone, Λ_T = 0.
  double a = 0.0, b = 0.0;
  evaluate<1>(0.0, rho, xi, Lambda, F, A ? &a : nullptr, &b);
  if (A) A[0] = a, B[0] = b;
  for (int k = 1; k < dim; ++k) {
    F[k] = Lambda[k];
    if (A) A[k * dim + k] = 1.0;
  }
}

}  // namespace dynamy
