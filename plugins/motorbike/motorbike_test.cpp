// Compares the motorbike with the published benchmark bicycle, closed forms and ballistics.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/simulation/linear/linearisation.hpp>
#include <dynamy/testing/check_element.hpp>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

Linearisation eigenvalues(const std::string& file, const Overrides& set) {
  LoadedModel loaded(file, set);
  return linearise(loaded.model(), loaded.model().initialState());
}

/// Compares four eigenvalues in the order of growing real part: a real one, the weave pair, a real
/// one. The expected figures have 12 digits.
void expectEigenvalues(const Linearisation& l, double fast, std::complex<double> weave, double slow,
                       double tolerance) {
  EXPECT_EQ(l.zeros, 6);  // position, heading, angles of both wheels, speed
  ASSERT_EQ(l.eigenvalues.size(), 4);
  EXPECT_NEAR(l.eigenvalues[0].real(), fast, tolerance);
  EXPECT_NEAR(l.eigenvalues[1].real(), weave.real(), tolerance);
  EXPECT_NEAR(l.eigenvalues[1].imag(), weave.imag(), tolerance);
  EXPECT_NEAR(l.eigenvalues[3].real(), slow, tolerance);
}

TEST(Motorbike, BenchmarkBicycleHasThePublishedEigenvalues) {
  // Meijaard, Papadopoulos, Ruina, Schwab 2007, table 2, at 5 m/s. Tolerance: half of the last
  // digit given, 5e-11, and the error of differences, 1e-11.
  const Linearisation l =
      eigenvalues("models/benchmark_bicycle.xml", {{"v", "5"}, {"disturbance", "0"}});
  expectEigenvalues(l, -14.0783896928, {-0.775341882196, 4.46486771379}, -0.322866429004, 1e-10);
}

TEST(Motorbike, BenchmarkBicycleIsStableBetweenWeaveAndCapsize) {
  // The limits are 4.2923825363 and 6.0242620154 m/s; the number of growing motions is counted some
  // 1e-9 m/s below and above them.
  const auto growing = [](const char* v) {
    return eigenvalues("models/benchmark_bicycle.xml", {{"v", v}, {"disturbance", "0"}}).growing();
  };
  EXPECT_EQ(growing("4.292382535"), 2);
  EXPECT_EQ(growing("4.292382538"), 0);
  EXPECT_EQ(growing("6.024262000"), 0);
  EXPECT_EQ(growing("6.024262030"), 1);  // its real part is 4e-10
}

TEST(Motorbike, ItsOwnEigenvaluesAreThoseOfTheLinearEquations) {
  // M q'' + v C1 q' + (g K0 + v² K2) q = 0 with the coefficients of Meijaard et al., appendix A.
  // The tolerance is larger than for the benchmark, since entries of A are up to 4 times as large.
  expectEigenvalues(eigenvalues("models/motorbike.xml", {{"push", "0"}, {"v", "8"}}), -23.115275125,
                    {-2.02925695381, 4.49726353297}, -0.461457263449, 6e-10);
  expectEigenvalues(eigenvalues("models/motorbike.xml", {{"push", "0"}, {"v", "20"}}),
                    -52.9209969751, {-8.13019457978, 13.5706459266}, 0.0932703945862, 6e-10);
}

TEST(Motorbike, WheelsCarryTheStaticLoads) {
  const Linearisation l = eigenvalues("models/motorbike.xml", {{"push", "0"}});
  ASSERT_EQ(l.contacts.size(), 2u);
  // N_f = g Σ m x/w; N_r the rest. Rounding of 3000 N.
  EXPECT_NEAR(l.contacts[0].lambda[0], 9.81 * (282.0 - 165.88 / 1.4), 1e-9);
  EXPECT_NEAR(l.contacts[1].lambda[0], 9.81 * 165.88 / 1.4, 1e-9);
  for (const HeldMotion::Contact& c : l.contacts) EXPECT_FALSE(c.slips);
}

TEST(Motorbike, GrowthOfASmallDisturbanceIsThatOfTheUnstableEigenvalue) {
  // The bicycle runs above its capsize speed. After 8 s only capsize is left: weave has decayed to
  // e^(−2.69·8) = 4e-10. Tolerance: for a lean of 2e-3 the nonlinear terms are its square, 4e-6;
  // the tolerance of the run, 1e-9, is 5e-7 of the lean.
  const auto leanAt = [](double t) {
    LoadedModel loaded("models/benchmark_bicycle.xml", {{"v", "8"}, {"disturbance", "1e-2"}});
    loaded.model().simulation.until = t;
    Simulation simulation(loaded.model());
    EXPECT_EQ(simulation.run().ended, RunReport::Ended::finished);
    const double* p = simulation.state().q.data() + 3;
    return std::asin(2.0 * (p[2] * p[3] + p[0] * p[1]));
  };
  const Linearisation l =
      eigenvalues("models/benchmark_bicycle.xml", {{"v", "8"}, {"disturbance", "0"}});
  const double growth = l.eigenvalues[3].real();
  EXPECT_GT(growth, 0.1);
  EXPECT_NEAR(std::log(leanAt(10.0) / leanAt(8.0)) / 2.0, growth, 5e-6);
}

