/// Which shapes touch which: the tables of doc/shape_pairs.md are what models are told, and what
/// is without thickness rests on all that it touches.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/core/error.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>
#include <fstream>
#include <iomanip>
#include <reference/scene.hpp>
#include <sstream>

namespace dynamy::reference {
namespace {

/// `ground`: with its top at z = 0.
struct Kind {
  const char *name, *text, *ground;
};
constexpr Kind kInSpace[] = {
    {"Sphere", R"(<Sphere radius="0.1" material="%"/>)",
     R"(<Sphere radius="0.2" position="0 0 -0.2" material="%"/>)"},
    {"Point", R"(<Point material="%"/>)", ""},
    {"Capsule", R"(<Capsule radius="0.1" length="0.3" material="%"/>)",
     R"(<Capsule radius="0.2" length="0.3" position="0 0 -0.2" euler="0 {pi/2} 0" material="%"/>)"},
    {"Line", R"(<Line points="0 0 0 0 0 1" material="%"/>)", ""},
    {"Cylinder", R"(<Cylinder radius="0.1" length="0.3" material="%"/>)",
     R"(<Cylinder radius="0.2" length="0.3" position="0 0 -0.15" material="%"/>)"},
    {"Cone", R"(<Cone radius="0.1" length="0.3" material="%"/>)",
     R"(<Cone radius="0.2" length="0.3" euler="{pi} 0 0" material="%"/>)"},
    {"Torus", R"(<Torus radius="0.1" tube="0.02" material="%"/>)",
     R"(<Torus radius="0.2" tube="0.1" position="0.2 0 -0.1" material="%"/>)"},
    {"Ellipsoid", R"(<Ellipsoid semiAxes="0.1 0.2 0.3" material="%"/>)",
     R"(<Ellipsoid semiAxes="0.2 0.3 0.2" position="0 0 -0.2" material="%"/>)"},
    {"Box", R"(<Box size="0.1 0.2 0.3" material="%"/>)",
     R"(<Box size="0.4 0.5 0.3" position="0 0 -0.15" material="%"/>)"},
    {"Polyhedron", R"(<Polyhedron points="0 0 0 1 0 0 0 1 0 0 0 1" material="%"/>)",
     R"(<Polyhedron points="-1 -1 0 1 -1 0 0 2 0 0 0 -1" material="%"/>)"},
    {"Mesh", R"(<Mesh points="0 0 0 1 0 0 0 1 0" triangles="0 1 2" material="%"/>)",
     R"(<Mesh points="-1 -1 0 1 -1 0 0 2 0" triangles="0 1 2" material="%"/>)"},
    {"HeightField", R"(<HeightField columns="2" spacing="1 1" heights="0 0 0 0" material="%"/>)",
     R"(<HeightField columns="2" spacing="1 1" position="-0.4 -0.3 0" heights="0 0 0 0" )"
     R"(material="%"/>)"},
    {"HalfSpace", R"(<HalfSpace material="%"/>)", R"(<HalfSpace material="%"/>)"},
    {"Bore", R"(<Bore radius="0.4" length="0.3" material="%"/>)", ""}};
constexpr Kind kInPlane[] = {
    {"Sphere, Circle", R"(<Sphere radius="0.1" material="%"/>)",
     R"(<Sphere radius="0.2" position="0 0 -0.2" material="%"/>)"},
    {"Point", R"(<Point material="%"/>)", ""},
    {"Capsule", R"(<Capsule radius="0.1" length="0.3" material="%"/>)",
     R"(<Capsule radius="0.2" length="0.3" position="0 0 -0.2" euler="0 {pi/2} 0" material="%"/>)"},
    {"Line", R"(<Line points="0 0 0 0 0 1" material="%"/>)", ""},
    {"Cylinder, Cone", R"(<Cylinder radius="0.1" length="0.3" material="%"/>)",
     R"(<Cylinder radius="0.2" length="0.3" position="0 0 -0.15" material="%"/>)"},
    {"Cylinder, Cone", R"(<Cone radius="0.1" length="0.3" material="%"/>)",
     R"(<Cone radius="0.2" length="0.3" euler="{pi} 0 0" material="%"/>)"},
    {"Torus", R"(<Torus radius="0.1" tube="0.02" material="%"/>)", ""},
    {"Ellipsoid", R"(<Ellipsoid semiAxes="0.1 0.2 0.3" material="%"/>)",
     R"(<Ellipsoid semiAxes="0.2 0.3 0.2" position="0 0 -0.2" material="%"/>)"},
    {"Box", R"(<Box size="0.1 0.2 0.3" material="%"/>)",
     R"(<Box size="0.4 0.5 0.3" position="0 0 -0.15" material="%"/>)"},
    {"Polygon", R"(<Polygon points="0 0 0 1 0 0 0 0 1" material="%"/>)",
     R"(<Polygon points="-0.2 0 0 0.2 0 0 0 0 -0.3" material="%"/>)"},
    {"Contour", R"~(<Contour r="0.05 + 0.01*cos(phi)" euler="{pi/2} 0 0" material="%"/>)~",
     R"~(<Contour r="0.2 + 0.01*cos(2*phi)" position="0 0 -0.19" euler="{pi/2} 0 0" material="%"/>)~"},
    {"HalfSpace", R"(<HalfSpace material="%"/>)", R"(<HalfSpace material="%"/>)"},
    {"Bore", R"(<Bore radius="0.4" euler="{pi/2} 0 0" material="%"/>)", ""}};

std::string of(const Kind& kind, const std::string& material) {
  std::string text = kind.text;
  return text.replace(text.find('%'), 1, material);
}

/// "yes", "no", or "–" where the two never meet.
std::string touches(const Kind& a, const Kind& b, const std::string& body) {
  const std::string mass =
      body == "RigidBody" ? "mass=\"1\" inertia=\"1 1 1\"" : "mass=\"1\" inertia=\"1\"";
  const auto one = [&](const Kind& k, const std::string& material) {
    return "<" + body + " name=\"" + material + "\" " + mass + ">" + of(k, material) + "</" + body +
           ">";
  };
  SceneSetup setup;
  setup.text =
      "<dynamy version=\"1\"><systems>" + one(a, "a") + one(b, "b") +
      "</systems><elements><Contact between=\"a b\"><UnilateralCoulomb mu=\"0.1\"/></Contact>"
      "</elements><simulation until=\"1\" step=\"1ms\"/></dynamy>";
  try {
    Scene scene("pair", std::move(setup));
    const auto& element = static_cast<const ShapeContacts&>(*scene.model().contacts().at(0));
    return element.pairs() == 0 ? "–" : "yes";
  } catch (const ModelError& e) {
    const bool missing = std::string(e.what()).find("is not available") != std::string::npos;
    EXPECT_TRUE(missing) << a.name << " " << b.name << ": " << e.what();
    return "no";
  }
}

/// Kinds that share a name share a row and a column, and what they touch.
template <std::size_t n>
std::string table(const Kind (&kinds)[n], const std::string& body) {
  std::vector<std::vector<Kind>> rows;
  for (const Kind& k : kinds)
    if (rows.empty() || std::string(rows.back()[0].name) != k.name)
      rows.push_back({k});
    else
      rows.back().push_back(k);
  std::string out = "| |", line = "|---|";
  for (const auto& row : rows) out += " " + std::string(row[0].name) + " |", line += "---|";
  out += "\n" + line + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += "| **" + std::string(rows[i][0].name) + "** |";
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const std::string one = j > i ? "" : " " + touches(rows[i][0], rows[j][0], body);
      for (const Kind& a : rows[i])
        for (const Kind& b : rows[j])
          if (j <= i) {
            EXPECT_EQ(" " + touches(a, b, body), one) << a.text << b.text;
          }
      out += one + " |";
    }
    out += "\n";
  }
  return out;
}

