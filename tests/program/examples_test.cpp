/// What `dynamy describe` shows as an example works, and the schema knows every model of the tree.
#include <build_paths.hpp>
#include <fstream>
#include <program/program_fixture.hpp>
#include <regex>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

using Examples = ProgramTest;

struct Listed {
  std::string name, kind;
};

/// From `dynamy list --json`, one object after the other.
std::vector<Listed> listed(const std::string& json) {
  std::vector<Listed> all;
  const std::regex object(R"re("name": "([^"]+)",\s*"kind": "([^"]+)")re");
  for (std::sregex_iterator it(json.begin(), json.end(), object), end; it != end; ++it)
    all.push_back({(*it)[1], (*it)[2]});
  return all;
}

std::string exampleIn(const std::string& description) {
  const std::size_t at = description.find("\nExample\n");
  return at == std::string::npos ? "" : description.substr(at + 9);
}

/// A model around the example, with the bodies that the examples of joints and forces speak of.
std::string around(const Listed& type, const std::string& example) {
  const auto body = [&](const std::string& name) {
    return example.find("name=\"" + name + "\"") != std::string::npos
               ? std::string()
               : "<RigidBody name=\"" + name +
                     "\" position=\"0 0 1\"><Sphere radius=\"0.1\" mass=\"1\"/>" + "</RigidBody>\n";
  };
  const bool ownPendulum = example.find("name=\"pendulum\"") != std::string::npos;
  std::string systems, forces, elements, simulation = "<simulation until=\"0.1\" step=\"1e-3\"/>\n";
  for (const char* name : {"bob", "base", "cart", "rod", "ball"}) systems += body(name);
  const std::string inPendulum = type.name == "CoordinateFrame" ? example : "";
  if (!ownPendulum)
    systems += "<Coordinates name=\"pendulum\" q=\"phi\" units=\"rad\" M=\"l^2\">" + inPendulum +
               "</Coordinates>\n";
  systems += "<Ground name=\"world\"/>\n";
  if (type.kind == "system") systems += example;
  if (type.kind == "shape" || type.name == "Frame")
    systems += (type.name == "HalfSpace" ? "<Ground>" + example + "</Ground>\n"
                                         : "<RigidBody><Sphere radius=\"0.1\" mass=\"1\"/>" +
                                               example + "</RigidBody>\n");
  if (type.kind == "force") forces += example;
  if (type.kind == "contact" || type.kind == "rule") elements += example;
  // Laws without a normal force are none of bodies that touch.
  const bool touches = type.name.starts_with("Unilateral") || type.name == "BeltFriction";
  if (type.kind == "law" && touches)
    elements += "<Contact between=\"wood steel\">" + example + "</Contact>\n";
  else if (type.kind == "law")
    elements +=
        "<CoordinateContact on=\"pendulum\" gap=\"phi\">" + example + "</CoordinateContact>\n";
  if (example.find("<simulation") != std::string::npos) simulation = example;
  return "<dynamy version=\"1\">\n<parameter name=\"l\" value=\"0.5\"/>\n<systems>\n" + systems +
         "</systems>\n<forces>\n" + forces + "</forces>\n<elements>\n" + elements +
         "</elements>\n" + simulation + "</dynamy>\n";
}

TEST_F(Examples, OfEveryTypeRun) {
  ASSERT_EQ(call("list --json"), 0) << err();
  const std::vector<Listed> types = listed(out());
  ASSERT_GT(types.size(), 30u) << out();
  for (const Listed& type : types) {
    ASSERT_EQ(call("describe " + type.name), 0) << err();
    const std::string example = exampleIn(out());
    EXPECT_NE(example, "") << type.name << " has no example";
    write("example.xml", around(type, example));
    EXPECT_EQ(call("run example.xml --until 0.01 --out o"), 0)
        << type.name << "\n"
        << err() << readWholeFile(path("example.xml"));
    // Differences of all elements at random states.
    EXPECT_EQ(call("check example.xml --elements"), 0) << type.name << "\n" << out() << err();
  }
}

TEST_F(Examples, OfEveryWordOfTheModelFileAreAccepted) {
  write("hopper.xml", "<dynamy version=\"1\"><parameter name=\"opening\" value=\"1\"/></dynamy>");
  ASSERT_EQ(call("list --names"), 0) << err();
  std::istringstream names(out());
  int words = 0;
  for (std::string name; std::getline(names, name);) {
    ASSERT_EQ(call("describe " + name), 0) << err();
    if (out().find("word of the model file") == std::string::npos) continue;
    const std::string example = exampleIn(out());
    EXPECT_NE(example, "") << name << " has no example";
    const auto lacks = [&](const char* text) { return example.find(text) == std::string::npos; };
    std::string model = "<dynamy version=\"1\">\n<parameter name=\"r\" value=\"0.01\"/>\n";
    if (lacks("<replicate"))
      model +=
          example + "<systems><RigidBody name=\"ball\" mass=\"1\" inertia=\"1 1 1\"/></systems>\n";
    else
      model += "<systems>" + example + "</systems>\n";
    if (lacks("<simulation")) model += "<simulation until=\"5\" step=\"1e-3\"/>\n";
    write("example.xml", name == "dynamy" ? example : model + "</dynamy>\n");
    EXPECT_EQ(call("check example.xml"), 0) << name << "\n"
                                            << err() << readWholeFile(path("example.xml"));
    ++words;
  }
  EXPECT_GE(words, 14);
}

