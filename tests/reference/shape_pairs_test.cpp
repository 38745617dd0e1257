/// Which shapes touch which: the tables of doc/shape_pairs.md are what models are told.
#include <gtest/gtest.h>

#include <dynamy/core/error.hpp>
#include <dynamy_elements/contacts/shape_contacts.hpp>
#include <fstream>
#include <reference/scene.hpp>
#include <sstream>

namespace dynamy::reference {
namespace {

struct Kind {
  const char *name, *text;
};
constexpr Kind kInSpace[] = {
    {"Sphere", R"(<Sphere radius="0.1" material="%"/>)"},
    {"Point", R"(<Point material="%"/>)"},
    {"Capsule", R"(<Capsule radius="0.1" length="0.3" material="%"/>)"},
    {"Line", R"(<Line points="0 0 0 0 0 1" material="%"/>)"},
    {"Cylinder", R"(<Cylinder radius="0.1" length="0.3" material="%"/>)"},
    {"Cone", R"(<Cone radius="0.1" length="0.3" material="%"/>)"},
    {"Torus", R"(<Torus radius="0.1" tube="0.02" material="%"/>)"},
    {"Ellipsoid", R"(<Ellipsoid semiAxes="0.1 0.2 0.3" material="%"/>)"},
    {"Box", R"(<Box size="0.1 0.2 0.3" material="%"/>)"},
    {"Polyhedron", R"(<Polyhedron points="0 0 0 1 0 0 0 1 0 0 0 1" material="%"/>)"},
    {"Mesh", R"(<Mesh points="0 0 0 1 0 0 0 1 0" triangles="0 1 2" material="%"/>)"},
    {"HeightField", R"(<HeightField columns="2" spacing="1 1" heights="0 0 0 0" material="%"/>)"},
    {"HalfSpace", R"(<HalfSpace material="%"/>)"}};
constexpr Kind kInPlane[] = {
    {"Sphere, Circle", R"(<Sphere radius="0.1" material="%"/>)"},
    {"Point", R"(<Point material="%"/>)"},
    {"Capsule", R"(<Capsule radius="0.1" length="0.3" material="%"/>)"},
    {"Line", R"(<Line points="0 0 0 0 0 1" material="%"/>)"},
    {"Cylinder, Cone", R"(<Cylinder radius="0.1" length="0.3" material="%"/>)"},
    {"Torus", R"(<Torus radius="0.1" tube="0.02" material="%"/>)"},
    {"Ellipsoid", R"(<Ellipsoid semiAxes="0.1 0.2 0.3" material="%"/>)"},
    {"Box", R"(<Box size="0.1 0.2 0.3" material="%"/>)"},
    {"Polygon", R"(<Polygon points="0 0 0 1 0 0 0 0 1" material="%"/>)"},
    {"Contour", R"~(<Contour r="0.05 + 0.01*cos(phi)" euler="{pi/2} 0 0" material="%"/>)~"},
    {"HalfSpace", R"(<HalfSpace material="%"/>)"}};

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

template <std::size_t n>
std::string table(const Kind (&kinds)[n], const std::string& body) {
  std::string out = "| |", line = "|---|";
  for (const Kind& k : kinds) out += " " + std::string(k.name) + " |", line += "---|";
  out += "\n" + line + "\n";
  for (std::size_t i = 0; i < n; ++i) {
    out += "| **" + std::string(kinds[i].name) + "** |";
    for (std::size_t j = 0; j < n; ++j)
      out += j > i ? " |" : " " + touches(kinds[i], kinds[j], body) + " |";
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

}  // namespace
}  // namespace dynamy::reference
