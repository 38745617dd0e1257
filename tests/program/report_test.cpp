/// dynamy report DIR: the page has what the run's files have.
#include <build_paths.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

using Report = ProgramTest;

/// The drawing that stands as base64 behind `mark`.
std::string drawingAfter(const std::string& page, const std::string& mark) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned word = 0;
  int bits = 0;
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) return out;
  for (std::size_t i = page.find(',', at) + 1; i < page.size(); ++i) {
    const std::size_t digit = digits.find(page[i]);
    if (digit == std::string::npos) break;
    word = word << 6 | static_cast<unsigned>(digit);
    if ((bits += 6) >= 8) out += static_cast<char>(word >> (bits -= 8) & 0xff);
  }
  return out;
}

TEST_F(Report, OfTheWoodpeckerHasAllSections) {
  ASSERT_EQ(call("run \"" DYNAMY_SOURCE_DIR "/models/woodpecker.xml\" --quiet --until 1 --out o"),
            1)
      << err();
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
  // The beak bounces off after each impact, also after the last one: no bar of a closed contact.
  const std::string drawing = drawingAfter(page, "status of the contacts over time\" src=\"");
  const std::size_t beak = drawing.find(">beak</text>");
  ASSERT_NE(beak, std::string::npos) << drawing;
  EXPECT_EQ(drawing.substr(beak, drawing.find("<g stroke", beak) - beak).find("<rect"),
            std::string::npos);
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
  EXPECT_EQ(call("report o"), 2);
  EXPECT_NE(err().find("run.json:1:34: expected ':'"), std::string::npos) << err();
  EXPECT_EQ(call("report nowhere"), 2);
  EXPECT_NE(err().find("nowhere: there is no such folder"), std::string::npos) << err();
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
