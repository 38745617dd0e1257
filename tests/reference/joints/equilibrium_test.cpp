// Rest as an inclusion against closed forms and a linear program.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/equilibrium/rest_range.hpp>

namespace dynamy {
namespace {

/// Models from text or files, with what they live on.
struct Models {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  Models() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }
  static std::string whole(const std::string& inside) {
    const bool weights = inside.find("Coordinates") == std::string::npos;
    return "<dynamy version=\"1\">" + inside + (weights ? "<forces><Gravity/></forces>" : "") +
           "<simulation until=\"1\" step=\"1e-3\"/></dynamy>";
  }
  Equilibrium find(const std::string& inside, const EquilibriumOptions& options = {},
                   const Overrides& set = {}) {
    LoadOptions load;
    load.set = set;
    Model model = loadModelText(whole(inside), "test.xml", registry, plugins, load);
    return equilibrium(model, model.initialState(), options);
  }
};

double value(const Equilibrium& e, const std::string& signal) {
  for (const auto& [name, x] : e.state)
    if (name == signal) return x;
  ADD_FAILURE() << "no " << signal;
  return 0.0;
}

/// A parameter is written with 17 digits.
std::string digits(double p) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", p);
  return text;
}

/// Ends of ranges are found where forces are 3e-12 of the largest beyond their bounds; barriers end
/// within 1e-13 of it. A parameter of order 1 that shifts the bounds by its own size is as good.
constexpr double kEnd = 2e-11;

std::vector<RestRange> ranges(Models& m, const std::string& inside, double a, double b,
                              int count = 11) {
  return restRanges(a, b, count, [&](double p) {
    return m.find(inside, {.relax = false}, {{"p", digits(p)}});
  });
}

TEST(Equilibrium, BlockRestsOnASlopeFromTheTangentOfItsAngleOn) {
  Models m;
  const std::vector<RestRange> r = ranges(m, R"xml(<parameter name="p" value="0.5"/><systems>
    <PlanarBody name="block" mass="2" inertia="0.1" position="{-0.05*sin(20deg)} 0 {0.05*cos(20deg)}"
      angle="-20deg"><Polygon points="-0.1 0 -0.05  0.1 0 -0.05  0.1 0 0.05  -0.1 0 0.05" material="block"/>
    </PlanarBody><Ground name="hill"><HalfSpace normal="{-sin(20deg)} 0 {cos(20deg)}" material="slope"/></Ground></systems>
    <elements><Contact between="block slope"><UnilateralCoulomb mu="{p}"/></Contact></elements>)xml",
                                          0.1, 1.0);
  ASSERT_EQ(r.size(), 1u);
  EXPECT_NEAR(r[0].from, std::tan(20.0 * M_PI / 180.0), kEnd);
  EXPECT_EQ(r[0].to, 1.0);
  EXPECT_NE(r[0].endsFrom.find("at the bound of its law"), std::string::npos) << r[0].endsFrom;
}

TEST(Equilibrium, LadderWithFrictionAtBothEndsHasItsLimit) {
  // Both contacts at their bounds: N_w = μ_f N_f, μ_w N_w + N_f = mg, moments about the foot
  // ⇒ tan θ = (1 − μ_f μ_w)/(2 μ_f). With μ_w = 0.3: μ_f = 1/(2 tan θ + 0.3).
  Models m;
  const std::vector<RestRange> r = ranges(m, R"xml(<parameter name="p" value="0.5"/><systems>
    <PlanarBody name="ladder" position="{cos(60deg)} 0 {sin(60deg)}" angle="-60deg" mass="3" inertia="1">
      <Point position="-1 0 0" material="top"/><Point position="1 0 0" material="foot"/></PlanarBody>
    <Ground name="house"><HalfSpace material="floor"/><HalfSpace normal="1 0 0" material="wall"/></Ground></systems>
    <elements><Contact between="foot floor"><UnilateralCoulomb mu="{p}"/></Contact>
    <Contact between="top wall"><UnilateralCoulomb mu="0.3"/></Contact>
    <NoContact between="foot wall"/><NoContact between="top floor"/></elements>)xml",
                                          0.05, 0.6);
  ASSERT_EQ(r.size(), 1u);
  EXPECT_NEAR(r[0].from, 1.0 / (2.0 * std::tan(M_PI / 3.0) + 0.3), kEnd);
}

TEST(Equilibrium, ArchStandsFromItsLimitThicknessOn) {
  // A linear program over the corner forces of this arch, written apart from this code and solved
  // with scipy's HiGHS, has its widest margin zero at t/R = 0.10491034304483.
  Models m;
  const auto at = [&](double t) {
    LoadOptions load;
    load.set = {{"t", digits(t)}};
    Model model =
        loadModel(DYNAMY_SOURCE_DIR "/models/masonry_arch.xml", m.registry, m.plugins, load);
    return equilibrium(model, model.initialState(), {.relax = false});
  };
  const std::vector<RestRange> r = restRanges(0.1, 0.12, 5, at);
  ASSERT_EQ(r.size(), 1u);
  EXPECT_NEAR(r[0].from, 0.10491034304483, kEnd);
  EXPECT_EQ(at(0.12).moved, 0.0);
}

TEST(Equilibrium, ThreeSupportsShareTheLoadEvenly) {
  // One of many ways to carry 12 g: that with the largest least force has 4 g in each.
  Models m;
  const Equilibrium e = m.find(R"xml(<systems>
    <PlanarBody name="beam" mass="12" inertia="4" position="0 0 0"><Point position="-1 0 0" material="a"/>
      <Point position="0 0 0" material="a"/><Point position="1 0 0" material="a"/></PlanarBody>
    <Ground name="g"><HalfSpace material="f"/></Ground></systems>
    <elements><Contact between="a f"><Unilateral/></Contact></elements>)xml");
  ASSERT_EQ(e.contacts.size(), 3u);
  for (const CarryingContact& c : e.contacts) EXPECT_NEAR(c.lambda[0], 4.0 * 9.81, 1e-9) << c.name;
  EXPECT_EQ(e.moved, 0.0);
}

