/// Measured orders of all schemes: free flight, persistent contact on a curved surface with and
/// without friction, a joint, across impacts. Truth: elliptic functions, closed form of the
/// bouncing ball, and Runge–Kutta's method in minimal coordinates (a second formulation of the same
/// motion).
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Orders that the equations promise (doc/theory/31_more_schemes.md, table of orders); kNone: not
/// defined there, with the reason.
struct SchemeOrders {
  const char* xml;
  double free;      ///< h(q, u)
  double curved;    ///< persistent contact on a curved surface
  double friction;  ///< the same, sliding with friction
  double joint;     ///< pendulum on a rod
  double impact;    ///< across impacts
  /// Of the velocity at most: the state of a two-step scheme holds that of half a step before.
  double velocity = 2;
};
std::ostream& operator<<(std::ostream& out, const SchemeOrders& s) { return out << s.xml; }

const SchemeOrders kSchemes[] = {
    {"MoreauMidpoint", 1, 1, 1, 1, 1},
    {"HalfExplicitEuler", 1, 1, 1, 1, 1},
    {"StewartTrinkle", 1, 1, 1, 1, kNone},
    {"AnitescuPotra", 1, 1, 1, 1, 1},
    {"PaoliSchatzman", 1, 2, 2, 2, 1, 1},
    {"ThetaMethod", 2, 1, 1, 1, 1},
    {"ThetaMethod theta=\"1\"", 1, 1, 1, 1, 1},
    {"NonsmoothRattle", 2, 2, 2, 2, 1},
    {"GeneralizedAlpha", 2, 1, 1, 1, 1},
    {"HalfExplicitHeun", 2, 2, 2, 2, 1},
    {"ConstraintIndex index=\"1\"", 1, kNone, kNone, 1, kNone},
    {"ConstraintIndex index=\"2\"", 1, kNone, kNone, 1, kNone},
    {"ConstraintIndex index=\"3\"", 1, kNone, kNone, 1, kNone},
    {"Ggl", 1, 1, 1, 1, 1},
};

std::string model(const std::string& scheme, const std::string& inside) {
  return "<dynamy version=\"1\">" + inside + "<simulation until=\"1\" step=\"1e-3\"><" + scheme +
         "/></simulation></dynamy>";
}

