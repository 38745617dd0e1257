// Trees of joints: their equations against differences, names that stay, what a scene costs.
#include <gtest/gtest.h>
#include <dynamy/testing/check_element.hpp>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/coordinates/coordinate_contact.hpp>
#include <dynamy_elements/forces/gravity.hpp>
#include <dynamy_elements/joints/joints.hpp>
#include <dynamy_elements/trees/compose_trees.hpp>
#include <dynamy_elements/trees/tree_system.hpp>

namespace dynamy {
namespace {

using Free = FreeMotion::Kind;

std::unique_ptr<PartialMechanicalSystem> body(const std::string& name, const Vec3& position,
                                              const Vec3& velocity = Vec3::Zero()) {
  return std::make_unique<RigidBody>(
      Parameters::of<RigidBody>("RigidBody", name,
                                {{"mass", 1.5},
                                 {"inertia", {0.1, 0.2, 0.25, 0.01, 0.02, -0.03}},
                                 {"position", position},
                                 {"velocity", velocity},
                                 {"euler", {0.3, 0.2, 0.1}}}));
}

using Joints = std::vector<std::vector<FreeMotion>>;

std::unique_ptr<TreeSystem> treeOf(const Joints& joints) {
  Parameters x;
  x.type = "Tree";
  auto tree = std::make_unique<TreeSystem>(x, Vec3::Zero());
  int parent = -1;
  Vec3 at(0.1, -0.2, 0.3);
  for (const std::vector<FreeMotion>& free : joints) {
    parent = tree->carry(body("b" + std::to_string(parent + 1), at + Vec3(0.3, 0.2, -0.4)), parent,
                         at, free);
    at += Vec3(0.4, -0.3, -0.5);
  }
  tree->finish();
  return tree;
}

const Vec3 kAxis = Vec3(0.2, 1.0, 0.3).normalized(), kOther = Vec3(-0.5, 0.1, 1.0).normalized();

/// Each simple motion and chains of them, one behind a ball joint, one before it.
class TreeEquations : public ::testing::TestWithParam<std::vector<FreeMotion>> {};

TEST_P(TreeEquations, AgreeWithDifferences) {
  // M, h, gravity, frames, their Jacobians and biases: checkSystem() knows what they have to
  // satisfy and what its differences are worth.
  const std::vector<FreeMotion>& free = GetParam();
  const std::vector<FreeMotion> ball{{Free::ball}};
  for (const Joints& joints :
       {Joints(1, free), Joints{ball, free}, Joints{free, ball}, Joints{free, free, free}}) {
    const Verdict check = checkSystem(*treeOf(joints));
    EXPECT_TRUE(check) << check.message();
  }
}

TEST_P(TreeEquations, InvertTheirMassByArticulatedBodies) {
  // M (M⁻¹ w) = w at a position away from the start. Rounding: ε times the condition of M, below
  // 1e3 for these chains, times some operations.
  const std::vector<FreeMotion>& free = GetParam();
  const std::vector<FreeMotion> ball{{Free::ball}};
  const auto tree = treeOf({free, ball, free, free});
  const int nu = tree->blocks().nu;
  Eigen::VectorXd q(tree->blocks().nq), u(nu), in(nu), out(nu);
  tree->initialState(view(q), view(u));
  for (int i = 0; i < nu; ++i) u[i] = std::sin(1.0 + i), in[i] = std::cos(3.0 * i);
  const Eigen::VectorXd &cq = q, &cu = u, &cin = in;
  tree->move(0.0, view(q), view(cu), 0.7);
  RowMatrix M(nu, nu);
  tree->M(0.0, view(cq), {M.data(), nu, 1});
  tree->applyInverseMass(0.0, view(cq), view(cin), view(out));
  EXPECT_LT((M * out - in).norm(), 1e-11 * in.norm());
}

INSTANTIATE_TEST_SUITE_P(
    Trees, TreeEquations,
    ::testing::Values(std::vector<FreeMotion>{{Free::turn, kAxis}},
                      std::vector<FreeMotion>{{Free::slide, kAxis}},
                      std::vector<FreeMotion>{{Free::screw, kAxis, 0.3}},
                      std::vector<FreeMotion>{{Free::turn, kAxis, 0.0, 0.4}},
                      std::vector<FreeMotion>{{Free::slide, kAxis, 0.0, 2.5}},
                      std::vector<FreeMotion>{{Free::ball}},
                      std::vector<FreeMotion>{{Free::turn, kAxis}, {Free::turn, kOther}},
                      std::vector<FreeMotion>{{Free::slide, kAxis}, {Free::turn, kAxis}},
                      std::vector<FreeMotion>{{Free::slide, Vec3::UnitX()},
                                              {Free::slide, Vec3::UnitY()},
                                              {Free::slide, Vec3::UnitZ()},
                                              {Free::ball}},
                      std::vector<FreeMotion>{}));

TEST(TreeRotors, AddTheirInertiaToTheDiagonalAlone) {
  const auto massOf = [](double rotor) {
    const auto tree = treeOf({{{Free::turn, kAxis}}, {{Free::turn, kOther, 0.0, rotor}}});
    Eigen::VectorXd q = Eigen::VectorXd::Constant(2, 0.3);
    const Eigen::VectorXd& cq = q;
    RowMatrix M(2, 2);
    tree->M(0.0, view(cq), {M.data(), 2, 1});
    return M;
  };
  const RowMatrix difference = massOf(0.7) - massOf(0.0);
  RowMatrix expected = RowMatrix::Zero(2, 2);
  expected(1, 1) = 0.7;
  EXPECT_LT((difference - expected).norm(), 1e-15);  // one addition to an entry below 1
}

// ---- composing ---------------------------------------------------------------------------------

template <class T>
void joint(Model& m, const std::string& name, const std::vector<GivenValue>& given) {
  m.add(std::make_unique<T>(Parameters::of<T>("Joint", name, given)));
}

Model scene() {
  Model m;
  m.simulation.coordinates = JointCoordinates::minimal;
  m.addCompletion(composeTrees);
  m.add<Ground>("world", {});
  return m;
}

void planarRod(Model& m, const std::string& name, double x) {
  m.add<PlanarBody>(name, {{"mass", 1.0}, {"inertia", 1.0 / 12.0}, {"position", {x, 0.0, 0.0}}});
}

/// Rows of closed contacts at the start.
int unknowns(Model& m) {
  MechanicalSystem s = m.mechanicalSystem();
  return s.evaluate(m.initialState()).contacts.rows();
}

TEST(Trees, NeedNoMultipliersWhereATreeSuffices) {
  Model m = scene();
  planarRod(m, "upper", 0.5);
  planarRod(m, "lower", 1.5);
  joint<Revolute>(m, "first", {{"between", "world upper"}, {"at", {0.0, 0.0, 0.0}}});
  joint<Revolute>(m, "second", {{"between", "lower upper"}, {"at", {1.0, 0.0, 0.0}}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 2);
  EXPECT_EQ(unknowns(m), 0);
  EXPECT_NE(m.signal("lower.phi"), nullptr);
  EXPECT_NE(m.signal("lower.joint.angle"), nullptr);
}

TEST(Trees, KeepTheRowsOfTheJointThatClosesALoop) {
  // Three hinges make a tree of three bars, the fourth has the two rows of a hinge in the plane.
  Model m = scene();
  for (const auto& [name, x] : {std::pair("a", 0.5), std::pair("b", 1.5), std::pair("c", 2.5)})
    planarRod(m, name, x);
  joint<Revolute>(m, "1", {{"between", "world a"}, {"at", {0.0, 0.0, 0.0}}});
  joint<Revolute>(m, "2", {{"between", "a b"}, {"at", {1.0, 0.0, 0.0}}});
  joint<Revolute>(m, "3", {{"between", "b c"}, {"at", {2.0, 0.0, 0.0}}});
  joint<Revolute>(m, "4", {{"between", "c world"}, {"at", {3.0, 0.0, 0.0}}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 3);
  EXPECT_EQ(unknowns(m), 2);
}

TEST(Trees, CutTheJointWithFewRows) {
  // A ball joint has three rows, the hinges of the loop five each: it closes the loop, though it
  // comes first.
  Model m = scene();
  for (const auto& [name, x] : {std::pair("a", 0.5), std::pair("b", 1.5)})
    m.add<RigidBody>(name,
                     {{"mass", 1.0}, {"inertia", {1.0, 1.0, 1.0}}, {"position", {x, 0.0, 0.0}}});
  joint<Spherical>(m, "1", {{"between", "world a"}, {"at", {0.0, 0.0, 0.0}}});
  joint<Revolute>(m, "2", {{"between", "a b"}, {"at", {1.0, 0.0, 0.0}}, {"axis", {0.0, 1.0, 0.0}}});
  joint<Revolute>(m, "3",
                  {{"between", "b world"}, {"at", {2.0, 0.0, 0.0}}, {"axis", {0.0, 1.0, 0.0}}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 2);
  EXPECT_EQ(unknowns(m), 3);
}

TEST(Trees, LeaveBodiesWithoutJointsAlone) {
  Model m = scene();
  planarRod(m, "swing", 0.5);
  planarRod(m, "free", 4.0);
  joint<Revolute>(m, "hinge", {{"between", "world swing"}, {"at", {0.0, 0.0, 0.0}}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 4);
  EXPECT_EQ(m.topology().systems().size(), 3U);
}

TEST(Trees, CarryMechanismsThatNothingHolds) {
  Model m = scene();
  planarRod(m, "a", 0.5);
  planarRod(m, "b", 1.5);
  joint<Revolute>(m, "hinge", {{"between", "a b"}, {"at", {1.0, 0.0, 0.0}}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 4);
  EXPECT_EQ(unknowns(m), 0);
}

TEST(Trees, KeepAJointToWhatMovesAsToldAsAConstraint) {
  Model m = scene();
  m.add<Ground>("crank", {{"rotation", "3*t"}, {"axis", {0.0, 1.0, 0.0}}});
  planarRod(m, "a", 0.5);
  planarRod(m, "b", 1.5);
  joint<Revolute>(m, "driven", {{"between", "crank a"}, {"at", {0.0, 0.0, 0.0}}});
  joint<Revolute>(m, "hinge", {{"between", "a b"}, {"at", {1.0, 0.0, 0.0}}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 4);
  EXPECT_EQ(unknowns(m), 2);
  EXPECT_EQ(m.composed.notes.front(), "\"driven\" stays a constraint: \"crank\" moves as told");
}

TEST(Trees, KeepTheFrictionOfAJoint) {
  Model m = scene();
  planarRod(m, "a", 0.5);
  Parameters x = Parameters::of<Revolute>("Revolute", "hinge",
                                          {{"between", "world a"}, {"at", {0.0, 0.0, 0.0}}});
  x.children.push_back({Kind::law, std::make_unique<GivenFriction>(1.0, 1.0)});
  m.add(std::make_unique<Revolute>(x));
  m.build();
  EXPECT_EQ(m.topology().nu(), 1);
  EXPECT_EQ(unknowns(m), 1);
  EXPECT_TRUE(checkContacts(m));
}

TEST(Trees, MayBeAWheelOnItsAxleUnderGravity) {
  // Nothing of its weight comes through the axle; that is no reason to refuse the model.
  Model m = scene();
  m.add<PlanarBody>("wheel", {{"mass", 1.0}, {"inertia", 0.1}, {"angularVelocity", 5.0}});
  m.add<Gravity>("", {});
  joint<Revolute>(m, "hinge", {{"between", "world wheel"}, {"at", {0.0, 0.0, 0.0}}});
  ASSERT_NO_THROW(m.build());
  EXPECT_EQ(m.topology().nu(), 1);
}

TEST(Trees, SayThatNoJointMakesOne) {
  Model m = scene();
  planarRod(m, "a", 0.5);
  try {
    m.build();
    FAIL() << "minimal coordinates without joints";
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("no joint of the model makes a tree"), std::string::npos);
  }
}

TEST(Trees, TakeAJointWithARotorBeforeOthers) {
  // Of two joints between the same bodies the clamp, with fewer motions, would be the coordinate.
  Model m = scene();
  planarRod(m, "bar", 0.5);
  joint<Fixed>(m, "clamp", {{"between", "world bar"}, {"at", {0.0, 0.0, 0.0}}});
  joint<Revolute>(m, "hinge", {{"between", "world bar"}, {"at", {0.0, 0.0, 0.0}}, {"rotor", 0.5}});
  m.build();
  EXPECT_EQ(m.topology().nu(), 1);
}

TEST(Trees, RefuseARotorWhereTheJointIsAConstraint) {
  Model m = scene();
  m.simulation.coordinates = JointCoordinates::absolute;
  planarRod(m, "bar", 0.5);
  joint<Revolute>(m, "hinge", {{"between", "world bar"}, {"at", {0.0, 0.0, 0.0}}, {"rotor", 0.5}});
  try {
    m.build();
    FAIL() << "a rotor without a coordinate was accepted";
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("its rotor needs the coordinate"), std::string::npos);
  }
}

TEST(Trees, TakeTheVelocitiesOfTheBodies) {
  // A hinge at the origin and 3 rad/s: the rod's middle at 0.5 m moves with 1.5 m/s. Rounding: a
  // few operations on numbers of size 1.
  Model m = scene();
  m.add<PlanarBody>("rod", {{"mass", 2.0},
                            {"inertia", 0.1},
                            {"position", {0.5, 0.0, 0.0}},
                            {"velocity", {0.0, 0.0, 1.5}},
                            {"angularVelocity", 3.0}});
  joint<Revolute>(m, "hinge", {{"between", "world rod"}, {"at", {0.0, 0.0, 0.0}}});
  m.build();
  EXPECT_NEAR(m.initialState().u[0], 3.0, 1e-15);
}

TEST(Trees, LoseVelocitiesThatTheirJointsForbid) {
  // Angular momentum about the hinge stays: m v r = (J + m r²) ω, 2·1.5·0.5 = 0.6 ω.
  Model m = scene();
  m.add<PlanarBody>("rod", {{"mass", 2.0},
                            {"inertia", 0.1},
                            {"position", {0.5, 0.0, 0.0}},
                            {"velocity", {0.0, 0.0, 1.5}}});
  joint<Revolute>(m, "hinge", {{"between", "world rod"}, {"at", {0.0, 0.0, 0.0}}});
  m.build();
  EXPECT_NEAR(m.initialState().u[0], 2.5, 1e-14);
  const Composition::Start& start = m.composed.start;
  EXPECT_EQ(start.joint, "hinge");
  EXPECT_EQ(start.joints, 1);
  EXPECT_NEAR(start.off, 2.5, 1e-14);  // of the angular velocity; that of the centre is 0.25 m/s
  EXPECT_NEAR(start.kineticBefore, 2.25, 1e-14);
  EXPECT_NEAR(start.kineticAfter, 0.5 * 0.6 * 2.5 * 2.5, 1e-14);
}

TEST(Trees, TurnFastWithoutGainingEnergy) {
  // M (u_E − u_A) = Δt h(q, ū) gives ½ u_EᵀM u_E = ½ u_AᵀM u_A + Δt ūᵀh(ū). With h at u_A each step
  // would gain ½ Δt² hᵀM⁻¹h.
  const auto tree = treeOf({{{Free::ball}}, {{Free::turn, kAxis}}, {{Free::ball}}});
  const int nu = tree->blocks().nu;
  Eigen::VectorXd q(tree->blocks().nq), u(nu), h(nu), own(nu);
  tree->initialState(view(q), view(u));
  u.setLinSpaced(-30.0, 40.0);
  const Eigen::VectorXd &cq = q, &cu = u;
  const double dt = 1e-3;  // turns by up to 0.1 rad
  tree->h(0.0, view(cq), view(cu), view(h));
  tree->gyroscopicAtMean(0.0, view(cq), view(cu), dt, view(h));
  RowMatrix M(nu, nu);
  tree->M(0.0, view(cq), {M.data(), nu, 1});
  const Eigen::VectorXd end = u + dt * M.ldlt().solve(h), mean = 0.5 * (u + end);
  tree->h(0.0, view(cq), view(mean), view(own));
  // The fixed point is found to 1e-10 of ū; h is quadratic in it.
  EXPECT_LT((h - own).norm(), 1e-8 * own.norm());
}

TEST(Trees, LetFormulasReadTheCoordinatesOfTheirBodies) {
  // A gap and a slip velocity of the second rod, which formulas know by x, z, phi whether joints carry
  // it or not: rows and biases against differences along the motion.
  Model m = scene();
  planarRod(m, "upper", 0.5);
  planarRod(m, "lower", 1.5);
  joint<Revolute>(m, "first", {{"between", "world upper"}, {"at", {0.0, 0.0, 0.0}}});
  joint<Revolute>(m, "second", {{"between", "upper lower"}, {"at", {1.0, 0.0, 0.0}}});
  joint<CoordinateContact>(m, "stop",
                           {{"on", "lower"},
                            {"gap", "0.2 - x*x - 0.5*sin(phi) + 0.3*z + 0.1*t"},
                            {"slipVelocity", "vx*cos(phi) + 0.4*omega - t"}});
  m.build();
  ASSERT_EQ(m.topology().nu(), 2);
  const Verdict check = checkContacts(m);
  EXPECT_TRUE(check) << check.message();
}

TEST(Trees, NameTheirBodiesWhereAFormulaNamesNone) {
  Model m = scene();
  planarRod(m, "rod", 0.5);
  joint<Revolute>(m, "hinge", {{"between", "world rod"}, {"at", {0.0, 0.0, 0.0}}});
  joint<CoordinateContact>(m, "stop", {{"on", "rot"}, {"gap", "phi"}});
  try {
    m.build();
    FAIL() << "a body of no name was found";
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean \"rod\""), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace dynamy
