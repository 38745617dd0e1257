#include <algorithm>
#include <cmath>
#include <dynamy/solver/local/local_friction.hpp>
#include <dynamy/solver/local/slip_equation.hpp>

namespace dynamy {
namespace {

/// Differences below this part of their terms are rounding.
constexpr double kSingular = 1e-13;

/// a − b, zero if that is rounding.
double difference(double a, double b) {
  const double c = a - b;
  return std::abs(c) <= kSingular * (std::abs(a) + std::abs(b)) ? 0.0 : c;
}

/// Λ_N and b̂ from b; Λ_N = pressed − toN·Λ_T.
template <int k>
struct Load {
  double pressed, b[k];
  Load(const FrictionBlock<k>& R, const double* full) : pressed(-R.inverseN * full[0]) {
    for (int i = 0; i < k; ++i) b[i] = full[1 + i] - R.toT[i] * full[0];
  }
};

template <int k>
double normalForce(const FrictionBlock<k>& R, const Load<k>& load, const double* T) {
  double N = load.pressed;
  for (int i = 0; i < k; ++i) N -= R.toN[i] * T[i];
  return N;
}

double square(const double* x, int n) {
  double s = 0.0;
  for (int i = 0; i < n; ++i) s += x[i] * x[i];
  return s;
}

/// Λ_T = −D̂⁻¹b̂; the shortest solution if D̂ is singular; false: there is none.
bool stickForce(const FrictionBlock<1>& R, const double* b, double* T) {
  T[0] = R.flat ? 0.0 : -b[0] / R.D[0];
  return !R.flat || b[0] == 0.0;
}
bool stickForce(const FrictionBlock<2>& R, const double* b, double* T) {
  if (!R.flat) {
    T[0] = (R.D[1] * b[1] - R.D[3] * b[0]) / R.d0, T[1] = (R.D[2] * b[0] - R.D[0] * b[1]) / R.d0;
    return true;
  }
  // D̂ = t v vᵀ with the trace t: T = −D̂ b̂/t².
  const double inverse = R.d1 > 0.0 ? 1.0 / R.d1 : 0.0;
  double rest[2];
  for (int i = 0; i < 2; ++i) {
    const double Db = (R.D[2 * i] * b[0] + R.D[2 * i + 1] * b[1]) * inverse;
    T[i] = -Db * inverse, rest[i] = b[i] - Db;
  }
  return std::sqrt(square(rest, 2)) <= kSingular * std::sqrt(square(b, 2));
}

SlipEquation slipEquation(const FrictionBlock<2>& R, const Load<2>& load, double mu) {
  SlipEquation e;
  e.p0[0] = R.D[1] * load.b[1] - R.D[3] * load.b[0];
  e.p0[1] = R.D[2] * load.b[0] - R.D[0] * load.b[1];
  e.p1[0] = -load.b[0], e.p1[1] = -load.b[1];
  e.d0 = R.d0, e.d1 = R.d1, e.s = mu;
  // q = d Λ_N.
  e.q0 = load.pressed * R.d0 - R.toN[0] * e.p0[0] - R.toN[1] * e.p0[1];
  e.q1 = load.pressed * R.d1 - R.toN[0] * e.p1[0] - R.toN[1] * e.p1[1];
  e.q2 = load.pressed;
  return e;
}

/// Λ of a root a, placed on the cone.
void slipForce(const SlipEquation& e, const FrictionBlock<2>& R, const Load<2>& load, double a,
               double* Lambda) {
  const double x = e.p0[0] + e.p1[0] * a, y = e.p0[1] + e.p1[1] * a;
  const double part = (e.d(a) < 0.0 ? -e.s : e.s) / std::sqrt(x * x + y * y);
  const double T[2] = {part * x, part * y};  // Λ_T/Λ_N
  // Λ_N (1 + toN·T) = pressed; in a jam the bracket vanishes.
  const double bracket = 1.0 + R.toN[0] * T[0] + R.toN[1] * T[1];
  double N = load.pressed / bracket;
  if (!(std::abs(bracket) > 1e-3)) N = (e.q0 + (e.q1 + e.q2 * a) * a) / e.d(a);
  Lambda[0] = N, Lambda[1] = N * T[0], Lambda[2] = N * T[1];
}

/// Slip along a tangent without inertia, D̂ = 0: the force only has the direction of b̂.
void slideFreely(const Load<2>& load, double mu, double* Lambda) {
  const double length = std::sqrt(square(load.b, 2)), N = std::max(load.pressed, 0.0);
  const double part = length > 0.0 ? -mu * N / length : 0.0;
  Lambda[0] = N, Lambda[1] = part * load.b[0], Lambda[2] = part * load.b[1];
}

/// Finds planar slip in both directions, smaller a first; returns the number of solutions.
int planarSlips(const FrictionBlock<1>& R, const Load<1>& load, double mu, LocalReport* reports,
                double* Lambda) {
  int found = 0;
  for (const double e : {1.0, -1.0}) {
    const double N = load.pressed / (1.0 + mu * e * R.toN[0]), T = mu * e * N;
    if (!(N > 0.0) || !std::isfinite(N)) continue;
    const double velocity = R.D[0] * T + load.b[0];
    if (!(velocity * e <= 0.0)) continue;
    const LocalReport report{LocalCase::slip, 1, mu > 0.0 ? -velocity / T : 0.0};
    const int at = found > 0 && report.a < reports[0].a ? 0 : found;
    if (at < found) reports[1] = reports[0], std::copy(Lambda, Lambda + 2, Lambda + 2);
    reports[at] = report, Lambda[2 * at] = N, Lambda[2 * at + 1] = T;
    ++found;
    if (mu == 0.0) break;
  }
  for (int r = 0; r < found; ++r) reports[r].roots = found;
  return found;
}

int slips(const FrictionBlock<1>& R, const Load<1>& load, LocalReport* reports, double* Lambda) {
  return planarSlips(R, load, R.mu, reports, Lambda);
}
int slips(const FrictionBlock<2>& R, const Load<2>& load, LocalReport* reports, double* Lambda) {
  if (R.mu == 0.0 || (R.flat && R.d1 == 0.0)) {
    slideFreely(load, R.mu, Lambda);
    reports[0] = {LocalCase::slip, 1, 0.0};
    return load.pressed > 0.0 ? 1 : 0;
  }
  const SlipEquation equation = slipEquation(R, load, R.mu);
  double a[SlipEquation::kMaxRoots];
  int n = 1;
  if (!R.unique)
    n = equation.roots(a);
  else if (load.pressed > 0.0)
    a[0] = equation.onlyRoot();
  else
    n = 0;
  for (int r = 0; r < n; ++r) {
    reports[r] = {LocalCase::slip, n, a[r]};
    slipForce(equation, R, load, a[r], Lambda + 3 * r);
  }
  return n;
}

/// Λ = −D⁻¹b if it lies in the cone.
template <int k>
bool stick(const FrictionBlock<k>& R, const Load<k>& load, double* Lambda) {
  double T[k];
  if (!stickForce(R, load.b, T)) return false;
  const double N = normalForce(R, load, T);
  if (!(N > 0.0 && square(T, k) <= R.mu * R.mu * N * N)) return false;
  Lambda[0] = N;
  std::copy(T, T + k, Lambda + 1);
  return true;
}

/// The slip of a contact with a unique solution that is pressed and does not stick.
LocalReport onlySlip(const FrictionBlock<1>& R, const Load<1>& load, double* Lambda) {
  const double e = load.b[0] > 0.0 ? -R.mu : R.mu;  // Λ_T/Λ_N
  Lambda[0] = load.pressed / (1.0 + e * R.toN[0]);
  Lambda[1] = e * Lambda[0];
  const double a = R.mu > 0.0 ? -load.b[0] / Lambda[1] - R.D[0] : 0.0;
  return {LocalCase::slip, 1, a};
}
LocalReport onlySlip(const FrictionBlock<2>& R, const Load<2>& load, double* Lambda) {
  if (R.mu == 0.0) {
    slideFreely(load, R.mu, Lambda);
    return {LocalCase::slip, 1, 0.0};
  }
  const SlipEquation equation = slipEquation(R, load, R.mu);
  const double a = equation.onlyRoot();
  slipForce(equation, R, load, a, Lambda);
  return {LocalCase::slip, 1, a};
}

/// True if μ|D_NT|/D_NN is below the least cos ∠(y, D̂y): there is then one solution at most.
bool uniqueSolution(const FrictionBlock<2>& R, double mu) {
  // D̂ = α + β J + γ (reflection): D̂y/y, as complex numbers, is a circle round α + iβ.
  const double alpha = 0.5 * R.d1, beta = 0.5 * std::abs(R.D[2] - R.D[1]);
  const double stretch = 0.5 * (R.D[0] - R.D[3]), shear = 0.5 * (R.D[1] + R.D[2]);
  const double gamma = std::sqrt(stretch * stretch + shear * shear);
  const double cosine = alpha * std::sqrt(std::max(R.d0, 0.0)) - beta * gamma,
               length = alpha * alpha + beta * beta;
  return alpha > 0.0 && R.d0 > 0.0 && mu * std::sqrt(square(R.toN, 2)) * length < cosine;
}
bool uniqueSolution(const FrictionBlock<1>& R, double mu) {
  return R.D[0] > 0.0 && mu * std::abs(R.toN[0]) < 1.0;
}

}  // namespace

template <int k>
bool FrictionBlock<k>::prepare(const double* full, double friction) {
  constexpr int n = k + 1;
  mu = friction, unique = flat = false;
  if (!(full[0] > 0.0)) return false;
  inverseN = 1.0 / full[0];
  for (int i = 0; i < k; ++i)
    toN[i] = full[1 + i] * inverseN, toT[i] = full[n * (1 + i)] * inverseN;
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j)
      D[k * i + j] = difference(full[n * (1 + i) + 1 + j], toT[i] * full[1 + j]);
  if constexpr (k == 1)
    d0 = d1 = D[0];
  else
    d0 = difference(D[0] * D[3], D[1] * D[2]), d1 = D[0] + D[3];
  flat = d0 == 0.0;
  unique = !flat && uniqueSolution(*this, mu);
  return true;
}