/// Runge–Kutta's classical method for y' = f(y), 20000 steps: errors below 1e-13.
template <std::size_t n, class F>
std::array<double, n> rungeKutta(std::array<double, n> y, double t, const F& f) {
  constexpr int kSteps = 20000;
  const double h = t / kSteps;
  const auto along = [&](const std::array<double, n>& k, double by) {
    std::array<double, n> out = y;
    for (std::size_t i = 0; i < n; ++i) out[i] += by * k[i];
    return out;
  };
  for (int s = 0; s < kSteps; ++s) {
    const auto k1 = f(y), k2 = f(along(k1, 0.5 * h)), k3 = f(along(k2, 0.5 * h)),
               k4 = f(along(k3, h));
    for (std::size_t i = 0; i < n; ++i)
      y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  return y;
}

/// Order of the error of `measure(scene)` after time t.
template <class Measure>
Fit orderOf(const std::string& text, double t, const std::vector<double>& dt, Measure&& measure) {
  std::vector<double> error;
  for (const double h : dt) {
    Scene scene("scene", {.text = text});
    scene.run(t, h);
    EXPECT_TRUE(scene.solved()) << "step " << h;
    error.push_back(std::abs(measure(scene)));
  }
  return fitOrder(dt, error);
}

class SchemeOrder : public testing::TestWithParam<SchemeOrders> {};

TEST_P(SchemeOrder, InFreeFlightIsAsStated) {
  // Duffing's oscillator with quadratic damping.
  const std::string text =
      model(GetParam().xml,
            "<systems><Coordinates name=\"x\" q=\"x\" q0=\"0.5\" u0=\"1\" M=\"1\" "
            "potential=\"2*x^2 + x^4\" h=\"-0.4*x_dot*abs(x_dot)\"/></systems>");
  const auto truth = rungeKutta<2>({0.5, 1.0}, 1.0, [](const std::array<double, 2>& y) {
    return std::array{y[1], -4.0 * y[0] - 4.0 * y[0] * y[0] * y[0] - 0.4 * y[1] * std::abs(y[1])};
  });
  const auto fit =
      orderOf(text, 1.0, halvings(1e-2, 5), [&](Scene& s) { return s.q("x")[0] - truth[0]; });
  const auto fitU =
      orderOf(text, 1.0, halvings(1e-2, 5), [&](Scene& s) { return s.u("x")[0] - truth[1]; });
  EXPECT_NEAR(fit.order, GetParam().free, 0.15) << fit;
  EXPECT_NEAR(fitU.order, GetParam().free, 0.15) << fitU;
}

/// A point mass slides through the bowl z = x²/2 + x³/10.
struct Bowl {
  static double slope(double x) { return x + 0.3 * x * x; }
  static double height(double x) { return 0.5 * x * x + 0.1 * x * x * x; }
  static std::string text(const std::string& scheme, double mu) {
    const std::string slope = "(x + 0.3*x^2)", root = "sqrt(1 + " + slope + "^2)";
    const double x0 = -0.8, v = 1.0, s = std::sqrt(1.0 + Bowl::slope(x0) * Bowl::slope(x0));
    const auto number = [](double x) { return numberText(x); };
    return model(
        scheme,
        "<systems><Coordinates name=\"p\" q=\"x z\" q0=\"" + number(x0) + " " + number(height(x0)) +
            "\" u0=\"" + number(v / s) + " " + number(v * Bowl::slope(x0) / s) +
            "\" M=\"1 ; 0 ; 1\" potential=\"9.81*z\"/></systems>"
            "<elements><CoordinateContact on=\"p\" gap=\"(z - 0.5*x^2 - 0.1*x^3)/" +
            root + "\" slip=\"1/" + root + " ; " + slope + "/" + root +
            "\"><UnilateralCoulomb mu=\"" + number(mu) + "\"/></CoordinateContact></elements>");
  }
  /// x and speed along the bowl after t; N = g cos θ + κ v².
  static std::array<double, 2> truth(double mu, double t) {
    return rungeKutta<2>({-0.8, 1.0}, t, [mu](const std::array<double, 2>& y) {
      const double f = slope(y[0]), c = 1.0 / std::sqrt(1.0 + f * f);
      const double kappa = (1.0 + 0.6 * y[0]) * c * c * c, N = 9.81 * c + kappa * y[1] * y[1];
      return std::array{y[1] * c, -9.81 * f * c - mu * N};
    });
  }
};

void expectBowl(const SchemeOrders& scheme, double mu, double expected) {
  constexpr double t = 0.4;
  const auto truth = Bowl::truth(mu, t);
  const std::string text = Bowl::text(scheme.xml, mu);
  const std::vector<double> dt = halvings(1e-3, 4);
  const Fit x = orderOf(text, t, dt, [&](Scene& s) { return s.q("p")[0] - truth[0]; });
  const double f = Bowl::slope(truth[0]), ux = truth[1] / std::sqrt(1.0 + f * f);
  const Fit v = orderOf(text, t, dt, [&](Scene& s) { return s.u("p")[0] - ux; });
  EXPECT_NEAR(x.order, expected, 0.2) << x;
  EXPECT_NEAR(v.order, std::min(expected, scheme.velocity), 0.2) << v;
}

TEST_P(SchemeOrder, OnACurvedSurfaceIsAsStated) {
  if (std::isnan(GetParam().curved)) GTEST_SKIP() << "knows no unilateral contact";
  expectBowl(GetParam(), 0.0, GetParam().curved);
}

TEST_P(SchemeOrder, OnACurvedSurfaceWithFrictionIsAsStated) {
  if (std::isnan(GetParam().friction)) GTEST_SKIP() << "knows no unilateral contact";
  expectBowl(GetParam(), 0.2, GetParam().friction);
}

TEST_P(SchemeOrder, WithAJointIsAsStated) {
  // Pendulum on a rod from the horizontal, after 1 s (S01).
  const std::string text =
      model(GetParam().xml,
            "<systems><PointMass name=\"bob\" plane=\"xz\" position=\"-1 0 0\" mass=\"1\"/><Ground "
            "name=\"world\"/></systems><forces><Gravity/></forces><elements><Distance name=\"rod\" "
            "between=\"world bob\"/></elements>");
  const Fit fit = orderOf(text, 1.0, halvings(4e-3, 5), [](Scene& s) {
    const Eigen::VectorXd q = s.q("bob");
    return std::atan2(q[0], -q[1]) - std::atan2(0.986291751131875, 0.165010853125541);
  });
  EXPECT_NEAR(fit.order, GetParam().joint, 0.2) << fit;
}

TEST_P(SchemeOrder, AcrossImpactsIsAsStated) {
  if (std::isnan(GetParam().impact)) GTEST_SKIP() << "knows no rebound";
  // N01 at 1 s; envelope over where in a step the impacts fall.
  const std::string text = model(
      GetParam().xml,
      "<systems><PointMass name=\"ball\" plane=\"xz\" position=\"0 0 1.1\" mass=\"1\"><Sphere "
      "radius=\"0.1\" material=\"rubber\"/></PointMass><Ground name=\"world\"><HalfSpace "
      "material=\"concrete\"/></Ground></systems><forces><Gravity/></forces><elements><Contact "
      "between=\"rubber concrete\"><Unilateral epsilonN=\"0.5\"/></Contact></elements>");
  const std::vector<double> dt = halvings(4e-3, 5);
  std::vector<double> worst;
  for (const double h : dt)
    worst.push_back(envelope(h, 12, [&](double step) {
      Scene scene("ball", {.text = text});
      scene.run(1.0, step);
      return scene.q("ball")[1] - 0.1 - 0.0612555656575454;
    }));
  const Fit fit = fitOrder(dt, worst);
  // Scatter of 12 samples.
  EXPECT_NEAR(fit.order, GetParam().impact, 0.25) << fit;
}

INSTANTIATE_TEST_SUITE_P(AllSchemes, SchemeOrder, testing::ValuesIn(kSchemes));

}  // namespace
}  // namespace dynamy::reference
