// Eigenvalues of steady motions against closed forms.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/linear/linearisation.hpp>

namespace dynamy {
namespace {

/// A model from text, with what it lives on.
struct Text {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  std::unique_ptr<Model> model;
  explicit Text(const std::string& inside) {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
    model = std::make_unique<Model>(loadModelText("<dynamy version=\"1\">" + inside + "</dynamy>",
                                                  "test.xml", registry, plugins));
  }
  Linearisation solve(const LinearisationOptions& options = {}) {
    return linearise(*model, model->initialState(), options);
  }
};

/// Differences of angles from steps of 0.1 rad, extrapolated six times, are good to 1e-12 of the
/// largest entry; the eigenvalues of these small matrices are as good.
constexpr double kGood = 1e-10;

void expectPair(const Linearisation& l, Eigen::Index at, double real, double imaginary) {
  ASSERT_GE(l.eigenvalues.size(), at + 2);
  EXPECT_NEAR(l.eigenvalues[at].real(), real, kGood) << at;
  EXPECT_NEAR(l.eigenvalues[at].imag(), imaginary, kGood) << at;
  EXPECT_NEAR(l.eigenvalues[at + 1].imag(), -imaginary, kGood) << at;
}

/// All imaginary parts ≥ 0 of pairs, growing.
std::vector<double> frequencies(const Linearisation& l) {
  std::vector<double> out;
  for (const std::complex<double>& z : l.eigenvalues)
    if (z.imag() > 0.0) out.push_back(z.imag());
  std::sort(out.begin(), out.end());
  return out;
}

TEST(Linearisation, DampedPendulumHasItsTwoEigenvalues) {
  Text t(R"xml(<systems><Coordinates name="p" q="phi" units="rad" q0="0.3" M="0.25"
    potential="-9.81*0.5*cos(phi)" h="-0.1*phi_dot"/></systems>
    <simulation until="1" step="1e-3"/>)xml");
  const Linearisation l = t.solve();
  EXPECT_NEAR(l.at.q[0], 0.0, 1e-12);  // Newton's method from 0.3 rad
  EXPECT_EQ(l.zeros, 0);
  EXPECT_EQ(l.growing(), 0);
  expectPair(l, 0, -0.2, std::sqrt(9.81 / 0.5 - 0.04));  // φ'' + 0.4 φ' + (g/l) φ = 0
}

TEST(Linearisation, SeesNothingOfAKinkBesideTheMotion) {
  // Two springs that press only, 6.7 and 9.5 mm deep, far from the middle by as much as keeps their
  // balance: beyond their ends the differences of the turn are half of the derivative, for any step.
  Text t(R"xml(<systems><Coordinates name="c" q="z phi" units="m rad" q0="0 0" M="100; 0; 10"
    h="1e5*max(0, 0.0067 - z - 0.95*phi) + 1e5*max(0, 0.0095 - z + 0.67*phi) - 1620;
       0.95*1e5*max(0, 0.0067 - z - 0.95*phi) - 0.67*1e5*max(0, 0.0095 - z + 0.67*phi)"/></systems>
    <simulation until="1" step="1e-3"/>)xml");
  const Linearisation l = t.solve();
  // m z'' = −2 c z − c (0.95 − 0.67) φ,  J φ'' = −0.28 c z − c (0.95² + 0.67²) φ; w² = d/2 ± …
  const double a = 2e3, b = 0.28e3, c = 0.28e4, d = 1e4 * (0.95 * 0.95 + 0.67 * 0.67);
  const double mean = 0.5 * (a + d), off = std::sqrt(0.25 * (a - d) * (a - d) + b * c);
  const std::vector<double> w = frequencies(l);
  ASSERT_EQ(w.size(), 2u);
  // Differences with steps below 6.7 mm are good to 1e-10 of the largest entry, 1.4e4.
  EXPECT_NEAR(w[0], std::sqrt(mean - off), 1e-6);
  EXPECT_NEAR(w[1], std::sqrt(mean + off), 1e-6);
}

TEST(Linearisation, SeesKinksOnBothSidesOfTheMotion) {
  // A spring that ends 3 mm to either side, harder inside than gravity pulls: beyond the ends the motion
  // grows by w² = 4, as differences with larger steps say, and inside it swings with w² = 96.
  Text t(R"xml(<systems><Coordinates name="c" q="x" units="m" q0="0" M="1"
    h="4*x - 100*max(-0.003, min(0.003, x))"/></systems><simulation until="1" step="1e-3"/>)xml");
  expectPair(t.solve(), 0, 0.0, std::sqrt(96.0));
}

TEST(Linearisation, FindsRestOfAStiffSpringFarAway) {
  // 1000 kg on a spring of 2e9 N/m at 174 m, not preloaded: the rounding of its place, 2e-14 m, is an
  // acceleration of 4e-8 m/s², more than a steady motion of free bodies leaves.
  Text scene(R"(<systems><Ground name="world"/>
    <PlanarBody name="car" position="0 0 -174" mass="1000" inertia="100"/></systems>
    <forces><Gravity/><SpringDamper between="world car" stiffness="2e9" length="173.9"/></forces>
    <elements><Prismatic between="world car" axis="0 0 1"/></elements>
    <simulation until="1" step="1e-3"/>)");
  const Linearisation l = scene.solve();
  ASSERT_EQ(l.eigenvalues.size(), 2);
  EXPECT_NEAR(std::abs(l.eigenvalues[0].imag()), std::sqrt(2e6), 1e-6);  // 1e-9 of it
}

TEST(Linearisation, UprightPendulumGrows) {
  Text t(R"xml(<systems><Coordinates name="p" q="phi" units="rad" q0="3.1" M="1"
    potential="-9.81*cos(phi)"/></systems><simulation until="1" step="1e-3"/>)xml");
  const Linearisation l = t.solve();
  EXPECT_EQ(l.growing(), 1);
  EXPECT_NEAR(l.eigenvalues[1].real(), std::sqrt(9.81), kGood);
  EXPECT_NEAR(l.eigenvalues[0].real(), -std::sqrt(9.81), kGood);
}

TEST(Linearisation, DoublePendulumHasOneSpectrumInAnglesAndWithJoints) {
  const double g = 9.81, slow = std::sqrt(g * (2.0 - std::sqrt(2.0))),
               fast = std::sqrt(g * (2.0 + std::sqrt(2.0)));
  Text t(R"xml(<systems>
    <Coordinates name="minimal" q="a b" units="rad rad" q0="0.1 -0.05"
      kineticEnergy="a_dot^2 + b_dot^2/2 + a_dot*b_dot*cos(a - b)"
      potential="-9.81*(2*cos(a) + cos(b))"/>
    <PointMass name="upper" plane="xz" position="0 0 -1" mass="1"/>
    <PointMass name="lower" plane="xz" position="0 0 -2" mass="1"/>
    <Ground name="world"/></systems>
    <forces><Gravity/></forces>
    <elements><Distance name="rod1" between="world upper"/>
    <Distance name="rod2" between="upper lower"/></elements>
    <simulation until="1" step="1e-3"/>)xml");
  const Linearisation l = t.solve();
  EXPECT_EQ(l.basis.cols(), 8);  // of 12: two rods, each on positions and velocities
  const std::vector<double> found = frequencies(l);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_NEAR(found[0], slow, kGood);
  EXPECT_NEAR(found[1], slow, kGood);
  EXPECT_NEAR(found[2], fast, kGood);
  EXPECT_NEAR(found[3], fast, kGood);
  EXPECT_EQ(l.growing(), 0);
  EXPECT_LE(l.leak, kGood);
  ASSERT_EQ(l.contacts.size(), 2u);
  EXPECT_NEAR(std::abs(l.contacts[0].lambda[0]), 2.0 * g, 1e-9);  // weight of both
}

TEST(Linearisation, FreeAxisSpinsStableOrNot) {
  // Euler's equations about axis 2 of J = (1, 2, 2.5): λ² = (J3 − J2)(J2 − J1)/(J1 J3) Ω² > 0;
  // about axis 3 λ² = (J3 − J2)(J1 − J3)/(J1 J2) Ω² < 0. Where it is and its attitude give zeros,
  // and the frame that turns ±iΩ.
  const auto spectrum = [](const char* omega) {
    Text t(std::string("<systems><RigidBody name=\"b\" mass=\"1\" inertia=\"1 2 2.5\" ") +
           "angularVelocity=\"" + omega + "\"/></systems><simulation until=\"1\" step=\"1e-3\"/>");
    return t.solve();
  };
  const Linearisation middle = spectrum("0 3 0"), largest = spectrum("0 0 3");
  EXPECT_EQ(middle.growing(), 1);
  EXPECT_NEAR(middle.eigenvalues[middle.eigenvalues.size() - 1].real(),
              3.0 * std::sqrt(0.5 * 1.0 / 2.5), kGood);
  EXPECT_EQ(largest.growing(), 0);
  const std::vector<double> found = frequencies(largest);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 3.0 * std::sqrt(0.5 * 1.5 / 2.0), kGood);
  EXPECT_NEAR(found[1], 3.0, kGood);
  EXPECT_EQ(largest.zeros, 8);
}

TEST(Linearisation, SlipWithCoulombFrictionKeepsItsDirection) {
  // A mass on a belt of 1 m/s, held by a spring: it slips against the belt all the time, friction
  // does not depend on the velocity, and the oscillation is not damped.
  Text t(R"xml(<systems><Coordinates name="m" q="x" units="m" q0="0.1" M="2" potential="50*x^2"/>
    </systems><elements><CoordinateContact name="belt" on="m" slipVelocity="x_dot - 1">
    <GivenFriction force="3"/></CoordinateContact></elements>
    <simulation until="1" step="1e-3"/>)xml");
  const Linearisation l = t.solve();
  ASSERT_EQ(l.contacts.size(), 1u);
  EXPECT_TRUE(l.contacts[0].slips);
  EXPECT_NEAR(l.at.q[0], 3.0 / 100.0, 1e-12);
  expectPair(l, 0, 0.0, std::sqrt(100.0 / 2.0));
}

TEST(Linearisation, RefusesWhatIsNotSteady) {
  const auto message = [](const char* inside, bool seek) {
    try {
      Text t(std::string(inside) + "<simulation until=\"1\" step=\"1e-3\"/>");
      t.solve({.seek = seek});
    } catch (const ModelError& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  const std::string swinging = message(R"xml(<systems><Coordinates name="p" q="phi" units="rad"
    q0="0.3" M="1" potential="-9.81*cos(phi)"/></systems>)xml",
                                       false);
  EXPECT_NE(swinging.find("no steady motion found: accelerations up to 2.9"), std::string::npos)
      << swinging;
  // At the lowest point without acceleration, but moving on.
  const std::string passing = message(R"xml(<systems><Coordinates name="p" q="phi" units="rad"
    u0="1" M="1" potential="-9.81*cos(phi)"/></systems>)xml",
                                      false);
  EXPECT_NE(passing.find("the motion is not steady"), std::string::npos) << passing;
  // A contact that would have to pull.
  const std::string pulled = message(R"xml(<systems><Coordinates name="p" q="x" units="m" M="1"
    h="1"/></systems><elements><CoordinateContact name="stop" on="p" gap="x"/></elements>)xml",
                                     true);
  EXPECT_NE(pulled.find("stop does not permit the steady motion"), std::string::npos) << pulled;
}

