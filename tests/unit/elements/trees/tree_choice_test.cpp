// Which joints become coordinates where a model leaves it to the program: by its method, by what is
// recorded, by what its bodies meet and carry.
#include <gtest/gtest.h>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/joints/joints.hpp>
#include <dynamy_elements/joints/spatial_joints.hpp>
#include <dynamy_elements/standard_elements.hpp>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

/// A model of which the program chooses the coordinates, from the inside of systems and elements.
struct ChosenModel {
  ChosenModel(const std::string& systems, const std::string& elements, const std::string& method,
              const std::string& record = "", const RunSetup& setup = {})
      : run("<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + systems +
                "</systems><elements>" + elements + "</elements><simulation until=\"0.1\" " +
                method + "/>" + record + "</dynamy>",
            setup) {}
  const Composition& made() { return run.model().composed; }
  std::string notes() {
    std::string out;
    for (const std::string& line : made().notes) out += line + "\n";
    return out;
  }
  BoundedRun run;
};

std::string rod(const std::string& name, double x, double m = 1.0, const std::string& shape = "") {
  return "<RigidBody name=\"" + name + "\" mass=\"" + std::to_string(m) +
         "\" inertia=\"0.1 0.1 0.1\" position=\"" + std::to_string(x) + " 0 0\">" + shape +
         "</RigidBody>";
}

std::string hinge(const std::string& name, const std::string& between, double x,
                  const std::string& more = "") {
  return "<Revolute name=\"" + name + "\" between=\"" + between + "\" at=\"" + std::to_string(x) +
         " 0 0\" axis=\"0 1 0\"" + more + "/>";
}

const std::string kTolerance = "tolerance=\"1e-6\"", kStep = "step=\"1e-3\"";
const std::string kChain = rod("a", 0.5) + rod("b", 1.5);
const std::string kHinges = hinge("h", "world a", 0.0) + hinge("k", "a b", 1.0);

TEST(TreeChoice, TakesJointsOfMechanismsInRunsToATolerance) {
  // Two bodies in space have 12 velocities; two hinges leave 2 and had 5 rows each.
  ChosenModel m(kChain, kHinges, kTolerance);
  EXPECT_EQ(m.made().coordinates, 2);
  EXPECT_EQ(m.made().joints, 2);
  EXPECT_EQ(m.made().velocitiesBefore, 12);
  EXPECT_EQ(m.made().velocitiesAfter, 2);
  EXPECT_EQ(m.made().rowsSaved, 10);
  EXPECT_EQ(m.run.model().topology().nu(), 2);
}

/// As the program runs models: nobody reads q and u.
constexpr RunSetup kRun{.reduce = true};

TEST(TreeChoice, LeavesJointsToTheSchemeOfFixedSteps) {
  ChosenModel m(kChain, kHinges, kStep);
  EXPECT_EQ(m.made().coordinates, 0);
  EXPECT_EQ(m.run.model().topology().nu(), 12);
  EXPECT_NE(m.notes().find("steps have a fixed length"), std::string::npos) << m.notes();
  BoundedRun named("<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + kChain +
                       "</systems><elements>" + kHinges + "</elements><simulation until=\"0.1\" " +
                       kStep + "><StaggeredMoreau/></simulation></dynamy>",
                   kRun);
  EXPECT_EQ(named.model().composed.coordinates, 0);
}

TEST(TreeChoice, TakesSmallMechanismsInFixedSteps) {
  ChosenModel two(kChain, kHinges, kStep, "", kRun);
  EXPECT_EQ(two.made().coordinates, 2);
  std::string bodies, hinges;
  for (int i = 0; i < 7; ++i) {
    const std::string name = "r" + std::to_string(i);
    bodies += rod(name, i + 0.5);
    hinges += hinge("h" + std::to_string(i),
                    (i == 0 ? "world " : "r" + std::to_string(i - 1) + " ") + name, i);
  }
  ChosenModel seven(bodies, hinges, kStep, "", kRun);
  EXPECT_EQ(seven.made().coordinates, 0);
  EXPECT_NE(seven.notes().find("7 velocities of a mechanism cost more than its constraints"),
            std::string::npos)
      << seven.notes();
}

