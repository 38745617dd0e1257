// What bodies offer beside their equations: rigid parts of trees, derivatives, renewal.
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/point_mass.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>

namespace dynamy {
namespace {

TEST(CarriedBody, HasTheStateOfItsMotion) {
  const double half = std::sqrt(0.5);
  const CarriedBody body({2.0, {0.1, 0.0, 0.0}, Mat3::Identity()}, {half, 0.0, 0.0, half});
  EXPECT_EQ(body.rigidPart().m, 2.0);
  EXPECT_EQ(body.rigidPart().r_BS_K, Vec3(0.1, 0.0, 0.0));
  EXPECT_FALSE(body.rigidPart().fixed);
  RigidMotion motion;
  motion.r_OS_I = {1.0, 2.0, 3.0}, motion.v_S_I = {4.0, 5.0, 6.0};
  motion.p = {half, 0.0, 0.0, half}, motion.Omega_I = {7.0, 0.0, 0.0};
  Eigen::VectorXd q(7), u(6);
  body.ownState(motion, view(q), view(u));
  EXPECT_EQ(q.head<3>(), motion.r_OS_I);
  EXPECT_EQ(u.head<3>(), motion.v_S_I);
  // Two quarter turns about z: body axes are reversed in the plane.
  EXPECT_LE((q.tail<4>() - Eigen::Vector4d(0.0, 0.0, 0.0, 1.0)).norm(), 1e-15);
  EXPECT_LE((u.tail<3>() - Vec3(-7.0, 0.0, 0.0)).norm(), 1e-14);
}

TEST(Bodies, OfferWhatTheyCanDo) {
  const RigidBody body(
      Parameters::of<RigidBody>("RigidBody", "b", {{"mass", 1.0}, {"inertia", {1.0, 1.0, 1.0}}}));
  const PointMass point(Parameters::of<PointMass>("PointMass", "p", {{"mass", 1.0}}));
  const Ground floor(Parameters::of<Ground>("Ground", "floor", {})),
      table(Parameters::of<Ground>("Ground", "table", {{"motion", "0; 0; sin(t)"}}));
  ASSERT_NE(body.abilities().rigid, nullptr);
  EXPECT_EQ(body.abilities().rigid->rigidPart().m, 1.0);
  EXPECT_NE(body.abilities().positionTangents, nullptr);
  EXPECT_EQ(body.abilities().renewable, nullptr);
  EXPECT_EQ(body.abilities().ownInverse, nullptr);
  EXPECT_EQ(point.abilities().rigid, nullptr);
  EXPECT_NE(point.abilities().positionTangents, nullptr);
  ASSERT_NE(floor.abilities().rigid, nullptr);
  EXPECT_TRUE(floor.abilities().rigid->rigidPart().fixed);
  EXPECT_EQ(table.abilities().rigid, nullptr);  // a motion that is prescribed
}

}  // namespace
}  // namespace dynamy
