/// Shapes of mesh files in models: mass and contact of the file, errors with their place, files that
/// change behind a run.
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

/// A cuboid of 20 × 40 × 60 mm about the origin, in mm.
constexpr const char* kBrick =
    "v -10 -20 -30\nv 10 -20 -30\nv 10 20 -30\nv -10 20 -30\nv -10 -20 30\nv 10 -20 30\nv 10 20 "
    "30\nv -10 20 30\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class ShapeFile : public ProgramTest {
 protected:
  std::string fall(const std::string& shapes) const {
    return "<dynamy version=\"1\"><systems><Ground><HalfSpace material=\"m\"/></Ground><RigidBody "
           "name=\"b\" position=\"0 0 0.2\" euler=\"0.3 0.2 0.1\" angularVelocity=\"1 2 3\">" +
           shapes +
           "</RigidBody></systems><forces><Gravity/></forces><elements><Contact between=\"m m\">"
           "<UnilateralCoulomb mu=\"0.4\" epsilonN=\"0.2\"/></Contact></elements><simulation "
           "until=\"0.5\" step=\"1e-3\"/><record signals=\"b.x b.z b.Omega_x\"/></dynamy>";
  }
  /// Signals of a run of this body.
  std::string signals(const std::string& shapes) const {
    write("m.xml", fall(shapes));
    EXPECT_EQ(call("run m.xml --quiet --out r"), 0) << err();
    return readWholeFile(path("r/signals.csv"));
  }
};

TEST_F(ShapeFile, GivesContactAndMassOfItsHull) {
  write("brick.obj", kBrick);
  const std::string points = signals(
      "<Polyhedron points=\"-10mm -20mm -30mm  10mm -20mm -30mm  10mm 20mm -30mm  -10mm 20mm "
      "-30mm  -10mm -20mm 30mm  10mm -20mm 30mm  10mm 20mm 30mm  -10mm 20mm 30mm\" "
      "density=\"2000\" material=\"m\"/>");
  EXPECT_EQ(signals("<Polyhedron file=\"brick.obj\" scale=\"0.001\" density=\"2000\" "
                    "material=\"m\"/>"),
            points);
  // Mass of the picture, contact of the hull: the same body.
  EXPECT_EQ(signals("<Mesh file=\"brick.obj\" scale=\"0.001\" density=\"2000\"/><Polyhedron "
                    "file=\"brick.obj\" scale=\"1e-3 1e-3 1e-3\" material=\"m\" "
                    "colour=\"transparent\"/>")
                .substr(0, 60),
            points.substr(0, 60));
}

TEST_F(ShapeFile, SaysWhereAndWhatIsWrong) {
  write("brick.obj", kBrick);
  write("none.obj", "v 0 0 0\n");
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::create_directory(path("folder.obj"));
  struct {
    std::string shape, said;
  } const kWrong[] = {
      {"<Polyhedron density=\"1\" file=\"brik.obj\"/>", "there is no such file"},
      {"<Polyhedron density=\"1\" file=\"folder.obj\"/>", "this is a folder, not a file"},
      {"<Polyhedron density=\"1\" file=\"none.obj\"/>", "it has no triangles"},
      {"<Polyhedron density=\"1\" file=\"flat.obj\"/>", "the points lie in one plane"},
      {"<Polyhedron density=\"1\"/>", "either points or a file has to be given"},
      {"<Polyhedron density=\"1\" points=\"0 0 0\" file=\"brick.obj\"/>",
       "either points or a file has to be given"},
      {"<Polyhedron density=\"1\" file=\"brick.obj\" scale=\"1 2\"/>",
       "one number or three are needed"},
      {"<Polyhedron density=\"1\" points=\"0 0 0  1 0 0  0 1 0  0 0 1\" scale=\"2\"/>",
       "is for a mesh file"},
      {"<Mesh density=\"1\" file=\"flat.obj\"/>", "has no volume"},
      {"<Mesh file=\"brick.obj\" triangles=\"0 1 2\"/>", "belongs to points"},
      {"<Mesh points=\"0 0 0  1 0 0  0 1 0\"/>", "triangles are missing"},
  };
  for (const auto& [shape, said] : kWrong) {
    write("m.xml", fall(shape + "\n<Sphere radius=\"0.1\" mass=\"1\"/>"));
    EXPECT_EQ(call("check m.xml"), 2) << shape;
    EXPECT_NE(err().find(said), std::string::npos) << shape << "\n" << err();
    EXPECT_NE(err().find("m.xml:1:"), std::string::npos) << shape << "\n" << err();
  }
}

TEST_F(ShapeFile, ThatChangesBehindARunIsSeen) {
  write("brick.obj", kBrick);
  write("m.xml", fall("<Polyhedron file=\"brick.obj\" scale=\"0.001\" density=\"2000\" "
                      "material=\"m\"/>"));
  ASSERT_EQ(call("run m.xml --quiet --out r"), 0) << err();
  write("brick.obj", std::string(kBrick) + "# thinner\n");
  EXPECT_NE(call("resume r --until 1"), 0) << out();
  EXPECT_NE(err().find("brick.obj"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