TEST(TreeChoice, LeavesBodiesWithContactsToFixedSteps) {
  const std::string ball = "<Sphere radius=\"0.1\" material=\"wood\"/>";
  ChosenModel m(rod("a", 0.5, 1.0, ball) + rod("b", 9.5, 1.0, ball),
                hinge("h", "world a", 0.0) +
                    "<Contact between=\"wood wood\"><UnilateralCoulomb mu=\"0.3\"/></Contact>",
                kStep, "", kRun);
  EXPECT_EQ(m.made().coordinates, 0);
  EXPECT_NE(m.notes().find("\"a\" meets others by its shapes"), std::string::npos) << m.notes();
}

TEST(TreeChoice, TakesAMechanismWithARotorWhateverTheSteps) {
  // The rotor needs its coordinate; the lone body on its own hinge needs none.
  ChosenModel m(kChain + rod("c", 5.0),
                hinge("h", "world a", 0.0) + hinge("k", "a b", 1.0, " rotor=\"0.1\"") +
                    hinge("l", "world c", 4.5),
                kStep);
  EXPECT_EQ(m.made().coordinates, 2);
  EXPECT_EQ(m.run.model().topology().nu(), 2 + 6);
}

TEST(TreeChoice, TellsOnceWhyManyJointsStay) {
  std::string bodies, hinges;
  for (int i = 0; i < 8; ++i) {
    const std::string own = "b" + std::to_string(i);
    bodies += rod(own.c_str(), i);
    const std::string between = (i == 0 ? "world " : "b" + std::to_string(i - 1) + ' ') + own;
    hinges += hinge(("j" + std::to_string(i)).c_str(), between.c_str(), i);
  }
  ChosenModel m(bodies, hinges, kStep, "", kRun);
  EXPECT_NE(
      m.notes().find("\"j0\", \"j1\" and 6 more stay constraints: in steps of a fixed length 8"),
      std::string::npos)
      << m.notes();
}

TEST(TreeChoice, KeepsTheForcesOfJointsThatAreRead) {
  ChosenModel named(kChain, kHinges, kTolerance, "<record signals=\"a.x k.Lambda_T1\"/>");
  EXPECT_EQ(named.made().coordinates, 1);
  EXPECT_NE(named.notes().find("\"k\" stays a constraint: \"k.Lambda_T1\" is read"),
            std::string::npos)
      << named.notes();
  ChosenModel checked(kChain, kHinges, kTolerance,
                      "<check signal=\"h.Lambda_T2\" between=\"-inf inf\"/>");
  EXPECT_EQ(checked.made().coordinates, 1);
  ChosenModel all(kChain, kHinges, kTolerance, "<record signals=\"*\"/>");
  EXPECT_EQ(all.made().coordinates, 0);
  // The angle of a hinge is there in both coordinates.
  ChosenModel motion(kChain, kHinges, kTolerance, "<record signals=\"k.angle\"/>");
  EXPECT_EQ(motion.made().coordinates, 2);
}

TEST(TreeChoice, KeepsBodiesWhoseVelocitiesAreKept) {
  ChosenModel m(kChain, kHinges, kTolerance + " keep=\"a\"");
  EXPECT_EQ(m.made().coordinates, 0);
}

TEST(TreeChoice, LeavesLooseMechanismsInSpaceThatMeetOthersToTheirBodies) {
  const std::string ball = "<Sphere radius=\"0.1\" material=\"wood\"/>";
  const std::string bodies = rod("a", 0.5, 1.0, ball) + rod("b", 1.5, 1.0, ball);
  const std::string touch =
      "<Contact between=\"wood wood\"><UnilateralCoulomb mu=\"0.3\"/></Contact>";
  ChosenModel loose(bodies, hinge("k", "a b", 1.0) + touch, kTolerance);
  EXPECT_EQ(loose.made().coordinates, 0);
  EXPECT_NE(loose.notes().find("meets other moving bodies"), std::string::npos) << loose.notes();
  ChosenModel apart(bodies, hinge("k", "a b", 1.0) + "<NoContact between=\"wood wood\"/>",
                    kTolerance);
  EXPECT_EQ(apart.made().coordinates, 1);
  ChosenModel held(bodies, kHinges + touch, kTolerance);
  EXPECT_EQ(held.made().coordinates, 2);
}

