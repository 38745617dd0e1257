/// What the replay draws of springs and rods: links between the frames they act on.
#include <gtest/gtest.h>

#include <dynamy/io/run_files/model_scene.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

TEST(Links, SpringsAndRodsJoinThePointsTheyActOn) {
  Scene scene("", {.text = R"(<dynamy version="1"><systems>
    <Ground name="world"/>
    <RigidBody name="top" position="0 0 -1" mass="1" inertia="1 1 1"><Sphere radius="0.1"/></RigidBody>
    <PointMass name="bob" position="0 0 -3" mass="1"/>
  </systems><elements><Distance between="top bob" pointA="0 0 -0.1" pointB="0 0 0" length="1.9"/></elements>
  <forces><SpringDamper between="world top" pointB="0 0 0.1" stiffness="1"/></forces>
  <simulation until="1" step="1e-2"/></dynamy>)"});
  const dynamy::Scene drawn = modelScene(scene.model());
  const auto nameOf = [&](int frame) { return drawn.frames[static_cast<std::size_t>(frame)].name; };
  std::vector<const SceneShape*> links;
  for (const SceneShape& s : drawn.shapes)
    if (s.kind == ShapeKind::link) links.push_back(&s);
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(nameOf(links[0]->frame), "top");
  EXPECT_EQ(nameOf(links[0]->frameEnd), "bob");
  EXPECT_EQ(links[0]->points[0][2], -0.1);
  EXPECT_EQ(links[0]->style, "");
  EXPECT_EQ(nameOf(links[1]->frame), "world");
  EXPECT_EQ(nameOf(links[1]->frameEnd), "top");
  EXPECT_EQ(links[1]->points[1][2], 0.1);
  EXPECT_EQ(links[1]->style, "spring");
  // One pose a drawn frame, those that carry links alone included.
  EXPECT_EQ(drawn.frames.size(), drawnFrames(scene.model()).size());
  EXPECT_EQ(drawn.frames.size(), 3U);
}

}  // namespace
}  // namespace dynamy::reference
