// Derivatives of runs against references with 20 digits, which tests/data/derivatives makes without
// dynamY, and one-sided derivatives against closed forms.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/io/model/file_gradient.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace dynamy {
namespace {

struct Reference {
  std::string model, of, by;
  double value = 0.0, derivative = 0.0, parameter = 0.0;
};

std::vector<Reference> references(const std::string& wanted) {
  std::ifstream in(DYNAMY_SOURCE_DIR "/tests/data/derivatives/reference.csv");
  std::vector<Reference> out;
  for (std::string line; std::getline(in, line);) {
    std::stringstream row(line);
    std::string cell[7];
    for (std::string& c : cell) std::getline(row, c, ',');
    if (cell[0] == wanted)
      out.push_back(
          {cell[1], cell[2], cell[3], std::stod(cell[4]), std::stod(cell[5]), std::stod(cell[6])});
  }
  return out;
}

struct Derivatives {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  Derivatives() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }
  Gradient operator()(const std::vector<Reference>& all, double tolerance) {
    std::vector<std::string> of, by;
    for (const Reference& r : all) {
      if (std::find(of.begin(), of.end(), r.of) == of.end()) of.push_back(r.of);
      if (std::find(by.begin(), by.end(), r.by) == by.end()) by.push_back(r.by);
    }
    std::string file = DYNAMY_SOURCE_DIR "/models/" + all[0].model + ".xml";
    if (!std::filesystem::exists(file))
      file = DYNAMY_SOURCE_DIR "/tests/data/derivatives/" + all[0].model + ".xml";
    return gradient({.file = file, .of = of, .by = by, .tolerance = tolerance}, registry, plugins);
  }
};

const GradientValue* valueOf(const Gradient& g, const std::string& of) {
  for (const GradientValue& v : g.values) {
    std::ostringstream name;
    name << v.of << '@' << v.at;
    if (of == (v.measure == "instant" ? v.of : name.str())) return &v;
  }
  return nullptr;
}

struct Case {
  const char* name;
  double tolerance, part;
};

class GradientTruth : public testing::TestWithParam<Case> {};