TEST(Motorbike, SteadyTurnIsFoundAndBalanced) {
  // The start is rough: a lean of 0.1 rad, and steer and yaw rate of a circle of radius
  // v²/(g tan φ).
  const double lean = 0.1, v = 6.1, g = 9.81, w = 1.02;
  LoadedModel loaded("models/benchmark_bicycle.xml", {{"v", "6.1"}, {"disturbance", "0"}});
  Model& model = loaded.model();
  const double yaw = g * std::tan(lean) / v;
  State x = model.initialState();
  x.q[3] = std::cos(0.5 * lean), x.q[4] = std::sin(0.5 * lean);
  x.q[8] = -w * yaw / v / std::cos(0.314159265358979);
  x.u[4] = -yaw * std::sin(lean), x.u[5] = -yaw * std::cos(lean);
  const Linearisation l = linearise(model, x, {.near = 0.02});

  // The forces of the two contacts fulfil Σ F = m ω × v_S, Σ N = m g; rounding of 2000 N.
  const Eigen::Quaterniond p(l.at.q[3], l.at.q[4], l.at.q[5], l.at.q[6]);
  const Vec3 omega = p * Vec3(l.at.u.segment<3>(3)), v_B = p * Vec3(l.at.u.head<3>());
  EXPECT_LE(omega.head<2>().norm(), 1e-10);
  const SignalView view{.q = ConstVec(l.at.q.data(), l.at.q.size())};
  const Vec3 S(model.signal("bike.Sx")->signal.value(view),
               model.signal("bike.Sy")->signal.value(view), 0.0);
  const Vec3 arm(S.x() - l.at.q[0], S.y() - l.at.q[1], 0.0);
  const Vec3 needed = 94.0 * omega.cross(v_B + omega.cross(arm));
  ASSERT_EQ(l.contacts.size(), 2u);
  double N = 0.0;
  Eigen::Vector2d F = Eigen::Vector2d::Zero();
  for (const HeldMotion::Contact& c : l.contacts)
    N += c.lambda[0], F += Eigen::Vector2d(c.lambda[1], c.lambda[2]);
  EXPECT_NEAR(N, 94.0 * g, 1e-7);
  EXPECT_NEAR(F.norm(), needed.head<2>().norm(), 1e-7);
  // Seen from the vehicle, a displaced circle rotates once per turn: eigenvalues ± i ω.
  bool round = false;
  for (const std::complex<double>& z : l.eigenvalues)
    round = round || std::abs(z - std::complex<double>(0.0, std::abs(omega.z()))) < 1e-9;
  EXPECT_TRUE(round);
}

TEST(Motorbike, EveryEntryOfItsSystemAgreesWithDifferences) {
  for (const char* file : {"models/motorbike.xml", "tests/data/motorbike/jump.xml"}) {
    LoadedModel loaded(file);
    for (const auto& system : loaded.model().systems()) {
      const Verdict verdict = checkSystem(*system);
      EXPECT_TRUE(verdict) << file << '\n' << verdict.message();
    }
  }
}

TEST(Motorbike, InTheAirOnlyTheWeightActs) {
  // For the centre of mass of the four bodies Sz(t+d) − 2 Sz(t) + Sz(t−d) = −g d², and Sx moves
  // uniformly. Both wheels are in the air from 0.9 to 1.4 s.
  LoadedModel loaded("tests/data/motorbike/jump.xml");
  Model& model = loaded.model();
  const auto centre = [&model](const HandStepper& s) {
    const SignalView view{.q = ConstVec(s.x.q.data(), s.x.q.size())};
    Eigen::Vector2d out;
    out << model.signal("bike.Sx")->signal.value(view), model.signal("bike.Sz")->signal.value(view);
    return out;
  };
  HandStepper s(model);
  Eigen::Vector2d at[3];
  for (int i = 0, k = 0; i <= 1300; ++i) {
    if (i == 900 || i == 1100 || i == 1300) at[k++] = centre(s);
    s.step(1e-3);
  }
  const Eigen::Vector2d second = at[2] - 2.0 * at[1] + at[0];
  // The scheme uses the mass matrix at the beginning of each step, with an error of order 2:
  // (1 ms)² × 10 1/s² × 13 m.
  EXPECT_NEAR(second[0], 0.0, 1.3e-4);
  EXPECT_NEAR(second[1], -9.81 * 0.2 * 0.2, 1.3e-4);
}

