// Several discs that share one normal force. Projection x of z onto K: with n = x_N,
//   min ½ (n − z_N)² + ½ Σ_b max(0, |z_b| − μ_b n)²,   n ≥ 0
// whose derivative n − z_N − Σ_{b outside} μ_b (|z_b| − μ_b n) is monotone and piecewise linear.
#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/law/rolling_friction.hpp>

namespace dynamy {
namespace {

/// Coefficients are limited to this value: friction then holds any load, and squares of
/// coefficients do not overflow.
constexpr double kMostRolling = 1e100;

/// Length of the n ≤ 2 numbers at x.
double length(const double* x, int n) { return n == 1 ? std::abs(x[0]) : std::hypot(x[0], x[1]); }

}  // namespace

/// The discs of a contact with `dim` rows: first row, number of rows and coefficient of each.
struct UnilateralRolling::Parts {
  struct Part {
    int first, rows;
    double mu;
  };
  std::array<Part, 4> all{};
  int count = 0;
  Parts(const RollingCoefficients& mu, int dim) {
    add(1, 2, mu.mu);
    if (dim == 5) add(3, 2, mu.rolling);
    if (dim > 5) add(3, 1, mu.drilling), add(4, 2, mu.rolling);
    if (dim == 8) add(6, 2, mu.contour);
  }
  const Part* begin() const { return all.data(); }
  const Part* end() const { return all.data() + count; }

  /// z ← nearest point of K.
  void projectCone(double* z) const {
    double size[4] = {};
    for (int b = 0; b < count; ++b) size[b] = length(z + at(b).first, at(b).rows);
    // Compute n for every choice of discs that z lies outside of. The right n confirms its choice.
    double n = z[0];
    for (int choice = 0; choice < 1 << count; ++choice) {
      double weight = 1.0, sum = z[0];
      for (int b = 0; b < count; ++b)
        if (choice & (1 << b)) weight += at(b).mu * at(b).mu, sum += at(b).mu * size[b];
      const double trial = sum / weight;
      bool right = true;
      for (int b = 0; b < count; ++b)
        right = right && ((choice & (1 << b)) != 0) == (size[b] > at(b).mu * trial);
      if (right) n = trial;
    }
    z[0] = std::max(0.0, n);
    for (const Part& p : *this) projectDisc(p, z[0], z + p.first);
  }
  static void projectDisc(const Part& p, double N, double* x) {
    const double size = length(x, p.rows), radius = p.mu * std::max(N, 0.0);
    for (int i = 0; size > radius && i < p.rows; ++i) x[i] *= radius / size;
  }

 private:
  const Part& at(int b) const { return all[static_cast<std::size_t>(b)]; }
  void add(int first, int rows, double mu) {
    all[static_cast<std::size_t>(count++)] = {first, rows, std::min(mu, kMostRolling)};
  }
};

UnilateralRolling::UnilateralRolling(const Parameters& x)
    : NormalTimesReservoir(x),
      mu_{x["mu"], x["rolling"], x["drilling"], x["contour"]},
      epsilonN_(x["epsilonN"]) {}

void UnilateralRolling::declare(Attributes& a) {
  a.about(
      "Contact with dry friction and resistance to rolling: beside |Λ_T| ≤ μ Λ_N a moment about "
      "the "
      "tangents of at most `rolling` Λ_N, one about the normal of at most `drilling` Λ_N, and a "
      "force of at most `contour` Λ_N against the velocity of the point of contact over the body "
      "(half spaces only). Wheels, balls on felt, coins. Needs bodies in space.");
  a.required("mu", Unit::none, "coefficient of friction μ").nonNegative();
  a.optional("rolling", Unit::length, 0.0, "arm of the moment against rolling").nonNegative();
  a.optional("drilling", Unit::length, 0.0, "arm of the moment against spin").nonNegative();
  a.optional("contour", Unit::none, 0.0, "coefficient of the way along the body's contour")
      .nonNegative();
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of the normal direction")
      .between(0.0, 1.0);
  a.example("<UnilateralRolling mu=\"0.3\" rolling=\"0.1mm\"/>");
}

int UnilateralRolling::groupEnd(int row, int dim) const {
  if (row == 0) return 1;
  for (const Parts::Part& p : Parts(mu_, dim))
    if (row < p.first + p.rows) return p.first + p.rows;
  return dim;
}

void UnilateralRolling::epsilon(int dim, double* epsilon) const {
  std::fill(epsilon, epsilon + dim, 0.0);
  epsilon[0] = epsilonN_;
}

void UnilateralRolling::project(const LawInput&, double N, const double*, int k, double* x) const {
  for (const Parts::Part& p : Parts(mu_, k + 1)) Parts::projectDisc(p, N, x + p.first - 1);
}

double UnilateralRolling::support(const LawInput&, int k, const double* y, double* gradient,
                                  double* hessian) const {
  if (hessian) std::fill(hessian, hessian + k * k, 0.0);
  double S = 0.0;
  for (const Parts::Part& p : Parts(mu_, k + 1)) {
    const int first = p.first - 1;
    const double size = length(y + first, p.rows);
    S += p.mu * size;
    double e[2] = {};
    for (int i = 0; size > 0.0 && i < p.rows; ++i) e[i] = y[first + i] / size;
    for (int i = 0; i < p.rows; ++i) {
      if (gradient) gradient[first + i] = p.mu * e[i];
      for (int j = 0; hessian && size > 0.0 && j < p.rows; ++j)
        hessian[(first + i) * k + first + j] = p.mu / size * ((i == j ? 1.0 : 0.0) - e[i] * e[j]);
    }
  }
  return S;
}

void UnilateralRolling::naturalMap(const LawInput& in, double rho, const double* xi,
                                   const double* Lambda, double* e) const {
  const Parts parts(mu_, in.dim);
  double z[kMostRows], shift = 0.0;
  for (const Parts::Part& p : parts) shift += p.mu * length(xi + p.first, p.rows);
  for (int i = 0; i < in.dim; ++i) z[i] = Lambda[i] - rho * (xi[i] + (i == 0 ? shift : 0.0));
  parts.projectCone(z);
  for (int i = 0; i < in.dim; ++i) e[i] = Lambda[i] - z[i];
}

bool UnilateralRolling::proxDerivative(const LawInput& in, double rho, const double* xi,
                                       const double* Lambda, double* A, double* B) const {
  const int n = in.dim;
  Eigen::Map<RowMatrix> a(A, n, n), b(B, n, n);
  double z[kMostRows];
  for (int i = 0; i < n; ++i) z[i] = Lambda[i] - rho * xi[i];
  a.setIdentity(), b.setZero();
  if (!(z[0] > 0.0)) return true;
  // P = ∂p/∂z into b, then A = I − P and B = ρ P.
  b(0, 0) = 1.0;
  for (const Parts::Part& p : Parts(mu_, n)) {
    const double radius = p.mu * z[0], size = length(z + p.first, p.rows);
    for (int i = 0; i < p.rows; ++i) {
      const int row = p.first + i;
      if (size <= radius) {
        b(row, row) = 1.0;
        continue;
      }
      const double e = z[row] / size;
      b(row, 0) = p.mu * e;
      for (int j = 0; j < p.rows; ++j)
        b(row, p.first + j) = radius / size * ((i == j ? 1.0 : 0.0) - e * z[p.first + j] / size);
    }
  }
  a -= b;
  b *= rho;
  return true;
}

}  // namespace dynamy
