// dynamy export vtk: files of bodies and contacts that ParaView reads.
#include <cstring>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

using VtkExport = ProgramTest;

/// The numbers of an array behind the XML, by the name that the XML gives it.
template <class Number>
std::vector<Number> arrayOf(const std::string& file, const std::string& name) {
  const std::string text = readWholeFile(file);
  const std::size_t at = text.find("offset=\"", text.find("Name=\"" + name + '"')) + 8;
  const char* data = text.data() + text.find("\n_") + 2 + std::stoul(text.substr(at));
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, data, sizeof bytes);
  std::vector<Number> out(bytes / sizeof(Number));
  std::memcpy(out.data(), data + sizeof bytes, bytes);
  return out;
}

TEST_F(VtkExport, WritesBodiesWhereTheyAreAndTheForcesOfContacts) {
  write("box.xml", R"(<dynamy version="1">
  <systems><RigidBody name="box" position="1 0 0.3"><Box size="0.2 0.4 0.6" mass="2" material="a"/></RigidBody>
    <Ground name="world"><HalfSpace name="floor" normal="0 0 1" material="b"/></Ground></systems>
  <forces><Gravity acceleration="0 0 -10"/></forces>
  <elements><Contact between="a b"><UnilateralCoulomb epsilonN="0" mu="0.3"/></Contact></elements>
  <simulation until="0.1" step="1e-2" coordinates="absolute"/><record frames="50Hz"/></dynamy>)");
  ASSERT_EQ(call("run box.xml --quiet --out r"), 0) << err();
  ASSERT_EQ(call("export vtk r"), 0) << err();
  EXPECT_EQ(out(), "r/vtk: bodies.pvd and contacts.pvd, 6 frames\n");
  EXPECT_NE(readWholeFile(path("r/vtk/bodies.pvd")).find("file=\"bodies_00005.vtp\""),
            std::string::npos);
  const auto points = arrayOf<float>(path("r/vtk/bodies_00005.vtp"), "Points");
  ASSERT_EQ(points.size(), 3u * (8 + 4));  // the box and the ground
  for (std::size_t i = 0; i < 8; ++i) {    // numbers of single precision, which is 1e-7 of 1 m
    EXPECT_NEAR(std::abs(points[3 * i] - 1.0F), 0.1F, 1e-6F);
    EXPECT_NEAR(std::abs(points[3 * i + 1]), 0.2F, 1e-6F);
    EXPECT_NEAR(std::abs(points[3 * i + 2] - 0.3F), 0.3F, 1e-6F);
  }
  const auto force = arrayOf<float>(path("r/vtk/contacts_00005.vtp"), "force");
  ASSERT_EQ(force.size(), 3u * 4);
  // The weight; the solver's own tolerance is far below single precision.
  EXPECT_NEAR(force[2] + force[5] + force[8] + force[11], 20.0F, 1e-4F);
}

TEST_F(VtkExport, LeavesOutGrainsThatWereTakenAway) {
  write("taken.xml", R"(<dynamy version="1">
  <systems><Grains name="g" count="4" within="0 0 1 2 2 1.4" pitch="0.5" takeWithin="-9 -9 -9 9 9 0.5">
    <Sphere radius="0.1" density="1000"/></Grains></systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <simulation until="0.6" step="1e-2"/><record frames="10Hz"/></dynamy>)");
  ASSERT_EQ(call("run taken.xml --quiet --out r"), 0) << err();
  ASSERT_EQ(call("export vtk r --sides 4"), 0) << err();
  const auto cells = [&](const std::string& file) {
    return arrayOf<std::int32_t>(path(file), "shape");
  };
  EXPECT_GT(cells("r/vtk/bodies_00000.vtp").size(), 0u);
  EXPECT_EQ(cells("r/vtk/bodies_00006.vtp").size(), 0u);  // all below 0.5 m after 0.43 s
}

}  // namespace
}  // namespace dynamy
