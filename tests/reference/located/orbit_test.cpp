// Periodic orbits against closed forms, and against solutions with 30 digits.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <complex>
#include <dynamy/io/model/file_orbit.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>

namespace dynamy {
namespace {

using Complex = std::complex<double>;
constexpr double kTurn = 6.283185307179586;

struct Orbits {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  Orbits() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }
  Orbit operator()(FileOrbit wanted) {
    wanted.file = DYNAMY_SOURCE_DIR "/models/" + wanted.file.string() + ".xml";
    return orbit(wanted, registry, plugins);
  }
  Orbit ofText(const std::string& inside, const OrbitRequest& request) {
    Model model = loadModelText("<dynamy version=\"1\">" + inside + "</dynamy>", "test.xml",
                                registry, plugins);
    return orbit(model, request);
  }
};

OrbitSection every(double period, int times = 1) {
  OrbitSection out;
  out.period = period, out.returns = times;
  return out;
}

double stateOf(const Orbit& o, const std::string& name) {
  for (const auto& [signal, value] : o.state)
    if (signal == name) return value;
  ADD_FAILURE() << "no signal " << name;
  return 0.0;
}

/// Differences of fourth order with δ = 3e-4 of the range are good to some 1e-11.
constexpr double kMultiplier = 1e-9;

TEST(Orbit, OfALinearOscillatorIsItsForcedMotion) {
  Orbits of;
  const double zeta = 0.1, omega = 1.7, T = kTurn / omega;
  const Orbit o = of.ofText(
      R"x(<systems><Coordinates name="m" q="x" q0="3" u0="-2" M="1" h="-0.2*x_dot - x + cos(1.7*t)"/></systems>)x"
      R"(<simulation until="20" tolerance="1e-9"/>)",
      {.section = every(T)});
  EXPECT_LE(o.newton, 2);  // the return map is linear; differences have an error of 1e-10
  EXPECT_LE(o.residual, 1e-12);
  const Complex x = 1.0 / Complex(1.0 - omega * omega, 2.0 * zeta * omega);
  EXPECT_NEAR(stateOf(o, "m.x"), x.real(), 1e-10);  // ten tolerances
  const Complex m = std::exp(Complex(-zeta, std::sqrt(1.0 - zeta * zeta)) * T);
  ASSERT_EQ(o.multipliers.size(), 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(o.multipliers[i].real(), m.real(), kMultiplier);
    EXPECT_NEAR(std::abs(o.multipliers[i].imag()), std::abs(m.imag()), kMultiplier);
  }
  EXPECT_EQ(o.zeros, 0);
}

/// One bounce a period T on a table A cos(ωt + ψ): with v = gT/2 (1 − ε)/(1 + ε) the speed of the
/// table at the impact and a its acceleration, the map of (time, speed) of impacts has the trace
/// 1 + ε² + (1 + ε)² a/g and the determinant ε².
void expectBouncing(double sign, double off) {
  Orbits of;
  const double g = 9.81, e = 0.8, omega = 10.0, A = 0.04, T = kTurn / omega;
  const double v = 0.5 * g * T * (1.0 - e) / (1.0 + e);
  const double sine = -v / (A * omega), cosine = sign * std::sqrt(1.0 - sine * sine);
  const double psi = std::atan2(sine, cosine) - 0.5 * omega * T;  // the impact is at T/2
  const double top = A * cosine + g * T * T / 8.0;
  const Orbit o = of.ofText(
      "<systems><Coordinates name=\"ball\" q=\"y\" q0=\"" + numberText(off * top) +
          "\" u0=\"0\" M=\"1\" h=\"-9.81\"/></systems><elements><CoordinateContact name=\"table\" "
          "on=\"ball\" gap=\"y - 0.04*cos(10*t + " +
          fmt::format("{:.17g}", psi) +
          ")\"><Unilateral epsilonN=\"0.8\"/></CoordinateContact></elements>"
          "<simulation until=\"1\" tolerance=\"1e-9\"/>",
      {.section = every(T)});
  EXPECT_LE(o.residual, 1e-12);
  EXPECT_LE(o.newton, 8);
  EXPECT_NEAR(stateOf(o, "ball.y"), top, 1e-10);
  EXPECT_NEAR(stateOf(o, "ball.y_dot"), 0.0, 1e-10);
  const double a = -A * omega * omega * cosine;
  const double half = 0.5 * (1.0 + e * e + (1.0 + e) * (1.0 + e) * a / g);
  const Complex root = std::sqrt(Complex(half * half - e * e));
  ASSERT_EQ(o.multipliers.size(), 2);
  // The order of conjugate multipliers is no matter.
  EXPECT_NEAR(std::abs(o.multipliers[0] - half), std::abs(root), kMultiplier);
  EXPECT_NEAR(std::abs(o.multipliers.sum() - 2.0 * half), 0.0, kMultiplier);
  EXPECT_NEAR(std::abs(o.multipliers.prod() - e * e), 0.0, kMultiplier);
}

TEST(Orbit, OfABouncingBallOnAVibratingTableHasTheMultipliersOfItsMap) {
  expectBouncing(1.0, 1.02);
}

TEST(Orbit, OfABouncingBallIsFoundWhereItIsUnstable) { expectBouncing(-1.0, 1.005); }

struct ImpactOrbit {
  double d, Omega;
  int n;
  double a, e, v, impact;
  Complex multiplier;
  double other;  // the second one if both are real
};

/// Motion of x" + d x' + x = cos Ωt from (x, v) at t0 to t1.
void fly(const ImpactOrbit& c, double t0, double t1, double& x, double& v) {
  const Complex gain = 1.0 / Complex(1.0 - c.Omega * c.Omega, c.d * c.Omega);
  const auto forced = [&](double t) { return gain * std::exp(Complex(0.0, c.Omega * t)); };
  const double w = std::sqrt(1.0 - 0.25 * c.d * c.d), s = t1 - t0;
  const double x0 = x - forced(t0).real();
  const double v0 = v - (Complex(0.0, c.Omega) * forced(t0)).real();
  const double B = (v0 + 0.5 * c.d * x0) / w, decay = std::exp(-0.5 * c.d * s);
  const double p = decay * (x0 * std::cos(w * s) + B * std::sin(w * s));
  const double q = decay * (B * std::cos(w * s) - x0 * std::sin(w * s)) * w - 0.5 * c.d * p;
  x = p + forced(t1).real();
  v = q + (Complex(0.0, c.Omega) * forced(t1)).real();
}

TEST(Orbit, OfAnImpactOscillatorIsThePublishedOneAlsoWhereItIsUnstable) {
  Orbits of;
  const ImpactOrbit cases[] = {
      {0.0, 2.2, 1, 0.0, 0.8, 1.8987487383113, 1.2744484431692, {0.64160, 0.47786}, 0},
      {0.0, 2.6, 1, 0.0, 0.8, 0.50543997089396, 1.1651472829823, {-0.57454, 0.55669}, 0},
      {0.0, 4.2, 2, 0.0, 0.8, 0.8402129343498, 0.66719807368774, {0.64052, 0.47930}, 0},
      {0.0, 2.8, 1, 0.0, 0.8, 0.33617726997566, 1.0926345564091, {-2.9581, 0}, -0.21636},
      {0.1, 2.5, 1, 0.0, 0.6, 0.68442079380126, 1.0950252426633, {-0.13313, 0.51213}, 0},
      {0.2, 2.4, 1, 0.1, 0.7, 0.45035138358123, 1.174423096611, {-0.31957, 0.43375}, 0}};
  for (const ImpactOrbit& c : cases) {
    const double T = c.n * kTurn / c.Omega;
    double x = c.a, v = -c.e * c.v;
    fly(c, c.impact - T, 0.0, x, v);
    const auto number = [](double p) { return fmt::format("{:.17g}", p); };
    const Orbit o = of.ofText(
        "<systems><Coordinates name=\"m\" q=\"x\" q0=\"" + number(1.1 * x) + "\" u0=\"" +
            number(0.95 * v) + "\" M=\"1\" h=\"-x - " + number(c.d) + "*x_dot + cos(" +
            number(c.Omega) +
            "*t)\"/></systems><elements><CoordinateContact name=\"wall\" on=\"m\" gap=\"" +
            number(c.a) + " - x\"><Unilateral epsilonN=\"" + number(c.e) +
            "\"/></CoordinateContact></elements><simulation until=\"10\" tolerance=\"1e-9\"/>",
        {.section = every(kTurn / c.Omega, c.n)});
    SCOPED_TRACE(c.Omega);
    EXPECT_LE(o.residual, 1e-12);
    EXPECT_LE(o.newton, 8);
    EXPECT_EQ(o.impacts, 1);
    // The table has 13 digits of the speed and of the instant.
    EXPECT_NEAR(stateOf(o, "m.x"), x, 1e-10);
    EXPECT_NEAR(stateOf(o, "m.x_dot"), v, 1e-10);
    ASSERT_EQ(o.multipliers.size(), 2);
    // The table has five digits.
    EXPECT_NEAR(o.multipliers[0].real(), c.multiplier.real(), 5.1e-5);
    EXPECT_NEAR(std::abs(o.multipliers[0].imag()), c.multiplier.imag(), 5.1e-6);
    if (c.other != 0.0) {
      EXPECT_NEAR(o.multipliers[1].real(), c.other, 5.1e-6);
    }
  }
}

/// A mass between two walls: the motion repeats itself mirrored after half a period. The product of
/// the multipliers of the whole orbit is ε⁴ exp(−dT).
TEST(Orbit, OfAMassBetweenTwoWallsIsFoundByHalfOfIt) {
  Orbits of;
  const double T = kTurn / 2.6;
  const auto found = [&](double x, double v, const OrbitSection& section) {
    const auto number = [](double p) { return fmt::format("{:.17g}", p); };
    return of.ofText(
        "<systems><Coordinates name=\"m\" q=\"x\" q0=\"" + number(x) + "\" u0=\"" + number(v) +
            "\" M=\"1\" h=\"-x - 0.1*x_dot + cos(2.6*t)\"/></systems><elements>"
            "<CoordinateContact name=\"right\" on=\"m\" gap=\"0.15 - x\"><Unilateral "
            "epsilonN=\"0.7\"/></CoordinateContact><CoordinateContact name=\"left\" on=\"m\" "
            "gap=\"0.15 + x\"><Unilateral epsilonN=\"0.7\"/></CoordinateContact></elements>"
            "<simulation until=\"40\" tolerance=\"1e-9\"/>",
        {.section = section});
  };
  OrbitSection mirrored = every(T);
  mirrored.mirror = {"m.x"};
  const Orbit half = found(0.11, 0.47, mirrored);
  EXPECT_LE(half.residual, 1e-12);
  EXPECT_LE(half.newton, 8);
  EXPECT_EQ(half.impacts, 2);
  EXPECT_NEAR(half.period, T, 1e-12);
  ASSERT_EQ(half.multipliers.size(), 2);
  ASSERT_EQ(half.half.size(), 2);
  EXPECT_NEAR(std::abs(half.multipliers.prod() - std::pow(0.7, 4) * std::exp(-0.1 * T)), 0.0,
              kMultiplier);
  // The whole orbit from the same state is the same.
  const double x = stateOf(half, "m.x"), v = stateOf(half, "m.x_dot");
  const Orbit whole = found(x, v, every(T));
  EXPECT_NEAR(stateOf(whole, "m.x"), x, 1e-10);
  EXPECT_NEAR(stateOf(whole, "m.x_dot"), v, 1e-10);
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(std::abs(whole.multipliers[i] - half.multipliers[i]), 0.0, kMultiplier);
}

TEST(Orbit, TellsWhatIsWrongInItsMirror) {
  Orbits of;
  const auto fault = [&](const std::string& mirror) -> std::string {
    OrbitSection section = every(1.0);
    section.mirror = {mirror};
    try {
      of.ofText(
          R"x(<systems><Coordinates name="m" q="x y" M="1;0;1" h="0;0"/></systems><simulation until="2" tolerance="1e-9"/>)x",
          {.section = section});
    } catch (const ModelError& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_NE(fault("m.z").find("no coordinate or velocity named \"m.z\""), std::string::npos);
  EXPECT_NE(fault("m.x=m.y_dot").find("cannot be mirror images"), std::string::npos);
}

/// From starts 10 % off in all that the section leaves free, and in one velocity.
TEST(Orbit, OfTheWoodpeckerIsFoundFromTenPerCentOff) {
  Orbits of;
  const std::vector<Overrides> starts = {{{"toy.phiM", "0"},
                                          {"toy.phiS", "0.00284"},
                                          {"toy.y_dot", "-0.3154"},
                                          {"toy.phiM_dot", "28.6"},
                                          {"toy.phiS_dot", "13.0"}},
                                         {{"toy.phiM", "0"},
                                          {"toy.phiS", "0.00348"},
                                          {"toy.y_dot", "-0.3854"},
                                          {"toy.phiM_dot", "34.98"},
                                          {"toy.phiS_dot", "15.89"}},
                                         {{"toy.phiM", "0"},
                                          {"toy.phiS", "0.00316"},
                                          {"toy.y_dot", "-0.3504"},
                                          {"toy.phiM_dot", "28.6"},
                                          {"toy.phiS_dot", "14.444"}}};
  for (const Overrides& start : starts) {
    const Orbit o = of({.file = "woodpecker", .start = start});
    EXPECT_GE(o.away, 0.05);
    EXPECT_LE(o.residual, 1e-12);
    EXPECT_LE(o.newton, 8);
    EXPECT_NEAR(o.period, 0.145976065144, 1e-12);
  }
}

TEST(Orbit, OfTheWoodpeckerHasItsPeriodFallAndMultiplier) {
  Orbits of;
  const Orbit o = of({.file = "woodpecker"});
  EXPECT_LE(o.residual, 1e-12);
  EXPECT_LE(o.newton, 8);
  EXPECT_NEAR(o.period, 0.145976065144, 1e-12);
  ASSERT_EQ(o.shift.size(), 1u);
  EXPECT_EQ(o.shift[0].first, "toy.y");
  EXPECT_NEAR(o.shift[0].second, -19.445379285e-3, 1e-12);
  ASSERT_EQ(o.multipliers.size(), 1);
  EXPECT_NEAR(o.multipliers[0].real(), -0.83916, 5e-6);  // the digits known
  // Five coordinates and velocities beside the height, one of which the section holds.
  EXPECT_EQ(o.zeros, 3);
}

}  // namespace
}  // namespace dynamy
