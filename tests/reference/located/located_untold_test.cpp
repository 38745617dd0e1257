// Runs to a tolerance of elements of users that tell gaps and directions and no bias (theory 52.4).
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <reference/located/located_run.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

/// A point in the round: inside (side 1) or outside (−1) of a circle or, of a system with three
/// coordinates, of a sphere of radius 1 m. Rows normal and tangents; the bias as a template.
template <bool kTells>
class Round final : public NonSmoothElement {
 public:
  static void declare(Attributes& a) {
    a.reference("on", "system", "the point");
    a.optional("side", Unit::none, 1.0, "1: inside, -1: outside");
    a.child(Kind::law, 1, 1, "law of the contact");
  }
  explicit Round(const Parameters& x)
      : NonSmoothElement(x),
        on_(x["on"].text),
        law_(x.takeOne<SetValuedForceLaw>()),
        side_(x["side"]) {}
  void connect(Topology& topology) override { system_ = topology.system(on_, *this); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    const ConstVec q = k.q(system_), u = k.u(system_);
    const int n = system_.nq;
    auto rows = sink.add(0, side_ * (1.0 - q.norm()), *law_, n);
    if (!rows) return;
    Block W = rows.segment(system_);
    const Eigen::Matrix3d D = directions(q);
    for (int r = 0; r < rows.dim(); ++r)
      for (int j = 0; j < n; ++j) W(r, j) = D(r, j);
    if (!kTells || !rows.wantsBias()) return;
    // Differences to sixth order of Wᵀ along the motion: 1e-12.
    constexpr double kStep = 3e-3, kWeight[] = {0.75, -0.15, 1.0 / 60.0};
    for (int p = 0; p < 3; ++p) {
      const Eigen::VectorXd d = (p + 1) * kStep * u;
      const Eigen::Matrix3d change = kWeight[p] / kStep * (directions(q + d) - directions(q - d));
      for (int r = 0; r < rows.dim(); ++r)
        for (int j = 0; j < n; ++j) rows.bias(r) += change(r, j) * u[j];
    }
  }
  void describe(Description& d) const override {
    describeContact(d, 0, law_->dim(system_.nq), *law_);
  }

 private:
  Eigen::Matrix3d directions(const Eigen::VectorXd& q) const {
    Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
    const double length = q.norm();
    if (q.size() == 2) {
      D.block<1, 2>(0, 0) = -side_ / length * q.transpose();
      D.block<1, 2>(1, 0) << -q[1] / length, q[0] / length;
      return D;
    }
    const Eigen::Vector3d n = -side_ / length * q.head<3>();
    const Eigen::Vector3d t = Eigen::Vector3d::UnitX().cross(n).normalized();
    D << n.transpose(), t.transpose(), n.cross(t).transpose();
    return D;
  }
  std::string on_;
  std::unique_ptr<SetValuedForceLaw> law_;
  SystemHandle system_;
  double side_;
};

void roundTypes(Registry& r) { r.add<Round<true>>("ToldRound"), r.add<Round<false>>("BareRound"); }

std::string number(double x) { return numberText(x); }

/// A point of 1 kg at angle `phi` from the bottom with velocity `v` along the circle.
std::string onCircle(const std::string& type, double phi, double v, const std::string& law,
                     double side = 1.0) {
  return "<dynamy version=\"1\"><systems><Coordinates name=\"bead\" q=\"x z\" units=\"m m\" q0=\"" +
         number(std::sin(phi)) + " " + number(-std::cos(phi)) + "\" u0=\"" +
         number(v * std::cos(phi)) + " " + number(v * std::sin(phi)) +
         "\" M=\"1 ; 0 ; 1\" potential=\"9.81*z\"/></systems><elements><" + type +
         " name=\"round\" on=\"bead\" side=\"" + number(side) + "\">" + law + "</" + type +
         "></elements><simulation until=\"1\" step=\"1\"/></dynamy>";
}

double angle(const State& x) { return std::atan2(x.q[0], -x.q[1]); }

/// Half the square of the speed at `phi`, let go at `from` inside with friction:
/// dw/dφ = −g (sin φ + μ cos φ) − 2μ w.
double halfSquare(double mu, double from, double phi) {
  const double c = kG / (1.0 + 4.0 * mu * mu), a = -3.0 * mu * c, b = (1.0 - 2.0 * mu * mu) * c;
  const auto forced = [&](double x) { return a * std::sin(x) + b * std::cos(x); };
  return forced(phi) - forced(from) * std::exp(-2.0 * mu * (phi - from));
}

TEST(LocatedUntold, ABeadComesToRestWhereTheClosedFormSays) {
  constexpr double kMu = 0.4, kFrom = -1.2;
  double low = 0.0, high = 1.2;  // it stops behind the bottom
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (halfSquare(kMu, kFrom, middle) > 0.0 ? low : high) = middle;
  }
  ASSERT_LT(std::tan(low), kMu);  // and stays there
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    LocatedRun bead(onCircle("BareRound", kFrom, 0.0, "<UnilateralCoulomb mu=\"0.4\"/>"), tolerance,
                    3.0, {}, roundTypes);
    ASSERT_EQ(bead.run().ended, RunReport::Ended::finished) << bead.report().reason;
    // A slip of 1 m in a second: the errors of its steps are within ten tolerances (theory 50.6).
    EXPECT_NEAR(angle(bead.state()), low, 10.0 * tolerance) << tolerance;
    EXPECT_NEAR(bead.state().q.norm(), 1.0, tolerance);
    EXPECT_LT(bead.state().u.norm(), 1e-15);  // rounding
    EXPECT_EQ(bead.report().located.undecided, 0);
    RecordProperty("evaluations " + number(tolerance),
                   std::to_string(bead.report().cost.evaluations));
  }
}

