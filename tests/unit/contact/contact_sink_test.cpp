// Emission of contacts: which are closed, rows of points, W and χ from γ.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {
namespace {

const Unilateral kUnilateral;
const UnilateralCoulomb kCoulomb(0.0, 0.0, 0.5);
const Bilateral kBilateral;

TEST(ContactSink, RecordsAllGapsAndClosesThoseWithinTheTolerance) {
  ContactSet set;
  set.clear();
  ContactSink sink(set, {.gTol = 1e-9});
  sink.element(2);
  EXPECT_FALSE(sink.add(0, 1e-8, kUnilateral, 1));
  EXPECT_TRUE(sink.add(1, 1e-9, kUnilateral, 1));
  EXPECT_TRUE(sink.add(5, -0.1, kCoulomb, 3));
  EXPECT_EQ(set.g, (std::vector<double>{1e-8, 1e-9, -0.1}));
  EXPECT_EQ(set.closedIndex, (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ(set.size(), 2);
  EXPECT_EQ(set.rows(), 4);
  EXPECT_EQ(set.key[1], contactKey(2, 5));
  EXPECT_EQ(set.find(2, 5), 1);
  EXPECT_EQ(set.find(2, 0), -1);
}

TEST(ContactSink, KeepsJointsClosedWhateverTheirError) {
  ContactSet set;
  set.clear();
  ContactSink sink(set, {});
  EXPECT_TRUE(sink.add(0, 0.3, kBilateral, 2));
  EXPECT_EQ(set.rows(), 2);
}

TEST(ContactSink, RefreshesExactlyTheFrozenContacts) {
  const std::vector<ContactKey> frozen = {contactKey(0, 1), contactKey(0, 3)};
  ContactSet set;
  set.clear();
  ContactSink sink(set, {.frozen = frozen, .refresh = true});
  EXPECT_FALSE(sink.add(0, -1.0, kUnilateral, 1));
  EXPECT_TRUE(sink.add(1, 1.0, kUnilateral, 1));
  EXPECT_FALSE(sink.add(2, -1.0, kUnilateral, 1));
  EXPECT_TRUE(sink.add(3, -1.0, kUnilateral, 1));
}

TEST(ContactSet, AddsTheSegmentsAndChiOfGamma) {
  ContactSet set;
  set.clear();
  ContactSink sink(set, {});
  auto rows = sink.add(0, 0.0, kCoulomb, 2);
  rows.segment(BlockPlace{0, 0, 1}) << 1.0, 2.0;
  rows.segment(BlockPlace{3, 4, 2}) << 1.0, -1.0, 0.5, 0.0;
  rows.chi(1) = 10.0;
  const Eigen::VectorXd u{{3.0, 9.0, 9.0, 9.0, 1.0, 2.0}};
  Eigen::VectorXd gamma(2);
  set.gamma({u.data(), 6}, {gamma.data(), 2});
  EXPECT_EQ(gamma[0], 3.0 + 1.0 - 2.0);
  EXPECT_EQ(gamma[1], 6.0 + 0.5 + 10.0);
}

TEST(ContactSet, AddsAbsoluteValuesOfBlocksOfAllSizes) {
  ContactSet set;
  set.clear();
  ContactSink sink(set, {});
  auto rows = sink.add(0, 0.0, kCoulomb, 2);
  rows.segment(BlockPlace{0, 0, 6}) << 1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 0.0, 0.0, -1.0, 0.0, 0.0,
      0.5;
  rows.segment(BlockPlace{1, 6, 2}) << 1.0, -1.0, 0.5, 0.0;
  const Eigen::VectorXd v{{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0}};
  Eigen::VectorXd sum{{100.0, 200.0}};
  set.addAbsolute({v.data(), 8}, sum.data());
  EXPECT_EQ(sum[0], 100.0 + 1.0 + 4.0 + 9.0 + 16.0 + 25.0 + 36.0 + 7.0 + 8.0);
  EXPECT_EQ(sum[1], 200.0 + 3.0 + 3.0 + 3.5);
}

TEST(PointContact, GivesTheRelativeVelocityOfThePointsOfBothBodies) {
  // Body: r = (1, 0, 0), v = (u0, u1, 0), Ω = u2 e_z, velocities u = (1, 2, 3). Wall: moves at
  // (0.5, 0, 0) and turns, both without velocities of its own.
  double J[18] = {};
  Frame body, wall;
  new (&body.J_S_I) Mat3X(J, 3, 3);
  new (&body.J_R_I) Mat3X(J + 9, 3, 3);
  body.J_S_I(0, 0) = body.J_S_I(1, 1) = body.J_R_I(2, 2) = 1.0;
  body.block = 0;
  const Eigen::VectorXd u{{1.0, 2.0, 3.0}};
  body.v_S_I = {1.0, 2.0, 0.0}, body.Omega_I = {0.0, 0.0, 3.0};
  wall.v_S_I = wall.nu_S_I = {0.5, 0.0, 0.0};
  wall.Omega_I = wall.nu_R_I = {0.0, 0.0, -2.0};
  ContactSet set;
  set.clear();
  ContactSink sink(set, {.bias = true});
  auto rows = sink.add(0, 0.0, kCoulomb, 2);
  const Vec3 rhoBody(0.2, -0.1, 0.0), rhoWall(0.0, 0.4, 0.0), n(0.6, 0.8, 0.0), t1(-0.8, 0.6, 0.0);
  pointContact(rows, wall, rhoWall, body, rhoBody, n, t1, Vec3::UnitZ());
  Eigen::VectorXd gamma(2);
  set.gamma({u.data(), 3}, {gamma.data(), 2});
  const Vec3 relative = body.velocity(rhoBody) - wall.velocity(rhoWall);
  EXPECT_NEAR(gamma[0], n.dot(relative), 1e-15);  // sums of five products of size 1
  EXPECT_NEAR(gamma[1], t1.dot(relative), 1e-15);
  EXPECT_EQ(set.segment.size(), 1u);
  // Points fixed to their bodies: γ̇ = n·(Ω×(Ω×ρ))_B − the same of A, at u̇ = 0 and fixed n.
  const Vec3 a = -9.0 * rhoBody + 4.0 * rhoWall;
  EXPECT_NEAR(set.bias[0], n.dot(a), 1e-14);
}

/// Point (x, y).
class Point final : public PartialMechanicalSystem {
 public:
  explicit Point(const Parameters& x) : PartialMechanicalSystem(x) {}
  static void declare(Attributes&) {}
  Blocks blocks() const override { return {.nq = 2, .nu = 2, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q << 2.0, 3.0, u << 5.0, 7.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }
};

/// g = x y − t², γ_N = y u₀ + x u₁ − 2t, γ_T = x u₀ + 4.
class Curved final : public SimpleContact {
 public:
  explicit Curved(const Parameters& x) : SimpleContact(x) {}
  static void declare(Attributes&) {}
  int rows() const override { return 2; }
  double g(double t, ConstVec q) const override { return q[0] * q[1] - t * t; }
  void gamma(double t, ConstVec q, ConstVec u, Vec gamma) const override {
    gamma[0] = q[1] * u[0] + q[0] * u[1] - 2.0 * t;
    gamma[1] = q[0] * u[0] + 4.0;
  }
};

struct CurvedScene {
  explicit CurvedScene(bool bias) {
    model.add<Point>("p", {});
    model.add(std::make_unique<Curved>(
        Parameters::of<Curved>("Curved", "c", {{"on", "p"}})
            .with<SetValuedForceLaw>(std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3))));
    model.build();
    const State x = model.initialState();
    kinematics.resize(model.topology());
    kinematics.evaluate(model.topology(), 1.5, view(x.q), view(x.u));
    set.clear();
    ContactSink sink(set, {.gTol = 10.0, .bias = bias});
    model.contacts()[0]->contacts(kinematics, sink);
  }
  Model model;
  Kinematics kinematics;
  ContactSet set;
};

TEST(SimpleContact, TakesWAndChiFromGamma) {
  const CurvedScene s(false);
  ASSERT_EQ(s.set.rows(), 2);
  EXPECT_EQ(s.set.g[0], 6.0 - 2.25);
  EXPECT_EQ(s.set.W, (std::vector<double>{3.0, 2.0, 2.0, 0.0}));
  EXPECT_EQ(s.set.chi, (std::vector<double>{-3.0, 4.0}));
}

TEST(SimpleContact, TakesTheBiasFromDifferencesAlongTheMotion) {
  // dγ_N/dt = 2 u₀u₁ − 2 = 68, dγ_T/dt = u₀² = 25 at u̇ = 0; quadratic: only rounding, ε·60/d with
  // d = 1e-3/8.
  const CurvedScene s(true);
  EXPECT_NEAR(s.set.bias[0], 68.0, 1e-9);
  EXPECT_NEAR(s.set.bias[1], 25.0, 1e-9);
}

/// The signals of contact 0 of element 0 with given Λ and γ^E.
double signal(const std::string& name, const Eigen::VectorXd& Lambda,
              const Eigen::VectorXd& gammaE) {
  ContactSet set;
  set.clear();
  ContactSink sink(set, {});
  sink.add(0, -0.25, kCoulomb, 2);
  Description d;
  describeContact(d, 0, 2, kCoulomb);
  SignalView v;
  v.contacts = &set, v.element = 0, v.dt = 0.5;
  new (&v.Lambda) ConstVec(Lambda.data(), Lambda.size());
  new (&v.gammaE) ConstVec(gammaE.data(), gammaE.size());
  for (const Signal& s : d.signals)
    if (s.name == name) return s.value(v);
  return std::nan("");
}

TEST(ContactSignals, GiveGapVelocitiesAndForces) {
  const Eigen::VectorXd Lambda{{2.0, -1.0}}, gammaE{{0.0, 0.4}};
  EXPECT_EQ(signal("g", Lambda, gammaE), -0.25);
  EXPECT_EQ(signal("gamma_T", Lambda, gammaE), 0.4);
  EXPECT_EQ(signal("Lambda_N", Lambda, gammaE), 2.0);
  EXPECT_EQ(signal("lambda_T", Lambda, gammaE), -2.0);
}

TEST(ContactSignals, TellTheStatusInAnyUnitOfMass) {
  for (const double mass : {1e-6, 1.0, 1e6}) {
    const auto status = [mass](double N, double T, double gN, double gT) {
      return static_cast<Status>(static_cast<int>(
          signal("status", mass * Eigen::VectorXd{{N, T}}, Eigen::VectorXd{{gN, gT}})));
    };
    EXPECT_EQ(status(2.0, -1.0, 0.0, 0.4), Status::slip);
    EXPECT_EQ(status(2.0, 0.3, 0.0, 0.0), Status::stick);
    EXPECT_EQ(status(0.0, 0.0, 0.5, 0.4), Status::separating);
    EXPECT_EQ(status(2.0, -1.0, 0.8, 0.4), Status::slip);  // rebound with ε > 0
  }
}

}  // namespace
}  // namespace dynamy
