// Joints: W, χ and bias against differences of the position errors, off the constraint as well.
#include <gtest/gtest.h>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/joints/joints.hpp>

#include "motion.hpp"

namespace dynamy {
namespace {

using testing::fourPoint;
using testing::kTolerance;
using testing::Motion;

const std::vector<GivenValue> kWorld{{"motion", "0.1*sin(3*t); t^2/4; 0.2*cos(2*t)"},
                                     {"rotation", "0.5*sin(2*t)"},
                                     {"axis", {0.0, 1.0, 0.0}}};

void addSpatial(Model& m) {
  m.add<Ground>("world", kWorld);
  m.add<RigidBody>("a",
                   {{"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}, {"position", {0.0, 0.0, 1.0}}});
  m.add<RigidBody>("b", {{"mass", 1.0},
                         {"inertia", {0.1, 0.1, 0.1}},
                         {"position", {1.0, 0.2, 1.0}},
                         {"euler", {0.3, 0.2, 0.1}}});
}

void addPlanar(Model& m) {
  m.add<Ground>("world", kWorld);
  m.add<PlanarBody>("a", {{"mass", 2.0}, {"inertia", 0.1}, {"position", {0.0, 0.0, 1.0}}});
  m.add<PlanarBody>(
      "b", {{"mass", 1.0}, {"inertia", 0.2}, {"position", {1.0, 0.0, 1.0}}, {"angle", 0.4}});
}

std::unique_ptr<GivenFriction> friction() { return std::make_unique<GivenFriction>(1.0, 1.0); }

/// γ against d/dt of the errors (rows without error: friction, at the end), bias against d/dt γ.
void expectRowsFit(Model& m, const Joint& joint, int constraintRows, int rows) {
  m.build();
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Motion motion(m);
    motion.scatter(seed);
    const Eigen::VectorXd gdot = fourPoint([&](double s) {
      const std::vector<double> e = joint.errors(motion.at(s));
      return Eigen::VectorXd(
          Eigen::Map<const Eigen::VectorXd>(e.data(), static_cast<Eigen::Index>(e.size())));
    });
    const Eigen::VectorXd gamma = motion.gamma(joint, 0.0);
    ASSERT_EQ(gdot.size(), constraintRows);
    ASSERT_EQ(gamma.size(), rows);
    EXPECT_LT((gamma.head(constraintRows) - gdot).norm(), kTolerance);
    const Eigen::VectorXd gammadot = fourPoint([&](double s) { return motion.gamma(joint, s); });
    // The direction of a distance turns with v/l: a few derivatives more than kTolerance allows.
    EXPECT_LT((motion.bias(joint) - gammadot).norm(), 10.0 * kTolerance);
  }
}

template <class T>
Joint& add(Model& m, const std::vector<GivenValue>& given, bool withFriction = false) {
  Parameters x = Parameters::of<T>("Joint", "joint", given);
  if (withFriction) x.children.push_back({Kind::law, friction()});
  return static_cast<Joint&>(m.add(std::make_unique<T>(x)));
}

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
}  // namespace dynamy