TEST(Equilibrium, BallWithRollingResistanceRestsUpToItsArmOverTheRadius) {
  // The moment about the contact, m g r sin α, is at most arm · m g cos α.
  Models m;
  const std::vector<RestRange> r = ranges(m, R"xml(<parameter name="p" value="0.1"/><systems>
    <RigidBody name="ball" position="{-0.1*sin(p)} 0 {0.1*cos(p)}"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
    <Ground name="hill"><HalfSpace normal="{-sin(p)} 0 {cos(p)}" material="slope"/></Ground></systems>
    <elements><Contact between="ball slope"><UnilateralRolling mu="0.5" rolling="0.02"/></Contact></elements>)xml",
                                          0.0, 0.4);
  ASSERT_EQ(r.size(), 1u);
  EXPECT_NEAR(r[0].to, std::atan(0.2), kEnd);
}

TEST(Equilibrium, SpringMovesToItsStaticLength) {
  Models m;
  const Equilibrium e = m.find(R"xml(<systems><Coordinates name="m" q="z" units="m" q0="0.3" M="2"
    potential="0.5*500*z^2 + 2*9.81*z"/></systems>)xml");
  EXPECT_NEAR(value(e, "m.z"), -2.0 * 9.81 / 500.0, 1e-12);  // linear: one step of Newton's method
}

TEST(Equilibrium, AModelMayStartInIt) {
  Models m;
  const auto start = [&](const std::string& word) {
    const Model model = loadModelText(
        R"xml(<dynamy version="1"><systems><Coordinates name="m" q="z" units="m" q0="0.3" M="2"
        potential="0.5*500*z^2 + 2*9.81*z"/></systems><simulation until="1" step="1e-3" )xml" +
            word + "/></dynamy>",
        "test.xml", m.registry, m.plugins);
    return model.initialState().q[0];
  };
  EXPECT_EQ(start(""), 0.3);
  EXPECT_NEAR(start("start=\"equilibrium\""), -2.0 * 9.81 / 500.0, 1e-12);
  EXPECT_THROW(
      loadModelText(R"xml(<dynamy version="1"><systems><PointMass name="m" mass="1"/></systems>
        <forces><Gravity/></forces><simulation until="1" step="1e-3" start="equilibrium"/></dynamy>)xml",
                    "test.xml", m.registry, m.plugins),
      ModelError);
}

TEST(Equilibrium, PendulumFallsIntoItsRestWithoutSwinging) {
  Models m;
  const Equilibrium e =
      m.find(R"xml(<systems><Coordinates name="p" q="phi" units="rad" q0="2.8" M="1"
    potential="-9.81*cos(phi)"/></systems>)xml");
  EXPECT_NEAR(std::remainder(value(e, "p.phi"), 2.0 * M_PI), 0.0,
              1e-10);  // as Newton's method ends
  EXPECT_GT(e.relaxations, 0);
  EXPECT_EQ(e.growing, 0);
  const Equilibrium top =
      m.find(R"xml(<systems><Coordinates name="p" q="phi" units="rad" q0="2.8" M="1"
    potential="-9.81*cos(phi)"/></systems>)xml",
             {.relax = false});
  EXPECT_NEAR(value(top, "p.phi"), M_PI, 1e-10);
  EXPECT_EQ(top.growing, 1);
}

TEST(Equilibrium, ABoxThatIsDroppedAskewLiesFlatInTheEnd) {
  Models m;
  const Equilibrium e = m.find(R"xml(<systems>
    <PlanarBody name="box" mass="2" inertia="0.02" position="0 0 0.5" angle="20deg">
      <Polygon points="-0.2 0 -0.1  0.2 0 -0.1  0.2 0 0.1  -0.2 0 0.1" material="box"/></PlanarBody>
    <Ground name="g"><HalfSpace material="f"/></Ground></systems>
    <elements><Contact between="box f"><UnilateralCoulomb mu="0.4" epsilonN="0.3"/></Contact></elements>)xml");
  // Newton's method closes the two gaps to rounding.
  EXPECT_NEAR(value(e, "box.z"), 0.1, 1e-9);
  EXPECT_NEAR(value(e, "box.phi"), 0.0, 1e-9);
  ASSERT_EQ(e.contacts.size(), 2u);
  EXPECT_NEAR(e.contacts[0].lambda[0], 9.81, 1e-6);
}

TEST(Equilibrium, WhatSlidesAwayHasNoRest) {
  Models m;
  try {
    m.find(R"xml(<systems>
      <PlanarBody name="block" mass="2" inertia="0.1" position="{-0.05*sin(20deg)} 0 {0.05*cos(20deg)}"
        angle="-20deg"><Polygon points="-0.1 0 -0.05  0.1 0 -0.05  0.1 0 0.05  -0.1 0 0.05" material="block"/>
      </PlanarBody><Ground name="hill"><HalfSpace normal="{-sin(20deg)} 0 {cos(20deg)}" material="slope"/></Ground></systems>
      <elements><Contact between="block slope"><UnilateralCoulomb mu="0.2"/></Contact></elements>)xml");
    ADD_FAILURE() << "a rest was found";
  } catch (const ModelError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("no rest found: at the start"), std::string::npos) << text;
    EXPECT_NE(text.find("beyond its law"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace dynamy