TEST(Linearisation, SplitsZeroEigenvaluesOffBeforeTheOthers) {
  // A Jordan block of three zeros, hidden by a rotation, beside −1 ± 2i.
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(5, 5);
  J(0, 1) = 3.0, J(1, 2) = 5.0, J(0, 3) = 1.0, J(2, 4) = 7.0;
  J.bottomRightCorner(2, 2) << -1.0, 2.0, -2.0, -1.0;
  Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(5, 5);
  for (int i = 0; i < 5; ++i)
    for (int k = i + 1; k < 5; ++k) {
      Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(5, 5);
      const double c = std::cos(0.3 + i + 2.0 * k), s = std::sin(0.3 + i + 2.0 * k);
      turn(i, i) = turn(k, k) = c, turn(i, k) = -s, turn(k, i) = s;
      Q *= turn;
    }
  const Eigen::MatrixXd A = Q * J * Q.transpose();
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
  EXPECT_EQ(nonzeroEigenvalues(A, 1e-12, values, vectors), 3);
  ASSERT_EQ(values.size(), 2);
  EXPECT_NEAR(values[0].real(), -1.0, 1e-13);  // rounding of entries up to 7
  EXPECT_NEAR(values[0].imag(), 2.0, 1e-13);
  for (Eigen::Index k = 0; k < 2; ++k)
    EXPECT_LE((A.cast<std::complex<double>>() * vectors.col(k) - values[k] * vectors.col(k)).norm(),
              1e-12 * vectors.col(k).norm());
}

