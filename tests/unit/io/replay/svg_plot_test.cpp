#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/io/replay/svg_plot.hpp>

namespace dynamy {
namespace {

using Panels = std::vector<std::vector<std::size_t>>;

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(SignalsSvg, PutsSignalsOfOneElementAndUnitTogether) {
  const std::vector<SignalName> signals{{"a.x", "m"}, {"a.v", "m/s"}, {"b.x", "m"}, {"a.z", "m"}};
  EXPECT_EQ(panelsOf(signals), (Panels{{0, 3}, {1}, {2}}));
}

TEST(SignalsSvg, GivesASignalWithoutUnitItsOwnPanel) {
  const std::vector<SignalName> signals{{"a.x", ""}, {"a.y", ""}};
  EXPECT_EQ(panelsOf(signals), (Panels{{0}, {1}}));
}

TEST(SignalsSvg, HasOneCurveASignalAndEscapedNames) {
  const SignalTable table{{{"a<b.x", "m"}, {"c&d", ""}}, {0, 1, 2}, {{0, 1, 0}, {5, 5, 5}}};
  const std::string svg = signalsSvg(table, "\"t\" > 1");
  EXPECT_EQ(countOf(svg, "class=\"curve\""), 2u);
  EXPECT_NE(svg.find("a&lt;b.x"), std::string::npos);
  EXPECT_NE(svg.find("c&amp;d"), std::string::npos);
  EXPECT_NE(svg.find("&quot;t&quot; &gt; 1"), std::string::npos);
}

TEST(SignalsSvg, LiftsThePenOverValuesThatAreNotFinite) {
  const SignalTable table{{{"x", ""}}, {0, 1, 2, 3, 4}, {{0, 1, std::nan(""), 1, INFINITY}}};
  const std::string svg = signalsSvg(table, "gap");
  const std::size_t begin = svg.find("d=\"", svg.find("class=\"curve\"")) + 3;
  const std::string path = svg.substr(begin, svg.find('"', begin) - begin);
  EXPECT_EQ(countOf(path, "M"), 2u);
  EXPECT_EQ(countOf(path, "L"), 1u);
  EXPECT_EQ(countOf(svg, "nan") + countOf(svg, "inf"), 0u);
}

TEST(SignalsSvg, IsAPictureEvenOfNothing) {
  EXPECT_NE(signalsSvg({}, "empty").find("</svg>"), std::string::npos);
  const SignalTable noRows{{{"x", "m"}}, {}, {{}}};
  EXPECT_NE(signalsSvg(noRows, "empty").find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace dynamy