/// Records impulses of road and ramp and positions of the centre of mass, along x and z, for all
/// steps.
class Ride final : public Observer {
 public:
  Ride() : Observer(Parameters()) {}
  void step(const StepView& v) override {
    const ContactSet& c = *v.system.problem().contacts;
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < c.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double* Lambda = v.Lambda.data() + c.row0[at];
      const Vec3 F = Lambda[0] * c.places.normal[at] + Lambda[1] * c.places.t1[at] +
                     Lambda[2] * c.places.t2[at];
      sum += c.places.normal[at].z() > 0.0 ? F : Vec3(-F);  // on the upper body
    }
    const SignalView at{.q = ConstVec(v.after.q.data(), v.after.q.size())};
    impulse_.push_back(Eigen::Vector2d(sum.x(), sum.z()));
    place_.emplace_back(v.model.signal("bike.Sx")->signal.value(at),
                        v.model.signal("bike.Sz")->signal.value(at));
  }
  /// Impulse of the contacts from step a to step b minus the change of m (v + g t). The velocity v
  /// of the centre of mass comes from differences of positions, exact for uniform motion and
  /// parabolas.
  Eigen::Vector2d missing(std::size_t a, std::size_t b, double dt) const {
    const auto v = [&](std::size_t k) {
      return Eigen::Vector2d((place_[k + 100] - place_[k - 100]) / (200.0 * dt));
    };
    Eigen::Vector2d given = Eigen::Vector2d::Zero();
    for (std::size_t k = a + 1; k <= b; ++k) given += impulse_[k];
    return given -
           282.0 * (v(b) - v(a) + Eigen::Vector2d(0.0, 9.81 * static_cast<double>(b - a) * dt));
  }

 private:
  std::vector<Eigen::Vector2d> impulse_, place_;
};

TEST(Motorbike, MomentumOverRampAndLandingIsThatOfWeightAndRoad) {
  // From steady riding at 0.2 s to flight at 1.2 s, and then until it rolls on its springs at 2.8
  // s. Tolerances: the weight gives 2766 N s in a second. Since the scheme uses the mass matrix at
  // the start of each step, 32, 9.7 and 0.8 N s of it are missing at 1, 0.5 and 0.25 ms while the
  // wheels hit the road at 6 m/s, and less than a tenth of that before.
  LoadedModel loaded("tests/data/motorbike/jump.xml");
  Simulation simulation(loaded.model());
  Ride ride;
  simulation.observe(ride);
  simulation.run();
  const double dt = 5e-4;
  const auto at = [dt](double t) { return static_cast<std::size_t>(std::lround(t / dt)) - 1; };
  for (const auto& [from, to] : {std::pair{0.2, 1.2}, std::pair{1.2, 2.8}}) {
    const Eigen::Vector2d off = ride.missing(at(from), at(to), dt);
    const double missed = from < 1.0 ? 1.0 : 10.0;
    EXPECT_NEAR(off[0], 0.0, missed) << from;
    EXPECT_NEAR(off[1], 0.0, missed) << from;
  }
}

TEST(Motorbike, OnAnOrdinaryRoadTheFrontWheelSlipsBeforeTheRearOneLifts) {
  // µ = 1.3 < (w − x_T)/h = 1.3787.
  LoadedModel loaded("tests/data/motorbike/stoppie.xml", {{"mu", "1.3"}});
  HandStepper s(loaded.model());
  const double slip = 1.36;  // front slips at 1.3567 s, by the closed form of motorbike_braking.xml
  while (s.x.t < slip) s.step(slip - s.x.t);
  MechanicalSystem system = loaded.model().mechanicalSystem();
  system.gTol(1e-9);
  const ContactSet& c = system.evaluate(s.x).contacts;
  int wheels = 0;
  Eigen::VectorXd gamma(c.rows());
  c.gamma(view(std::as_const(s.x.u)), view(gamma));
  for (int i = 0; i < c.size(); ++i) {
    if (!c.law[static_cast<std::size_t>(i)]->unilateral()) continue;
    ++wheels;
    const double slipSpeed = std::abs(gamma[c.row0[static_cast<std::size_t>(i)] + 1]);
    EXPECT_EQ(slipSpeed > 1e-4, wheels == 2) << "wheel " << wheels;  // rear first
  }
  EXPECT_EQ(wheels, 2);
}

TEST(Motorbike, ControlsNeedAMotorbike) {
  Registry registry;
  PluginLoader plugins({std::filesystem::path(DYNAMY_BINARY_DIR) / "lib" / "dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, registry);
  try {
    loadModelText(
        "<dynamy version=\"1\"><plugin library=\"motorbike\"/><systems><PointMass name=\"m\" "
        "mass=\"1\"/></systems><forces><RiderSteering on=\"m\"/></forces></dynamy>",
        "wrong.xml", registry, plugins);
    FAIL();
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("\"m\" is no Motorbike"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace dynamy
