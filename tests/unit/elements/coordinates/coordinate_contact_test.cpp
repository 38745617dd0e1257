// Contacts written as formulas against closed forms; tolerances as in coordinates_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/coordinates/coordinate_contact.hpp>
#include <dynamy_elements/coordinates/coordinates.hpp>

namespace dynamy {
namespace {

using Given = std::vector<GivenValue>;
using Symbols = std::vector<std::pair<std::string, double>>;

/// One contact on a system of its own, evaluated once.
struct Evaluated {
  std::unique_ptr<Coordinates> system;
  std::unique_ptr<CoordinateContact> contact;
  ContactSet set;
  Kinematics kinematics;

  Evaluated(const Given& coordinates, const Given& given, std::unique_ptr<SetValuedForceLaw> law,
            const Symbols& symbols = {}) {
    Parameters s = Parameters::of<Coordinates>("Coordinates", "toy", coordinates);
    s.symbols = symbols;
    system = std::make_unique<Coordinates>(s);
    Given all = given;
    all.emplace_back("on", "toy");
    Parameters c = Parameters::of<CoordinateContact>("CoordinateContact", "stop", all);
    if (law) c.children.push_back({Kind::law, std::move(law)});
    c.symbols = symbols;
    contact = std::make_unique<CoordinateContact>(c);
  }
  void at(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
    Topology topology({system.get()});
    contact->connect(topology);
    kinematics.resize(topology);
    kinematics.evaluate(topology, t, view(q), view(u));
    set.clear();
    const ContactRequest request{1e9, true, {}, false};
    ContactSink sink(set, request);
    sink.element(0);
    contact->contacts(kinematics, sink);
  }
};

const Given kTwo{{"q", "x phi"}, {"M", "1;0;1"}};
const Eigen::VectorXd kTwoQ = Eigen::Vector2d(0.3, 0.8), kTwoU = Eigen::Vector2d(-1.1, 2.4);

std::unique_ptr<SetValuedForceLaw> coulomb() {
  return std::make_unique<UnilateralCoulomb>(0.5, 0.0, 0.3);
}

TEST(CoordinateContact, NormalRowIsTheGradientOfTheGap) {
  // g = d + A sin 5t − x − l sin φ
  Evaluated e(kTwo, {{"gap", "d + 0.1*sin(5*t) - x - l*sin(phi)"}}, nullptr,
              {{"d", 2.0}, {"l", 0.7}});
  const double t = 0.2, s = std::sin(0.8), c = std::cos(0.8);
  e.at(t, kTwoQ, kTwoU);
  ASSERT_EQ(e.set.size(), 1);
  ASSERT_EQ(e.set.rows(), 1);
  EXPECT_NEAR(e.set.g[0], 2.0 + 0.1 * std::sin(1.0) - 0.3 - 0.7 * s, 1e-14);
  EXPECT_NEAR(e.set.W[0], -1.0, 1e-15);
  EXPECT_NEAR(e.set.W[1], -0.7 * c, 1e-15);
  EXPECT_NEAR(e.set.chi[0], 0.5 * std::cos(1.0), 1e-15);
  EXPECT_NEAR(e.set.bias[0], -2.5 * std::sin(1.0) + 0.7 * s * 2.4 * 2.4, 1e-13);
}

TEST(CoordinateContact, SlipDirectionsAreTheTangentialRows) {
  Evaluated e(kTwo, {{"gap", "x"}, {"slip", "1 ; cos(phi) | 0 ; x"}}, coulomb());
  e.at(0.0, kTwoQ, kTwoU);
  ASSERT_EQ(e.set.rows(), 3);
  const std::vector<double> expected{1, 0, 1, std::cos(0.8), 0, 0.3};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(e.set.W[i], expected[i], 1e-15) << i;
  EXPECT_NEAR(e.set.bias[1], -std::sin(0.8) * 2.4 * 2.4, 1e-14);
  EXPECT_NEAR(e.set.bias[2], -1.1 * 2.4, 1e-14);
}

TEST(CoordinateContact, SlipVelocityGivesTheSameRowAndTheBeltSpeed) {
  Evaluated e(kTwo, {{"gap", "x"}, {"slipVelocity", "x_dot + cos(phi)*phi_dot - 3*t"}}, coulomb());
  e.at(0.5, kTwoQ, kTwoU);
  ASSERT_EQ(e.set.rows(), 2);
  EXPECT_NEAR(e.set.W[2], 1.0, 1e-15);
  EXPECT_NEAR(e.set.W[3], std::cos(0.8), 1e-15);
  EXPECT_NEAR(e.set.chi[1], -1.5, 1e-14);
  EXPECT_NEAR(e.set.bias[1], -std::sin(0.8) * 2.4 * 2.4 - 3.0, 1e-14);
}

TEST(CoordinateContact, IsDrawnWhereItsFormulasSay) {
  Evaluated e(kTwo,
              {{"gap", "x"},
               {"slip", "1; cos(phi)"},
               {"drawnAt", "x; 0; 2 + l*sin(phi)"},
               {"drawnNormal", "0 0 2"},
               {"drawnAlong", "1 0 5"}},
              coulomb(), {{"l", 0.7}});
  e.at(0.0, kTwoQ, kTwoU);
  EXPECT_LT((e.set.places.point[0] - Vec3(0.3, 0.0, 2.0 + 0.7 * std::sin(0.8))).norm(), 1e-15);
  EXPECT_EQ(e.set.places.normal[0], Vec3::UnitZ());
  EXPECT_LT((e.set.places.t1[0] - Vec3::UnitX()).norm(), 1e-15);  // across the normal
  EXPECT_LT((e.set.places.t2[0] - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_THROW(Evaluated(kTwo, {{"gap", "x"}, {"drawnAt", "x; 0"}}, nullptr), ModelError);
}

TEST(CoordinateContact, OpenContactLeavesOnlyItsGap) {
  Evaluated e(kTwo, {{"gap", "x + 1e10"}}, nullptr);
  e.at(0.0, kTwoQ, kTwoU);
  EXPECT_EQ(e.set.size(), 0);
  ASSERT_EQ(e.set.g.size(), 1u);
}

TEST(CoordinateContact, WorksWithoutGapForLawsThatAlwaysAct) {
  Evaluated e(kTwo, {{"slipVelocity", "x_dot - 2"}}, std::make_unique<GivenFriction>(1.0, 1.0));
  e.at(0.0, kTwoQ, kTwoU);
  ASSERT_EQ(e.set.rows(), 1);
  EXPECT_NEAR(e.set.W[0], 1.0, 0.0);
  EXPECT_NEAR(e.set.chi[0], -2.0, 1e-15);
}

TEST(CoordinateContact, WoodpeckerHasThePublishedGapsAndDirections) {
  const Symbols lengths{
      {"lM", 0.010}, {"lG", 0.015}, {"lS", 0.0201}, {"hS", 0.020}, {"r0", 0.0025}};
  Evaluated e({{"q", "y phiM phiS"}, {"M", "1;0;0;1;0;1"}},
              {{"gap", "lM+lG-lS-r0-hS*phiS"}, {"slip", "1 ; lM ; lG-lS"}}, coulomb(), lengths);
  e.at(0.0, Eigen::Vector3d(0, 0, 0.1), Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(e.set.g[0], 0.0004, 1e-16);  // closes at φ_S = 0.12
  const std::vector<double> expected{0, 0, -0.02, 1, 0.01, -0.0051};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(e.set.W[i], expected[i], 1e-17) << i;
}

// ---- messages ----------------------------------------------------------------------------------

void expectContactMessage(const Given& given, const std::string& part,
                          std::unique_ptr<SetValuedForceLaw> law = nullptr) {
  std::string message = "no error";
  try {
    Evaluated e(kTwo, given, std::move(law));
    e.at(0.0, kTwoQ, kTwoU);
  } catch (const ModelError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(CoordinateContactMessages, NameWhatIsWrong) {
  expectContactMessage({{"gap", "x - phy"}}, "did you mean \"phi\"");
  expectContactMessage({{"gap", "x_dot"}}, "a gap depends on t and positions only");
  expectContactMessage({{"gap", "x"}, {"slip", "1"}},
                       "expects 2 components for each slip direction");
  expectContactMessage({{"gap", "x"}, {"slip", "1 ; 2 | 3"}}, "directions are separated by |");
  expectContactMessage({{"gap", "x"}, {"slip", "1 ; x_dot"}}, "slipVelocity takes a formula");
  expectContactMessage({{"gap", "x"}, {"slipVelocity", "x_dot^2"}},
                       "must be affine in the velocities");
  expectContactMessage({{"gap", "x"}, {"slip", "1;0"}, {"slipVelocity", "x_dot"}}, "both given");
  expectContactMessage({{"slip", "1;0"}}, "the gap is missing");
  expectContactMessage({{"gap", "x"}}, "no direction in which the friction could act", coulomb());
}

}  // namespace
}  // namespace dynamy