TEST_F(Examples, TheReferencePagesAreThoseOfTheProgram) {
  ASSERT_EQ(call("describe --pages pages"), 0) << err();
  const fs::path kept = fs::path(DYNAMY_SOURCE_DIR) / "doc" / "reference";
  int pages = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "pages")) {
    const fs::path page = kept / entry.path().filename();
    ASSERT_TRUE(fs::exists(page)) << page;
    EXPECT_EQ(readWholeFile(page), readWholeFile(entry.path()))
        << "build/release/bin/dynamy describe --pages doc/reference";
    ++pages;
  }
  for (const auto& entry : fs::directory_iterator(kept))
    EXPECT_TRUE(fs::exists(folder_ / "pages" / entry.path().filename())) << entry.path();
  EXPECT_GT(pages, 9);
}

TEST_F(Examples, EveryModelFitsTheSchema) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no xmllint";
  int models = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(DYNAMY_SOURCE_DIR) / "models")) {
    if (entry.path().extension() != ".xml") continue;
    const std::string text = readWholeFile(entry.path());
    std::string plugins;
    const std::regex line("<plugin library=\"([^\"]+)\"");
    for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
      plugins += " --plugin " + (*it)[1].str();
    ASSERT_EQ(call("schema" + plugins), 0) << err();
    fs::rename(path("out"), path("dynamy.xsd"));
    const std::string command = "xmllint --noout --schema '" + path("dynamy.xsd") + "' '" +
                                entry.path().string() + "' > '" + path("log") + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << readWholeFile(path("log"));
    ++models;
  }
  EXPECT_GT(models, 10);
}

TEST_F(Examples, ElementsOfTheModelsFitTheirOwnDerivatives) {
  // Differences of all elements at random states. Models of more coordinates take up to a minute.
  constexpr int kMostCoordinates = 1000;
  int models = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(DYNAMY_SOURCE_DIR) / "models")) {
    if (entry.path().extension() != ".xml") continue;
    const std::string model = "'" + entry.path().string() + "'";
    call("check " + model);
    std::smatch q;
    const std::string text = out();
    ASSERT_TRUE(std::regex_search(text, q, std::regex("\n q ([0-9]+) "))) << text << err();
    if (std::stoi(q[1].str()) > kMostCoordinates) continue;
    EXPECT_EQ(call("check --elements " + model), 0) << out() << err();
    ++models;
  }
  EXPECT_GT(models, 80);
}

TEST_F(Examples, ReaderAndSchemaRefuseTheSameMistakes) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no xmllint";
  const std::string good = readWholeFile(fs::path(DYNAMY_SOURCE_DIR) / "models/bouncing_ball.xml");
  ASSERT_EQ(call("schema"), 0) << err();
  fs::rename(path("out"), path("dynamy.xsd"));
  const auto valid = [&] {
    return std::system(("cd '" + folder_.string() +
                        "' && xmllint --noout --schema dynamy.xsd m.xml > log 2>&1")
                           .c_str()) == 0;
  };
  write("m.xml", good);
  EXPECT_TRUE(valid());
  EXPECT_EQ(call("check m.xml"), 0) << err();
  struct Mistake {
    const char *from, *to;
  };
  for (const Mistake& m : {
           Mistake{"<systems>", "<sistems/><systems>"},        // unknown section
           Mistake{"<systems>", "<systems><RigidBdy/>"},       // unknown element
           Mistake{"<systems>", "<systems><Gravity/>"},        // element in a wrong section
           Mistake{"<Gravity ", "<Gravity strength=\"2\" "},   // unknown attribute
           Mistake{"radius=", "raduis="},                      // misspelt attribute
           Mistake{"<Sphere ", "<Sphere mu=\"1\" "},           // attribute of another element
           Mistake{"<Unilateral ", "<MoreauMidpoint "},        // no law inside of a contact
           Mistake{"<MoreauMidpoint/>", "<Sphere/>"},          // no scheme in the simulation
           Mistake{"view=\"xz\"", "view=\"zx\""},              // none of the words
           Mistake{"measure=\"min\"", "measure=\"least\""},    // the same
           Mistake{"name=\"e\" value=\"0.5\"", "name=\"e\""},  // what a word demands
           Mistake{"until=", "untill="},                       // misspelt setting
       }) {
    std::string text = good;
    const std::size_t at = text.find(m.from);
    ASSERT_NE(at, std::string::npos) << m.from;
    write("m.xml", text.replace(at, std::string(m.from).size(), m.to));
    EXPECT_FALSE(valid()) << m.to << "\n" << readWholeFile(path("log"));
    EXPECT_EQ(call("check m.xml"), 2) << m.to << "\n" << err();
  }
}

}  // namespace
}  // namespace dynamy
