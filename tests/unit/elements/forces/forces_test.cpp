// Forces: power against the rate of the potential, −dV/dt along a motion; and closed forms.
#include <gtest/gtest.h>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/point_mass.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/forces/bushing.hpp>
#include <dynamy_elements/forces/drag.hpp>
#include <dynamy_elements/forces/elastic_rope.hpp>
#include <dynamy_elements/forces/force_input.hpp>
#include <dynamy_elements/forces/gravity.hpp>
#include <dynamy_elements/forces/springs.hpp>
#include <dynamy_elements/joints/coordinate_forces.hpp>

#include "unit/elements/motion.hpp"

namespace dynamy {
namespace {

using testing::fourPoint;
using testing::kTolerance;
using testing::Motion;

struct Forces {
  Eigen::VectorXd h, nonPotential;
};

Forces forces(const ExternalForce& f, Motion& motion) {
  const Kinematics& k = motion.at(0.0);
  Forces out;
  out.h.setZero(motion.start().u.size());
  out.nonPotential.setZero(out.h.size());
  ForceSink sink({out.h.data(), out.h.size()}, {out.nonPotential.data(), out.nonPotential.size()});
  sink.hasPotential(f.hasPotential());
  f.addTo(k, sink);
  return out;
}

/// (h − nonPotential)·u = −dV/dt for a scene whose ground stands still.
void expectPotentialFits(Model& m) {
  m.build();
  const ExternalForce& force = *m.forces().at(0);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Motion motion(m);
    motion.scatter(seed, 0.5);
    const Forces f = forces(force, motion);
    const double power = (f.h - f.nonPotential).dot(motion.start().u);
    const Eigen::VectorXd Vdot = fourPoint([&](double s) {
      return Eigen::VectorXd::Constant(1, force.potentialEnergy(motion.at(s)));
    });
    // Energies up to 100 J on top of the scale of lengths.
    EXPECT_NEAR(power, -Vdot[0], 100.0 * kTolerance);
  }
}

void addBodies(Model& m) {
  m.add<Ground>("world", {{"position", {0.1, 0.2, 0.3}}});
  m.add<RigidBody>("a",
                   {{"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}, {"position", {1.0, 2.0, 3.0}}});
  m.add<PlanarBody>("b", {{"mass", 1.0}, {"inertia", 0.2}, {"plane", "xy"}});
  m.add<PointMass>("c", {{"mass", 0.5}, {"plane", "yz"}});
}

TEST(Gravity, IsTheGradientOfItsPotential) {
  Model m;
  addBodies(m);
  m.add<Gravity>("g", {{"acceleration", {1.0, -2.0, -9.81}}});
  expectPotentialFits(m);
}

TEST(Gravity, ChangesAsToldAndDoesWorkThen) {
  Model m;
  addBodies(m);
  m.add<Gravity>("g", {{"acceleration", {0.0, 0.0, -9.81}}, {"change", "2*t; 0; t"}});
  m.build();
  const ExternalForce& gravity = *m.forces().at(0);
  EXPECT_FALSE(gravity.hasPotential());
  Motion motion(m, 0.25);
  const Forces f = forces(gravity, motion);
  // Body a of 2 kg at t = 0.25: 2 (0.5, 0, -9.81 + 0.25).
  EXPECT_DOUBLE_EQ(f.h[0], 1.0);
  EXPECT_DOUBLE_EQ(f.h[1], 0.0);
  EXPECT_DOUBLE_EQ(f.h[2], 2.0 * (-9.81 + 0.25));
  EXPECT_EQ(f.nonPotential, f.h);
  EXPECT_EQ(gravity.potentialEnergy(motion.at(0.0)), 0.0);
}

TEST(SpringDamper, IsTheGradientOfItsPotentialWithoutItsDamper) {
  Model m;
  addBodies(m);
  m.add<SpringDamper>("s", {{"between", "a b"},
                            {"pointA", {0.1, 0.2, 0.3}},
                            {"pointB", {-0.2, 0.1, 0.0}},
                            {"stiffness", 50.0},
                            {"damping", 3.0},
                            {"length", 0.7}});
  expectPotentialFits(m);
}

TEST(SpringDamper, LosesEnergyInItsDamper) {
  Model m;
  addBodies(m);
  m.add<SpringDamper>("s", {{"between", "world c"}, {"stiffness", 0.0}, {"damping", 3.0}});
  m.build();
  Motion motion(m);
  motion.scatter(7);
  const Forces f = forces(*m.forces()[0], motion);
  EXPECT_LT(f.h.dot(motion.start().u), 0.0);
  EXPECT_EQ(f.h, f.nonPotential);
}

TEST(SpringDamper, IsAtRestAtTheStartWithoutALength) {
  Model m;
  addBodies(m);
  m.add<SpringDamper>("s", {{"between", "world a"}, {"stiffness", 50.0}});
  m.build();
  Motion motion(m, 0.0);
  EXPECT_EQ(forces(*m.forces()[0], motion).h.norm(), 0.0);
}

TEST(TorsionSpring, IsTheGradientOfItsPotentialBetweenPlanarBodies) {
  Model m;
  m.add<Ground>("world", {});
  m.add<PlanarBody>("a", {{"mass", 1.0}, {"inertia", 0.2}, {"angle", 0.3}});
  m.add<PlanarBody>("b", {{"mass", 1.0}, {"inertia", 0.2}});
  m.add<TorsionSpring>("s", {{"between", "a b"},
                             {"axis", {0.0, -1.0, 0.0}},
                             {"stiffness", 5.0},
                             {"damping", 1.0},
                             {"angle", 0.2}});
  expectPotentialFits(m);
}

TEST(TorsionSpring, IsTheGradientOfItsPotentialWhereBodiesTilt) {
  Model m;
  m.add<Ground>("world", {});
  m.add<RigidBody>("a", {{"mass", 1.0}, {"inertia", {0.2, 0.3, 0.4}}, {"euler", {0.3, -0.2, 0.5}}});
  m.add<RigidBody>("b", {{"mass", 1.0}, {"inertia", {0.3, 0.3, 0.2}}, {"euler", {-0.4, 0.6, 0.1}}});
  m.add<TorsionSpring>("s", {{"between", "a b"},
                             {"axis", {0.6, 0.0, 0.8}},
                             {"stiffness", 5.0},
                             {"damping", 1.0},
                             {"angle", 0.2}});
  expectPotentialFits(m);
}

TEST(TorsionSpring, ReadsTheAngleOfThePlane) {
  Model m;
  m.add<Ground>("world", {});
  m.add<PlanarBody>("a", {{"mass", 1.0}, {"inertia", 0.2}, {"angle", 0.3}});
  m.add<TorsionSpring>("s",
                       {{"between", "world a"}, {"axis", {0.0, -1.0, 0.0}}, {"stiffness", 5.0}});
  m.build();
  Motion motion(m, 0.0);
  EXPECT_NEAR(forces(*m.forces()[0], motion).h[2], -1.5, 1e-14);  // rounding of the arctangent
}

TEST(ForceInput, ActsAtItsPointAtTheTime) {
  Model m;
  m.add<PlanarBody>("a", {{"mass", 1.0}, {"inertia", 0.2}, {"plane", "xy"}});
  m.add<ForceInput>(
      "f",
      {{"on", "a"}, {"point", {0.5, 0.0, 0.0}}, {"force", "1; 10*t; 0"}, {"moment", "0; 0; 7"}});
  m.build();
  Motion motion(m, 0.3);
  const Forces f = forces(*m.forces()[0], motion);
  EXPECT_DOUBLE_EQ(f.h[0], 1.0);
  EXPECT_DOUBLE_EQ(f.h[1], 3.0);
  EXPECT_DOUBLE_EQ(f.h[2], 7.0 + 0.5 * 3.0);
  EXPECT_EQ(f.h, f.nonPotential);
}

TEST(ElasticRope, IsTheGradientOfItsPotential) {
  // Two drums that move and turn, and a sheave between them that moves; the damper's part is none of
  // the potential.
  for (const double damping : {0.0, 0.1}) {
    Model m;
    for (const auto& [name, x, z] : {std::tuple{"a", 0.0, 0.0}, {"b", 6.0, 0.0}, {"c", 3.0, 4.0}})
      m.add<PlanarBody>(name, {{"mass", 1.0}, {"inertia", 0.2}, {"position", {x, 0.0, z}}});
    m.add(std::make_unique<ElasticRope>(
        Parameters::of<ElasticRope>("ElasticRope", "rope",
                                    {{"between", "a b"},
                                     {"pointA", {0.1, 0.0, 0.2}},
                                     {"drumA", 0.5},
                                     {"drumB", 0.3},
                                     {"sideA", {-1.0, 0.0, 0.0}},
                                     {"damping", damping},
                                     {"EA", 40.0},
                                     {"preload", 15.0}})
            .with(std::make_unique<Sheave>(Parameters::of<Sheave>(
                "Sheave", "", {{"on", "c"}, {"radius", 0.4}, {"point", {0.0, 0.0, 0.1}}})))));
    expectPotentialFits(m);
  }
}

TEST(ForceInput, PointsAtTheMistakeInAFormula) {
  try {
    ForceInput(
        Parameters::of<ForceInput>("ForceInput", "f", {{"on", "a"}, {"force", "0; sim(t); 0"}}));
    FAIL() << "no error";
  } catch (const ModelError& error) {
    EXPECT_EQ(error.diagnostics().at(0).hint, "did you mean \"sin\"?");
  }
}

TEST(Bushing, IsTheGradientOfItsPotentialAtLargeAngles) {
  Model m;
  addBodies(m);
  m.add<Bushing>("b", {{"between", "world a"},
                       {"at", {0.3, 0.0, 0.2}},
                       {"stiffness", {10.0, 20.0, 5.0}},
                       {"damping", {1.0, 2.0, 3.0}},
                       {"turnStiffness", {3.0, 1.0, 2.0}},
                       {"turnDamping", {0.1, 0.2, 0.3}}});
  expectPotentialFits(m);
}

TEST(Bushing, ActsOnTwoBodies) {
  Model m;
  addBodies(m);
  m.add<Bushing>(
      "b",
      {{"between", "b a"}, {"stiffness", {10.0, 20.0, 5.0}}, {"turnStiffness", {3.0, 1.0, 2.0}}});
  expectPotentialFits(m);
}

TEST(JointSpring, IsTheGradientOfItsPotential) {
  for (const char* coordinate : {"angle", "displacement"}) {
    SCOPED_TRACE(coordinate);
    Model m;
    addBodies(m);
    m.add<JointSpring>("s", {{"between", "b a"},
                             {"coordinate", coordinate},
                             {"axis", {0.2, 0.1, 1.0}},
                             {"stiffness", 4.0},
                             {"damping", 0.3}});
    expectPotentialFits(m);
  }
}

TEST(Drag, IsThatOfTheVelocityAgainstTheWind) {
  Model m;
  addBodies(m);
  m.add<Drag>("d", {{"on", "c"},
                    {"area", 0.5},
                    {"coefficient", 0.8},
                    {"density", 2.0},
                    {"viscous", 0.1},
                    {"wind", "0; t; 3"}});
  m.build();
  Motion motion(m, 2.0);
  State& x = motion.start();
  x.u.setZero();  // v = (0, −2, −3) against the wind; 0.4 |v| + 0.1
  const Forces f = forces(*m.forces().at(0), motion);
  const double factor = 0.4 * std::sqrt(13.0) + 0.1;
  const Eigen::Index first = f.h.size() - 2;
  EXPECT_NEAR(f.h[first], 2.0 * factor, 1e-14);
  EXPECT_NEAR(f.h[first + 1], 3.0 * factor, 1e-14);
}

}  // namespace
}  // namespace dynamy
