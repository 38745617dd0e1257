#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy_elements/laws/orthotropic_friction.hpp>

namespace dynamy {
namespace {

using Point = convex::Point<2>;
using Matrix = convex::Matrix<2>;

/// Rotation matrix with the axes of the grain as columns.
Matrix turn(double c, double s) {
  Matrix R;
  R << c, -s, s, c;
  return R;
}

}  // namespace

UnilateralOrthotropic::UnilateralOrthotropic(double epsilonN, double epsilonT, double mu1,
                                             double mu2, double angle)
    : epsilonN_(epsilonN),
      epsilonT_(epsilonT),
      mu_{mu1, mu2},
      cos_(std::cos(angle)),
      sin_(std::sin(angle)) {}

UnilateralOrthotropic::UnilateralOrthotropic(const Parameters& x)
    : NormalTimesReservoir(x),
      epsilonN_(x["epsilonN"]),
      epsilonT_(x["epsilonT"]),
      mu_{x["mu1"], x["mu2"]},
      cos_(std::cos(double(x["angle"]))),
      sin_(std::sin(double(x["angle"]))) {}

void UnilateralOrthotropic::declare(Attributes& a) {
  a.about(
      "Contact with friction that differs by direction: −ξ_T ∈ N_B(Λ_T), B the ellipse with "
      "semi-axes μ1 Λ_N and μ2 Λ_N. Axis 1 is the first tangent turned by `angle`: the `grain` of "
      "one of the two shapes, seen along the normal, which turns with that body; without a grain, "
      "the tangents of a contact on a half space are fixed in it.");
  a.required("mu1", Unit::none, "coefficient of friction along axis 1").nonNegative();
  a.required("mu2", Unit::none, "coefficient of friction along axis 2").nonNegative();
  a.optional("angle", Unit::angle, 0.0, "from the first tangent to axis 1");
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of the normal direction")
      .between(0.0, 1.0);
  a.optional("epsilonT", Unit::none, 0.0, "coefficient of restitution of the tangents")
      .between(0.0, 1.0);
  a.example("<UnilateralOrthotropic mu1=\"0.1\" mu2=\"0.3\" angle=\"30deg\"/>");
}

void UnilateralOrthotropic::epsilon(int dim, double* epsilon) const {
  epsilon[0] = epsilonN_;
  std::fill(epsilon + 1, epsilon + dim, epsilonT_);
}

SimpleSet UnilateralOrthotropic::simpleSet(const LawInput& in) const {
  const double one = 1.0;
  if (in.dim == 1) return {SimpleSet::Shape::interval, 0.0, kInfinity};
  if (in.dim != 2) return {};
  return {SimpleSet::Shape::friction, 0.0, support(in, 1, &one)};
}

void UnilateralOrthotropic::project(const LawInput& in, double N, const double* r, int k,
                                    double* x) const {
  N = std::max(N, 0.0);
  if (k == 1) {
    const double one = 1.0;
    x[0] = convex::prox(convex::symmetricInterval(N * support(in, 1, &one)), x[0]);
    return;
  }
  Eigen::Map<Point> z(x);
  const Matrix R = turn(cos_, sin_);
  if (r[0] == r[1]) {
    const Point inside = R.transpose() * z;
    z = R * convex::prox(convex::Ellipse{{N * mu_[0], N * mu_[1]}}, inside);
    return;
  }
  const Matrix H = R * Point(mu_[0], mu_[1]).asDiagonal();
  const Point argument = z;
  z = convex::prox(convex::inMetric<2>(H, Matrix(Point(r[0], r[1]).asDiagonal())), argument, N);
}

double UnilateralOrthotropic::support(const LawInput&, int k, const double* y, double* gradient,
                                      double* hessian) const {
  const Matrix R = turn(cos_, sin_);
  Matrix H2 = R * Point(mu_[0] * mu_[0], mu_[1] * mu_[1]).asDiagonal() * R.transpose();
  if (k == 1) {
    const double mu = std::sqrt(H2(0, 0));
    if (gradient) gradient[0] = y[0] > 0.0 ? mu : (y[0] < 0.0 ? -mu : 0.0);
    if (hessian) hessian[0] = 0.0;
    return mu * std::abs(y[0]);
  }
  const Point v(y[0], y[1]), Hv = H2 * v;
  const double S = std::sqrt(std::max(0.0, v.dot(Hv)));
  const Point g = S > 0.0 ? Point(Hv / S) : Point::Zero();
  if (gradient) Eigen::Map<Point>{gradient} = g;
  if (hessian) {
    Eigen::Map<Matrix> h(hessian);
    h.setZero();
    if (S > 0.0) h = (H2 - g * g.transpose()) / S;
  }
  return S;
}

bool UnilateralOrthotropic::proxDerivative(const LawInput& in, double rho, const double* xi,
                                           const double* Lambda, double* A, double* B) const {
  if (in.dim != 3) return NormalTimesReservoir::proxDerivative(in, rho, xi, Lambda, A, B);
  using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Eigen::Map<Matrix3> a(A), b(B);
  a.setIdentity(), b.setZero();
  const double N = Lambda[0] - rho * xi[0];
  if (!(N > 0.0)) return true;
  // P = ∂p/∂z of the ellipse in its own axes.
  const Matrix R = turn(cos_, sin_);
  const Point z = R.transpose() * Point(Lambda[1] - rho * xi[1], Lambda[2] - rho * xi[2]);
  const convex::Ellipse C{{N * mu_[0], N * mu_[1]}};
  Matrix3 P = Matrix3::Zero();
  P(0, 0) = 1.0;
  P.block<2, 2>(1, 1) = R * convex::proxDerivative(C, z) * R.transpose();
  P.block<2, 1>(1, 0) = R * convex::scaleDerivative(C, z) / N;
  a -= P;
  b = rho * P;
  return true;
}

}  // namespace dynamy
