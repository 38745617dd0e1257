// Mutated models that broke a promise of `dynamy check` (scripts/mutate-models), cut down.
#include <gtest/gtest.h>

#include <fuzz/small_runs.hpp>

namespace dynamy {
namespace {

class Mutants : public ::testing::Test {
 protected:
  /// What is wrong with the model; "" if nothing is.
  std::string fault(const std::string& systems, const std::string& elements) {
    const std::string text = R"(<dynamy version="1"><systems>)" + systems + "</systems><elements>" +
                             elements +
                             R"(</elements><simulation until="1ms" step="1ms"/></dynamy>)";
    try {
      Model model = loadModelText(text, "mutant.xml", world_.registry, world_.plugins);
      Simulation(model).run();
      return {};
    } catch (const ModelError& e) {
      EXPECT_GT(e.diagnostics().front().place.line, 0) << e.what();
      return e.what();
    }
  }
  /// A contact of `other` shape is not of the kind of `convex`, beside or behind it.
  void expectNotAlike(const std::string& other, const std::string& convex,
                      const std::string& rest) {
    const std::string law =
        R"(<Contact between="p q"><Unilateral/></Contact><NoContact between="p p"/>)";
    EXPECT_EQ(fault(convex + convex + rest, law), "");
    EXPECT_TRUE(has(fault(other + convex + rest, law), "is not available"));
    EXPECT_TRUE(has(fault(convex + other + rest, law), "is not available"));
  }
  bool has(const std::string& text, const char* part) { return text.find(part) != text.npos; }
  fuzz::World world_;
};

TEST_F(Mutants, GrainsInABoxOfMoreCellsThanNumbersCount) {
  for (const char* half : {"1e8", "1e18", "1e200"}) {
    const std::string high(half);
    EXPECT_EQ(fault(R"(<Grains count="3" pitch="20mm" within="-)" + high + " -" + high + " 0 " +
                        high + ' ' + high + R"( 1"><Sphere radius="5mm" density="1"/></Grains>)",
                    ""),
              "");
  }
}

/// A hundred thousand bodies in one place are near each other in 5e9 pairs.
TEST_F(Mutants, CopiesInOnePlaceAreToldAndNotPairedWithoutEnd) {
  Model model = loadModelText(
      R"(<dynamy version="1"><systems><replicate count="9000">
           <RigidBody name="b" mass="1" inertia="1 1 1"><Sphere radius="1" material="p"/></RigidBody>
         </replicate></systems>
         <elements><Contact between="p p"><Unilateral/></Contact></elements></dynamy>)",
      "mutant.xml", world_.registry, world_.plugins);
  try {
    model.mechanicalSystem().evaluate(model.initialState());
    FAIL() << "no error";
  } catch (const ModelError& e) {
    EXPECT_TRUE(has(e.what(), "are near each other, \"b[")) << e.what();
    EXPECT_TRUE(has(e.what(), "did one copy too many?")) << e.what();
  }
}

/// Of 99999 shapes none beyond the thousandth is read: the error is told once.
TEST_F(Mutants, ChildrenBeyondTheMostAreNotRead) {
  const std::string text = fault(R"(<RigidBody name="b" mass="1" inertia="1 1 1">
                 <replicate count="99999"><Sphere radius="{1001 - i}"/></replicate></RigidBody>)",
                                 "");
  EXPECT_TRUE(has(text, "takes at most 1000 shapes")) << text;
  EXPECT_FALSE(has(text, "must be")) << text;  // as radii of the last copies would be told
}

/// The second is not convex: a ball cannot touch it, though it can touch the first.
TEST_F(Mutants, PolygonsOfAsManyCornersNeedNotBeAlike) {
  const auto polygon = [](const std::string& last) {
    return R"(<PlanarBody mass="1" inertia="1"><Polygon material="p" points="0 0 0  1 0 0  1 0 1  )" +
           last + R"("/></PlanarBody>)";
  };
  expectNotAlike(polygon("0.9 0 0.5"), polygon("0 0 1"),
                 R"(<PlanarBody position="0 0 5" mass="1" inertia="1">
    <Sphere radius="0.1" material="q"/></PlanarBody>)");
}

/// A contour that goes in touches a plane at more than one point.
TEST_F(Mutants, ContoursNeedNotBeAlike) {
  const auto contour = [](const std::string& r) {
    return R"(<PlanarBody position="0 0 5" mass="1" inertia="1"><Contour material="p" r=")" + r +
           R"(" euler="{pi/2} 0 0"/></PlanarBody>)";
  };
  expectNotAlike(contour("0.2 + 0.1*cos(4*phi)"), contour("0.2 + 0.01*cos(2*phi)"),
                 R"(<Ground name="g"><HalfSpace material="q"/></Ground>)");
}

TEST_F(Mutants, AContactOfCoordinatesNeedsAFormula) {
  EXPECT_TRUE(has(fault(R"(<PlanarBody name="a" mass="1" inertia="1"/>)",
                        R"(<CoordinateContact on="a"><Bilateral/></CoordinateContact>)"),
                  "nothing that it could act on"));
}

}  // namespace
}  // namespace dynamy
