// Standard set-valued laws. With z = Λ − r ξ:
//   bilateral      Λ = z
//   unilateral     Λ = max(0, z)
//   Coulomb        Λ_N = max(0, z_N),  Λ_T = prox_{disc μ Λ_N}(z_T)
//   given size     Λ = prox_{disc a Δt}(z)
// and their generalised derivatives P = ∂Λ/∂z, handed out as A = I − P and B = ρ P.
#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/safe_norm.hpp>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {
namespace {

/// Coefficients μ below this value have squares that do not overflow; above, the cone is
/// practically a half space.
constexpr double kMostMu = 1e100;

/// x ← nearest point of the ball of `radius` in the metric diag(r)⁻¹.
void projectBall(double radius, const double* r, int k, double* x) {
  radius = std::max(radius, 0.0);
  if (k == 1) {
    x[0] = convex::prox(convex::symmetricInterval(radius), x[0]);
    return;
  }
  if (k == 2 && r[0] == r[1]) {  // the usual case
    const double length = safeNorm(x, 2);
    if (length > radius) x[0] *= radius / length, x[1] *= radius / length;
    return;
  }
  Eigen::Map<Eigen::VectorXd> z(x, k);
  const bool equal = std::all_of(r, r + k, [r](double value) { return value == r[0]; });
  if (equal) {
    const double length = safeNorm(x, k);
    if (length > radius) z *= radius / length;
  } else if (k == 2) {
    const convex::Point<2> in = z;
    z = convex::prox(convex::Ball<2>{radius},
                     convex::Matrix<2>(convex::Point<2>(r[0], r[1]).asDiagonal()), in);
  } else {
    expects(k == 3, "rows of a ball with more than 3 dimensions share one r");
    const convex::Point<3> in = z;
    z = convex::prox(convex::Ball<3>{radius},
                     convex::Matrix<3>(convex::Point<3>(r[0], r[1], r[2]).asDiagonal()), in);
  }
}

/// P of the ball: I inside, (a/|z|)(I − e eᵀ) outside; e = z/|z| outside, 0 inside.
void ballDerivative(double radius, const double* z, int k, double* P, double* e) {
  // Plain loops: an outer product of vectors of dynamic size makes a temporary matrix.
  const double length = safeNorm(z, k), q = std::max(radius, 0.0) / length;
  const bool inside = length <= std::max(radius, 0.0);
  for (int i = 0; i < k; ++i) e[i] = inside ? 0.0 : z[i] / length;
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j) {
      const double unit = i == j ? 1.0 : 0.0;
      P[i * k + j] = inside ? unit : q * (unit - e[i] * e[j]);
    }
}

/// Nearest point of the cone if squares of z or of μ would overflow or vanish. It uses the
/// direction (cos, sin) of the cone's edge, and z divided by its largest number.
template <int n>
convex::Point<n> farCone(double mu, const convex::Point<n>& z) {
  const double unit = z.template lpNorm<Eigen::Infinity>(), edge = std::hypot(1.0, mu);
  if (!(unit > 0.0) || !std::isfinite(unit)) return z;
  const convex::Point<n> x = z / unit;
  const double cosine = 1.0 / edge, sine = mu / edge, xT = x.template tail<n - 1>().norm();
  if (xT * cosine <= x[0] * sine) return z;
  const double along = cosine * x[0] + sine * xT;
  if (along <= 0.0) return convex::Point<n>::Zero();
  convex::Point<n> y;
  y[0] = cosine * along;
  y.template tail<n - 1>() = x.template tail<n - 1>() * (sine * along / xT);
  return unit * y;
}

/// One projection onto the cone of n rows.
template <int n>
void coneMap(double mu, double rho, const double* xi, const double* Lambda, double* e) {
  convex::Point<n> L, z;
  for (int i = 0; i < n; ++i) L[i] = Lambda[i], z[i] = xi[i];
  z[0] += mu * safeNorm(xi + 1, n - 1);
  z = L - rho * z;
  const double square = z.squaredNorm();
  const bool near = square > kLeastSquare && square < kMostSquare && mu < kMostMu;
  const convex::Point<n> p =
      near ? convex::prox(convex::FrictionCone<n>{mu}, z) : farCone<n>(mu, z);
  for (int i = 0; i < n; ++i) e[i] = L[i] - p[i];
}

Attribute& restitution(Attributes& a, const char* name, const char* text) {
  return a.optional(name, Unit::none, 0.0, text).between(0.0, 1.0);
}

}  // namespace

// ---- Bilateral ---------------------------------------------------------------------------------

void Bilateral::declare(Attributes& a) {
  a.about("γ = 0 in every row, C = ℝ: a joint.");
  a.example("<Bilateral/>");
}

void Bilateral::prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const {
  for (int i = 0; i < in.dim; ++i) Lambda[i] -= r[i] * xi[i];
}

