// Scenes in space whose motion stays in a plane: found by their structure, computed in the plane, with
// the same motion; and scenes that look like them and are not.
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <random>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

constexpr RunSetup kFind{.reduce = true};

/// Bodies of all kinds that fall on a floor or a slope, with springs and hinges between some, in the
/// plane across `axis`, which has the offset `across`.
class RandomPlanar {
 public:
  RandomPlanar(unsigned seed, int axis) : random_(seed), axis_(axis) {
    across_ = chance(0.5) ? 0.0 : in(-1.0, 1.0);
    const int n = 1 + static_cast<int>(in(0.0, 4.0));
    for (int i = 0; i < n; ++i) addBody(i);
    if (n > 1 && chance(0.4))
      forces_ = "<SpringDamper between=\"b0 b1\" stiffness=\"50\" length=\"0.7\"/>";
    if (n > 2 && chance(0.5)) {
      const std::string joint = " between=\"b1 b2\" axis=\"" + normal() + "\"";
      forces_ += "<JointSpring" + joint + " stiffness=\"5\"/>";
      elements_ = "<JointStop" + joint +
                  " lower=\"-0.3\" upper=\"1\"><Unilateral epsilonN=\"0.5\"/></JointStop>";
      elements_ += "<Revolute" + joint + " at=\"" + place(1.5, 1.0) + "\"/>";
    }
  }
  std::string text(const std::string& simulation) const {
    const double slope = axis_ == 2 ? 0.0 : 0.1;
    const std::array<double, 3> up = turned(std::sin(slope), std::cos(slope));
    const std::array<double, 3> g = turned(0.0, -9.81);
    // The half space's normal is its z-axis: a quaternion that turns z onto it.
    return "<dynamy version=\"1\"><systems><Ground name=\"floor\"><HalfSpace orientation=\"" +
           onto(up) + "\" material=\"m\"/></Ground>" + bodies_ +
           "</systems><forces><Gravity acceleration=\"" + vector(g) + "\"/>" + forces_ +
           "</forces><elements>" + elements_ +
           "<Contact between=\"m m\"><UnilateralCoulomb mu=\"0.4\" epsilonN=\"0.3\"/></Contact>"
           "</elements><simulation " +
           simulation + "/><record signals=\"" + signals_ +
           "\" every=\"0.05\" frames=\"0\"/></dynamy>";
  }

 private:
  double in(double a, double b) {
    return a + (b - a) * (static_cast<double>(random_()) / 4294967296.0);
  }
  bool chance(double p) { return in(0.0, 1.0) < p; }
  static std::string vector(const std::array<double, 3>& v) {
    return numberText(v[0]) + ' ' + numberText(v[1]) + ' ' + numberText(v[2]);
  }
  /// The direction (x, z) in the plane, in the axes of the world: axes follow each other cyclically.
  std::array<double, 3> turned(double x, double z) const {
    std::array<double, 3> out{};
    out[static_cast<std::size_t>((axis_ + 2) % 3)] = x;  // axis 1 (y): x, z as they are
    out[static_cast<std::size_t>((axis_ + 1) % 3)] = z;
    if (axis_ == 1) out = {x, 0.0, z};
    return out;
  }
  std::string normal() const {
    std::array<double, 3> n{};
    n[static_cast<std::size_t>(axis_)] = 1.0;
    return vector(n);
  }
  std::string place(double x, double z) const {
    std::array<double, 3> out = turned(x, z);
    out[static_cast<std::size_t>(axis_)] = across_;
    return vector(out);
  }
  /// The shortest turn of the z-axis onto a unit vector, as a quaternion.
  static std::string onto(const std::array<double, 3>& v) {
    if (v[2] > 1.0 - 1e-12) return "1 0 0 0";
    return numberText(1.0 + v[2]) + ' ' + numberText(-v[1]) + ' ' + numberText(v[0]) + " 0";
  }
  void addBody(int i) {
    const std::string name = "b" + std::to_string(i);
    const double angle = in(-3.0, 3.0);
    std::array<double, 3> spin{}, n{};
    spin[static_cast<std::size_t>(axis_)] = in(-3.0, 3.0);
    n[static_cast<std::size_t>(axis_)] = std::sin(angle / 2.0);
    // The axis of a cylinder lies along the normal or in the plane.
    const std::string along = axis_ == 2   ? ""
                              : axis_ == 1 ? " euler=\"90deg 0 0\""
                                           : " euler=\"0 90deg 0\"";
    const std::string within = axis_ == 2 ? " euler=\"90deg 0 0\"" : "";
    const std::string shapes[] = {
        "<Sphere radius=\"0.2\" mass=\"2\" material=\"m\"/>",
        "<Box size=\"0.3 0.4 0.5\" mass=\"2\" material=\"m\"/>",
        "<Cylinder radius=\"0.2\" length=\"0.3\" mass=\"2\" material=\"m\"" + along + "/>",
        "<Cylinder radius=\"0.15\" length=\"0.4\" mass=\"2\" material=\"m\"" + within + "/>",
        "<Capsule radius=\"0.1\" length=\"0.3\" mass=\"2\" material=\"m\"" + within + "/>",
        "<Ellipsoid semiAxes=\"0.15 0.2 0.25\" mass=\"2\" material=\"m\"/>"};
    bodies_ += "<RigidBody name=\"" + name + "\" position=\"" + place(i, 0.6 + in(0.0, 0.5)) +
               "\" orientation=\"" + numberText(std::cos(angle / 2.0)) + ' ' + vector(n) +
               "\" velocity=\"" + vector(turned(in(-1.0, 1.0), in(-1.0, 1.0))) +
               "\" angularVelocity=\"" + vector(spin) + "\">" +
               shapes[static_cast<std::size_t>(in(0.0, 6.0))] + "</RigidBody>";
    for (const char* s : {"x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "Omega_x",
                          "Omega_y", "Omega_z", "Omega_I_y", "kineticEnergy"})
      signals_ += (signals_.empty() ? "" : " ") + name + "." + s;
  }
  std::mt19937 random_;
  int axis_;
  double across_ = 0.0;
  std::string bodies_, forces_, elements_, signals_;
};

