// Bodies of every shape, thrown onto meshes: none of them falls through, whatever the method.
#include <gtest/gtest.h>
#include <cmath>
#include <random>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

struct Named {
  const char *name, *xml;
};
constexpr Named kShapes[] = {
    {"octahedron",
     R"(<Polyhedron points="0.06 0 0 -0.06 0 0 0 0.06 0 0 -0.06 0 0 0 0.06 0 0 -0.06" )"},
    {"box", R"(<Box size="0.1 0.08 0.06" )"},
    {"cylinder", R"(<Cylinder radius="0.05" length="0.1" )"},
    {"cone", R"(<Cone radius="0.05" length="0.1" )"},
    {"ellipsoid", R"(<Ellipsoid semiAxes="0.05 0.04 0.03" )"},
    {"torus", R"(<Torus radius="0.05" tube="0.02" )"},
    {"capsule", R"(<Capsule radius="0.03" length="0.08" )"},
    {"ball", R"(<Sphere radius="0.05" )"}};

/// A surface, and its height over (x, 0).
struct Ground {
  const char *name, *xml;
  double (*height)(double x);
};
const Ground kGrounds[] = {
    {"flat", R"(points="-1 -1 0  1 -1 0  -1 1 0  1 1 0" triangles="0 1 2  1 3 2")",
     [](double) { return 0.0; }},
    {"ridge", R"(points="-1 0 0  0 -1 0.2  1 0 0  0 1 0.2" triangles="0 1 3  1 2 3")",
     [](double x) { return 0.2 * (1.0 - std::abs(x)); }},
    {"valley",
     R"(points="-1 -1 0.3  -1 1 0.3  0 -1 0  0 1 0  1 -1 0.3  1 1 0.3"
        triangles="0 2 1  2 3 1  2 4 3  4 5 3")",
     [](double x) { return 0.3 * std::abs(x); }}};

class Drop {
 public:
  Drop(const Named& shape, const Ground& ground, unsigned seed) : random_(seed) {
    // Some fall along edges and in axes of the mesh, where places are on the borders of features.
    const double x = in(0.01), y = in(0.2), z = 0.7 + in(0.35);
    text_ = "<dynamy version=\"1\"><systems><Ground name=\"g\"><Mesh " + std::string(ground.xml) +
            " material=\"m\"/></Ground><RigidBody name=\"c\" position=\"" + number(x) + ' ' +
            number(y) + ' ' + number(z) + "\" velocity=\"" + number(in(0.3)) + ' ' +
            number(in(0.3)) + " 0\"";
    if (seed % 3 > 0)
      text_ += " euler=\"" + number(in(3.0)) + ' ' + number(in(1.5)) + ' ' + number(in(3.0)) + '"';
    text_ +=
        ">" + std::string(shape.xml) +
        "density=\"1000\" material=\"m\"/></RigidBody></systems><forces><Gravity/></forces>"
        "<elements><Contact between=\"m m\"><UnilateralCoulomb mu=\"0.4\"/></Contact></elements>"
        "<simulation until=\"" +
        number(0.6 + 0.1 * (seed % 3)) + "\" ";
  }
  std::string by(const std::string& method) const {
    return text_ + method + "/><record signals=\"c.x c.y c.z\" every=\"0.1\"/></dynamy>";
  }

 private:
  double in(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
  static std::string number(double x) { return std::to_string(x); }
  std::mt19937 random_;
  std::string text_;
};

TEST(MeshDrops, NoBodyFallsThroughAMesh) {
  unsigned seed = 0;
  for (const Named& shape : kShapes)
    for (const Ground& ground : kGrounds)
      for (int i = 0; i < 3; ++i, ++seed)
        for (const char* method : {"step=\"2e-3\"", "tolerance=\"1e-4\""}) {
          BoundedRun run(Drop(shape, ground, seed).by(method));
          run.run();
          ASSERT_TRUE(run.finished()) << run.report().reason;
          const double x = run.last(0), y = run.last(1), z = run.last(2);
          // Those that have slid over the border fall on.
          if (std::abs(x) + std::abs(y) > 0.9) continue;
          EXPECT_GT(z, ground.height(x)) << shape.name << " on " << ground.name << ", seed " << seed
                                         << ", " << method << ", x = " << x << ", y = " << y;
        }
}

}  // namespace
}  // namespace dynamy
