// Which laws runs to a tolerance follow: the table of theory 50.8, and the refusal of the others.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/law/set_valued_force_law.hpp>
#include <fstream>
#include <map>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// A ball thrown on a table.
std::string thrownBall(const std::string& law) {
  return R"xml(<dynamy version="1"><systems>
  <RigidBody name="ball" position="0 0 0.06" velocity="0.3 0.1 0" angularVelocity="0 0 5">
  <Sphere radius="0.05" mass="0.2" material="a"/></RigidBody>
  <Ground name="table"><HalfSpace material="b"/></Ground></systems><forces><Gravity/></forces>
  <elements><Contact between="a b">)xml" +
         law + R"xml(</Contact></elements><simulation until="1" step="1"/></dynamy>)xml";
}

/// A body pushed to and fro on a line.
std::string slider(const std::string& row, const std::string& law) {
  return R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" q0="0" u0="0.2" M="2"
  h="40*sin(9*t)"/></systems><elements><CoordinateContact name="c" on="body" )xml" +
         row + ">" + law +
         R"xml(</CoordinateContact></elements><simulation until="1" step="1"/></dynamy>)xml";
}

/// Two bodies on the strands of a rope round a drum.
std::string sheave(const std::string& law) {
  return R"xml(<dynamy version="1"><systems><Ground name="drum"/>
  <PlanarBody name="pulled" position="-0.2 -0.06 -0.6" mass="20" inertia="0.1"/>
  <PlanarBody name="held" position="-0.2 0.06 0.6" mass="20" inertia="0.1"/></systems>
  <forces><ForceInput on="pulled" force="0; 0; -700"/><ForceInput on="held" force="0; 0; 100"/>
  </forces><elements><SheaveRope name="rope" between="pulled held" sheave="drum" carrier="drum"
  radius="0.2" side="-1 0 0" turns="1">)xml" +
         law + R"xml(</SheaveRope></elements><simulation until="1" step="1"/></dynamy>)xml";
}

struct TableCase {
  const char* law;
  std::string scene;
  bool followed = true;
};

std::vector<TableCase> tableCases() {
  const std::string slip = R"(slipVelocity="x_dot")", gap = R"(gap="x")";
  return {
      {"Bilateral", slider(gap, "<Bilateral/>")},
      {"Unilateral", thrownBall("<Unilateral/>")},
      {"UnilateralCoulomb", thrownBall(R"(<UnilateralCoulomb mu="0.3"/>)")},
      {"UnilateralStribeck",
       thrownBall(R"(<UnilateralStribeck mu="0.4" kineticMu="0.2" speed="0.05"/>)")},
      {"UnilateralOrthotropic", thrownBall(R"(<UnilateralOrthotropic mu1="0.1" mu2="0.3"/>)")},
      {"UnilateralDrilling", thrownBall(R"(<UnilateralDrilling mu="0.3" radius="2mm"/>)")},
      {"UnilateralRolling", thrownBall(R"(<UnilateralRolling mu="0.3" rolling="0.1mm"/>)")},
      {"UnilateralAdhesion", thrownBall(R"(<UnilateralAdhesion force="1"/>)")},
      {"UnilateralAdhesion", thrownBall(R"(<UnilateralAdhesion force="1" mu="0.3"/>)"), false},
      {"GivenFriction", slider(slip, R"(<GivenFriction force="5"/>)")},
      {"StribeckFriction",
       slider(slip, R"(<StribeckFriction force="5" kineticForce="3" speed="0.1"/>)")},
      {"ForceLimit", slider(slip, R"(<ForceLimit lower="-2" upper="5"/>)")},
      {"OneWayClutch", slider(slip, "<OneWayClutch/>")},
      {"PreloadedSpring", slider(gap, R"(<PreloadedSpring stiffness="50" preload="3"/>)")},
      {"BeltFriction", sheave(R"(<BeltFriction mu="0.2" wrap="360deg"/>)")},
  };
}

/// Word of the second column for each law of the table: yes, partly, no.
std::map<std::string, std::string> documented() {
  std::map<std::string, std::string> out;
  std::ifstream page(DYNAMY_SOURCE_DIR "/doc/theory/50_located_switching.md");
  for (std::string line; std::getline(page, line);) {
    const std::size_t end = line.starts_with("| `") ? line.find("` |") : std::string::npos;
    if (end == std::string::npos) continue;
    const std::size_t word = end + 4, stop = line.find_first_of(" |", word);
    out[line.substr(3, end - 3)] = line.substr(word, stop - word);
  }
  return out;
}

