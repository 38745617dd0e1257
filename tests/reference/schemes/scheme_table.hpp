/// All schemes with the orders that doc/theory/31_more_schemes.md states, and the situations in
/// which the orders are measured. Shared by the test of the orders, the drawing of their chart and
/// the tests that go through all schemes.
#pragma once
#include <array>
#include <build_paths.hpp>
#include <fstream>
#include <limits>
#include <ostream>
#include <reference/order.hpp>
#include <reference/scene.hpp>
#include <sstream>

namespace dynamy::reference {

/// Where an order is measured.
enum class Situation { freeFlight, curvedSurface, friction, joint, impacts };
inline constexpr Situation kSituations[] = {Situation::freeFlight, Situation::curvedSurface,
                                            Situation::friction, Situation::joint,
                                            Situation::impacts};
constexpr std::size_t index(Situation s) { return static_cast<std::size_t>(s); }
inline const char* situationText(Situation s) {
  constexpr const char* kText[] = {"free flight", "curved surface", "sliding on it", "joint",
                                   "impacts"};
  return kText[index(s)];
}

struct SchemeOrders {
  const char* name;                  ///< letters and digits, for the name of a test
  const char* xml;                   ///< element with its attributes
  std::array<double, 5> position{};  ///< order of positions in each situation
  std::array<double, 5> velocity{};  ///< of velocities away from jumps; impacts: not measured
};
inline std::ostream& operator<<(std::ostream& out, const SchemeOrders& s) { return out << s.xml; }

/// Zero: the scheme lacks this (OneStep::lacks), its reason is what the test asks for.
inline constexpr SchemeOrders kAllSchemes[] = {
    {"MoreauMidpoint", "MoreauMidpoint", {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},
    {"HalfExplicitEuler", "HalfExplicitEuler", {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},
    {"StewartTrinkle", "StewartTrinkle", {1, 1, 1, 1, 0}, {1, 1, 1, 1, 0}},
    {"AnitescuPotra", "AnitescuPotra", {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},
    // The velocity of its state is that of half a step before.
    {"PaoliSchatzman", "PaoliSchatzman", {1, 2, 2, 2, 1}, {1, 1, 1, 1, 1}},
    {"ThetaMethod", "ThetaMethod", {2, 1, 1, 1, 1}, {2, 1, 1, 1, 1}},
    {"ThetaMethodOne", "ThetaMethod theta=\"1\"", {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},
    {"NonsmoothRattle", "NonsmoothRattle", {2, 2, 2, 2, 1}, {2, 2, 2, 2, 1}},
    {"GeneralizedAlpha", "GeneralizedAlpha", {2, 1, 1, 1, 1}, {2, 1, 1, 1, 1}},
    {"HalfExplicitHeun", "HalfExplicitHeun", {2, 2, 2, 2, 1}, {2, 2, 2, 2, 1}},
    {"Ggl", "Ggl", {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},
    {"AugmentedMoreau", "AugmentedMoreau order=\"2\"", {2, 1, 1, 1, 2}, {2, 1, 1, 1, 2}},
    {"AugmentedMoreauOne", "AugmentedMoreau order=\"1\"", {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}},
    {"StaggeredMoreau", "StaggeredMoreau", {1, 1, 1, 2, 1}, {1, 1, 1, 2, 1}},
    {"EnergyMomentum", "EnergyMomentum", {1, 1, 1, 2, 1}, {1, 1, 1, 2, 1}},
    {"Index1", "ConstraintIndex index=\"1\"", {1, 0, 0, 1, 0}, {1, 0, 0, 1, 0}},
    {"Index2", "ConstraintIndex index=\"2\"", {1, 0, 0, 1, 0}, {1, 0, 0, 1, 0}},
    {"Index3", "ConstraintIndex index=\"3\"", {1, 0, 0, 1, 0}, {1, 0, 0, 1, 0}},
};

/// A model of these sections with this scheme.
inline std::string modelWith(const std::string& scheme, const std::string& inside,
                             const std::string& law = "") {
  return "<dynamy version=\"1\">" + inside + "<simulation until=\"1\" step=\"1e-3\"><" + scheme +
         "/>" + law + "</simulation></dynamy>";
}

/// A file of models/ with another scheme and nothing else changed.
inline std::string modelFile(const std::string& name, const std::string& scheme) {
  std::ifstream in(std::string(DYNAMY_SOURCE_DIR) + "/models/" + name + ".xml");
  std::stringstream text;
  text << in.rdbuf();
  std::string out = text.str();
  const std::string original = "<MoreauMidpoint/>";
  const std::size_t at = out.find(original);
  if (at == std::string::npos) throw std::runtime_error(name + " names another scheme");
  return out.replace(at, original.size(), "<" + scheme + "/>");
}

/// Where the coordinates of a system are at the end, and how fast.
struct Truth {
  Eigen::VectorXd q, u;
};

/// Pendulum of 1 m and 1 kg on a rod, from the horizontal (S01).
inline constexpr const char* kRodPendulum =
    "<systems><PointMass name=\"bob\" plane=\"xz\" position=\"-1 0 0\" mass=\"1\"/><Ground "
    "name=\"world\"/></systems><forces><Gravity/></forces><elements><Distance name=\"rod\" "
    "between=\"world bob\"/></elements>";

/// The same from another state.
inline std::string swingingPendulum(const Truth& from) {
  const auto vector = [](const Eigen::VectorXd& v) {
    return numberText(v[0]) + " 0 " + numberText(v[1]);
  };
  std::string out = kRodPendulum;
  const std::string start = "position=\"-1 0 0\"";
  return out.replace(out.find(start), start.size(),
                     "position=\"" + vector(from.q) + "\" velocity=\"" + vector(from.u) + "\"");
}

/// Ball of 0.1 m dropped by 1 m (N01).
inline std::string droppedBall(double epsilon) {
  return "<systems><PointMass name=\"ball\" plane=\"xz\" position=\"0 0 1.1\" "
         "mass=\"1\"><Sphere radius=\"0.1\" material=\"rubber\"/></PointMass><Ground "
         "name=\"world\"><HalfSpace material=\"concrete\"/></Ground></systems><forces><Gravity/>"
         "</forces><elements><Contact between=\"rubber concrete\"><Unilateral epsilonN=\"" +
         numberText(epsilon) + "\"/></Contact></elements>";
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

/// A point mass slides through the bowl z = x²/2 + x³/10.
struct Bowl {
  static double slope(double x) { return x + 0.3 * x * x; }
  static double height(double x) { return 0.5 * x * x + 0.1 * x * x * x; }
  static std::string sections(double mu) {
    const std::string slope = "(x + 0.3*x^2)", root = "sqrt(1 + " + slope + "^2)";
    const double x0 = -0.8, v = 1.0, s = std::sqrt(1.0 + Bowl::slope(x0) * Bowl::slope(x0));
    const auto number = [](double x) { return numberText(x); };
    return "<systems><Coordinates name=\"p\" q=\"x z\" q0=\"" + number(x0) + " " +
           number(height(x0)) + "\" u0=\"" + number(v / s) + " " + number(v * Bowl::slope(x0) / s) +
           "\" M=\"1 ; 0 ; 1\" potential=\"9.81*z\"/></systems>"
           "<elements><CoordinateContact on=\"p\" gap=\"(z - 0.5*x^2 - 0.1*x^3)/" +
           root + "\" slip=\"1/" + root + " ; " + slope + "/" + root +
           "\"><UnilateralCoulomb mu=\"" + number(mu) + "\"/></CoordinateContact></elements>";
  }
  /// (x, z) and its rate after t, from the speed along the bowl; N = g cos θ + κ v².
  static Truth truth(double mu, double t) {
    const auto y = rungeKutta<2>({-0.8, 1.0}, t, [mu](const std::array<double, 2>& s) {
      const double f = slope(s[0]), c = 1.0 / std::sqrt(1.0 + f * f);
      const double kappa = (1.0 + 0.6 * s[0]) * c * c * c, N = 9.81 * c + kappa * s[1] * s[1];
      return std::array{s[1] * c, -9.81 * f * c - mu * N};
    });
    const double f = slope(y[0]), ux = y[1] / std::sqrt(1.0 + f * f);
    return {Eigen::Vector2d(y[0], height(y[0])), Eigen::Vector2d(ux, f * ux)};
  }
};

/// Errors over steps that are halved.
struct Convergence {
  std::vector<double> dt, position, velocity;
  std::string_view refused;  ///< the scheme's words, if a step was refused
  bool solved = true;        ///< all inclusions
};

/// One run of a situation's scene to its end: distances to the truth.
struct Errors {
  double position = 0.0, velocity = 0.0;
};

inline Errors runTo(Scene& scene, double t, double dt, Convergence& out, const std::string& system,
                    const Truth& truth) {
  scene.run(t, dt, [&] {
    if (!scene.report().refused.empty()) out.refused = scene.report().refused;
  });
  out.solved = out.solved && scene.solved();
  return {(scene.q(system) - truth.q).norm(), (scene.u(system) - truth.u).norm()};
}

/// Measures the order of a scheme in a situation. Truth: Runge–Kutta in minimal coordinates,
/// elliptic functions of the pendulum, closed form of the bouncing ball.
inline Convergence measure(const std::string& scheme, Situation situation) {
  Convergence out;
  const auto record = [&](double h, const Errors& e) {
    out.dt.push_back(h);
    out.position.push_back(std::abs(e.position)), out.velocity.push_back(std::abs(e.velocity));
  };
  const auto all = [&](const std::string& sections, double t, const std::vector<double>& steps,
                       const std::string& system, const Truth& truth) {
    for (const double h : steps) {
      Scene scene("scene", {.text = modelWith(scheme, sections)});
      record(h, runTo(scene, t, h, out, system, truth));
    }
  };
  switch (situation) {
    case Situation::freeFlight: {  // Duffing's oscillator with quadratic damping, h(q, u)
      const auto truth = rungeKutta<2>({0.5, 1.0}, 1.0, [](const std::array<double, 2>& y) {
        return std::array{y[1],
                          -4.0 * y[0] - 4.0 * y[0] * y[0] * y[0] - 0.4 * y[1] * std::abs(y[1])};
      });
      all("<systems><Coordinates name=\"x\" q=\"x\" q0=\"0.5\" u0=\"1\" M=\"1\" "
          "potential=\"2*x^2 + x^4\" h=\"-0.4*x_dot*abs(x_dot)\"/></systems>",
          1.0, halvings(1e-2, 5), "x",
          {Eigen::VectorXd::Constant(1, truth[0]), Eigen::VectorXd::Constant(1, truth[1])});
      break;
    }
    case Situation::curvedSurface:
    case Situation::friction: {
      const double mu = situation == Situation::friction ? 0.2 : 0.0;
      all(Bowl::sections(mu), 0.4, halvings(1e-3, 4), "p", Bowl::truth(mu, 0.4));
      break;
    }
    case Situation::joint: {
      // S01 from 1 s, in full swing, to 2 s; |u|² = −2 g z along the circle, there and back.
      const auto at = [](double x, double z, double sense) {
        const double speed = sense * std::sqrt(-2.0 * 9.81 * z);
        return Truth{Eigen::Vector2d(x, z), Eigen::Vector2d(-z * speed, x * speed)};
      };
      all(swingingPendulum(at(0.986291751131875, -0.165010853125541, 1.0)), 1.0, halvings(4e-3, 5),
          "bob", at(-0.793566195343322, -0.608483930443792, -1.0));
      break;
    }
    case Situation::impacts:
      // N01 at 1 s; envelope over where in a step the impacts fall.
      for (const double h : halvings(4e-3, 5))
        record(h, {envelope(h, 12,
                            [&](double step) {
                              Scene scene("ball", {.text = modelWith(scheme, droppedBall(0.5))});
                              scene.run(1.0, step, [&] {
                                if (!scene.report().refused.empty())
                                  out.refused = scene.report().refused;
                              });
                              out.solved = out.solved && scene.solved();
                              return scene.q("ball")[1] - 0.1 - 0.0612555656575454;
                            }),
                   std::numeric_limits<double>::quiet_NaN()});
      break;
  }
  return out;
}

}  // namespace dynamy::reference
