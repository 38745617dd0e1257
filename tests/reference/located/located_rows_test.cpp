// Rows that a run to a tolerance records between the ends of its steps.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// The energy in each recorded row of bodies of 1 kg, of which a model records ½ m v² + ½ Ω·J Ω, x, y, z and
/// the quaternion.
class RowEnergies final : public RecordSink {
 public:
  void row(double, std::span<const double> values) override {
    double sum = 0.0;
    for (std::size_t i = 0; i + 8 <= values.size(); i += 8) sum += values[i] + 9.81 * values[i + 3];
    energies.push_back(sum);
  }
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void event(const ContactEvent&) override {}
  std::vector<double> energies;
};

TEST(LocatedRows, BeforeAnImpactShowTheMotionBeforeIt) {
  // A random scene. The step that ends with an impact at 1.0322 s has no interpolation of its own, and a row
  // within it was shown on the way to the velocities after the impact: 31.5 J were missing there.
  std::ifstream in(DYNAMY_SOURCE_DIR "/tests/data/defects/impact_between_rows.xml");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  LocatedRun run(text, 1e-3, 1.05);
  run.record(0.0119933, 0.0);
  RowEnergies rows;
  run.simulation().record(rows);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  ASSERT_GT(rows.energies.size(), 80u);
  double least = rows.energies.front();
  for (const double E : rows.energies) {
    // A thousandth of 3320 J at the start: the tolerance.
    EXPECT_LT(E, least + 3.3);
    least = std::min(least, E);
  }
}

/// The largest depth in a floor at z = 0 of a box with half edges `half`, of which a model records z and
/// the quaternion.
class RowDepth final : public RecordSink {
 public:
  explicit RowDepth(const Eigen::Vector3d& half) : half_(half) {}
  void row(double, std::span<const double> x) override {
    ASSERT_EQ(x.size(), 5u);
    const Eigen::Matrix3d A_IK = Eigen::Quaterniond(x[1], x[2], x[3], x[4]).toRotationMatrix();
    depth = std::max(depth, A_IK.row(2).cwiseAbs().dot(half_.transpose()) - x[0]);
  }
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void event(const ContactEvent&) override {}
  double depth = 0.0;

 private:
  Eigen::Vector3d half_;
};

TEST(LocatedRows, OfStepsInTimeAreNoDeeperThanTold) {
  // A random scene, whose boxes are recorded deeper in each other within steps in time than at their
  // ends: overlaps in rows of such steps were not looked at. Rows do not change the motion.
  std::ifstream in(DYNAMY_SOURCE_DIR "/tests/data/defects/overlap_between_rows.xml");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  LocatedRun few(text, 1.5e-3, 0.108096), many(text, 1.5e-3, 0.108096);
  many.record(0.0007, 0.0);
  RowDepth rows(0.5 * Eigen::Vector3d(0.00710914, 0.00684414, 0.00642509));
  many.simulation().record(rows);
  ASSERT_EQ(few.run().ended, RunReport::Ended::finished) << few.report().reason;
  ASSERT_EQ(many.run().ended, RunReport::Ended::finished) << many.report().reason;
  EXPECT_GT(many.report().stepping.periods, 0);
  expectSameBits(few, many);
  EXPECT_GT(many.report().gaps.penetration.value, 10.0 * few.report().gaps.penetration.value);
  // Rounding of places of 0.1 m.
  EXPECT_GE(many.report().gaps.penetration.value, rows.depth - 1e-15);
}

/// Rows of the energy ledger.
class Ledger final : public RecordSink {
 public:
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void ledger(const LedgerRow& row) override { rows.push_back(row); }
  bool wantsLedger() const override { return true; }
  std::vector<LedgerRow> rows;
};

/// A box that falls 1 m onto a floor at t = √0.2 s, ε = 1/2, or slides on it from 2 m/s with μ = 1/2.
constexpr const char* kBoxOnFloor = R"(<dynamy version="1">
  <systems><RigidBody name="ball" position="0 0 {z}" velocity="{v} 0 0"><Box size="0.2 0.2 0.2" mass="1" material="a"/></RigidBody>
    <Ground name="world"><HalfSpace name="floor" normal="0 0 1" material="b"/></Ground></systems>
  <forces><Gravity acceleration="0 0 -10"/></forces>
  <elements><Contact between="a b"><UnilateralCoulomb epsilonN="0.5" mu="0.5"/></Contact></elements>
  <simulation until="0.6" tolerance="1e-6" coordinates="absolute"/></dynamy>)";

std::string boxOnFloor(const std::string& z, const std::string& v) {
  std::string text = kBoxOnFloor;
  text.replace(text.find("{z}"), 3, z);
  return text.replace(text.find("{v}"), 3, v);
}

std::vector<LedgerRow> ledgerOf(const std::string& text) {
  LocatedRun run(text, 1e-6, 0.6);
  Ledger ledger;
  run.simulation().record(ledger);
  EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  return ledger.rows;
}

void expectSums(const std::vector<LedgerRow>& rows) {
  const auto sum = [](const LedgerRow& r) {  // T + V less works
    double out = r.value[0] + r.value[1];
    for (std::size_t k = 2; k < 8; ++k) out -= r.value[k];
    return out;
  };
  for (const LedgerRow& r : rows) EXPECT_NEAR(sum(r), sum(rows.front()), 1e-12) << r.t;
}

TEST(LedgerRows, OfALocatedImpactStandOnBothSidesOfIt) {
  const std::vector<LedgerRow> rows = ledgerOf(boxOnFloor("1.1", "0"));
  EXPECT_GT(rows.size(), 400u);
  expectSums(rows);
  const auto at = std::adjacent_find(rows.begin(), rows.end(),
                                     [](const auto& a, const auto& b) { return a.t == b.t; });
  ASSERT_NE(at, rows.end());
  EXPECT_NEAR(at->t, std::sqrt(0.2), 1e-6);  // the tolerance
  // ½ m v² = m g h = 10 J before the impact and ε² of that after it, to the tolerance of 1e-6 of v.
  EXPECT_NEAR(at->value[0], 10.0, 1e-4);
  EXPECT_NEAR((at + 1)->value[0], 2.5, 1e-4);
  EXPECT_NEAR(at->value[4], 0.0, 1e-9);
  EXPECT_NEAR((at + 1)->value[4], -7.5, 1e-4);
  // Between: T = ½ m (g t)² in free fall.
  for (auto r = rows.begin(); r != at; ++r) EXPECT_NEAR(r->value[0], 50.0 * r->t * r->t, 1e-4);
}

TEST(LedgerRows, WithinALocatedStepHaveTheWorkOfFriction) {
  const std::vector<LedgerRow> rows = ledgerOf(boxOnFloor("0.1", "2"));
  EXPECT_GE(rows.size(), 400u);
  expectSums(rows);
  // It slides with 5 m/s² for 0.4 s: the work of friction is ½ v² − ½ v0², at every instant.
  for (const LedgerRow& r : rows) {
    const double v = std::max(0.0, 2.0 - 5.0 * r.t);
    EXPECT_NEAR(r.value[3], 0.5 * v * v - 2.0, 1e-4) << r.t;
  }
}

}  // namespace
}  // namespace dynamy::reference
