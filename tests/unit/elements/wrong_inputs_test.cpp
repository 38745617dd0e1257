/// What a newcomer writes and reads: each text of tests/data/wrong_inputs.txt and first_tries.txt
/// stands in a small model and has to give the messages below it, word by word. The first tries were
/// written down before the messages were looked at.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <filesystem>
#include <sstream>

extern "C" const dynamy::PluginInfo* dynamy_plugin_info();

namespace dynamy {
namespace {
namespace fs = std::filesystem;

struct WrongInput {
  std::string section, text;
  std::vector<std::string> messages;
};

/// Lines: `[section] title`, a text, its messages indented by two blanks.
std::vector<WrongInput> wrongInputs(const std::string& file) {
  std::istringstream in(readWholeFile(fs::path(DYNAMY_SOURCE_DIR) / "tests" / "data" / file));
  std::vector<WrongInput> out;
  std::string section;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('['))
      section = line.substr(1, line.find(']') - 1);
    else if (line.starts_with("  "))
      out.back().messages.push_back(line.substr(2));
    else if (line.starts_with('<'))
      out.push_back({section, line, {}});
  }
  return out;
}

/// A ball above a floor, with the text in its place.
std::string modelAround(const WrongInput& input) {
  const auto in = [&](const std::string& section, const std::string& otherwise) {
    return input.section == section ? input.text : otherwise;
  };
  return "<dynamy version=\"1\">" + in("root", "") +
         "<systems><RigidBody name=\"ball\" mass=\"1\" inertia=\"1 1 1\" position=\"0 0 2\">" +
         in("shape", "<Sphere radius=\"0.1\" material=\"rubber\"/>") +
         "</RigidBody><Ground name=\"world\"><HalfSpace material=\"concrete\"/></Ground>" +
         in("systems", "") + "</systems><forces>" + in("forces", "") +
         "</forces><elements><Contact between=\"rubber concrete\">" + in("law", "<Unilateral/>") +
         "</Contact>" + in("elements", "") + "</elements>" +
         in("simulation", "<simulation until=\"1\" step=\"1e-3\"/>") + "</dynamy>";
}

std::vector<std::string> messagesOf(const std::string& model) {
  Registry registry;
  registerFramework(registry);
  dynamy_plugin_info()->registerElements(registry);
  PluginLoader plugins((std::vector<fs::path>()));
  std::vector<std::string> out;
  try {
    loadModelText(model, "m.xml", registry, plugins);
  } catch (const ModelError& e) {
    for (const Diagnostic& d : e.diagnostics()) {
      EXPECT_GT(d.place.line, 0) << d.text;
      out.push_back((d.element.empty() ? "" : "<" + d.element + ">: ") + d.text +
                    (d.hint.empty() ? "" : " — " + d.hint));
    }
  }
  return out;
}

class WrongInputs : public ::testing::TestWithParam<const char*> {};

TEST_P(WrongInputs, GiveMessagesThatNameTheRemedy) {
  const std::vector<WrongInput> all = wrongInputs(GetParam());
  EXPECT_GE(all.size(), 60u);
  for (const WrongInput& input : all) {
    const auto messages = messagesOf(modelAround(input));
    EXPECT_EQ(messages, input.messages) << input.text;
    EXPECT_FALSE(messages.empty()) << input.text << " is accepted";
  }
}
INSTANTIATE_TEST_SUITE_P(Files, WrongInputs,
                         ::testing::Values("wrong_inputs.txt", "first_tries.txt"));

}  // namespace
}  // namespace dynamy
