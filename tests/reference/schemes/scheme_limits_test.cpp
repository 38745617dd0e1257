/// Agreement in the limit Δt → 0: all schemes whose definition admits impacts tend to the same
/// motion of the rocking block (Housner, by quadrature) and of the woodpecker (event-driven, Taylor
/// series of order 40). The others refuse it in their own words.
#include <gtest/gtest.h>

#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

class SchemeLimit : public testing::TestWithParam<SchemeOrders> {};
/// Across impacts; a scheme that is better there may be so, as far as states between steps tell it.
void expectOrderOne(const std::vector<double>& dt, const std::vector<double>& error, double by) {
  const Fit fit = fitOrder(dt, error);
  const bool better = SchemeLimit::GetParam().position[index(Situation::impacts)] > 1.0;
  EXPECT_GT(fit.order, 1.0 - by) << fit;
  EXPECT_TRUE(better || fit.order < 1.0 + by) << fit;
}
std::string schemeName(const testing::TestParamInfo<SchemeOrders>& p) { return p.param.name; }

// ---- rocking block -----------------------------------------------------------------------------

constexpr double kAlpha = 0.19739555984988075;
constexpr double kThirdImpact = 1.702799677331815;                     // [s]
constexpr double kPeak[] = {0.49611579332844813, 0.4192034424847593};  // [α]

struct Rocking {
  double thirdImpact = 0.0, peak[2] = {};
};

/// Third impact, interpolated, and the peaks before and after the second one [α].
Rocking rock(const std::string& scheme, double dt, std::string_view& refused) {
  Scene scene("rocking_block", {.text = modelFile("rocking_block", scheme)});
  Rocking out;
  double before = scene.q("block")[2], tBefore = 0.0, peak = 0.0;
  int impacts = 0;
  scene.run(2.0, dt, [&] {
    if (!scene.report().refused.empty()) refused = scene.report().refused;
    const double phi = scene.q("block")[2], t = scene.state().t;
    if (phi * before < 0.0) {
      if (impacts == 1 || impacts == 2) out.peak[impacts - 1] = peak / kAlpha;
      if (++impacts == 3) out.thirdImpact = t - (t - tBefore) * phi / (phi - before);
      peak = 0.0;
    }
    peak = std::max(peak, std::abs(phi));
    before = phi, tBefore = t;
  });
  EXPECT_TRUE(scene.solved()) << dt;
  EXPECT_GE(impacts, refused.empty() ? 3 : 0);
  return out;
}

TEST_P(SchemeLimit, OfTheRockingBlockIsHousners) {
  const std::string scheme = GetParam().xml;
  std::string_view refused;
  rock(scheme, 1e-3, refused);
  if (!refused.empty()) return;  // the reason is the business of SchemeRefusal
  const std::vector<double> dt = halvings(2e-3, 4);
  std::vector<double> time, peak[2];
  for (const double h : dt) {
    double worst[3] = {};
    for (int k = 0; k < 8; ++k) {
      const Rocking r = rock(scheme, h * (1.0 + 0.3 * k / 8.0), refused);
      worst[0] = std::max(worst[0], std::abs(r.thirdImpact - kThirdImpact));
      for (int i = 0; i < 2; ++i)
        worst[i + 1] = std::max(worst[i + 1], std::abs(r.peak[i] - kPeak[i]));
    }
    time.push_back(worst[0]), peak[0].push_back(worst[1]), peak[1].push_back(worst[2]);
  }
  // Order one across impacts; 8 samples of the envelope scatter by a third, over a factor of 8.
  expectOrderOne(dt, time, 0.3);
  for (const std::vector<double>& p : peak) expectOrderOne(dt, p, 0.3);
  // All to the same limit: the block arrives at 0.65 rad/s · 0.1 m and penetrates or is braked
  // within one step of each of three impacts; that moves the third one by some 10 steps each.
  EXPECT_LT(time.back(), 100.0 * 2e-3 / 8.0);
}

// ---- woodpecker --------------------------------------------------------------------------------

constexpr double kTurn[] = {0.032805571232, 0.178588177089, 0.324727480140};  // [s]
constexpr double kTurnPhiS[] = {-0.53006127852090, -0.52897921513051, -0.52988676621187};

struct Turns {
  double t[3] = {}, phiS[3] = {};
};

/// The first three turning points of the bird while the sleeve sticks.
Turns turns(const std::string& scheme, double dt, std::string_view& refused) {
  static const std::string file = "woodpecker_expressions";
  Scene scene(file, {.text = modelFile(file, scheme)});
  Turns out;
  int found = 0;
  double before = scene.state().u[2];
  while (found < 3 && scene.state().t < 0.4) {
    const double tBefore = scene.state().t;
    scene.step(dt);
    if (!scene.report().refused.empty()) {
      refused = scene.report().refused;
      return out;
    }
    const State& x = scene.state();
    if (before < 0.0 && x.u[2] >= 0.0 && x.q[2] < -0.4) {
      out.t[found] = tBefore + (x.t - tBefore) * before / (before - x.u[2]);
      out.phiS[found++] = x.q[2];
    }
    before = x.u[2];
  }
  EXPECT_TRUE(scene.solved()) << dt;
  EXPECT_EQ(found, 3) << dt;
  return out;
}

TEST_P(SchemeLimit, OfTheWoodpeckerIsTheEventDrivenOne) {
  const std::string scheme = GetParam().xml;
  std::string_view refused;
  turns(scheme, 4e-5, refused);
  if (!refused.empty()) return;
  const std::vector<double> dt = halvings(8e-5, 4);
  std::vector<double> time, angle;
  for (const double h : dt) {
    double worst[2] = {};
    for (int k = 0; k < 8; ++k) {
      const Turns r = turns(scheme, h * (1.0 + 0.3 * k / 8.0), refused);
      for (int i = 1; i < 3; ++i) {
        worst[0] = std::max(worst[0], std::abs(r.t[i] - kTurn[i]));
        worst[1] = std::max(worst[1], std::abs(r.phiS[i] - kTurnPhiS[i]));
      }
    }
    time.push_back(worst[0]), angle.push_back(worst[1]);
  }
  expectOrderOne(dt, time, 0.35);
  expectOrderOne(dt, angle, 0.35);
}

INSTANTIATE_TEST_SUITE_P(AllSchemes, SchemeLimit, testing::ValuesIn(kAllSchemes), schemeName);

}  // namespace
}  // namespace dynamy::reference