TEST(LocatedLaws, AreFollowedOrRefusedByNameAsTheTableSays) {
  std::map<std::string, int> followed, all;
  for (const TableCase& c : tableCases()) {
    LocatedRun run(c.scene, 1e-6, 1.0);
    const RunReport& r = run.run();
    EXPECT_EQ(r.ended == RunReport::Ended::finished, c.followed) << c.law << ": " << r.reason;
    EXPECT_EQ(r.refused, !c.followed) << c.law;
    EXPECT_EQ(r.located.undecided, 0) << c.law;
    EXPECT_EQ(r.stepping.periods, 0) << c.law;
    if (!c.followed) {
      EXPECT_NE(r.reason.find(std::string("<") + c.law + ">"), std::string::npos) << r.reason;
    }
    all[c.law] += 1, followed[c.law] += c.followed ? 1 : 0;
  }
  const auto table = documented();
  for (const auto& [law, n] : all) {
    const auto row = table.find(law);
    ASSERT_NE(row, table.end()) << law << " is missing";
    EXPECT_EQ(row->second, followed[law] == n   ? "yes"
                           : followed[law] == 0 ? "no"
                                                : "partly")
        << law;
  }
}

TEST(LocatedLaws, HaveARowInTheTableEach) {
  Registry registry;
  registerFramework(registry);
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  plugins.load(kStandardElements, {}, registry);
  const auto table = documented();
  for (const RegisteredType* type : registry.types()) {
    if (type->kind != Kind::law) continue;
    EXPECT_TRUE(table.contains(type->name)) << type->name << " is missing in theory 50.8";
  }
}

/// A unilateral contact that knows its projection alone.
class OwnSet final : public SetValuedForceLaw {
 public:
  static void declare(Attributes&) {}
  explicit OwnSet(const Parameters& x) : SetValuedForceLaw(x) {}
  int dim(int) const override { return 1; }
  bool unilateral() const override { return true; }
  RowKind rowKind(int) const override { return RowKind::normal; }
  void prox(const LawInput&, const double* r, const double* xi, double* Lambda) const override {
    Lambda[0] = std::max(Lambda[0] - r[0] * xi[0], 0.0);
  }
  Status status(const LawInput&, const double* argument) const override {
    return argument[0] > 0.0 ? Status::slip : Status::separating;
  }
};

TEST(LocatedLaws, OfUsersAreRefusedByNameWithoutAShape) {
  LocatedRun run(thrownBall("<OwnSet/>"), 1e-6, 1.0, {},
                 [](Registry& r) { r.add<OwnSet>("OwnSet"); });
  EXPECT_EQ(run.run().ended, RunReport::Ended::failed);
  EXPECT_NE(run.report().reason.find("<OwnSet>"), std::string::npos) << run.report().reason;
}

TEST(LocatedLaws, LetGoWhereTheirScaleJumps) {
  // Held against 3 N until the friction is switched off: 3/2 (t − w)²/2. The bound jumps, which no
  // step of Newton's method finds, and steps at rest have grown beyond the jump. A cube is not
  // foreseen (ExpressionSet::nextInstant).
  for (const char* w : {"2", "20"})
    for (const double tol : {1e-4, 1e-6, 1e-9}) {
      LocatedRun run(R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" q0="0" M="2"
  h="3"/></systems><elements><CoordinateContact name="c" on="body" slipVelocity="x_dot"
  scale="1 - step((t - )xml" +
                         std::string(w) +
                         R"xml()^3)"><GivenFriction force="5"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml",
                     tol, std::stod(w) + 1.0);
      ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
      EXPECT_NEAR(run.state().q[0], 0.75, tol) << w << " " << tol;
      EXPECT_EQ(run.report().contacts.switches, 1) << w << " " << tol;
    }
}

TEST(LocatedLaws, PullUpToTheirForceAndNoLonger) {
  // A lift that grows by 4 N/s: off the ground after (m g + a)/4, then a τ²/2m + 4 τ³/6m.
  LocatedRun run(R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" q0="0" M="0.2"
  h="4*t - 1.962"/></systems><elements><CoordinateContact name="c" on="body" gap="x">
  <UnilateralAdhesion force="1"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml",
                 1e-10, 1.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const double tau = 1.0 - 2.962 / 4.0;
  EXPECT_NEAR(run.state().q[0], tau * tau / 0.4 + 4.0 * tau * tau * tau / 1.2, 1e-9);
  EXPECT_EQ(run.report().contacts.switches, 1);
}

}  // namespace
}  // namespace dynamy::reference
