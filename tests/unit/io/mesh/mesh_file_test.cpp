/// Files of meshes: all formats give the same body; damaged ones are errors, never crashes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/mesh/mesh_file.hpp>
#include <random>
#include <stdexcept>

#include "unit/io/files/scratch_folder.hpp"

namespace dynamy {
namespace {

using testing::ScratchFolder;

/// A cuboid of 1 × 2 × 3 m with a corner at (10, 0, 0), as squares counterclockwise from outside.
constexpr double kCorners[8][3] = {{10, 0, 0}, {11, 0, 0}, {11, 2, 0}, {10, 2, 0},
                                   {10, 0, 3}, {11, 0, 3}, {11, 2, 3}, {10, 2, 3}};
constexpr int kSquares[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::string cornerText(int i) {
  std::string out;
  for (const double x : kCorners[i]) out += ' ' + std::to_string(x);
  return out;
}

std::string objText() {
  std::string out = "# brick\no brick\n";
  for (int i = 0; i < 8; ++i) out += "v" + cornerText(i) + "\n";
  for (const auto& s : kSquares) {
    out += "f";
    for (const int i : s) out += ' ' + std::to_string(i + 1) + "//1";
    out += "\n";
  }
  return out;
}

std::string stlText() {
  std::string out = "solid brick\n";
  for (const auto& s : kSquares)
    for (const int k : {1, 2}) {
      out += "facet normal 0 0 0\nouter loop\n";
      for (const int i : {s[0], s[k], s[k + 1]}) out += "vertex" + cornerText(i) + "\n";
      out += "endloop\nendfacet\n";
    }
  return out + "endsolid brick\n";
}

template <class T>
void append(std::string& out, T value, bool swap = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swap) std::reverse(raw, raw + sizeof(T));
  out.append(raw, sizeof(T));
}

std::string stlBinary() {
  std::string out(80, ' ');
  append(out, std::uint32_t{12});
  for (const auto& s : kSquares)
    for (const int k : {1, 2}) {
      for (int i = 0; i < 3; ++i) append(out, 0.0F);
      for (const int i : {s[0], s[k], s[k + 1]})
        for (const double x : kCorners[i]) append(out, static_cast<float>(x));
      append(out, std::uint16_t{0});
    }
  return out;
}

std::string plyHead(const std::string& format) {
  return "ply\r\nformat " + format +
         " 1.0\r\ncomment with a property that nobody needs\r\nelement vertex 8\r\nproperty uchar "
         "red\r\nproperty double x\r\nproperty float32 y\r\nproperty float z\r\nelement face "
         "6\r\nproperty short flags\r\nproperty list uint8 uint vertex_indices\r\nelement edge "
         "1\r\nproperty list int double ends\r\nend_header\r\n";
}

std::string plyText() {
  std::string out = plyHead("ascii");
  for (int i = 0; i < 8; ++i) out += "255" + cornerText(i) + "\n";
  for (const auto& s : kSquares) {
    out += "0 4";
    for (const int i : s) out += ' ' + std::to_string(i);
    out += "\n";
  }
  return out + "2 0 1\n";
}

std::string plyBinary(bool swap) {
  std::string out = plyHead(swap ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : kCorners) {
    append(out, std::uint8_t{255});
    append(out, p[0], swap), append(out, static_cast<float>(p[1]), swap),
        append(out, static_cast<float>(p[2]), swap);
  }
  for (const auto& s : kSquares) {
    append(out, std::int16_t{0}, swap), append(out, std::uint8_t{4});
    for (const int i : s) append(out, static_cast<std::uint32_t>(i), swap);
  }
  append(out, std::int32_t{2}, swap), append(out, 0.0, swap), append(out, 1.0, swap);
  return out;
}

/// The half of each corner stands in the file, 4 m away and turned by 90° about z, in units of 2 m.
std::string colladaText() {
  std::string numbers, corners, counts;
  for (const auto& p : kCorners)
    numbers += std::to_string(p[1] / 2.0) + ' ' + std::to_string(-p[0] / 2.0 - 4.0) + ' ' +
               std::to_string(p[2] / 2.0) + " 7 ";
  for (const auto& s : kSquares) {
    counts += "4 ";
    for (const int i : s) corners += "0 " + std::to_string(i) + ' ';
  }
  return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\"><asset><unit name=\"two\" meter=\"2\"/></asset><library_geometries>"
         "<geometry id=\"g\"><mesh><source id=\"s\"><float_array id=\"a\" count=\"32\">" +
         numbers +
         "</float_array><technique_common><accessor source=\"#a\" count=\"8\" stride=\"4\"/>"
         "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" "
         "source=\"#s\"/>"
         "</vertices><polylist count=\"6\"><input semantic=\"NORMAL\" source=\"#n\" offset=\"0\"/>"
         "<input semantic=\"VERTEX\" source=\"#v\" offset=\"1\"/><vcount>" +
         counts + "</vcount><p>" + corners +
         "</p></polylist></mesh></geometry><geometry id=\"unused\"/></library_geometries>"
         "<library_visual_scenes><visual_scene id=\"scene\"><node><rotate>0 0 1 90</rotate><node>"
         "<translate>0 4 0</translate><instance_geometry url=\"#g\"/></node></node></visual_scene>"
         "</library_visual_scenes><scene><instance_visual_scene url=\"#scene\"/></scene></COLLADA>";
}

struct MeshText {
  std::string name, content;
};

std::vector<MeshText> allFormats() {
  return {{"b.obj", objText()},        {"text.stl", stlText()},       {"binary.STL", stlBinary()},
          {"text.ply", plyText()},     {"low.ply", plyBinary(false)}, {"high.ply", plyBinary(true)},
          {"scene.dae", colladaText()}};
}

TEST(MeshFile, AllFormatsGiveTheSameBody) {
  const ScratchFolder folder;
  for (const auto& [name, content] : allFormats()) {
    writeWholeFile(folder / name, content);
    const TriangleMesh mesh = readMesh(folder / name);
    EXPECT_EQ(mesh.points.size(), 8u) << name;
    EXPECT_EQ(mesh.triangles.size(), 12u) << name;
    EXPECT_TRUE(closed(mesh)) << name;
    const MassProperties m = enclosed(mesh);
    // The numbers are exact in binary, so that sums of 12 terms of size 100 round by 1e-13 at most.
    // The turn of COLLADA rounds coordinates by 1e-15.
    EXPECT_NEAR(m.volume, 6.0, 1e-13) << name;
    EXPECT_LT((m.centre_B - Vec3(10.5, 1.0, 1.5)).norm(), 1e-13) << name;
    EXPECT_LT((m.inertia_B - Mat3(Vec3(6.5, 5.0, 2.5).asDiagonal())).norm(), 1e-12) << name;
    EXPECT_LT((extentOf(mesh).sizes() - Vec3(1.0, 2.0, 3.0)).norm(), 1e-14) << name;
  }
}

TEST(MeshFile, SaysWhatIsWrong) {
  const ScratchFolder folder;
  struct {
    std::string name, content, said;
  } const kWrong[] = {
      {"a.glb", "glTF", "files .glb are not read, STL, OBJ, PLY and DAE are"},
      {"a.dae", "<COLLADA/>", "it has no triangles"},
      {"a.dae", "<X3D/>", "its root is <X3D>"},
      {"a.stl", "solid\nendsolid\n", "it has no triangles"},
      {"a.obj", "v 0 0 0\nf 1 2 3\n", "a face has the corner \"2\""},
      {"a.obj", "v 0 0 zero\n", "\"zero\" is no number"},
      {"a.obj", "v 0 0 0\nv nan 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n", "a corner is not finite"},
      {"a.ply", "plough\n", "it does not begin with \"ply\""},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n",
       "its head has no end"},
      {"a.ply", "ply\nformat utf8 1.0\nend_header\n", "its format is \"utf8\""},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n",
       "it ends within a list of numbers"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement face 1\nproperty list char int vertex_index\nend_header\n3 "
       "0 "
       "1 2\n",
       "a face has the corner 0"},
  };
  for (const auto& [name, content, said] : kWrong) {
    writeWholeFile(folder / name, content);
    try {
      readMesh(folder / name);
      ADD_FAILURE() << content;
    } catch (const std::runtime_error& e) {
      EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
    }
  }
}

TEST(MeshFile, DamagedFilesAreReadOrRefused) {
  const ScratchFolder folder;
  std::mt19937 random(7);
  int refused = 0;
  for (const auto& [name, content] : allFormats())
    for (int trial = 0; trial < 200; ++trial) {
      std::string bytes = content;
      if (trial % 2 == 0) bytes.resize(random() % bytes.size());
      for (std::size_t k = 0; k < trial % 5u && !bytes.empty(); ++k)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      writeWholeFile(folder / name, bytes);
      try {
        const TriangleMesh mesh = readMesh(folder / name);
        for (const Triangle& t : mesh.triangles)
          for (const int i : t) ASSERT_LT(static_cast<std::size_t>(i), mesh.points.size());
      } catch (const std::runtime_error&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace dynamy
