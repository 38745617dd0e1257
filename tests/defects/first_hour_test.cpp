/// Known defects that users meet early: elastic ropes.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <program/program_fixture.hpp>
#include <support/bounded_run.hpp>

namespace dynamy::defects {
namespace {

class KnownDefectsOfUse : public ProgramTest {};

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

}  // namespace
}  // namespace dynamy::defects
