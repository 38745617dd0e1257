// The axis of a hinge between planar bodies: its side counts, another direction is refused.
#include <gtest/gtest.h>

#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

std::string hangingRod(const std::string& body, const std::string& axis,
                       const std::string& coordinates) {
  return "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + body +
         "</systems><forces><Gravity/></forces><elements><Revolute name=\"hinge\" between=\"world "
         "rod\" "
         "at=\"0 0 0\" " +
         axis + "/></elements><simulation until=\"0.2\" tolerance=\"1e-9\" coordinates=\"" +
         coordinates + "\"/></dynamy>";
}

const std::string kFlatRod =
    R"(<PlanarBody name="rod" position="0.5 0 0" mass="1" inertia="0.1"/>)";
const std::string kRodInSpace =
    R"(<RigidBody name="rod" position="0.5 0 0" mass="1" inertia="0.1 0.1 0.1"/>)";

double angleAtEnd(const std::string& text) {
  BlockScene scene(text);
  return scene.signal(scene.run(), "hinge.angle");
}

TEST(HingeAxis, OfPlanarBodiesCountsTheAngleByItsSide) {
  // A rod that falls from the horizontal turns about +y; in space the axis says so by itself. The normal
  // of the plane xz, in which angles count from x to z, is −y.
  for (const char* coordinates : {"absolute", "minimal"}) {
    const double right = angleAtEnd(hangingRod(kRodInSpace, "axis=\"0 1 0\"", coordinates));
    EXPECT_GT(right, 0.1);
    // Ten tolerances of runs of different coordinates.
    EXPECT_NEAR(angleAtEnd(hangingRod(kFlatRod, "", coordinates)), -right, 1e-8);
    EXPECT_NEAR(angleAtEnd(hangingRod(kFlatRod, "axis=\"0 1 0\"", coordinates)), right, 1e-8);
    EXPECT_NEAR(angleAtEnd(hangingRod(kFlatRod, "axis=\"0 -1 0\"", coordinates)), -right, 1e-8);
  }
}

TEST(HingeAxis, OfPlanarBodiesIsRefusedAcrossTheirPlane) {
  try {
    BlockScene scene(hangingRod(kFlatRod, "axis=\"1 0 0\"", "auto"));
    FAIL() << "no error";
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("turns about the normal of their plane"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace dynamy
