// Rows that a run to a tolerance records between the ends of its steps.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace dynamy::reference
