#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/laws/drilling_friction.hpp>
#include <numbers>

namespace dynamy {
namespace {

/// Complete elliptic integral K(k) and S₁ = Σ_{n≥1} 2^{n−1} c_n² of its arithmetic-geometric mean,
/// E = K (1 − k²/2 − S₁).
struct Elliptic {
  double K, S1 = 0.0;
  explicit Elliptic(double k) {
    // K has a logarithmic singularity at k = 1; this close to it F and T are those of the limit.
    constexpr double kClosest = 1e-30;
    double a = 1.0, b = std::max(std::sqrt((1.0 - k) * (1.0 + k)), kClosest), c = 1.0;
    for (double weight = 1.0; std::abs(c) > 1e-17 * a && weight < 1e6; weight *= 2.0) {
      // c = (a − b)/2; for the first mean k²/(2(1 + b)), which keeps its digits at small k.
      c = weight == 1.0 ? 0.5 * k * k / (1.0 + b) : 0.5 * (a - b);
      const double mean = 0.5 * (a + b);
      b = std::sqrt(a * b), a = mean;
      S1 += weight * c * c;
    }
    K = 0.5 * std::numbers::pi / a;
  }
};

}  // namespace

ContensouCurve contensouCurve(double v, double w) {
  ContensouCurve out;
  constexpr double kF = 4.0 / (3.0 * std::numbers::pi);
  if (v <= w) {
    const double d = v / w, d2 = d * d;
    const Elliptic e(d);
    const double E = e.K * (1.0 - 0.5 * d2 - e.S1);
    const double S1OverD2 = d2 > 0.0 ? e.S1 / d2 : 0.0;
    out.FOverD = kF * e.K * (1.5 - 0.5 * d2 - (1.0 + d2) * S1OverD2);
    out.F = d * out.FOverD;
    out.T = kF / 3.0 * ((4.0 - 2.0 * d2) * E - (1.0 - d2) * e.K);
    out.slope = 4.0 / std::numbers::pi * E - out.FOverD;
    return out;
  }
  const double k = w / v, k2 = k * k;
  const Elliptic e(k);
  const double S1d2 = k2 > 1e-60 ? e.S1 / k2 : 0.0, S1d4 = k2 > 1e-60 ? S1d2 / k2 : 1.0 / 16.0;
  out.F = kF * e.K * (1.5 - 0.5 * k2 - e.S1 - S1d2);
  out.T = kF / 3.0 * e.K * k * (1.0 - 4.0 * S1d2 + 2.0 * S1d4);
  out.slopeCubed = kF * e.K * (0.5 + S1d2 - 2.0 * S1d4);
  return out;
}

namespace {

/// F, T and d³F′ for Hertz pressure as series in k = 1/d ≤ ½, where the closed form loses digits by
/// a factor d⁴. (22.10)
void hertzFar(double k, ContensouCurve& out) {
  out.F = 1.0, out.T = 0.0, out.slopeCubed = 0.0;
  double c = 1.0, power = 1.0;  // c_n m_n, k^(2n−2)
  for (int n = 1; n <= 40; ++n) {
    const double b = (1.5 - n) / n;          // b_n/b_(n−1)
    c *= b * b * 2.0 * n / (2.0 * n + 3.0);  // m_n/m_(n−1) = 2n/(2n + 3)
    const double term = c * power, two = 2.0 * n;
    out.F -= (two - 1.0) * term * k * k;
    out.T += two * term * k;
    out.slopeCubed += two * (two - 1.0) * term;
    power *= k * k;
    if (term * n * n < 1e-18) break;
  }
}

}  // namespace

ContensouCurve hertzCurve(double v, double w) {
  ContensouCurve out;
  if (v <= w) {
    constexpr double kHalf = 3.0 * std::numbers::pi / 32.0;
    const double d = v / w, d2 = d * d;
    out.FOverD = kHalf * (4.0 - d2);
    out.F = d * out.FOverD;
    out.T = kHalf * (2.0 - 2.0 * d2 + 0.75 * d2 * d2);
    out.slope = kHalf * (4.0 - 3.0 * d2);
    return out;
  }
  const double k = w / v;
  if (k <= 0.5) {
    hertzFar(k, out);
    return out;
  }
  // The angle is computed from y and not from k: both then belong to the
  // same d, also next to the rim.
  const double d = v / w, d2 = d * d, y = std::sqrt((d - 1.0) * (d + 1.0));
  const double theta = std::atan2(1.0, y);
  const double dF = 0.75 * ((d2 - 0.25 * d2 * d2) * theta + 0.75 * y + 0.25 * y * y * y);
  out.F = dF / d;
  out.T = 0.75 * ((0.5 - 0.5 * d2 + 0.1875 * d2 * d2) * theta + 0.1875 * (y - y * y * y));
  // d F′ = d V − F with the potential V of the pressure.
  const double V = 0.75 * ((2.0 - d2) * theta + y);
  out.slopeCubed = d2 * (d * V - out.F);
  return out;
}

UnilateralDrilling::UnilateralDrilling(const Parameters& x)
    : NormalTimesReservoir(x),
      mu_(x["mu"]),
      radius_(x["radius"]),
      epsilonN_(x["epsilonN"]),
      set_(x["set"].text == "ellipsoid" ? Set::ellipsoid : Set::contensou),
      pressure_(x["pressure"].text == "hertz" ? Pressure::hertz : Pressure::uniform) {}

void UnilateralDrilling::declare(Attributes& a) {
  a.about(
      "Contact with coupled sliding and drilling friction of a round patch: −(ξ_T, ξ_τ) ∈ "
      "N_B(Λ_T, Λ_τ), B the exact Coulomb-Contensou body of the pressure or an ellipsoid with the "
      "semi-axes μ Λ_N, μ Λ_N, R μ Λ_N; R = 2/3 a under uniform, 3π/16 a under Hertz pressure. "
      "Needs a contact with a spin row.");
  a.required("mu", Unit::none, "coefficient of friction μ").nonNegative();
  a.required("radius", Unit::length, "radius a of the patch").positive();
  a.choice("set", {"contensou", "ellipsoid"}, "contensou", "shape of the set");
  a.choice("pressure", {"uniform", "hertz"}, "uniform",
           "in the patch: that of a flat foot, or of balls, p ~ sqrt(1 - (r/a)^2)");
  a.optional("epsilonN", Unit::none, 0.0, "coefficient of restitution of the normal direction")
      .between(0.0, 1.0);
  a.example("<UnilateralDrilling mu=\"0.3\" radius=\"5mm\"/>");
}

void UnilateralDrilling::epsilon(int dim, double* epsilon) const {
  std::fill(epsilon, epsilon + dim, 0.0);
  epsilon[0] = epsilonN_;
}

double UnilateralDrilling::support(const LawInput&, int k, const double* y, double* gradient,
                                   double* hessian) const {
  const double v = std::hypot(y[0], y[1]), w = radius_ * std::abs(y[2]);
  const double e[2] = {v > 0.0 ? y[0] / v : 1.0, v > 0.0 ? y[1] / v : 0.0};
  const double a = std::copysign(radius_, y[2]);
  if (gradient) std::fill(gradient, gradient + k, 0.0);
  if (hessian) std::fill(hessian, hessian + k * k, 0.0);
  if (!(v > 0.0 || w > 0.0)) return 0.0;
  // S, ∂S/∂v, ∂S/∂w; second derivatives along e, e and w, w, and F/v across.
  double F, T, ee, ew, ww, across;
  if (set_ == Set::ellipsoid) {
    const double R = pressure_ == Pressure::hertz ? 3.0 * std::numbers::pi / 16.0 : 2.0 / 3.0;
    const double m = R * w, S = std::hypot(v, m);
    F = v / S, T = R * m / S, across = 1.0 / S;
    ee = m * m / (S * S * S), ew = -R * v * m / (S * S * S);
    ww = R * R * v * v / (S * S * S);
  } else {
    const ContensouCurve c = pressure_ == Pressure::hertz ? hertzCurve(v, w) : contensouCurve(v, w);
    F = c.F, T = c.T;
    if (v <= w) {
      const double d = v / w;
      across = c.FOverD / w, ee = c.slope / w, ew = -d * ee, ww = d * d * ee;
    } else {
      const double q = w / v;
      across = F / v, ww = c.slopeCubed / v, ew = -q * ww, ee = q * q * ww;
    }
  }
  if (gradient) {
    for (int i = 0; i < 2; ++i) gradient[i] = v > 0.0 ? mu_ * F * e[i] : 0.0;
    gradient[2] = mu_ * T * (y[2] != 0.0 ? a : 0.0);
  }
  if (hessian) {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j)
        hessian[i * k + j] =
            mu_ * (ee * e[i] * e[j] + across * ((i == j ? 1.0 : 0.0) - e[i] * e[j]));
      hessian[i * k + 2] = hessian[2 * k + i] = mu_ * ew * e[i] * a;
    }
    hessian[2 * k + 2] = mu_ * ww * a * a;
  }
  return mu_ * (v * F + w * T);
}

}  // namespace dynamy
