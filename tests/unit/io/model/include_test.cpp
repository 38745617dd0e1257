#include <gtest/gtest.h>

#include <fstream>
#include <unit/io/model/load_text.hpp>

namespace dynamy {
namespace {

using namespace dummy;

class Includes : public ::testing::Test {
 protected:
  Includes() {
    std::string name = (fs::temp_directory_path() / "dynamy_include_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Includes() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& inside) const {
    std::ofstream(folder_ / name) << around(inside);
  }
  fs::path folder_;
};

TEST_F(Includes, GetPrefixAndParametersOfTheirOwn) {
  write("part.xml",
        "<parameter name=\"h\" value=\"1\"/><systems><Ball name=\"b\" z=\"{h}\"/></systems>"
        "<elements><Stop on=\"b\"><Law/></Stop></elements><simulation until=\"99\"/>");
  const std::string text = around(
      "<defaults><Ball mass=\"1\"/></defaults><parameter name=\"n\" value=\"3\"/>"
      "<include file=\"part.xml\" prefix=\"left\"/>"
      "<include file=\"part.xml\" prefix=\"right\"><set name=\"h\" value=\"{2*n}\"/></include>"
      "<elements><Stop on=\"right/b\"><Law/></Stop></elements>");
  const Model m = load(text, {}, folder_);
  ASSERT_EQ(m.systems().size(), 2u);
  EXPECT_EQ(ball(m, 1).name(), "right/b");
  EXPECT_EQ(m.initialState().q, Eigen::Vector2d(1, 6));
  EXPECT_EQ(stop(m, 0).on, "left/b");
  EXPECT_EQ(stop(m, 1).on, "right/b");
  EXPECT_EQ(stop(m, 2).on, "right/b");
  EXPECT_EQ(m.simulation.until, 1.0);
  EXPECT_EQ(load(text, {{"left/h", "5"}}, folder_).initialState().q, Eigen::Vector2d(5, 6));
}

TEST_F(Includes, ShowTheChainOfFilesThatIncludeEachOther) {
  write("a.xml", "<include file=\"b.xml\"/>");
  write("b.xml", "<include file=\"a.xml\"/>");
  const std::string error = errors(around("<include file=\"a.xml\"/>"), {}, folder_);
  EXPECT_EQ(error.substr(0, error.find('\n')),
            (folder_ / "b.xml").string() +
                ":2:16: error: <include>: the file includes itself: m.xml → a.xml → b.xml → a.xml");
}

TEST_F(Includes, ErrorsNameTheIncludedFile) {
  write("part.xml", "<systems><Ball name=\"b\" mas=\"1\"/></systems>");
  const std::string error = errors(around("<include file=\"part.xml\"/>"), {}, folder_);
  EXPECT_TRUE(error.starts_with((folder_ / "part.xml").string() + ":2:")) << error;
}

TEST_F(Includes, SayThatAFileOrAParameterIsMissing) {
  write("part.xml", "<parameter name=\"height\" value=\"1\"/>");
  EXPECT_EQ(
      errors(around("<include file=\"part.xml\"><set name=\"heigth\" value=\"1\"/></include>"), {},
             folder_),
      "m.xml:2:37: error: <set name=\"heigth\">: \"" + (folder_ / "part.xml").string() +
          "\" has no parameter \"heigth\" — did you mean \"height\"?\n"
          "    2 | <include file=\"part.xml\"><set name=\"heigth\" value=\"1\"/></include>\n"
          "      |                                     ^~~~~~");
  const std::string error = errors(around("<include file=\"prat.xml\"/>"), {}, folder_);
  EXPECT_TRUE(error.starts_with("m.xml:2:16: error: <include>: \"")) << error;
}

}  // namespace
}  // namespace dynamy
