// Systems written as formulas against closed forms. Tolerances: the formulas have a few dozen
// operations on numbers of order 1 to 100, so 1e-12 relative is some hundred roundings.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <dynamy/system/description.hpp>
#include <dynamy_elements/coordinates/coordinates.hpp>

namespace dynamy {
namespace {

using Given = std::vector<GivenValue>;

constexpr double kM1 = 0.7, kM2 = 1.9, kL1 = 0.6, kL2 = 1.1, kG = 9.81;
const std::vector<std::pair<std::string, double>> kSymbols{
    {"m1", kM1}, {"m2", kM2}, {"l1", kL1}, {"l2", kL2}, {"g", kG}};
const char* const kPotential = "-(m1+m2)*g*l1*cos(a) - m2*g*l2*cos(b)";

std::unique_ptr<Coordinates> system(
    const Given& given, std::vector<std::pair<std::string, double>> symbols = kSymbols) {
  Parameters x = Parameters::of<Coordinates>("Coordinates", "toy", given);
  x.symbols = std::move(symbols);
  return std::make_unique<Coordinates>(x);
}

std::unique_ptr<Coordinates> doublePendulum() {
  return system({{"q", "a b"},
                 {"kineticEnergy",
                  "(m1+m2)*l1^2*a_dot^2/2 + m2*l2^2*b_dot^2/2 + m2*l1*l2*cos(a-b)*a_dot*b_dot"},
                 {"potential", kPotential}});
}

Eigen::MatrixXd massOf(const Coordinates& s, const Eigen::VectorXd& q, double t = 0.0) {
  const int n = s.blocks().nu;
  Eigen::VectorXd data = Eigen::VectorXd::Constant(n * n, 1e99);
  s.M(t, view(q), MassBlocks(data.data(), n, 1));
  return Eigen::Map<const RowMatrix>(data.data(), n, n);
}

Eigen::VectorXd forceOf(const Coordinates& s, const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                        double t = 0.0) {
  Eigen::VectorXd h = Eigen::VectorXd::Constant(q.size(), 1e99);
  s.h(t, view(q), view(u), view(h));
  return h;
}

Eigen::MatrixXd closedMass(const Eigen::VectorXd& q) {
  Eigen::Matrix2d M;
  const double c = kM2 * kL1 * kL2 * std::cos(q[0] - q[1]);
  M << (kM1 + kM2) * kL1 * kL1, c, c, kM2 * kL2 * kL2;
  return M;
}

Eigen::VectorXd closedForce(const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  const double s = kM2 * kL1 * kL2 * std::sin(q[0] - q[1]);
  return Eigen::Vector2d(-s * u[1] * u[1] - (kM1 + kM2) * kG * kL1 * std::sin(q[0]),
                         s * u[0] * u[0] - kM2 * kG * kL2 * std::sin(q[1]));
}

const Eigen::VectorXd kQ = Eigen::Vector2d(0.7, -1.2), kU = Eigen::Vector2d(2.3, -3.1);

void expectNear(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_LE((a - b).lpNorm<Eigen::Infinity>(), tolerance) << a << "\n\n" << b;
}

TEST(Coordinates, DoublePendulumByItsKineticEnergyHasTheClosedFormMAndH) {
  const auto s = doublePendulum();
  EXPECT_FALSE(s->blocks().constantMass);
  expectNear(massOf(*s, kQ), closedMass(kQ), 1e-13);
  expectNear(forceOf(*s, kQ, kU), closedForce(kQ, kU), 1e-11);
  EXPECT_NEAR(s->potentialEnergy(0.0, view(kQ)),
              -(kM1 + kM2) * kG * kL1 * std::cos(0.7) - kM2 * kG * kL2 * std::cos(1.2), 1e-12);
}

TEST(Coordinates, FullAndUpperMassMatrixAgree) {
  const char* const h = "-m2*l1*l2*sin(a-b)*b_dot^2 ; m2*l1*l2*sin(a-b)*a_dot^2";
  const std::string full = "(m1+m2)*l1^2 ; m2*l1*l2*cos(a-b) ; m2*l1*l2*cos(a-b) ; m2*l2^2",
                    upper = "(m1+m2)*l1^2 ; m2*l1*l2*cos(a-b) ; m2*l2^2";
  for (const std::string& M : {full, upper}) {
    const auto s = system({{"q", "a b"}, {"M", M}, {"h", h}, {"potential", kPotential}});
    expectNear(massOf(*s, kQ), closedMass(kQ), 1e-13);
    expectNear(forceOf(*s, kQ, kU), closedForce(kQ, kU), 1e-11);
  }
}

TEST(Coordinates, GyroscopicTermsInHDoNoWork) {
  const char* const h = "-m2*l1*l2*sin(a-b)*b_dot^2 - 0.3*a_dot ; m2*l1*l2*sin(a-b)*a_dot^2";
  const auto s =
      system({{"q", "a b"}, {"M", "(m1+m2)*l1^2 ; m2*l1*l2*cos(a-b) ; m2*l2^2"}, {"h", h}});
  Eigen::VectorXd left(2);
  s->nonPotentialForce(0.0, view(kQ), view(kU), view(left));
  expectNear(left, Eigen::Vector2d(-0.3 * kU[0], 0.0), 1e-12);
}

TEST(Coordinates, DrivenPivotByItsKineticEnergy) {
  // Pendulum whose pivot moves by x = A sin(w t):
  //   T = m/2 ((A w cos wt + l φ̇ cos φ)² + (l φ̇ sin φ)²)  ⇒  m l² φ̈ = m l A w² sin wt cos φ
  const auto s = system(
      {{"q", "phi"},
       {"kineticEnergy", "m/2*((A*w*cos(w*t) + l*phi_dot*cos(phi))^2 + (l*phi_dot*sin(phi))^2)"}},
      {{"m", 1.3}, {"A", 0.2}, {"w", 7.0}, {"l", 0.8}});
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.4);
  const Eigen::VectorXd u = Eigen::VectorXd::Constant(1, 1.7);
  const double t = 0.31;
  EXPECT_NEAR(massOf(*s, q, t)(0, 0), 1.3 * 0.8 * 0.8, 1e-14);
  EXPECT_NEAR(forceOf(*s, q, u, t)[0], 1.3 * 0.8 * 0.2 * 49.0 * std::sin(7.0 * t) * std::cos(0.4),
              1e-12);
}

TEST(Coordinates, ConstantMassIsRecognised) {
  const Given spring{{"q", "x"}, {"M", "2*m1"}, {"h", "-x"}};
  const Given energy{{"q", "x"}, {"kineticEnergy", "m1*x_dot^2"}, {"h", "-x"}};
  EXPECT_TRUE(system(spring)->blocks().constantMass);
  EXPECT_TRUE(system(energy)->blocks().constantMass);
  EXPECT_FALSE(system({{"q", "x"}, {"M", "2 + t"}})->blocks().constantMass);
}

TEST(Coordinates, StiffPartsAreTheDerivativesOfH) {
  const auto s = system(
      {{"q", "a b"}, {"M", "1 ; 0 ; 1"}, {"h", "-2*a_dot*b ; a*b_dot^2"}, {"potential", "a^2*b"}});
  RowMatrix K(2, 2), D(2, 2), expectedK(2, 2), expectedD(2, 2);
  ASSERT_TRUE(s->dh(0.0, view(kQ), view(kU), 0, Block(K.data(), 2, 2), Block(D.data(), 2, 2)));
  expectedK << -2 * kQ[1], -2 * kU[0] - 2 * kQ[0], kU[1] * kU[1] - 2 * kQ[0], 0;
  expectedD << -2 * kQ[1], 0, 0, 2 * kQ[0] * kU[1];
  expectNear(K, expectedK, 1e-13);
  expectNear(D, expectedD, 1e-13);
}

TEST(Coordinates, NamesCoordinatesAndVelocitiesWithTheirUnits) {
  const auto s = system({{"q", "y phi"}, {"units", "m rad"}, {"M", "1;0;1"}, {"q0", "0.1 30deg"}});
  Description d;
  s->describe(d);
  ASSERT_EQ(d.signals.size(), 4u);
  EXPECT_EQ(d.signals[0].name, "y");
  EXPECT_EQ(d.signals[0].unit, Unit::length);
  EXPECT_EQ(d.signals[1].name, "y_dot");
  EXPECT_EQ(d.signals[3].name, "phi_dot");
  EXPECT_EQ(d.signals[3].unit, Unit::angularVelocity);
  Eigen::VectorXd q(2), u(2);
  s->initialState(view(q), view(u));
  EXPECT_NEAR(q[1], std::acos(-1.0) / 6.0, 1e-15);
}

// ---- frames ------------------------------------------------------------------------------------

std::unique_ptr<CoordinateFrame> frame(const Given& given) {
  return std::make_unique<CoordinateFrame>(
      Parameters::of<CoordinateFrame>("CoordinateFrame", "bob", given));
}

/// Frame 0 of a system of two coordinates at t, q, u, with memory for its Jacobians, in which a state
/// before has left numbers.
struct FrameAt {
  std::vector<double> S = std::vector<double>(6, 7.0), R = std::vector<double>(6, 7.0);
  Frame f;
  FrameAt(const Given& given, double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
    Parameters x = Parameters::of<Coordinates>("Coordinates", "toy", {{"q", "a b"}, {"M", "1;0;1"}})
                       .with(frame(given));
    x.symbols = kSymbols;
    new (&f.J_S_I) Mat3X(S.data(), 3, 2);
    new (&f.J_R_I) Mat3X(R.data(), 3, 2);
    Coordinates(x).frame(t, view(q), view(u), 0, f);
  }
};

TEST(Coordinates, FrameOfADoublePendulumOnADrivenPivot) {
  const double t = 0.4, w = 3.0;
  const FrameAt at({{"position", "0.2*sin(3*t) + l1*sin(a) + l2*sin(b) ; 0 ; -l1*cos(a)-l2*cos(b)"},
                    {"angle", "b"},
                    {"axis", "0 -1 0"}},
                   t, kQ, kU);
  const double a = kQ[0], b = kQ[1], p = kU[0], r = kU[1];
  const Vec3 da(kL1 * std::cos(a), 0, kL1 * std::sin(a)),
      db(kL2 * std::cos(b), 0, kL2 * std::sin(b));
  const Vec3 na(-kL1 * std::sin(a), 0, kL1 * std::cos(a)),
      nb(-kL2 * std::sin(b), 0, kL2 * std::cos(b));
  const Vec3 nu(0.2 * w * std::cos(w * t), 0, 0), drive(-0.2 * w * w * std::sin(w * t), 0, 0);
  expectNear(at.f.J_S_I.col(0), da, 1e-14);
  expectNear(at.f.J_S_I.col(1), db, 1e-14);
  expectNear(at.f.nu_S_I, nu, 1e-14);
  expectNear(at.f.v_S_I, da * p + db * r + nu, 1e-13);
  expectNear(at.f.bias_S_I, na * p * p + nb * r * r + drive, 1e-12);
  expectNear(at.f.Omega_I, Vec3(0, -r, 0), 1e-14);
  expectNear(at.f.J_R_I.col(1), Vec3(0, -1, 0), 1e-14);
  expectNear(at.f.bias_R_I, Vec3::Zero(), 1e-14);
  EXPECT_EQ(at.f.block, 0);
  // b turns x towards z.
  expectNear(at.f.A_IK * Vec3::UnitX(), Vec3(std::cos(b), 0, std::sin(b)), 1e-14);
}

TEST(Coordinates, SuccessiveRotationsGiveAngularVelocityAndBias) {
  // z by a, then the turned x by b²: Ω = ȧ e_z + 2 b ḃ R_z(a) e_x.
  const FrameAt at({{"angle", "a ; b^2"}, {"axis", "0 0 1  1 0 0"}}, 0.0, kQ, kU);
  const double a = kQ[0], b = kQ[1], p = kU[0], r = kU[1];
  const Vec3 ez = Vec3::UnitZ(), ex(std::cos(a), std::sin(a), 0);
  expectNear(at.f.Omega_I, p * ez + 2 * b * r * ex, 1e-13);
  expectNear(at.f.J_R_I.col(0), ez, 1e-14);
  expectNear(at.f.J_R_I.col(1), 2 * b * ex, 1e-14);
  expectNear(at.f.bias_R_I, 2 * r * r * ex + 2 * b * r * p * ez.cross(ex), 1e-12);
  expectNear(at.f.A_IK,
             (Eigen::AngleAxisd(a, ez) * Eigen::AngleAxisd(b * b, Vec3::UnitX())).matrix(), 1e-14);
}

TEST(Coordinates, FrameThatNoCoordinateMovesHasNoBlock) {
  const FrameAt at({{"position", "sin(t) ; 0 ; l1"}}, 0.5, kQ, kU);
  EXPECT_EQ(at.f.block, -1);
  expectNear(at.f.v_S_I, Vec3(std::cos(0.5), 0, 0), 1e-15);
  expectNear(at.f.nu_S_I, at.f.v_S_I, 0.0);
}

// ---- messages ----------------------------------------------------------------------------------

std::string messageOf(const Given& given) {
  try {
    system(given);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "no error";
}

void expectMessage(const Given& given, const std::string& part) {
  const std::string message = messageOf(given);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(CoordinatesMessages, NameWhatIsWrong) {
  expectMessage({{"q", "a b"}, {"M", "1;0;0;1"}, {"h", "a ; sinn(b)"}}, "did you mean \"sin\"");
  expectMessage({{"q", "phiM"}, {"M", "1"}, {"h", "phim"}}, "did you mean \"phiM\"");
  expectMessage({{"q", "a b"}, {"M", "1;0"}}, "M has 2 entries, expects 4 (rows) or 3");
  expectMessage({{"q", "a b"}, {"M", "1;0;0.1;1"}}, "M is not symmetric: entry (2, 1) is 0.1");
  expectMessage({{"q", "a"}, {"M", "1 + a_dot"}}, "M depends on t and positions only");
  expectMessage({{"q", "a"}, {"kineticEnergy", "a_dot^4"}}, "not quadratic in a_dot");
  expectMessage({{"q", "a"}}, "give either M or kineticEnergy");
  expectMessage({{"q", "a"}, {"M", "1"}, {"potential", "a_dot"}}, "a potential depends on t");
  expectMessage({{"q", "a"}, {"M", "1"}, {"h", "1;2"}}, "h has 2 formulas for 1 coordinates");
  expectMessage({{"q", "a"}, {"M", "1"}, {"q0", "1 2"}}, "q0 has 2 numbers for 1 coordinates");
  expectMessage({{"q", "g"}, {"M", "1"}}, "has the name of a parameter");
  expectMessage({{"q", "a a_dot"}, {"M", "1;0;1"}}, "\"a_dot\" stands for two things");
  expectMessage({{"q", "2a"}, {"M", "1"}}, "is no name");
  expectMessage({{"q", "t"}, {"M", "1"}}, "is the time");
  expectMessage({{"q", "a"}, {"M", "1"}, {"units", "deg"}}, "m, rad or -");
}

TEST(CoordinatesMessages, ShowEveryFaultOfEveryFormula) {
  const std::string all = messageOf({{"q", "a"}, {"M", "1+"}, {"h", "b"}, {"potential", "c"}});
  EXPECT_NE(all.find("M=\"1+\""), std::string::npos) << all;
  EXPECT_NE(all.find("h=\"b\""), std::string::npos) << all;
  EXPECT_NE(all.find("potential=\"c\""), std::string::npos) << all;
}

TEST(CoordinatesMessages, PointAtTheTokenInsideTheAttribute) {
  // As the loader does: the value begins at line 3, column 8 of the file.
  Parameters x = Parameters::of<Coordinates>("Coordinates", "toy",
                                             {{"q", "a b"}, {"M", "1;0;1"}, {"h", "a ; 2*bb"}});
  for (ParameterValue& v : x.values)
    v.locate = [](std::size_t offset, std::size_t length) {
      Place p;
      p.file = "toy.xml", p.line = 3, p.column = 8 + static_cast<int>(offset);
      p.length = static_cast<int>(length);
      return p;
    };
  try {
    Coordinates s(x);
    FAIL() << "no error";
  } catch (const ModelError& e) {
    ASSERT_EQ(e.diagnostics().size(), 1u);
    EXPECT_EQ(e.diagnostics()[0].place.format(), "toy.xml:3:14");
    EXPECT_EQ(e.diagnostics()[0].place.length, 2);
  }
}

}  // namespace
}  // namespace dynamy