TEST(ShapePairs, AreThoseOfTheirPage) {
  std::ifstream file(DYNAMY_SOURCE_DIR "/doc/shape_pairs.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const std::string& part : {table(kInSpace, "RigidBody"), table(kInPlane, "PlanarBody")})
    EXPECT_NE(page.str().find(part), std::string::npos) << "doc/shape_pairs.md should have\n"
                                                        << part;
}

const char* const kSimulations[] = {
    R"(<simulation until="1" step="1ms"><MoreauMidpoint/></simulation>)",
    R"(<simulation until="1" step="1ms"><EnergyMomentum/></simulation>)",
    R"(<simulation until="1" tolerance="1e-6"/>)"};
/// Two steps of free fall from rest, and what the fixed steps sink in the second in which they
/// close: g Δt² = 1e-5 each [m].
constexpr double kSunk = 3e-5;

/// Height and angle after a second of a body that falls from 0.01 mm above the ground at z = 0; all
/// is turned by `angle` in the plane.
struct Rest {
  double height, turned;
};
Rest rest(const std::string& body, const std::string& shape, const std::string& ground,
          const std::string& simulation, double angle = 0.0) {
  std::ostringstream text;
  const bool space = body == "RigidBody";
  const double s = std::sin(angle), c = std::cos(angle);
  text << std::setprecision(17) << R"(<dynamy version="1"><systems><)" << body
       << R"( name="it" mass="1" inertia=")" << (space ? "1 1 1" : "0.3") << R"(" position=")"
       << -1e-5 * s << " 0 " << 1e-5 * c << '"';
  if (!space) text << " angle=\"" << angle << '"';
  text << '>' << shape << "</" << body << R"(><Ground name="ground">)" << ground
       << R"(</Ground></systems><forces><Gravity acceleration=")" << 9.81 * s << " 0 " << -9.81 * c
       << R"("/></forces><elements><Contact between="a b"><UnilateralCoulomb mu="0.5"/></Contact>)"
       << "</elements>" << simulation << "</dynamy>";
  SceneSetup setup;
  setup.text = text.str();
  Scene scene("rest", std::move(setup));
  scene.run(1.0, 1e-3);
  const Eigen::VectorXd q = scene.q("it");
  return {c * q[space ? 2 : 1] - s * q[0], space ? 0.0 : q[2] - angle};
}