template <int k>
LocalReport FrictionBlock<k>::solve(const double* b, double* Lambda) const {
  if (b[0] >= 0.0) {
    std::fill(Lambda, Lambda + k + 1, 0.0);
    return {LocalCase::takeOff, 1, 0.0};
  }
  const Load<k> load(*this, b);
  if (stick(*this, load, Lambda)) return {LocalCase::stick, 1, 0.0};
  if (unique) return onlySlip(*this, load, Lambda);
  LocalReport reports[kMaxSolutions];
  double all[kMaxSolutions * (k + 1)];
  if (slips(*this, load, reports, all) == 0) return {LocalCase::noSolution, 0, 0.0};
  std::copy(all, all + k + 1, Lambda);
  return reports[0];
}

template <int k>
int FrictionBlock<k>::solutions(const double* b, LocalReport* reports, double* Lambda) const {
  int found = 0;
  if (b[0] >= 0.0) {
    std::fill(Lambda, Lambda + k + 1, 0.0);
    reports[found++] = {LocalCase::takeOff, 1, 0.0};
    if (unique) return found;
  }
  const Load<k> load(*this, b);
  if (stick(*this, load, Lambda + found * (k + 1))) {
    reports[found++] = {LocalCase::stick, 1, 0.0};
    if (unique) return found;
  }
  return found + slips(*this, load, reports + found, Lambda + found * (k + 1));
}

template struct FrictionBlock<1>;
template struct FrictionBlock<2>;

}  // namespace dynamy
