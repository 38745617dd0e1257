// Formulas in model files: places of faults, parameters, and steps without allocation.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/testing/counting_allocation.hpp>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

std::string errorsOf(const std::string& systems, const std::string& elements = "") {
  Registry registry;
  PluginLoader plugins({std::filesystem::path(DYNAMY_BINARY_DIR) / "lib" / "dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, registry);
  try {
    loadModelText("<dynamy version=\"1\">\n<parameter name=\"l\" value=\"0.5\"/>\n<systems>\n" +
                      systems + "\n</systems>\n<elements>\n" + elements +
                      "\n</elements>\n<simulation until=\"1\" step=\"1e-3\"/>\n</dynamy>",
                  "toy.xml", registry, plugins);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "no error";
}

void expectIn(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(CoordinatesModel, FaultsPointIntoTheFormula) {
  const std::string errors =
      errorsOf("<Coordinates name=\"toy\" q=\"x phi\" M=\"1 ; 0 ;\n  l2*l\" h=\"{2*l}*x ; phy\"/>");
  expectIn("toy.xml:5:3: error: <Coordinates name=\"toy\">: unknown symbol \"l2\"", errors);
  // The second formula stands behind braces that became a number.
  expectIn("toy.xml:5:22: error: <Coordinates name=\"toy\">: unknown symbol \"phy\"", errors);
  expectIn("did you mean \"phi\"", errors);
}

TEST(CoordinatesModel, FaultsOfContactsPointIntoTheFormula) {
  const std::string errors =
      errorsOf("<Coordinates name=\"toy\" q=\"x\" M=\"1\"/>",
               "<CoordinateContact name=\"stop\" on=\"toy\" gap=\"l - 2*y\"/>");
  expectIn("toy.xml:7:52: error: <CoordinateContact name=\"stop\">: unknown symbol \"y\"", errors);
}

TEST(CoordinatesModel, ContactTakesCoordinatesOfEverySystemThatNamesThem) {
  EXPECT_EQ(errorsOf("<PointMass name=\"ball\" mass=\"1\"/>",
                     "<CoordinateContact name=\"floor\" on=\"ball\" gap=\"z - x^2\"/>"),
            "no error");
  for (const char* other :
       {"<Ground name=\"b\"/>", "<RigidBody name=\"b\" mass=\"1\" inertia=\"1 1 1\"/>"})
    expectIn("\"b\" does not name one coordinate and one velocity",
             errorsOf(other, "<CoordinateContact name=\"stop\" on=\"b\" gap=\"1\"/>"));
}

TEST(CoordinatesModel, StepsDoNotAllocate) {
  ASSERT_TRUE(AllocationCounter::active());
  LoadedModel toy("models/woodpecker_expressions.xml");
  HandStepper s(toy.model());
  while (s.x.t < 0.2) s.step(1e-4);  // a whole cycle: every contact was closed
  const AllocationCounter counter;
  for (int i = 0; i < 2000; ++i) s.step(1e-4);
  EXPECT_EQ(counter.count(), 0);
}

}  // namespace
}  // namespace dynamy
