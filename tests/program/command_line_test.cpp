/// The manual page and the completion of shells say what --help says, for every command.
#include <build_paths.hpp>
#include <program/program_fixture.hpp>
#include <regex>
#include <set>

namespace dynamy {
namespace {

class CommandLine : public ProgramTest {
 protected:
  /// Names of all sub-commands, from the list of --help.
  std::vector<std::string> commands() const {
    EXPECT_EQ(call("--help"), 0);
    std::vector<std::string> all;
    bool inside = false;
    std::istringstream lines(out());
    for (std::string line; std::getline(lines, line);) {
      if (inside && !line.starts_with("  ")) break;
      if (inside) all.push_back(line.substr(2, line.find(' ', 2) - 2));
      inside = inside || line == "Subcommands:";
    }
    return all;
  }
  /// "--until", … of `dynamy COMMAND --help`.
  std::set<std::string> options(const std::string& command) const {
    EXPECT_EQ(call(command + " --help"), 0);
    const std::string text = out();
    const std::regex option(R"(\n  (?:-\w,)?(--[a-z-]+))");
    std::set<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it)
      all.insert((*it)[1]);
    return all;
  }
  /// What bash offers after these words; the last one is being typed.
  std::string offered(const std::string& words) const {
    write("complete.sh",
          "PATH='" DYNAMY_BINARY_DIR
          "/bin':$PATH\n"
          "source ./script\n"
          "COMP_WORDS=(" +
              words +
              ")\n"
              "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_dynamy\necho \"${COMPREPLY[*]}\"\n");
    const std::string command =
        "cd '" + folder_.string() + "' && bash --norc complete.sh > offered 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string text = readWholeFile(path("offered"));
    return text.substr(0, text.find_last_not_of('\n') + 1);
  }
};

TEST_F(CommandLine, TheManualHoldsEveryOptionOfEveryCommand) {
  const std::vector<std::string> all = commands();
  ASSERT_GT(all.size(), 8u);
  ASSERT_EQ(call("manual"), 0) << err();
  const std::string page = out();
  for (const std::string& command : all) {
    const std::size_t begin =
        page.find(".SS dynamy " + std::regex_replace(command, std::regex("-"), "\\-") + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string section = page.substr(begin, page.find("\n.S", begin + 1) - begin);
    for (const std::string& option : options(command)) {
      if (option == "--help") continue;
      const std::string roff = std::regex_replace(option, std::regex("-"), "\\-");
      EXPECT_NE(section.find("\\fB" + roff + "\\fR"), std::string::npos)
          << command << ' ' << option;
    }
  }
}

TEST_F(CommandLine, TheManualIsAPageForMan) {
  if (std::system("man --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no man";
  ASSERT_EQ(call("manual"), 0) << err();
  const std::string command =
      "cd '" + folder_.string() + "' && MANROFFOPT=-ww man -l --warnings out > page 2> warnings";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(readWholeFile(path("warnings")), "");
  EXPECT_NE(readWholeFile(path("page")).find("EXIT STATUS"), std::string::npos);
}

TEST_F(CommandLine, BashCompletesCommandsOptionsTypesAndFiles) {
  ASSERT_EQ(call("completion bash"), 0) << err();
  std::filesystem::rename(path("out"), path("script"));
  write("ball.xml", "");
  write("ball.csv", "");
  std::filesystem::create_directory(folder_ / "bag");
  EXPECT_EQ(offered("dynamy desc"), "describe");
  EXPECT_EQ(offered("dynamy run --int"), "--integrator");
  EXPECT_EQ(offered("dynamy run --integrator MoreauM"), "MoreauMidpoint");
  EXPECT_EQ(offered("dynamy run ball.xml --solver Autom"), "Automatic");
  EXPECT_EQ(offered("dynamy describe RigidB"), "RigidBody");
  EXPECT_EQ(offered("dynamy describe simul"), "simulation");
  EXPECT_EQ(offered("dynamy check ba"), "ball.xml bag") << "models and folders, no other file";
  EXPECT_EQ(offered("dynamy view ba"), "bag");
  EXPECT_EQ(offered("dynamy completion \"\""), "bash zsh fish");
  EXPECT_EQ(offered("dynamy run --until \"\""), "") << "a time is for the user to say";
}

TEST_F(CommandLine, EveryShellKnowsEveryOption) {
  const std::vector<std::string> all = commands();
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    ASSERT_EQ(call("completion " + shell), 0) << err();
    const std::string script = out();
    for (const std::string& command : all) {
      EXPECT_NE(script.find(command), std::string::npos) << shell << ' ' << command;
      for (const std::string& option : options(command))
        EXPECT_NE(script.find(shell == "fish" ? "-l " + option.substr(2) : option),
                  std::string::npos)
            << shell << ' ' << command << ' ' << option;
    }
  }
  EXPECT_EQ(call("completion tcsh"), 64);
  EXPECT_NE(err().find("tcsh"), std::string::npos);
}

TEST_F(CommandLine, ListTellsNamesOfOneKind) {
  ASSERT_EQ(call("list --names --kind impact"), 0) << err();
  EXPECT_NE(out().find("NewtonImpact\n"), std::string::npos);
  EXPECT_EQ(out().find("RigidBody"), std::string::npos);
  EXPECT_EQ(call("list --kind bump"), 64);
  EXPECT_NE(err().find("impact"), std::string::npos) << err();
}

TEST_F(CommandLine, TheVersionNamesLibrariesAndFormats) {
  ASSERT_EQ(call("--version"), 0);
  for (const char* part : {"dynamY ", "compiler", "Eigen 3.", "HDF5 ", "Boost ", "zlib ",
                           "tinyxml2 ", "binary interface", "models 1", "FCLIB", "replay"})
    EXPECT_NE(out().find(part), std::string::npos) << part << '\n' << out();
}

TEST_F(CommandLine, AWrongWordIsNamedWithTheRightOne) {
  const auto first = [&](const std::string& arguments) {
    EXPECT_EQ(call(arguments), 64);
    return err().substr(0, err().find('\n'));
  };
  EXPECT_EQ(first("runn"), "dynamy: there is no command \"runn\" — did you mean \"run\"?");
  EXPECT_EQ(first("runn m.xml"), "dynamy: there is no command \"runn\" — did you mean \"run\"?");
  EXPECT_EQ(first("simulate m.xml"),
            "dynamy: there is no command \"simulate\" — did you mean \"run\"?");
  EXPECT_EQ(first("run m.xml --untill 3"),
            "dynamy: there is no option \"--untill\" — did you mean \"--until\"?");
  EXPECT_EQ(first("run m.xml --param a=1"),
            "dynamy: there is no option \"--param\" — a parameter of the model is given by "
            "--set NAME=VALUE");
  EXPECT_EQ(first(""), "dynamy: a command is missing, such as dynamy run model.xml");
}

TEST_F(CommandLine, KindsAreUnderstoodInAnyCaseAndNumber) {
  ASSERT_EQ(call("list --kind law"), 0) << err();
  const std::string laws = out();
  ASSERT_EQ(call("list --kind Laws"), 0) << err();
  EXPECT_EQ(out(), laws);
}

TEST_F(CommandLine, DescribeFindsTypesOfPlugInsAndListNamesThem) {
  ASSERT_EQ(call("describe Motorbike"), 0) << err();
  EXPECT_TRUE(out().starts_with("<Motorbike>  system of motorbike\n")) << out();
  ASSERT_EQ(call("list"), 0) << err();
  const std::size_t more = out().find("\nPlug-ins bring more, dynamy list --plugin NAME: ");
  ASSERT_NE(more, std::string::npos) << out();
  EXPECT_NE(out().find(" woodpecker", more), std::string::npos) << out();
}

TEST_F(CommandLine, DescribeListsTheTypesOnASubject) {
  ASSERT_EQ(call("describe friction"), 0) << err();
  for (const char* law :
       {"UnilateralCoulomb", "GivenFriction", "UnilateralStribeck", "BeltFriction"})
    EXPECT_NE(out().find(std::string("  ") + law + ' '), std::string::npos) << law << out();
  EXPECT_EQ(out().find("  Gravity "), std::string::npos) << out();
  ASSERT_EQ(call("describe hinge"), 0) << err();
  EXPECT_TRUE(out().starts_with("in dynamY a hinge is <Revolute>\n")) << out();
  ASSERT_EQ(call("describe restitution"), 0) << err();
  EXPECT_NE(out().find("<UnilateralCoulomb> epsilonN: "), std::string::npos) << out();
}

}  // namespace
}  // namespace dynamy
