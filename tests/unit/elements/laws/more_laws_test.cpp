// Orthotropic and drilling friction, force limits: the definitions of a law by checkLaw, numbers
// from closed forms and tables, and motions whose end is known.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy_elements/laws/drilling_friction.hpp>
#include <dynamy_elements/laws/force_limit.hpp>
#include <dynamy_elements/laws/orthotropic_friction.hpp>

namespace dynamy {
namespace {

TEST(ForceLimit, FulfilsTheDefinitionsOfALaw) {
  for (const int dim : {1, 3}) {
    const Verdict two = checkLaw(ForceLimit(-0.5, 2.0), dim);
    EXPECT_TRUE(two) << two.message();
    const Verdict one = checkLaw(ForceLimit(-kInfinity, 0.3), dim);
    EXPECT_TRUE(one) << one.message();
  }
}

TEST(ForceLimit, CutsAtItsLimitsTimesTheStep) {
  const ForceLimit law(-2.0, 5.0);
  const double r = 1.0, zero = 0.0;
  const LawInput in{.dim = 1, .dt = 0.1};
  for (const auto& [z, Lambda, status] :
       {std::tuple{0.3, 0.3, Status::locked}, std::tuple{0.6, 0.5, Status::upper},
        std::tuple{-1.0, -0.2, Status::lower}}) {
    double x = z;
    law.prox(in, &r, &zero, &x);
    EXPECT_DOUBLE_EQ(x, Lambda);
    EXPECT_EQ(law.status(in, &z), status);
  }
}

TEST(ForceLimit, TransmitsNothingFiniteInAnImpact) {
  const double r = 1.0, zero = 0.0;
  const LawInput impact{.dim = 1, .dt = 0.0};
  double x = 3.0, y = -3.0;
  const ForceLimit law(-kInfinity, 5.0);
  law.prox(impact, &r, &zero, &x);
  law.prox(impact, &r, &zero, &y);
  EXPECT_EQ(x, 0.0);
  EXPECT_EQ(y, -3.0);
}

TEST(ForceLimit, RefusesLimitsInTheWrongOrder) {
  EXPECT_THROW(
      ForceLimit(Parameters::of<ForceLimit>("ForceLimit", "", {{"lower", "2"}, {"upper", "1"}})),
      ModelError);
}

TEST(UnilateralOrthotropic, FulfilsTheDefinitionsOfALaw) {
  for (const int dim : {1, 2, 3})
    for (const double angle : {0.0, 0.7}) {
      const Verdict result = checkLaw(UnilateralOrthotropic(0.0, 0.0, 0.1, 0.5, angle), dim);
      EXPECT_TRUE(result) << "dim " << dim << ", angle " << angle << ": " << result.message();
    }
}

TEST(UnilateralOrthotropic, ProjectsInAMetricOfItsOwn) {
  // r₁ ≠ r₂: the result must be nearest in the metric diag(r)⁻¹, not in the Euclidean one.
  const UnilateralOrthotropic law(0.0, 0.0, 0.2, 0.6, 0.4);
  const LawInput in{.dim = 3};
  const double r[2] = {0.5, 3.0}, z[2] = {1.3, -0.9};
  double x[2] = {z[0], z[1]};
  law.project(in, 1.0, r, 2, x);
  const auto distance = [&](double a, double b) {
    return (z[0] - a) * (z[0] - a) / r[0] + (z[1] - b) * (z[1] - b) / r[1];
  };
  const double least = distance(x[0], x[1]);
  for (int k = 0; k < 360; ++k) {
    const double s = k * 0.0174532925199433, c = std::cos(0.4), d = std::sin(0.4);
    const double a = 0.2 * std::cos(s), b = 0.6 * std::sin(s);
    // No point of the ellipse is nearer; rounding of numbers of order one.
    EXPECT_GE(distance(c * a - d * b, d * a + c * b), least - 1e-14);
  }
}

/// Moreau steps of a point of mass 1 under gravity 9.81 on a plane, from u0; time and place of the
/// stop. One contact with G = I, solved by fixed point to rounding.
struct Stop {
  double t = 0.0, x = 0.0, y = 0.0;
};
Stop slide(const SetValuedForceLaw& law, double ux, double uy, double dt) {
  Stop out;
  double u[3] = {0.0, ux, uy}, Lambda[3] = {};
  const LawInput in{.dim = 3, .dt = dt};
  for (int k = 0; k < 1000000 && std::hypot(u[1], u[2]) > 1e-12; ++k) {
    const double free[3] = {u[0] - 9.81 * dt, u[1], u[2]}, r[3] = {1.0, 1.0, 1.0};
    out.x += 0.5 * dt * u[1], out.y += 0.5 * dt * u[2];
    for (int it = 0; it < 100; ++it) {
      double xi[3];
      for (int i = 0; i < 3; ++i) xi[i] = free[i] + Lambda[i];
      law.prox(in, r, xi, Lambda);
    }
    // The step in which it stops ends where the remaining speed is used up.
    const double before = std::hypot(u[1], u[2]);
    for (int i = 0; i < 3; ++i) u[i] = free[i] + Lambda[i];
    const double after = std::hypot(u[1], u[2]);
    const double force = std::hypot(9.81 * 0.3, 0.0);
    out.t += after > 1e-12 ? dt : std::min(dt, before / force);
    out.x += 0.5 * dt * u[1], out.y += 0.5 * dt * u[2];
  }
  return out;
}

TEST(UnilateralOrthotropic, StopsWhereTheExactMotionStops) {
  // μ = (0.1, 0.3), u₀ = (1, 1): u₁^(1/μ₁²)/u₂^(1/μ₂²) is constant; quadrature of the motion gives
  // the stop at t = 1.1887585369 s.
  const double truth = 1.1887585369;
  const UnilateralOrthotropic law(0.0, 0.0, 0.1, 0.3);
  const double coarse = std::abs(slide(law, 1.0, 1.0, 1e-2).t - truth),
               fine = std::abs(slide(law, 1.0, 1.0, 1e-4).t - truth);
  // The scheme has order 1 and the time of the stop a resolution of Δt: 2 Δt.
  EXPECT_LT(coarse, 2e-2);
  EXPECT_LT(fine, 2e-4);
}

TEST(UnilateralDrilling, FulfilsTheDefinitionsOfALaw) {
  // A point outside a set of very different axes counted as inside: the patch of a tippe top is 0.1 mm.
  using Set = UnilateralDrilling::Set;
  for (const auto& [set, radius] : {std::pair{Set::contensou, 0.05}, std::pair{Set::contensou, 0.4},
                                    std::pair{Set::contensou, 3.0}, std::pair{Set::ellipsoid, 1e-4},
                                    std::pair{Set::ellipsoid, 1e-3}, std::pair{Set::ellipsoid, 0.4},
                                    std::pair{Set::ellipsoid, 100.0}})
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
      CheckOptions options;
      options.seed = seed;
      const Verdict result = checkLaw(UnilateralDrilling(0.3, radius, set), 4, options);
      EXPECT_TRUE(result) << radius << ": " << result.message();
    }
}

TEST(UnilateralDrilling, HasTheCurveOfEllipticIntegrals) {
  // Quadrature of the disc under uniform pressure to 1e-12.
  const ContensouCurve half = contensouCurve(0.5, 1.0);
  EXPECT_NEAR(half.F, 0.483843755630, 1e-12);
  EXPECT_NEAR(half.T, 0.547748354772, 1e-12);
  // Limits: pure spin T = 2/3, pure sliding F = 1; slopes F′(0) = 1, d³F′(∞) = 1/4; tolerance:
  // rounding.
  EXPECT_NEAR(contensouCurve(0.0, 2.0).T, 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(contensouCurve(0.0, 2.0).slope, 1.0, 1e-15);
  EXPECT_NEAR(contensouCurve(2.0, 0.0).F, 1.0, 1e-15);
  EXPECT_NEAR(contensouCurve(2.0, 0.0).slopeCubed, 0.25, 1e-15);
  // d = 1: F = 8/(3π), T = 8/(9π) on both sides; the next number changes F by 1e-16 ln(1e16).
  for (const double w : {1.0, 1.0 - 1e-16, 1.0 + 3e-16}) {
    EXPECT_NEAR(contensouCurve(1.0, w).F, 8.0 / (3.0 * M_PI), 1e-14);
    EXPECT_NEAR(contensouCurve(1.0, w).T, 8.0 / (9.0 * M_PI), 1e-14);
  }
}

TEST(UnilateralDrilling, SlidesAndSpinsToAStopAtOnce) {
  // A disc of radius 0.1 m, I = ½ m a², μ = 0.2: with u = −Λ both stop together. From v = 1 m/s and
  // ω = 20 rad/s the smooth motion, integrated with high order, stops at t = 0.970040839 s.
  const double a = 0.1, m = 1.0, J = 0.5 * m * a * a, dt = 1e-3;
  const UnilateralDrilling law(0.2, a);
  const LawInput in{.dim = 4, .dt = dt};
  const double r[4] = {m, m, m, J};
  double u[4] = {0.0, 1.0, 0.0, 20.0}, Lambda[4] = {};
  int steps = 0;
  for (; steps < 2000 && (u[1] > 1e-12 || u[3] > 1e-12); ++steps) {
    const double free[4] = {-9.81 * dt, u[1], u[2], u[3]};
    for (int it = 0; it < 20; ++it) {
      double xi[4];
      for (int i = 0; i < 4; ++i) xi[i] = free[i] + Lambda[i] / r[i];
      law.prox(in, r, xi, Lambda);
    }
    for (int i = 0; i < 4; ++i) u[i] = free[i] + Lambda[i] / r[i];
    EXPECT_EQ(u[1] > 1e-12, u[3] > 1e-12) << "step " << steps;
  }
  EXPECT_NEAR(steps * dt, 0.970040839, 2 * dt);  // the step in which it stops, order 1
}

}  // namespace
}  // namespace dynamy
