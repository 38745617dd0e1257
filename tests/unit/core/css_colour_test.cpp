#include <gtest/gtest.h>

#include <dynamy/core/css_colour.hpp>

namespace dynamy {
namespace {

TEST(CssColour, ReadsNamesAndNumbers) {
  EXPECT_EQ(cssColour("#c8553d"), (Rgb{0xc8, 0x55, 0x3d}));
  EXPECT_EQ(cssColour("#FA0"), (Rgb{0xff, 0xaa, 0x00}));
  EXPECT_EQ(cssColour("Tomato"), (Rgb{0xff, 0x63, 0x47}));
  EXPECT_EQ(cssColour("rebeccapurple"), (Rgb{0x66, 0x33, 0x99}));
}

TEST(CssColour, RefusesWhatIsNone) {
  for (const char* text : {"", "rot", "#", "#12", "#12345g", "#12345", "12ff00", "red "})
    EXPECT_FALSE(cssColour(text)) << text;
  EXPECT_EQ(nearestColour("orang"), "orange");
}

}  // namespace
}  // namespace dynamy