TEST(Linearisation, BicycleOfBodiesWithSharpWheelsHasThePublishedEigenvalues) {
  // Meijaard, Papadopoulos, Ruina, Schwab 2007, table 2, 5 m/s. A torus with tube="0" is a circle.
  Text t(
      R"xml(<parameter name="v" value="5"/><parameter name="tube" value="0"/><parameter name="l" value="{pi/10}"/>
  <systems>
    <Ground name="road"><HalfSpace normal="0 0 1" material="road"/></Ground>
    <RigidBody name="frame" position="0.3 0 0.9" velocity="{v} 0 0" mass="85" inertia="9.2 11 2.8 0 -2.4 0"/>
    <RigidBody name="fork" position="0.9 0 0.7" velocity="{v} 0 0" mass="4" inertia="0.05892 0.06 0.00708 0 0.00756 0"/>
    <RigidBody name="rear" position="0 0 0.3" euler="{-pi/2} 0 0" velocity="{v} 0 0" angularVelocity="0 0 {v/0.3}" mass="2" inertia="0.0603 0.0603 0.12"><Torus radius="{0.3-tube}" tube="{tube}" material="tyre"/></RigidBody>
    <RigidBody name="front" position="1.02 0 0.35" euler="{-pi/2} 0 0" velocity="{v} 0 0" angularVelocity="0 0 {v/0.35}" mass="3" inertia="0.1405 0.1405 0.28"><Torus radius="{0.35-tube}" tube="{tube}" material="tyre"/></RigidBody>
  </systems>
  <forces><Gravity/></forces>
  <elements>
    <Revolute name="hub" between="frame rear" at="0 0 0.3" axis="0 1 0"/>
    <Revolute name="head" between="frame fork" at="{1.1-0.9*tan(l)} 0 0.9" axis="{-sin(l)} 0 {cos(l)}"/>
    <Revolute name="axle" between="fork front" at="1.02 0 0.35" axis="0 1 0"/>
    <NoContact between="tyre tyre"/><Contact between="road tyre"><UnilateralCoulomb mu="10"/></Contact>
  </elements>
  <simulation until="1" tolerance="1e-8" coordinates="minimal"/>)xml");
  const Linearisation l = t.solve();
  const std::complex<double> published[] = {{-14.0783896928, 0.0},
                                            {-0.775341882196, 4.46486771379},
                                            {-0.775341882196, -4.46486771379},
                                            {-0.322866429004, 0.0}};
  for (const std::complex<double>& z : published) {
    double off = 1.0;
    for (const std::complex<double>& found : l.eigenvalues)
      off = std::min(off, std::abs(found - z));
    // The last published digit, and kGood of entries of size 14.
    EXPECT_LT(off, 1e-9) << z;
  }
}

}  // namespace
}  // namespace dynamy