bool Bilateral::proxDerivative(const LawInput& in, double rho, const double*, const double*,
                               double* A, double* B) const {
  Eigen::Map<RowMatrix>(A, in.dim, in.dim).setZero();
  Eigen::Map<RowMatrix>(B, in.dim, in.dim).setIdentity() *= rho;
  return true;
}

SimpleSet Bilateral::simpleSet(const LawInput&) const { return {SimpleSet::Shape::all}; }

// ---- Unilateral --------------------------------------------------------------------------------

void Unilateral::declare(Attributes& a) {
  a.about(
      "Contact without friction: 0 ≤ Λ_N ⊥ ξ_N ≥ 0 with ξ_N = γ_N⁺ + ε_N γ_N⁻, C = ℝ₀⁺; acts while "
      "the gap is closed.");
  restitution(a, "epsilonN", "coefficient of restitution ε_N of the normal direction");
  a.example("<Unilateral epsilonN=\"0.5\"/>");
}

Unilateral::Unilateral(const Parameters& x) : SetValuedForceLaw(x), epsilonN_(x["epsilonN"]) {}

void Unilateral::epsilon(int, double* epsilon) const { epsilon[0] = epsilonN_; }

void Unilateral::prox(const LawInput&, const double* r, const double* xi, double* Lambda) const {
  Lambda[0] = convex::prox(convex::Interval{}, Lambda[0] - r[0] * xi[0]);
}

bool Unilateral::proxDerivative(const LawInput&, double rho, const double* xi, const double* Lambda,
                                double* A, double* B) const {
  const double P = convex::proxDerivative(convex::Interval{}, Lambda[0] - rho * xi[0]);
  A[0] = 1.0 - P, B[0] = rho * P;
  return true;
}

SimpleSet Unilateral::simpleSet(const LawInput&) const {
  return {SimpleSet::Shape::interval, 0.0, kInfinity};
}

Status Unilateral::status(const LawInput&, const double* argument) const {
  return argument[0] > 0.0 ? Status::slip : Status::separating;
}

// ---- UnilateralCoulomb -------------------------------------------------------------------------

void UnilateralCoulomb::declare(Attributes& a) {
  a.about(
      "Contact with dry friction: 0 ≤ Λ_N ⊥ ξ_N ≥ 0, −ξ_T ∈ N_B(Λ_T), B the disc (planar: "
      "interval) "
      "of radius μ Λ_N; ξ = γ⁺ + ε γ⁻. Acts while the gap is closed.");
  a.required("mu", Unit::none, "coefficient of friction μ").nonNegative();
  restitution(a, "epsilonN", "coefficient of restitution ε_N of the normal direction");
  restitution(a, "epsilonT", "coefficient of restitution ε_T of the tangential directions");
  a.example("<UnilateralCoulomb mu=\"0.3\" epsilonN=\"0.5\"/>");
}

UnilateralCoulomb::UnilateralCoulomb(const Parameters& x)
    : NormalTimesReservoir(x), epsilonN_(x["epsilonN"]), epsilonT_(x["epsilonT"]), mu_(x["mu"]) {}

void UnilateralCoulomb::epsilon(int dim, double* epsilon) const {
  epsilon[0] = epsilonN_;
  std::fill(epsilon + 1, epsilon + dim, epsilonT_);
}

void UnilateralCoulomb::project(const LawInput&, double N, const double* r, int k,
                                double* x) const {
  projectBall(mu_ * N, r, k, x);
}

double UnilateralCoulomb::support(const LawInput&, int k, const double* y, double* gradient,
                                  double* hessian) const {
  const Eigen::Map<const Eigen::VectorXd> direction(y, k);
  const double length = direction.norm();
  // At y = 0 every point of B is a subgradient; its centre is taken.
  const double inverse = length > 0.0 ? 1.0 / length : 0.0;
  if (gradient)
    for (int i = 0; i < k; ++i) gradient[i] = mu_ * inverse * y[i];
  if (hessian)
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j)
        hessian[i * k + j] =
            mu_ * inverse * ((i == j ? 1.0 : 0.0) - inverse * inverse * y[i] * y[j]);
  return mu_ * length;
}

void UnilateralCoulomb::prox(const LawInput& in, const double* r, const double* xi,
                             double* Lambda) const {
  // Same as NormalTimesReservoir::prox, but without its virtual call: this is the innermost loop of
  // a solver.
  for (int i = 0; i < in.dim; ++i) Lambda[i] -= r[i] * xi[i];
  Lambda[0] = std::max(Lambda[0], 0.0);
  if (in.dim > 1) projectBall(mu_ * Lambda[0], r + 1, in.dim - 1, Lambda + 1);
}