TEST(LocatedUntold, ABeadStaysInALoopThatItsWeightAloneWouldLeave) {
  // At the top, with v² = 1.5 g: decided with forces that the turn of the row has a part in.
  LocatedRun bead(onCircle("BareRound", M_PI, std::sqrt(1.5 * 9.81), "<Unilateral/>"), 1e-9, 2.0,
                  {}, roundTypes);
  ASSERT_EQ(bead.run().ended, RunReport::Ended::finished) << bead.report().reason;
  EXPECT_TRUE(bead.changes("round", Status::open).empty());
  const State& x = bead.state();
  EXPECT_NEAR(x.q.norm(), 1.0, 1e-9);
  // Energy; errors of some 40 steps of at most 1e-9 each, at speeds of 8 m/s.
  EXPECT_NEAR(0.5 * x.u.squaredNorm() + 9.81 * x.q[1], 1.75 * 9.81, 1e-6);
}

TEST(LocatedUntold, ABeadLeavesASphereAtTwoThirdsOfItsHeight) {
  constexpr double kSpeed = 0.5, kTolerance = 1e-9;
  // At z = 2/3 + v²/(3g), with the speed √(gz), after ∫ dφ/√(v² + 2g(1 − cos φ)).
  const double z = 2.0 / 3.0 + kSpeed * kSpeed / (3.0 * kG), v = std::sqrt(kG * z);
  constexpr int kPieces = 200000;  // the midpoint rule: 1e-12
  double leaves = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const double d = std::acos(z) / kPieces, phi = (i + 0.5) * d;
    leaves += d / std::sqrt(kSpeed * kSpeed + 2.0 * kG * (1.0 - std::cos(phi)));
  }
  LocatedRun bead(onCircle("BareRound", M_PI, kSpeed, "<Unilateral/>", -1.0), kTolerance, 1.0, {},
                  roundTypes);
  ASSERT_EQ(bead.run().ended, RunReport::Ended::finished) << bead.report().reason;
  const auto left = bead.changes("round", Status::open);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_NEAR(left[0], leaves, 1e-6);  // the gap opens with the third power of what it is late
  const double fell = 1.0 - leaves, up = -v * std::sqrt(1.0 - z * z);
  const State& x = bead.state();
  // Ten tolerances of the speed at the start, which the fall amplifies: by 1/(√g v), 0.64 s, times
  // 4.3 m/s in positions, times g in speeds.
  EXPECT_NEAR(x.q[1], z + up * fell - 0.5 * kG * fell * fell, 28.0 * kTolerance);
  EXPECT_NEAR(x.u[1], up - kG * fell, 63.0 * kTolerance);
  EXPECT_NEAR(std::abs(x.u[0]), v * z, 10.0 * kTolerance);
}

/// In the sphere with friction in two tangents, from the equator's height 0.5.
std::string inSphere(const std::string& type) {
  return "<dynamy version=\"1\"><systems><Coordinates name=\"bead\" q=\"x y z\" units=\"m m m\" "
         "q0=\"0.6 0 -0.8\" u0=\"0.4 1.5 0.3\" M=\"1 ; 0 ; 0 ; 1 ; 0 ; 1\" "
         "potential=\"9.81*z\"/></systems><elements><" +
         type + " name=\"round\" on=\"bead\"><UnilateralCoulomb mu=\"0.2\"/></" + type +
         "></elements><simulation until=\"1\" step=\"1\"/></dynamy>";
}

TEST(LocatedUntold, SpatialSlipEndsWhereItDoesForAnElementThatTellsItsBias) {
  LocatedRun told(inSphere("ToldRound"), 1e-12, 3.0, {}, roundTypes);
  ASSERT_EQ(told.run().ended, RunReport::Ended::finished) << told.report().reason;
  for (const double tolerance : {1e-5, 1e-8, 1e-10}) {
    LocatedRun bare(inSphere("BareRound"), tolerance, 3.0, {}, roundTypes);
    ASSERT_EQ(bare.run().ended, RunReport::Ended::finished) << bare.report().reason;
    // Ten tolerances, as for methods with a bias (theory 50.6).
    EXPECT_NEAR((bare.state().q - told.state().q).norm(), 0.0, 10.0 * tolerance) << tolerance;
    EXPECT_NEAR((bare.state().u - told.state().u).norm(), 0.0, 10.0 * tolerance) << tolerance;
    RecordProperty("evaluations " + number(tolerance),
                   std::to_string(bare.report().cost.evaluations));
  }
}

TEST(LocatedUntold, AResumedRunGoesOnBitForBit) {
  const std::string model = inSphere("BareRound");
  LocatedRun whole(model, 1e-7, 0.5, {}, roundTypes), first(model, 1e-7, 0.2, {}, roundTypes),
      second(model, 1e-7, 0.5, {}, roundTypes);
  whole.run(), first.run();
  second.simulation().resume(first.simulation().checkpoint());
  second.run();
  EXPECT_EQ(second.state().q, whole.state().q);
  EXPECT_EQ(second.state().u, whole.state().u);
}

}  // namespace
}  // namespace dynamy::reference