TEST(TreeChoice, LeavesBodiesThatCarryMuchMoreThanTheirMass) {
  // 16 digits of M less those of 1e6: seen from the root, "a" carries "b".
  ChosenModel heavy(rod("a", 0.5, 1.0) + rod("b", 1.5, 1e6), kHinges, kTolerance);
  EXPECT_EQ(heavy.made().coordinates, 0);
  EXPECT_NE(heavy.notes().find("\"a\" carries much more than its own mass"), std::string::npos)
      << heavy.notes();
  ChosenModel light(rod("a", 0.5, 1e6) + rod("b", 1.5, 1.0), kHinges, kTolerance);
  EXPECT_EQ(light.made().coordinates, 2);
}

TEST(TreeChoice, IsNoReasonToRefuseAModel) {
  // The caller needs a velocity of a body, or a force of a joint: the loader builds the model from
  // its bodies.
  Registry registry;
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, {}, registry);
  const auto load = [&](const std::string& signal, const std::string& number) {
    LoadOptions options;
    options.signals = {signal}, options.numbers = {number};
    return loadModelText("<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + kChain +
                             "</systems><elements>" + kHinges + "</elements><simulation " +
                             kTolerance + "/></dynamy>",
                         "scene.xml", registry, plugins, options);
  };
  EXPECT_EQ(load("b.Omega_y", "a.joint.rate").composed.coordinates, 2);
  const Model asked = load("k.angle", "b.Omega_y"), forced = load("h.lambda_T1", "a.joint.angle");
  for (const Model* m : {&asked, &forced}) {
    EXPECT_EQ(m->composed.coordinates, 0);
    EXPECT_NE(m->composed.notes.back().find(
                  "bodies keep their own coordinates, since elements need them"),
              std::string::npos);
  }
}

TEST(TreeChoice, GivesEachMechanismItsOwnIsland) {
  // Joints that became coordinates belong to their tree and to nothing else: two pendulums apart
  // are two islands.
  ChosenModel m(rod("a", 0.5) + rod("b", 9.5),
                hinge("h", "world a", 0.0) + hinge("k", "world b", 9.0), kTolerance);
  EXPECT_EQ(m.made().coordinates, 2);
  m.run.run();
  EXPECT_EQ(m.run.report().located.islands, 2);
}

TEST(TreeChoice, LetsSpringsConnectBodiesThatAreFixedToEachOther) {
  // Two bodies that a Fixed joint connects are one node of the tree: the spring between them does
  // nothing, as between bodies of their own that the joint holds.
  ChosenModel m(kChain,
                hinge("h", "world a", 0.0) +
                    "<Fixed name=\"k\" between=\"a b\" at=\"1 0 0\"/></elements><forces>"
                    "<SpringDamper name=\"s\" between=\"a b\" stiffness=\"10\" length=\"0.5\"/>"
                    "</forces><elements>",
                kTolerance);
  EXPECT_EQ(m.made().coordinates, 2);
  EXPECT_EQ(m.run.model().topology().nu(), 1);
  m.run.run();
  EXPECT_TRUE(m.run.finished());
}

TEST(TreeChoice, TellsVelocitiesThatTheJointsDoNotAllow) {
  // A rod of 1 kg about its end, J = 0.1, r = 0.5: m v r = (J + m r²) ω, ω = 0.5/0.35 for v = 1, and
  // T falls from 0.5 to ½ 0.35 ω² = 0.357 J. The hinge would not allow −v_z = 1 and Ω = 0.
  ChosenModel m(
      "<RigidBody name=\"a\" mass=\"1\" inertia=\"0.1 0.1 0.1\" position=\"0.5 0 0\" "
      "velocity=\"0 0 -1\"/>",
      hinge("h", "world a", 0.0), kTolerance);
  m.run.run();
  const StartReport start = m.run.report().start;
  EXPECT_EQ(start.velocities.joints, 1);
  EXPECT_EQ(start.velocities.joint.substr(0, 1), "h");
  // Rounding of a few operations on numbers of size 1.
  EXPECT_NEAR(start.kineticBefore, 0.5, 1e-14);
  EXPECT_NEAR(start.kineticAfter, 0.5 * 0.35 * std::pow(0.5 / 0.35, 2), 1e-14);
  EXPECT_NEAR(start.velocities.off, 0.5 / 0.35, 1e-14);
  EXPECT_NEAR(start.velocities.share, std::sqrt(1.0 - 0.25 / 0.35), 1e-14);
}

}  // namespace
}  // namespace dynamy
