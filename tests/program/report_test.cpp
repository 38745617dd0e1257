/// dynamy report DIR: the page has what the run's files have.
#include <dynamy/io/json_reader.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

using Report = ProgramTest;

TEST_F(Report, OfTheWoodpeckerHasAllSections) {
  const std::string models = std::string(DYNAMY_SOURCE_DIR) + "/models/";
  ASSERT_EQ(call("run " + models + "woodpecker.xml --quiet --until 1 --out o"), 1) << err();
  ASSERT_EQ(call("report o"), 0) << err();
  EXPECT_EQ(out(), "o/report.html\n");
  const std::string page = readWholeFile(path("o/report.html"));
  EXPECT_EQ(page.find("{{"), std::string::npos);
  for (const char* title : {"Result", "What it costs", "Checks", "Energy", "Impacts and switches",
                            "Worst events", "Convergence", "Signals", "Model"})
    EXPECT_NE(page.find("<h2>" + std::string(title) + "</h2>"), std::string::npos) << title;
  const JsonValue run = readJson(readWholeFile(path("o/run.json")), "run.json");
  EXPECT_NE(page.find(run["hash"].text), std::string::npos);
  EXPECT_NE(page.find("FAILS"), std::string::npos);  // the checks at 2.95 s
  EXPECT_NE(page.find("holds"), std::string::npos);
  EXPECT_NE(page.find("&lt;parameter name=&quot;mu&quot;"), std::string::npos);
  // One file: nothing is fetched.
  for (const char* outside : {"src=\"http", "href=\"http", "<link", "@import", "<script"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST_F(Report, ShowsWhatAnEndedOrFailedRunHas) {
  write("fall.xml",
        "<dynamy version=\"1\"><systems><Coordinates name=\"a\" q=\"z\" units=\"m\" M=\"1\" "
        "h=\"1/(0.4375-t)\"/></systems><simulation until=\"1\" "
        "step=\"0.125\"><MoreauMidpoint/></simulation></dynamy>\n");
  ASSERT_EQ(call("run fall.xml --out o --quiet"), 1) << err();
  ASSERT_EQ(call("report o --out elsewhere.html"), 0) << err();
  const std::string page = readWholeFile(path("elsewhere.html"));
  EXPECT_NE(page.find("<td class=\"text bad\">failed: "), std::string::npos) << page;
  fs::remove(path("o/ledger.csv"));
  fs::remove(path("o/signals.csv"));
  fs::remove(path("o/events.csv"));
  EXPECT_EQ(call("report o"), 0) << err();
  write("o/run.json", "{\"format\": \"dynamy-run\", \"state\" }");
  EXPECT_EQ(call("report o"), 1);
  EXPECT_NE(err().find("run.json:1:34: expected ':'"), std::string::npos) << err();
  EXPECT_EQ(call("report nowhere"), 1);
  EXPECT_NE(err().find("holds no run"), std::string::npos) << err();
}

TEST_F(Report, IsRemovedWithTheRunItTellsOf) {
  write("fall.xml",
        "<dynamy version=\"1\"><systems><Coordinates name=\"a\" q=\"z\" units=\"m\" M=\"1\"/>"
        "</systems><simulation until=\"1\" step=\"0.125\"/></dynamy>\n");
  ASSERT_EQ(call("run fall.xml --out o --quiet"), 0) << err();
  ASSERT_EQ(call("report o"), 0) << err();
  ASSERT_EQ(call("run fall.xml --out o --quiet"), 0) << err();
  EXPECT_FALSE(fs::exists(path("o/report.html")));
}

}  // namespace
}  // namespace dynamy
