// Whole models from text, with all standard elements registered through the plug-in's entry.
#include <gtest/gtest.h>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>

#include <cmath>

extern "C" const dynamy::PluginInfo* dynamy_plugin_info();

namespace dynamy {
namespace {

Registry registry() {
  Registry r;
  registerFramework(r);
  dynamy_plugin_info()->registerElements(r);
  return r;
}

Model load(const std::string& inside) {
  Registry r = registry();
  PluginLoader plugins((std::vector<std::filesystem::path>()));
  return loadModelText("<dynamy version=\"1\">\n" + inside + "\n</dynamy>", "m.xml", r, plugins);
}

/// Steps of `dt` until `until`; the state at the end.
State run(Model& m, double until, double dt) {
  MechanicalSystem s = m.mechanicalSystem();
  State x = m.initialState();
  const long steps = std::lround(until / dt);
  for (long i = 0; i < steps; ++i) {
    const StepReport report = m.scheme().step(s, m.solver(), x, dt);
    EXPECT_TRUE(report.solved.ok()) << "step " << i;
    if (!report.solved.ok()) break;
  }
  return x;
}

double energy(Model& m, const State& x) {
  MechanicalSystem s = m.mechanicalSystem();
  const Evaluation& e = s.evaluate(x);
  return e.mass.kineticEnergy({x.u.data(), x.u.size()}) + s.potentialEnergy(x);
}

const char* const kFloor =
    "<Ground name=\"world\"><HalfSpace name=\"floor\" material=\"concrete\"/></Ground>";
const std::string kGravity = "<forces><Gravity/></forces>";

TEST(Models, LetABallBounceToTheHeightOfItsRestitution) {
  Model m =
      load(std::string("<systems><RigidBody name=\"ball\" position=\"0 0 1.1\"><Sphere "
                       "radius=\"0.1\" mass=\"1\" "
                       "material=\"rubber\"/></RigidBody>") +
           kFloor + "</systems>" + kGravity +
           "<elements><Contact between=\"rubber concrete\"><UnilateralCoulomb epsilonN=\"0.8\" "
           "mu=\"0.3\"/></Contact></elements><simulation until=\"1\" step=\"1e-4\"/>");
  // Falls 1 m, and is at the next apex after t = v/g (1 + e), v = √(2 g h).
  const double v = std::sqrt(2.0 * 9.81), apex = v / 9.81 * 1.8;
  const State x = run(m, apex, apex / 10000.0);
  // First order: the impact is late by at most one step, v(1 + e) Δt = 6e-4 m.
  EXPECT_NEAR(x.q[2], 0.1 + 0.64, 1.5e-3);
  EXPECT_NEAR(x.u[2], 0.0, 2e-3);
}

TEST(Models, RollABallAfterItHasSlipped) {
  Model m =
      load(std::string(
               "<systems><RigidBody name=\"ball\" position=\"0 0 0.1\" velocity=\"7 0 0\"><Sphere "
               "radius=\"0.1\" mass=\"1\" material=\"rubber\"/></RigidBody>") +
           kFloor + "</systems>" + kGravity +
           "<elements><Contact between=\"rubber concrete\"><UnilateralCoulomb "
           "mu=\"0.5\"/></Contact></elements>");
  const State x = run(m, 1.0, 1e-3);
  // Slip ends at t = 2 v/(7 μ g) = 0.41 s with 5/7 of the velocity, which is exact for constant
  // forces.
  EXPECT_NEAR(x.u[0], 5.0, 1e-9);
  EXPECT_NEAR(x.u[4], 50.0, 1e-8);
}

TEST(Models, HoldABlockOnASlopeByFriction) {
  // tan(20°) = 0.364 < 0.4; tangent row of a plane contact.
  const std::string scene =
      "<systems><PlanarBody name=\"block\" position=\"-0.0342020143325669 0 0.0939692620785908\" "
      "angle=\"20deg\"><Box "
      "size=\"0.4 0.2 0.2\" mass=\"2\" material=\"wood\"/></PlanarBody><Ground "
      "name=\"slope\"><HalfSpace "
      "normal=\"-0.342020143325669 0 0.939692620785908\" material=\"wood\"/></Ground></systems>" +
      kGravity;
  Model m = load(scene +
                 "<elements><Contact between=\"wood wood\"><UnilateralCoulomb "
                 "mu=\"0.4\"/></Contact></elements>");
  const State x = run(m, 0.5, 1e-3);
  EXPECT_LT(x.u.norm(), 1e-9);  // residual of the solver
}

TEST(Models, SwingADoublePendulumOfRigidBodies) {
  // Planar bodies with hinges keep their energy at any step. Rounding: positions of 1 m to 1e-16
  // make velocities of 1e-16 m / Δt, which a momentum of 6 kg m/s turns into energy, all steps of
  // 0.5 s in one sense: 500 · 6e-13 J and 50 · 6e-14 J.
  const std::string scene =
      "<systems><Ground name=\"world\"/>"
      "<PlanarBody name=\"a\" position=\"0.5 0 0\"><Box size=\"1 0.1 0.1\" "
      "mass=\"1\"/></PlanarBody>"
      "<PlanarBody name=\"b\" position=\"1.5 0 0\"><Box size=\"1 0.1 0.1\" "
      "mass=\"1\"/></PlanarBody>"
      "</systems>" +
      kGravity +
      "<elements><Revolute name=\"j\" between=\"world a\" at=\"0 0 0\"/>"
      "<Revolute name=\"k\" between=\"a b\" at=\"1 0 0\"/></elements>";
  const auto drift = [&](double dt) {
    Model m = load(scene);
    const State x = run(m, 0.5, dt);
    EXPECT_LT(x.q[1], -0.1);
    return energy(m, x) - energy(m, m.initialState());
  };
  EXPECT_NEAR(drift(1e-3), 0.0, 3e-10);
  EXPECT_NEAR(drift(1e-2), 0.0, 3e-12);
}

TEST(Models, SwingASpatialHingeLikeAPlanarOne) {
  const char* const body = "position=\"0.5 0 0\"><Box size=\"1 0.1 0.2\" mass=\"1\"/>";
  Model plane = load(std::string("<systems><Ground name=\"world\"/><PlanarBody name=\"a\" ") +
                     body + "</PlanarBody></systems>" + kGravity +
                     "<elements><Revolute between=\"world a\" at=\"0 0 0\"/></elements>");
  Model space =
      load(std::string("<systems><Ground name=\"world\"/><RigidBody name=\"a\" ") + body +
           "</RigidBody></systems>" + kGravity +
           "<elements><Revolute between=\"world a\" at=\"0 0 0\" axis=\"0 1 0\"/></elements>");
  const State p = run(plane, 0.3, 1e-3), s = run(space, 0.3, 1e-3);
  // The same equations in other coordinates: only the solver's residual differs, 300 steps of it.
  EXPECT_NEAR(s.q[0], p.q[0], 1e-7);
  EXPECT_NEAR(s.q[2], p.q[1], 1e-7);
  EXPECT_NEAR(s.u[4], -p.u[2], 1e-6);
}

TEST(Models, LoadTheExamplesOfAllSystemsAndShapes) {
  const Registry r = registry();
  for (const RegisteredType* type : r.types()) {
    if (type->library == "dynamy" && type->attributes.exampleText().empty()) continue;
    const std::string& example = type->attributes.exampleText();
    std::string text;
    if (type->kind == Kind::system)
      text = "<systems>" + example + "</systems>";
    else if (type->kind == Kind::shape)
      text = "<systems><RigidBody name=\"b\"><Sphere radius=\"0.1\" mass=\"1\"/>" + example +
             "</RigidBody></systems>";
    else if (type->kind == Kind::rule)
      text = "<elements>" + example + "</elements>";
    else
      continue;
    EXPECT_FALSE(example.empty()) << type->name;
    try {
      load(text);
    } catch (const ModelError& e) {
      ADD_FAILURE() << type->name << ": " << e.what();
    }
  }
}

TEST(Models, LoadTheExamplesOfJointsAndForces) {
  const Registry r = registry();
  const std::string systems =
      "<systems><Ground name=\"world\"/><RigidBody name=\"rod\" position=\"1 0 0\" mass=\"1\" "
      "inertia=\"1 1 "
      "1\"/><RigidBody name=\"cart\" position=\"1 0 0\" mass=\"1\" inertia=\"1 1 1\"/><RigidBody "
      "name=\"ball\" "
      "position=\"1 0 0\" mass=\"1\" inertia=\"1 1 1\"/><RigidBody name=\"base\" mass=\"1\" "
      "inertia=\"1 1 "
      "1\"/><PointMass name=\"bob\" position=\"1 0 0\" mass=\"1\"/></systems>";
  for (const char* name : {"Gravity", "SpringDamper", "TorsionSpring", "ForceInput", "Revolute",
                           "Spherical", "Prismatic", "Fixed", "Distance"}) {
    const RegisteredType* type = r.find(name);
    ASSERT_NE(type, nullptr) << name;
    const std::string section = type->kind == Kind::force ? "forces" : "elements";
    try {
      load(systems + "<" + section + ">" + type->attributes.exampleText() + "</" + section + ">");
    } catch (const ModelError& e) {
      ADD_FAILURE() << name << ": " << e.what();
    }
  }
}

}  // namespace
}  // namespace dynamy
