// Joints: W, χ and bias against differences of the position errors, off the constraint as well.
#include <gtest/gtest.h>
#include <dynamy_elements/joints/joints.hpp>

#include "joint_models.hpp"

// Its test suite has the name of a class of the library.
namespace dynamy::joints {
namespace {

using testing::add;
using testing::addPlanar;
using testing::addSpatial;
using testing::expectRowsFit;
using testing::Motion;

class JointRows : public ::testing::TestWithParam<const char*> {};

TEST_P(JointRows, OfARevoluteFit) {
  Model space, plane;
  addSpatial(space);
  addPlanar(plane);
  const std::vector<GivenValue> given{
      {"between", GetParam()}, {"at", {0.4, 0.0, 1.1}}, {"axis", {0.2, 1.0, 0.3}}};
  expectRowsFit(space, add<Revolute>(space, given, true), 5, 6);
  expectRowsFit(
      plane, add<Revolute>(plane, {{"between", GetParam()}, {"at", {0.4, 0.0, 1.1}}}, true), 2, 3);
}

TEST_P(JointRows, OfASphericalFit) {
  Model space, plane;
  addSpatial(space);
  addPlanar(plane);
  expectRowsFit(space, add<Spherical>(space, {{"between", GetParam()}, {"at", {0.4, 0.0, 1.1}}}), 3,
                3);
  expectRowsFit(plane, add<Spherical>(plane, {{"between", GetParam()}}), 2, 2);
}

TEST_P(JointRows, OfAPrismaticFit) {
  Model space, plane;
  addSpatial(space);
  addPlanar(plane);
  expectRowsFit(space,
                add<Prismatic>(space, {{"between", GetParam()}, {"axis", {1.0, 0.5, 0.2}}}, true),
                5, 6);
  expectRowsFit(plane,
                add<Prismatic>(plane, {{"between", GetParam()}, {"axis", {1.0, 0.0, 0.2}}}, true),
                2, 3);
}

TEST_P(JointRows, OfAFixedFit) {
  Model space, plane;
  addSpatial(space);
  addPlanar(plane);
  expectRowsFit(space, add<Fixed>(space, {{"between", GetParam()}}), 6, 6);
  expectRowsFit(plane, add<Fixed>(plane, {{"between", GetParam()}}), 3, 3);
}

TEST_P(JointRows, OfADistanceFit) {
  Model space, plane;
  addSpatial(space);
  addPlanar(plane);
  const std::vector<GivenValue> given{
      {"between", GetParam()}, {"pointA", {0.1, 0.0, 0.2}}, {"pointB", {0.0, 0.0, 0.3}}};
  expectRowsFit(space, add<Distance>(space, given), 1, 1);
  expectRowsFit(plane, add<Distance>(plane, given), 1, 1);
}

INSTANTIATE_TEST_SUITE_P(Between, JointRows, ::testing::Values("world b", "b world", "a b"),
                         [](const auto& between) {
                           std::string name = between.param;
                           name.erase(name.find(' '), 1);
                           return name;
                         });

TEST(Joints, FitTheBodiesAsTheyAreAtTheStart) {
  Model m;
  addSpatial(m);
  Joint& joint = add<Prismatic>(m, {{"between", "a b"}, {"axis", {1.0, 0.5, 0.2}}});
  m.build();
  Motion motion(m, 0.0);
  for (const double e : joint.errors(motion.at(0.0)))
    EXPECT_NEAR(e, 0.0, 1e-15);  // products of unit vectors
}

TEST(Joints, RefuseWhatCannotMove) {
  Model m;
  m.add<Ground>("world", {});
  m.add<Ground>("table", {});
  m.add<Spherical>("joint", {{"between", "world table"}});
  EXPECT_THROW(m.build(), ModelError);
}

TEST(Joints, AskForAnAxisInSpace) {
  Model m;
  addSpatial(m);
  m.add<Revolute>("joint", {{"between", "a b"}});
  EXPECT_THROW(m.build(), ModelError);
}

}  // namespace
}  // namespace dynamy::joints
