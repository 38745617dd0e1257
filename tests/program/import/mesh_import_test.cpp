/// Bodies of mesh files: mass properties, convex pieces, errors.
#include <dynamy/system/convex_hull.hpp>
#include <numbers>
#include <program/import/import_fixture.hpp>
#include <random>
#include <sstream>

namespace dynamy {
namespace {

class MeshImport : public ImportTest {
 protected:
  /// Triangles of an outline in x and y, counterclockwise, from z = 0 to `height`, as OBJ; `faces`
  /// divide the outline.
  static std::string extruded(const std::vector<std::array<double, 2>>& outline,
                              const std::vector<std::array<int, 3>>& faces, double height) {
    const int n = static_cast<int>(outline.size());
    std::string out;
    for (const double z : {0.0, height})
      for (const auto& p : outline)
        out += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(z) +
               "\n";
    const auto face = [&](int a, int b, int c) {
      out += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
             std::to_string(c + 1) + "\n";
    };
    for (const auto& f : faces) face(f[0], f[2], f[1]), face(n + f[0], n + f[1], n + f[2]);
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      face(i, j, n + j), face(i, n + j, n + i);
    }
    return out;
  }
  /// An L of two legs of 100 and 60 mm, 10 mm thick and 30 mm wide.
  static std::string bracket() {
    return extruded({{0, 0}, {100, 0}, {100, 10}, {10, 10}, {10, 60}, {0, 60}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}, 30.0);
  }
  /// Corners of all pieces, in axes of the file.
  std::vector<std::vector<Vec3>> corners() const {
    const std::string all = model(), key = "<Polyhedron points=\"";
    std::vector<std::vector<Vec3>> out;
    for (std::size_t at = 0; (at = all.find(key, at)) != std::string::npos;) {
      at += key.size();
      std::istringstream numbers(all.substr(at, all.find('"', at) - at));
      out.emplace_back();
      for (Vec3 p; numbers >> p.x() >> p.y() >> p.z();) out.back().push_back(p);
    }
    return out;
  }
  /// Of a note, the number before or after these words.
  double noted(const std::string& words) const {
    const std::size_t at = notes_.find(words);
    return at == std::string::npos ? 0.0 : std::stod(notes_.substr(at + words.size()));
  }
  int pieces() const {
    const std::string all = model();
    int n = 0;
    for (std::size_t at = 0; (at = all.find("<Polyhedron", at)) != std::string::npos; ++at) ++n;
    return n;
  }
};

TEST_F(MeshImport, BlocksAlongTheAxesAreMetExactly) {
  ASSERT_EQ(import("bracket.obj", bracket(), "--scale 0.001 --density 7800"), 0) << err();
  EXPECT_EQ(pieces(), 2);
  EXPECT_NE(notes_.find("2 convex pieces, together of its volume; they contain it"),
            std::string::npos)
      << notes_;
  // (100 · 10 + 10 · 50) mm² · 30 mm · 7800 kg/m³; centre: (1000 · 50 + 500 · 5)/1500 mm.
  EXPECT_NE(model().find("mass=\"0.351\""), std::string::npos) << model();
  EXPECT_NE(model().find("position=\"0.035 0.015 0.015\""), std::string::npos) << model();
  expectChecks();
}

TEST_F(MeshImport, AHoleStaysOpen) {
  // A square tube, 4 m wide with walls of 1 m, 3 m high, that no hull keeps open: a ball falls through to the
  // floor inside of it.
  std::string tube;
  const double at[2] = {2.0, 1.0};
  for (const double half : at)
    for (const double z : {0.0, 3.0})
      for (int k = 0; k < 4; ++k)
        tube += "v " + std::to_string(k == 0 || k == 3 ? -half : half) + " " +
                std::to_string(k < 2 ? -half : half) + " " + std::to_string(z) + "\n";
  const auto quad = [&](int a, int b, int c, int d) {
    for (const int i : {a, b, c, -1, a, c, d, -1}) {
      if (i == a && tube.back() == '\n') tube += "f";
      tube += i < 0 ? "\n" : " " + std::to_string(i + 1);
    }
  };
  for (int k = 0; k < 4; ++k) {
    const int l = (k + 1) % 4;
    quad(k, l, 4 + l, 4 + k);            // outside
    quad(8 + l, 8 + k, 12 + k, 12 + l);  // inside
    quad(4 + k, 4 + l, 12 + l, 12 + k);  // top
    quad(l, k, 8 + k, 8 + l);            // bottom
  }
  ASSERT_EQ(import("tube.obj", tube), 0) << err();
  EXPECT_LE(pieces(), 8) << "four walls, cut once more where a plane through a corner goes on";
  EXPECT_NE(model().find("mass=\"36000\""), std::string::npos) << "(16 − 4) m² · 3 m";
  std::string with = model();
  const std::string body =
      "<RigidBody name=\"ball\" position=\"0.1 0 5\"><Sphere radius=\"0.5\" mass=\"1\" "
      "material=\"tube\"/></RigidBody></systems>";
  with.replace(with.find("</systems>"), 10, body);
  write("model.xml", with);
  EXPECT_NEAR(atEnd("ball.z", "--until 3"), 0.5, 1e-6) << model();
}

TEST_F(MeshImport, PiecesOfRandomStarsContainThem) {
  // Prisms over stars with 5 to 12 points, turned at random: no face lies across an axis of the file.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int trial = 0; trial < 10; ++trial) {
    const int n = 2 * (5 + trial % 8);
    std::vector<std::array<double, 2>> star;
    double area = 0.0;
    for (int k = 0; k < n; ++k) {
      const double r = k % 2 == 0 ? 0.7 + 0.3 * number(random) : 0.2 + 0.3 * number(random),
                   angle = 2.0 * std::numbers::pi * k / n;
      star.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    for (int k = 0; k < n; ++k) {
      const auto &a = star[static_cast<std::size_t>(k)],
                 &b = star[static_cast<std::size_t>((k + 1) % n)];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    const Eigen::Quaterniond turn = Eigen::Quaterniond(number(random) - 0.5, number(random) - 0.5,
                                                       number(random) - 0.5, number(random))
                                        .normalized();
    const double height = 0.3;
    std::ostringstream obj;
    obj.precision(17);
    const auto vertex = [&](double x, double y, double z) {
      const Vec3 p = turn * Vec3(x, y, z);
      obj << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    };
    for (const double z : {0.0, height}) {
      for (const auto& p : star) vertex(p[0], p[1], z);
      vertex(0.0, 0.0, z);
    }
    const auto face = [&](int a, int b, int c) {
      obj << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    };
    for (int k = 0; k < n; ++k) {
      const int l = (k + 1) % n, top = n + 1;
      face(n, l, k), face(top + n, top + k, top + l);
      face(k, l, top + l), face(k, top + l, top + k);
    }
    ASSERT_EQ(import("star.obj", obj.str()), 0) << err();
    const double size = noted("star: is "), inside = noted("their faces are at most ");
    EXPECT_LT(inside, 0.03 * size) << notes_;
    double volume = 0.0;
    std::vector<std::pair<std::vector<Vec3>, std::vector<Triangle>>> hulls;
    for (const std::vector<Vec3>& all : corners()) {
      hulls.emplace_back(all, convexHull(all));
      volume += enclosed(all, hulls.back().second).volume;
    }
    EXPECT_GT(volume, 0.97 * area * height) << notes_;
    EXPECT_LT(volume, 1.4 * area * height) << notes_;
    for (int i = 0; i < 300; ++i) {  // points inside, of a triangle from the middle to a side
      const auto k = static_cast<std::size_t>(number(random) * n),
                 l = (k + 1) % static_cast<std::size_t>(n);
      const double s = number(random), t = (1.0 - s) * number(random);
      const Vec3 p = turn * Vec3(s * star[k][0] + t * star[l][0], s * star[k][1] + t * star[l][1],
                                 height * number(random));
      double least = 1e9;
      for (const auto& [points, triangles] : hulls) {
        double out = -1e9;
        for (const Triangle& f : triangles) {
          const Vec3 &a = points[static_cast<std::size_t>(f[0])],
                     &b = points[static_cast<std::size_t>(f[1])],
                     &c = points[static_cast<std::size_t>(f[2])];
          out = std::max(out, (b - a).cross(c - a).normalized().dot(p - a));
        }
        least = std::min(least, out);
      }
      // The numbers of the model have nine digits or more, the note two.
      ASSERT_LT(least, 1.05 * inside + 1e-8)
          << "trial " << trial << ", point " << i << ": " << notes_;
    }
  }
}

TEST_F(MeshImport, OpenMeshesAndOtherFilesAreErrors) {
  EXPECT_NE(import("plate.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), 0);
  EXPECT_NE(err().find("do not enclose a volume"), std::string::npos) << err();
  EXPECT_NE(import("none.stl", "solid x\nendsolid\n"), 0);
  EXPECT_NE(err().find("it has no triangles"), std::string::npos) << err();
  EXPECT_NE(import("bracket.obj", bracket(), "--key home"), 0);
  EXPECT_NE(err().find("a mesh is one body"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