/// Largest difference of all recorded values over 1 + |value|.
double difference(const BoundedRun& a, const BoundedRun& b, std::size_t columns) {
  double off = 0.0;
  EXPECT_EQ(a.times().size(), b.times().size());
  for (std::size_t row = 0; row < std::min(a.times().size(), b.times().size()); ++row)
    for (std::size_t k = 0; k < columns; ++k)
      off = std::max(
          off, std::abs(a.value(row, k) - b.value(row, k)) / (1.0 + std::abs(b.value(row, k))));
  return off;
}

TEST(PlaneOfMotion, RandomScenesMoveInItAsInSpace) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const RandomPlanar scene(seed, static_cast<int>(seed % 3));
    const std::string text = scene.text("until=\"0.4\" tolerance=\"1e-9\"");
    BoundedRun flat(text, kFind), space(text);
    const int bodies = flat.model().composed.flat;
    ASSERT_GT(bodies, 0) << text;
    EXPECT_LE(flat.model().topology().nu(), 3 * bodies) << text;
    flat.run(), space.run();
    ASSERT_TRUE(flat.finished()) << seed << ' ' << flat.report().reason;
    ASSERT_TRUE(space.finished()) << seed << ' ' << space.report().reason;
    if (flat.report().qualified() || space.report().qualified()) continue;
    ++compared;
    // A thousand tolerances: errors of two runs, each grown by some impacts.
    EXPECT_LT(difference(flat, space, flat.model().record.signals.size()), 1e-6) << seed << text;
  }
  EXPECT_GE(compared, 55);
}

TEST(PlaneOfMotion, StepsOfFixedLengthAreTheSame) {
  for (unsigned seed = 101; seed <= 120; ++seed) {
    const RandomPlanar scene(seed, static_cast<int>(seed % 3));
    const std::string text = scene.text("until=\"0.3\" step=\"1e-3\"");
    BoundedRun flat(text, kFind), space(text);
    ASSERT_GT(flat.model().composed.flat, 0) << text;
    flat.run(), space.run();
    // Both solve the same inclusions, each to its tolerance; errors grow by some impacts.
    EXPECT_LT(difference(flat, space, flat.model().record.signals.size()), 1e-5) << seed << text;
  }
}

std::string tumbling(const std::string& body, const std::string& more = "",
                     const std::string& elements = "", const std::string& record = "b.x") {
  return "<dynamy version=\"1\"><systems><Ground name=\"floor\"><HalfSpace "
         "material=\"m\"/></Ground>"
         "<RigidBody name=\"b\" position=\"0 0 1\" " +
         body + "</systems><forces>" + more + "</forces><elements>" + elements +
         "<Contact between=\"m m\"><UnilateralCoulomb mu=\"0.4\"/></Contact></elements><simulation "
         "until=\"1\" tolerance=\"1e-6\"/><record signals=\"" +
         record + "\"/></dynamy>";
}