/// Bodies without thickness have no inside that would push them out again.
template <std::size_t n>
void expectRest(const Kind (&kinds)[n], const std::string& body) {
  for (const std::string shape :
       {R"(<Line points="-1 0 0 1 0 0" material="%"/>)", R"(<Point material="%"/>)"})
    for (const Kind& k : kinds) {
      const Kind thin{"", shape.c_str(), ""};
      if (*k.ground == '\0' || touches(thin, k, body) != "yes") continue;
      for (const char* simulation : {kSimulations[0], kSimulations[1]}) {
        const Rest at = rest(body, of(thin, "a"), of({"", k.ground, ""}, "b"), simulation);
        EXPECT_NEAR(at.height, 0.0, kSunk) << shape << k.ground << simulation;
      }
    }
}
TEST(ShapePairs, HoldWhatHasNoThicknessInSpace) { expectRest(kInSpace, "RigidBody"); }
TEST(ShapePairs, HoldWhatHasNoThicknessInAPlane) { expectRest(kInPlane, "PlanarBody"); }

/// On a fixed line rests what has corners.
TEST(ShapePairs, HoldBodiesOnALine) {
  for (const char* shape :
       {R"(<Box size="0.4 1 0.1" position="0 0 0.05" material="a"/>)",
        R"(<Cylinder radius="0.2" length="0.1" position="0 0 0.05" material="a"/>)",
        R"(<Polygon points="-0.2 0 0 0.2 0 0 0 0 0.3" material="a"/>)",
        R"(<Sphere radius="0.2" position="0 0 0.2" material="a"/>)"})
    for (const char* simulation : {kSimulations[0], kSimulations[1]}) {
      const Rest at =
          rest("PlanarBody", shape, R"(<Line points="-1 0 0 1 0 0" material="b"/>)", simulation);
      EXPECT_NEAR(at.height, 0.0, kSunk) << shape << simulation;
    }
}

/// A capsule and a line that lie flat across a box: corners on both sides, however all is turned.
TEST(ShapePairs, KeepACapsuleFlatOnTheCornersOfABox) {
  for (
      const char* shape :
      {R"(<Capsule radius="0.05" length="2" position="0.03 0 0.05" euler="0 {pi/2} 0" material="a"/>)",
       R"(<Line points="-0.97 0 0 1.03 0 0" material="a"/>)"})
    for (const double angle : {0.0, 0.1, 0.3, 0.7, 1.0})
      for (const char* simulation : kSimulations) {
        std::ostringstream ground;
        ground << std::setprecision(17)
               << R"(<Polygon points="-0.2 0 -0.1 0.2 0 -0.1 0.2 0 0 -0.2 0 0" euler="0 )" << -angle
               << R"( 0" material="b"/>)";
        const Rest at = rest("PlanarBody", shape, ground.str(), simulation, angle);
        EXPECT_NEAR(at.height, 0.0, kSunk) << shape << angle << simulation;
        // Two corners close within the same step: what is left is rounding, 1e-16 a step of 1000.
        EXPECT_NEAR(at.turned, 0.0, 1e-12) << shape << angle << simulation;
      }
}

}  // namespace
}  // namespace dynamy::reference
