#include <dynamy/core/utf8.hpp>

#include <gtest/gtest.h>

namespace dynamy {
namespace {

TEST(Utf8, DecodesCharactersOfOneToFourBytes) {
  EXPECT_EQ(nextCharacter("a", 0).code, U'a');
  EXPECT_EQ(nextCharacter("µ", 0).code, U'µ');
  EXPECT_EQ(nextCharacter("球", 0).code, U'球');
  EXPECT_EQ(nextCharacter("x😀", 1).code, U'😀');
  EXPECT_EQ(characterCount("aµ球😀"), 4);
}

TEST(Utf8, CountsAnInvalidByteAsOneCharacter) {
  EXPECT_EQ(characterCount("\xc2"), 1);
  EXPECT_EQ(characterCount("\xe7\x90x"), 3);
  EXPECT_FALSE(nextCharacter("\xff", 0).valid);
}

TEST(Utf8, RejectsOverlongFormsSurrogatesAndTooLargeCodes) {
  EXPECT_FALSE(nextCharacter("\xc0\xaf", 0).valid);          // '/' in two bytes
  EXPECT_FALSE(nextCharacter("\xe0\x80\xaf", 0).valid);      // '/' in three bytes
  EXPECT_FALSE(nextCharacter("\xed\xa0\x80", 0).valid);      // U+D800
  EXPECT_FALSE(nextCharacter("\xf4\x90\x80\x80", 0).valid);  // U+110000
}

TEST(Utf8, GivesTheColumnOfAByte) {
  EXPECT_EQ(columnOf("µ=b", 0), 1);
  EXPECT_EQ(columnOf("µ=b", 3), 3);
  EXPECT_EQ(columnOf("µ=b", 99), 4);
}

}  // namespace
}  // namespace dynamy