void UnilateralCoulomb::naturalMap(const LawInput& in, double rho, const double* xi,
                                   const double* Lambda, double* e) const {
  // e = Λ − prox_K(Λ − ρ ξ^), ξ^ = (ξ_N + μ|ξ_T|, ξ_T): one projection onto the cone K. A contact
  // that leaves without a force needs none.
  if (xi[0] >= 0.0 && std::all_of(Lambda, Lambda + in.dim, [](double x) { return x == 0.0; })) {
    std::fill(e, e + in.dim, 0.0);
    return;
  }
  if (in.dim == 1)
    e[0] = Lambda[0] - std::max(Lambda[0] - rho * xi[0], 0.0);
  else if (in.dim == 2)
    coneMap<2>(mu_, rho, xi, Lambda, e);
  else
    coneMap<3>(mu_, rho, xi, Lambda, e);
}

SimpleSet UnilateralCoulomb::simpleSet(const LawInput& in) const {
  if (in.dim == 1) return {SimpleSet::Shape::interval, 0.0, kInfinity};
  return {SimpleSet::Shape::friction, 0.0, std::min(mu_, kMostMu)};
}

bool UnilateralCoulomb::proxDerivative(const LawInput& in, double rho, const double* xi,
                                       const double* Lambda, double* A, double* B) const {
  const int n = in.dim, k = n - 1;
  double z[3] = {}, P[4], e[2], square = 0.0;
  for (int i = 0; i < n; ++i) z[i] = Lambda[i] - rho * xi[i];
  for (int i = 1; i < n; ++i) square += z[i] * z[i];
  const bool pressed = z[0] > 0.0;
  // Stick: A = 0, B = ρ I; open: A = I, B = 0.
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      A[i * n + j] = !pressed && i == j ? 1.0 : 0.0;
      B[i * n + j] = pressed && i == j ? rho : 0.0;
    }
  if (!pressed || square <= mu_ * mu_ * z[0] * z[0]) return true;
  ballDerivative(mu_ * z[0], z + 1, k, P, e);
  for (int i = 0; i < k; ++i) {
    double *a = A + (1 + i) * n, *b = B + (1 + i) * n;
    a[0] = -mu_ * e[i], b[0] = rho * mu_ * e[i];
    for (int j = 0; j < k; ++j) {
      a[1 + j] = (i == j ? 1.0 : 0.0) - P[i * k + j];
      b[1 + j] = rho * P[i * k + j];
    }
  }
  return true;
}

// ---- GivenFriction -----------------------------------------------------------------------------

void GivenFriction::declare(Attributes& a) {
  a.about(
      "Dry friction whose size does not depend on a normal force: −ξ ∈ N_C(Λ), C = disc of radius "
      "a Δt. The static value holds while the relative velocity at the beginning of the step is "
      "zero (1e-9 m/s), else the kinetic one. Brakes, clutches, joints.");
  a.required("force", Unit::force, "static friction a [N]; of a rotation [N m]").nonNegative();
  Attribute& kinetic = a.add(AttributeType::number, "kineticForce", std::nullopt,
                             "friction while slipping; default: force");
  kinetic.unit = Unit::force;
  kinetic.optionalValue = true;
  kinetic.nonNegative();
  a.example("<GivenFriction force=\"2\" kineticForce=\"1.5\"/>");
}

GivenFriction::GivenFriction(const Parameters& x)
    : SetValuedForceLaw(x),
      static_(x["force"]),
      kinetic_(x.has("kineticForce") ? double(x["kineticForce"]) : static_) {}

double GivenFriction::radius(const LawInput& in) const {
  double square = 0.0;
  for (int i = 0; i < in.dim; ++i) square += in.gammaA[i] * in.gammaA[i];
  return in.scale * in.dt * (square > in.rest * in.rest ? kinetic_ : static_);
}

void GivenFriction::prox(const LawInput& in, const double* r, const double* xi,
                         double* Lambda) const {
  for (int i = 0; i < in.dim; ++i) Lambda[i] -= r[i] * xi[i];
  projectBall(radius(in), r, in.dim, Lambda);
}

bool GivenFriction::proxDerivative(const LawInput& in, double rho, const double* xi,
                                   const double* Lambda, double* A, double* B) const {
  const int n = in.dim;
  double z[kMostRows] = {}, P[kMostRows * kMostRows], e[kMostRows];
  for (int i = 0; i < n; ++i) z[i] = Lambda[i] - rho * xi[i];
  ballDerivative(radius(in), z, n, P, e);
  for (int i = 0; i < n * n; ++i) B[i] = rho * P[i], A[i] = -P[i];
  for (int i = 0; i < n; ++i) A[i * n + i] += 1.0;
  return true;
}

SimpleSet GivenFriction::simpleSet(const LawInput& in) const {
  return {SimpleSet::Shape::ball, 0.0, std::max(radius(in), 0.0)};
}

Status GivenFriction::status(const LawInput& in, const double* argument) const {
  double square = 0.0;
  for (int i = 0; i < in.dim; ++i) square += argument[i] * argument[i];
  const double a = radius(in);
  return square > a * a ? Status::slip : Status::stick;
}

}  // namespace dynamy
