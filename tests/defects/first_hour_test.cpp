/// Known defects that users meet early: steady motions, elastic ropes, writing the state.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <program/program_fixture.hpp>
#include <support/bounded_run.hpp>
#include <support/load_model.hpp>

namespace dynamy::defects {
namespace {

class KnownDefectsOfUse : public ProgramTest {};

TEST_F(KnownDefectsOfUse, AMotorbikeWhoseSpringsAreNotPreloadedHasASteadyMotion) {
  // Bodies, joints and two springs in minimal coordinates; at the start the springs do not carry
  // the weight. Upright straight riding with the springs compressed is steady, by symmetry.
  knownDefect("eigen_unpreloaded", [&] {
    EXPECT_EQ(call("eigen '" DYNAMY_SOURCE_DIR "/tests/data/defects/eigen_unpreloaded.xml'"), 0)
        << err();
  });
}

TEST_F(KnownDefectsOfUse, ARopeOverASheaveMayBeElastic) {
  // EA/L = 4e5 N/m over a sheave that turns freely: two masses on springs and a wheel.
  knownDefect("elastic_rope", [] {
    try {
      BoundedRun rope(R"(<dynamy version="1"><systems><Ground name="world"/>
<PlanarBody name="sheave" position="0 0 5" mass="80" inertia="2.5"/>
<PlanarBody name="a" position="-0.25 0 2" mass="1000" inertia="100"/><PlanarBody name="b" position="0.25 0 2" mass="900" inertia="100"/>
</systems><forces><Gravity/></forces><elements><Revolute between="world sheave"/>
<Prismatic between="world a" axis="0 0 1"/><Prismatic between="world b" axis="0 0 1"/>
<SheaveRope name="rope" between="a b" sheave="sheave" radius="0.25"><PreloadedSpring stiffness="4e5" sides="one"/></SheaveRope>
</elements><simulation until="2" step="1e-3"/><record signals="a.z b.z" every="10ms"/></dynamy>)");
    } catch (const ModelError& e) {
      ADD_FAILURE() << e.what();
    }
  });
}

TEST_F(KnownDefectsOfUse, AVelocityThatIsWrittenBetweenStepsLasts) {
  // A cart on a rail is pushed by hand between steps: it keeps its velocity, no force acts along
  // it.
  Registry registry;
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, ".", registry);
  Model model = loadModelText(
      R"(<dynamy version="1"><systems><Ground name="rail"/><PlanarBody name="cart" mass="1" inertia="1"/></systems>
<forces><Gravity/></forces><elements><Prismatic between="rail cart" axis="1 0 0"/></elements>
<simulation until="1" step="1e-3"/></dynamy>)",
      "cart.xml", registry, plugins);
  model.readyScheme();
  HandStepper cart(model);
  for (int i = 0; i < 10; ++i) cart.step(1e-3);
  cart.x.u[0] = 1.0;
  for (int i = 0; i < 100; ++i) cart.step(1e-3);
  knownDefect("written_velocity_is_lost", [&] {
    EXPECT_NEAR(cart.x.u[0], 1.0, 1e-12);  // a hundred roundings
    EXPECT_NEAR(cart.x.q[0], 0.1, 1e-12);
  });
}

}  // namespace
}  // namespace dynamy::defects
