#include <algorithm>
#include <cmath>
#include <dynamy/contact/drilling_friction.hpp>
#include <dynamy/core/parameters.hpp>
#include <numbers>

namespace dynamy {
namespace {

/// Complete elliptic integral K(k) and S₁ = Σ_{n≥1} 2^{n−1} c_n² of its arithmetic-geometric mean,
/// E = K (1 − k²/2 − S₁).
struct Elliptic {
  double K, S1 = 0.0;
  explicit Elliptic(double k) {
    // At k = 1 K is infinite like a logarithm: this close F and T are those of the limit.
    constexpr double kClosest = 1e-30;
    double a = 1.0, b = std::max(std::sqrt((1.0 - k) * (1.0 + k)), kClosest), c = 1.0;
    for (double weight = 1.0; std::abs(c) > 1e-17 * a && weight < 1e6; weight *= 2.0) {
      // c = (a − b)/2; of the first mean k²/(2(1 + b)), which keeps its digits at small k.
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

UnilateralDrilling::UnilateralDrilling(const Parameters& x)
    : NormalTimesReservoir(x),
      mu_(x["mu"]),
      radius_(x["radius"]),
      epsilonN_(x["epsilonN"]),
      set_(x["set"].text == "ellipsoid" ? Set::ellipsoid : Set::contensou) {}

void UnilateralDrilling::declare(Attributes& a) {
  a.about(
      "Contact with coupled sliding and drilling friction of a round patch under uniform pressure: "
      "−(ξ_T, ξ_τ) ∈ N_B(Λ_T, Λ_τ), B the exact Coulomb-Contensou body or an ellipsoid with the "
      "semi-axes μ Λ_N, μ Λ_N, 2/3 μ a Λ_N. Needs a contact with a spin row.");
  a.required("mu", Unit::none, "coefficient of friction μ").nonNegative();
  a.required("radius", Unit::length, "radius a of the patch").positive();
  a.choice("set", {"contensou", "ellipsoid"}, "contensou", "shape of the set");
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
    constexpr double kMoment = 2.0 / 3.0;
    const double m = kMoment * w, S = std::hypot(v, m);
    F = v / S, T = kMoment * m / S, across = 1.0 / S;
    ee = m * m / (S * S * S), ew = -kMoment * v * m / (S * S * S);
    ww = kMoment * kMoment * v * v / (S * S * S);
  } else {
    const ContensouCurve c = contensouCurve(v, w);
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
