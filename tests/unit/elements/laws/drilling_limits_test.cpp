// Sliding with drilling: the curves of both pressures against quadrature over the patch, and the
// limits in which the law is a simpler one.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy_elements/laws/drilling_friction.hpp>
#include <numbers>
#include <random>

namespace dynamy {
namespace {

using Set = UnilateralDrilling::Set;
using Pressure = UnilateralDrilling::Pressure;
constexpr double kPi = std::numbers::pi;

/// Means over the unit patch, seen from a point c that lies d from its centre, of |x − c| and of
/// the part of (c − x)/|x − c| along the line of centres. Polar axes about c, ρ = ρmax − s², so
/// that Hertz pressure √((ρmax − ρ)(ρ − ρmin)) is smooth; trapezoids round, Simpson along s. d < 1.
struct PatchMeans {
  double distance = 0.0, force = 0.0;
  PatchMeans(double d, Pressure pressure) {
    constexpr int kRound = 256, kAlong = 1000;
    for (int i = 0; i < kRound; ++i) {
      const double phi = 2.0 * kPi * i / kRound, c = std::cos(phi);
      const double root = std::sqrt(1.0 - d * d * (1.0 - c * c));
      const double largest = root - d * c, least = -root - d * c, end = std::sqrt(largest);
      for (int j = 0; j <= kAlong; ++j) {
        const double s = end * j / kAlong, rho = largest - s * s;
        const double weight = (j == 0 || j == kAlong ? 1.0
                               : j % 2               ? 4.0
                                                     : 2.0) *
                              end / kAlong / 3.0;
        const double p =
            pressure == Pressure::hertz ? 1.5 / kPi * s * std::sqrt(rho - least) : 1.0 / kPi;
        const double part = weight * p * rho * 2.0 * s * 2.0 * kPi / kRound;
        distance += part * rho;
        force -= part * c;
      }
    }
  }
};

ContensouCurve curve(Pressure pressure, double v, double w) {
  return pressure == Pressure::hertz ? hertzCurve(v, w) : contensouCurve(v, w);
}

TEST(DrillingFriction, HasTheCurveOfItsPressure) {
  for (const Pressure pressure : {Pressure::uniform, Pressure::hertz})
    for (const double d : {0.0, 0.1, 0.5, 0.8}) {
      const PatchMeans means(d, pressure);
      const ContensouCurve at = curve(pressure, d, 1.0);
      // Simpson's rule with intervals of 1/1000: 1e-12 times a fourth derivative of up to 100.
      EXPECT_NEAR(at.F, means.force, 1e-10) << "d = " << d;
      EXPECT_NEAR(at.T + d * at.F, means.distance, 1e-10) << "d = " << d;
    }
}

TEST(DrillingFriction, HasASmoothCurveUnderHertzPressure) {
  // Outside of the patch F and T follow from Laplace's equation: (dF)' = d V, T' = −d F', with the
  // potential V of Hertz [johnson1985, 3.42]; central differences of 1e-4 err by 1e-8.
  for (const double d : {1.2, 1.9, 1.999, 2.001, 5.0, 40.0}) {
    const double h = 1e-4;
    const auto at = [](double x) { return hertzCurve(x, 1.0); };
    const double V = 0.75 * ((2.0 - d * d) * std::asin(1.0 / d) + std::sqrt(d * d - 1.0));
    const double slope = (at(d + h).F - at(d - h).F) / (2.0 * h);
    EXPECT_NEAR(at(d).F + d * slope, d * V, 1e-7) << "d = " << d;
    EXPECT_NEAR((at(d + h).T - at(d - h).T) / (2.0 * h), -d * slope, 1e-7) << "d = " << d;
    EXPECT_NEAR(at(d).slopeCubed, d * d * d * slope, 1e-7 * d * d * d) << "d = " << d;
  }
  // Both sides of the rim, d = 1: F = 9π/32, T = 3π/16 · 3/8, and of d = 2, where a series begins;
  // the next numbers change them by rounding.
  for (const double w : {1.0, 1.0 - 1e-15}) {
    EXPECT_NEAR(hertzCurve(1.0, w).F, 9.0 * kPi / 32.0, 1e-14);
    EXPECT_NEAR(hertzCurve(1.0, w).T, 9.0 * kPi / 128.0, 1e-14);
  }
  EXPECT_NEAR(hertzCurve(2.0, 1.0).T, hertzCurve(2.0 - 1e-15, 1.0).T, 1e-14);
  EXPECT_NEAR(hertzCurve(2.0, 1.0).slopeCubed, hertzCurve(2.0 - 1e-15, 1.0).slopeCubed, 1e-13);
}

TEST(DrillingFriction, FulfilsTheDefinitionsOfALawUnderHertzPressure) {
  for (const Set set : {Set::contensou, Set::ellipsoid}) {
    const Verdict result = checkLaw(UnilateralDrilling(0.3, 0.4, set, 0.0, Pressure::hertz), 4);
    EXPECT_TRUE(result) << result.message();
  }
}

/// A law, its R and the means over its patch, all per radius: ⟨r²⟩, ⟨1/r⟩.
struct Case {
  Set set;
  Pressure pressure;
  double R, square, inverse;
};
constexpr double kMu = 0.3, kRadius = 0.4;
const Case kCases[] = {
    {Set::contensou, Pressure::uniform, 2.0 / 3.0, 0.5, 2.0},
    {Set::contensou, Pressure::hertz, 3.0 * kPi / 16.0, 0.4, 0.75 * kPi},
    // The ellipsoid has the slopes of its own axes.
    {Set::ellipsoid, Pressure::uniform, 2.0 / 3.0, 8.0 / 9.0, 3.0},
    {Set::ellipsoid, Pressure::hertz, 3.0 * kPi / 16.0, 9.0 * kPi* kPi / 128.0, 32.0 / 3.0 / kPi},
};

/// Force and moment per normal force while it slides with v and spins with omega.
Eigen::Vector2d forces(const Case& c, double v, double omega) {
  const UnilateralDrilling law(kMu, kRadius, c.set, 0.0, c.pressure);
  const double y[3] = {v, 0.0, omega};
  double g[3];
  law.support({.dim = 4}, 3, y, g);
  return {g[0], g[2]};
}

TEST(DrillingFriction, IsCoulombFrictionWithoutSpin) {
  const UnilateralCoulomb coulomb(0.0, 0.0, kMu);
  for (const Case& c : kCases) {
    const UnilateralDrilling law(kMu, kRadius, c.set, 0.0, c.pressure);
    for (const double size : {0.1, 1.0, 10.0}) {
      const double r[4] = {1.0, 1.0, 1.0, 0.1}, xi[4] = {-1.0, 0.6 * size, -0.8 * size, 0.0};
      double drilling[4] = {}, disc[3] = {};
      law.prox({.dim = 4}, r, xi, drilling);
      coulomb.prox({.dim = 3}, r, xi, disc);
      // Newton's iteration on the support function ends at 1e-13 of the argument.
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(drilling[i], disc[i], 1e-12 * size);
      EXPECT_NEAR(drilling[3], 0.0, 1e-12 * size);
    }
    // Little spin: |λ_T| = μ N (1 − ω²⟨r²⟩/(4 v²)), τ = μ N ω⟨r²⟩/(2 v), next terms of fourth and
    // third order in ω a/v = 4e-4.
    const Eigen::Vector2d f = forces(c, 1.0, 1e-3);
    const double square = c.square * kRadius * kRadius;
    EXPECT_NEAR(f[0], kMu * (1.0 - 0.25e-6 * square), 1e-13);
    EXPECT_NEAR(f[1], kMu * 0.5e-3 * square, 1e-10);
  }
}

TEST(DrillingFriction, IsPureDrillingFrictionWithoutSliding) {
  for (const Case& c : kCases) {
    const UnilateralDrilling law(kMu, kRadius, c.set, 0.0, c.pressure);
    const double most = kMu * c.R * kRadius;
    for (const double tau : {-5.0, -0.5 * most, 0.5 * most, 0.99 * most, 1.01 * most, 2.0}) {
      const double r[4] = {1.0, 1.0, 1.0, 1.0}, xi[4] = {-1.0, 0.0, 0.0, -tau};
      double Lambda[4] = {};
      law.prox({.dim = 4}, r, xi, Lambda);
      EXPECT_NEAR(Lambda[3], convex::prox(convex::symmetricInterval(most), tau), 1e-12) << tau;
      EXPECT_NEAR(std::hypot(Lambda[1], Lambda[2]), 0.0, 1e-12);
    }
    // Little sliding is resisted as by a damper, λ_T = μ N v⟨1/r⟩/(2 ω) (ellipsoid: μ N v/(R ω));
    // the next term is ½ (v/(R ω))² = 1e-7 of 1.3e-4.
    EXPECT_NEAR(forces(c, 1e-4, 1.0)[0], kMu * 0.5e-4 * c.inverse / kRadius, 2e-11);
  }
}

TEST(DrillingFriction, IsABallAsAnEllipsoidOfEqualAxes) {
  // R a = 1 m: rows of equal units, the unit ball times μ Λ_N.
  const UnilateralDrilling law(kMu, 1.5, Set::ellipsoid);
  for (int i = 0; i < 8; ++i) {
    const convex::Point<3> z(i & 1 ? 0.9 : -0.2, i & 2 ? 0.5 : 0.05, i & 4 ? -1.3 : 0.1);
    double x[3] = {z[0], z[1], z[2]};
    const double r[3] = {1.0, 1.0, 1.0};
    law.project({.dim = 4}, 2.0, r, 3, x);
    const convex::Point<3> ball = convex::prox(convex::Ball<3>{2.0 * kMu}, z);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(x[k], ball[k], 1e-12);
  }
}

TEST(DrillingFriction, DoesNotKnowDirections) {
  for (const Case& c : kCases) {
    const UnilateralDrilling law(kMu, kRadius, c.set, 0.0, c.pressure);
    const double r[4] = {1.0, 1.0, 1.0, 0.2};
    const auto prox = [&](double angle, double spin) {
      const double xi[4] = {-1.0, std::cos(angle), std::sin(angle), spin};
      Eigen::Vector4d out = Eigen::Vector4d::Zero();
      law.prox({.dim = 4}, r, xi, out.data());
      return out;
    };
    const Eigen::Vector4d first = prox(0.0, 3.0);
    for (const double angle : {0.4, 2.0, -1.1}) {
      const Eigen::Vector4d turned = prox(angle, 3.0), mirrored = prox(angle, -3.0);
      EXPECT_NEAR(turned[1], std::cos(angle) * first[1], 1e-12);
      EXPECT_NEAR(turned[2], std::sin(angle) * first[1], 1e-12);
      EXPECT_NEAR(turned[3], first[3], 1e-12);
      EXPECT_NEAR(mirrored[3], -turned[3], 1e-12);
    }
  }
}

/// Projection of z onto the ellipsoid of semi-axes w in the metric 1/r: xᵢ = zᵢ/(1 + τ rᵢ/wᵢ²) with the
/// root τ of Σ (xᵢ/wᵢ)² = 1, by bisection.
Vec3 onEllipsoid(const Vec3& w, const Vec3& r, const Vec3& z) {
  const auto at = [&](double tau) {
    return Vec3(z.array() / (1.0 + tau * r.array() / w.array().square()));
  };
  const auto outside = [&](double tau) { return at(tau).cwiseQuotient(w).squaredNorm() > 1.0; };
  if (!outside(0.0)) return z;
  double low = 0.0, high = 1e-12;
  while (outside(high)) low = high, high *= 4.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (outside(middle) ? low : high) = middle;
  }
  return at(low);
}

TEST(DrillingFriction, ProjectsOntoEllipsoidsOfAnyAxes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto power = [&](double most) { return std::pow(10.0, most * unit(random)); };
  for (const double radius : {1e-6, 1e-4, 1e-2, 1.0, 1e3}) {
    const UnilateralDrilling law(0.3, radius, Set::ellipsoid);
    for (int k = 0; k < 2000; ++k) {
      const double N = power(2.0);
      const Vec3 w = 0.3 * N * Vec3(1.0, 1.0, 2.0 / 3.0 * radius);
      const double r[4] = {1.0, power(1.5), power(1.5), power(1.5)}, xi[4] = {};
      double Lambda[4] = {N, 0.0, 0.0, 0.0};
      Vec3 z;
      for (int i = 0; i < 3; ++i) z[i] = unit(random) * power(2.0) * (k % 3 != 0 ? w[i] : w[0]);
      std::copy(z.data(), z.data() + 3, Lambda + 1);
      law.prox({.dim = 4, .dt = 1.0}, r, xi, Lambda);
      const Vec3 x = onEllipsoid(w, Vec3(r[1], r[2], r[3]), z),
                 off = (Vec3(Lambda[1], Lambda[2], Lambda[3]) - x).cwiseQuotient(w);
      // x = z − R ν has the rounding of z; the bisection that of its 200 steps.
      const double rounding = 32.0 * 2.3e-16 * (1.0 + z.cwiseAbs().maxCoeff() / w.minCoeff());
      ASSERT_LE(off.cwiseAbs().maxCoeff(), rounding)
          << "radius " << radius << ", N " << N << ", z/w " << z.cwiseQuotient(w).transpose();
    }
  }
}

}  // namespace
}  // namespace dynamy