TEST(PlaneOfMotion, IsNotFoundWhereSomethingLeadsOut) {
  const std::string box = "><Box size=\"1 1 1\" mass=\"1\" material=\"m\"/></RigidBody>",
                    weight = "<Gravity/>";
  const auto bodies = [](const std::string& text) {
    return BoundedRun(text, kFind).model().composed.flat;
  };
  EXPECT_EQ(bodies(tumbling(box, weight)), 1);
  EXPECT_EQ(bodies(tumbling("euler=\"0 0.3 0\" velocity=\"1 0 2\" angularVelocity=\"0 3 0\"" + box,
                            weight)),
            1);
  const std::string other =
      "<RigidBody name=\"c\" position=\"2 0.01 1\"><Sphere radius=\"0.1\" mass=\"1\" "
      "material=\"m\"/></RigidBody>";
  const std::string out[] = {
      tumbling("velocity=\"1 1e-9 0\" angularVelocity=\"0 1 0\"" + box, weight),
      tumbling("velocity=\"1 0 0\" angularVelocity=\"1e-12 1 0\"" + box, weight),
      tumbling("euler=\"0.1 0.2 0\"" + box, weight),
      tumbling("mass=\"1\" inertia=\"1 1.2 1.3 0.01 0.1 0.02\"" + box.substr(0, 1) +
                   "<Box size=\"1 1 1\" material=\"m\"/></RigidBody>",
               weight),
      tumbling(box + other, "<Gravity acceleration=\"1 0 -9.81\"/>"),
      tumbling(box, "<Gravity acceleration=\"0.1 0.1 -9.81\"/>"),
      tumbling(box, "<Gravity change=\"0; sin(t); 0\"/>"),
      tumbling(box,
               "<Gravity acceleration=\"1 0 -9.81\"/><SpringDamper between=\"b floor\" "
               "pointA=\"0 0.1 0\" stiffness=\"10\"/>"),
      tumbling(box, "<Gravity acceleration=\"1 0 -9.81\"/><Drag on=\"b\" viscous=\"1\"/>"),
      tumbling(box, weight, "", "b.x b-floor.*"),
      tumbling(box, weight, "", "*"),
  };
  for (const std::string& text : out) {
    try {
      EXPECT_EQ(bodies(text), 0) << text;
    } catch (const ModelError& e) {
      ADD_FAILURE() << e.what() << '\n' << text;
    }
  }
}

TEST(PlaneOfMotion, IsSoughtOnlyWhereTheProgramChooses) {
  const std::string text =
      tumbling("><Box size=\"1 1 1\" mass=\"1\" material=\"m\"/></RigidBody>", "<Gravity/>");
  EXPECT_EQ(BoundedRun(text).model().composed.flat, 0) << "callers that read q and u";
  EXPECT_EQ(BoundedRun(text, {.coordinates = JointCoordinates::absolute, .reduce = true})
                .model()
                .composed.flat,
            0);
}

TEST(PlaneOfMotion, CostsAsMuchAsABodyOfThePlane) {
  const std::string space =
      "<dynamy version=\"1\"><systems><Ground><HalfSpace material=\"m\"/></Ground><RigidBody "
      "name=\"b\" position=\"0 0 1\" euler=\"0 0.3 0\" velocity=\"1 0 0\" angularVelocity=\"0 2 "
      "0\">"
      "<Box size=\"0.4 0.3 0.3\" mass=\"10\" "
      "material=\"m\"/></RigidBody></systems><forces><Gravity/>"
      "</forces><elements><Contact between=\"m m\"><UnilateralCoulomb mu=\"0.4\" epsilonN=\"0.3\"/>"
      "</Contact></elements><simulation until=\"3\" tolerance=\"1e-8\"/><record signals=\"b.x\" "
      "frames=\"0\"/></dynamy>";
  std::string plane = space;
  plane.replace(plane.find("RigidBody"), 9, "PlanarBody");
  plane.replace(plane.find("/RigidBody"), 10, "/PlanarBody");
  plane.replace(plane.find("euler=\"0 0.3 0\""), 15, "angle=\"-0.3\"");
  plane.replace(plane.find("angularVelocity=\"0 2 0\""), 23, "angularVelocity=\"-2\"");
  BoundedRun flat(space, kFind), own(plane);
  flat.run(), own.run();
  // The angle counts from the start here, from the axes of the body there, so that errors are weighted
  // in another way.
  const auto cost = static_cast<double>(own.report().cost.evaluations);
  EXPECT_NEAR(static_cast<double>(flat.report().cost.evaluations), cost, 0.02 * cost);
  EXPECT_NEAR(flat.last(), own.last(), 1e-6) << "some impacts amplify the tolerance";
}

}  // namespace
}  // namespace dynamy