// At a tolerance of 1e-10 derivatives are good to 1e-8 of max(|d|, |value/p|), and not worse than
// said. One case needs more:
// N05e: slip begins with a slope of friction of 3 N s/m against the motion. Errors of the tolerance
//   grow: 1e-7 at 1e-10. The run to 1e-12 has the 1e-8.
TEST_P(GradientTruth, IsThatOfTheReference) {
  const auto [name, tolerance, part] = GetParam();
  const std::vector<Reference> all = references(name);
  ASSERT_FALSE(all.empty());
  Derivatives of;
  const Gradient g = of(all, tolerance);
  for (const Reference& r : all) {
    const GradientValue* v = valueOf(g, r.of);
    ASSERT_NE(v, nullptr) << r.of;
    const auto i =
        static_cast<std::size_t>(std::find(g.by.begin(), g.by.end(), r.by) - g.by.begin());
    ASSERT_TRUE(g.refused[i].empty()) << g.refused[i];
    const double size = r.parameter != 0.0 ? std::abs(r.parameter) : 1.0;
    const double scale = std::max(std::abs(r.derivative), std::abs(r.value / size));
    const double error = std::abs(v->d[i] - r.derivative);
    EXPECT_LE(error, part * scale) << r.of << " by " << r.by << ": " << v->d[i];
    EXPECT_LE(error, v->dError[i]) << r.of << " by " << r.by;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, GradientTruth,
    testing::Values(Case{"N01", 1e-10, 1e-8}, Case{"N02", 1e-10, 1e-8}, Case{"N04", 1e-10, 1e-8},
                    Case{"N05", 1e-10, 1e-8}, Case{"N05c", 1e-10, 1e-8}, Case{"N05e", 1e-12, 1e-8},
                    Case{"N06", 1e-10, 1e-8}, Case{"N07", 1e-10, 1e-8}, Case{"N08", 1e-10, 1e-8},
                    Case{"N10", 1e-10, 1e-8}, Case{"N19", 1e-10, 1e-8}, Case{"N21", 1e-10, 1e-8},
                    Case{"N22", 1e-10, 1e-8}, Case{"S01", 1e-10, 1e-8}, Case{"S06", 1e-10, 1e-8},
                    Case{"S07", 1e-10, 1e-8}, Case{"S09", 1e-10, 1e-8}),
    [](const auto& i) { return std::string(i.param.name); });

Gradient ofText(const std::string& inside, double p, double until) {
  Derivatives with;
  return gradient(
      [&](const std::vector<Varied>& changed) {
        LoadOptions options;
        for (const auto& [name, value] : changed)
          options.set.emplace_back(name, "{" + numberText(value) + "}");
        return loadModelText(
            "<dynamy version=\"1\"><parameter name=\"p\" value=\"1\"/>" + inside + "</dynamy>",
            "test.xml", with.registry, with.plugins, options);
      },
      {.of = {{"ball.x", until}}, .by = {{"p", p}}, .tolerance = 1e-10});
}

TEST(OneSidedGradient, ExistsWhereABallMissesTheWall) {
  // x = −cos t misses a wall at p > 1, and hits it with √(1 − p²) before: no bound on that side.
  const Gradient g = ofText(R"xml(
    <systems><Coordinates name="ball" q="x" q0="-1" M="1" potential="x^2/2"/></systems>
    <elements><CoordinateContact name="wall" on="ball" gap="{p} - x"><Unilateral epsilonN="0.5"/>
    </CoordinateContact></elements><simulation until="5" tolerance="1e-8"/>)xml",
                            1.0, 5.0);
  ASSERT_FALSE(g.refused[0].empty());
  const GradientValue& v = g.values[0];
  EXPECT_TRUE(std::isnan(v.left[0].d)) << v.left[0].d;
  EXPECT_NEAR(v.right[0].d, 0.0, 1e-8);  // the wall is not there: rounding over δ
  EXPECT_FALSE(v.right[0].jumps);
}

TEST(OneSidedGradient, TellsWhereTheOrderOfTwoImpactsMakesTheValueJump) {
  // M = [1 0.4; 0.4 1], ε = 0.5, u = (1, 1) towards walls x = p and y = 1. For p > 1 y is hit first:
  // u = (1.6, −0.5), x at once: (−0.8, 0.46), y again: (−0.524, −0.23). At p = 1 both: (−0.5, −0.5).
  const Gradient g = ofText(R"xml(
    <systems><Coordinates name="ball" q="x y" q0="0 0" u0="1 1" M="1 ; 0.4 ; 1"/></systems>
    <elements>
    <CoordinateContact name="a" on="ball" gap="{p} - x"><Unilateral epsilonN="0.5"/></CoordinateContact>
    <CoordinateContact name="b" on="ball" gap="1 - y"><Unilateral epsilonN="0.5"/></CoordinateContact>
    </elements><simulation until="2" tolerance="1e-10"/>)xml",
                            1.0, 2.0);
  ASSERT_FALSE(g.refused[0].empty());
  const GradientValue& v = g.values[0];
  EXPECT_TRUE(v.left[0].jumps);
  EXPECT_TRUE(v.right[0].jumps);
  EXPECT_NEAR(v.value, 0.5, 1e-9);
  EXPECT_NEAR(v.right[0].limit, 1.0 - 0.524, 1e-9);
  // x is hit at 1 + s/1.6, s = p − 1, at x = p; y at 0.5 s/1.6/0.46 later: x goes by −0.8, −0.524.
  const double first = 1.0 / 1.6, second = first + 0.5 / 1.6 / 0.46;
  EXPECT_NEAR(v.right[0].d, 1.0 - 0.8 * (second - first) + 0.524 * second, 1e-8);
}

}  // namespace
}  // namespace dynamy
