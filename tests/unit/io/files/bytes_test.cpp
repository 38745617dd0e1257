#include <gtest/gtest.h>

#include <dynamy/io/files/bytes.hpp>
#include <limits>

namespace dynamy {
namespace {

TEST(Bytes, NumbersStandLittleEndian) {
  std::string out;
  appendBytes(out, std::uint32_t{0x01020304});
  EXPECT_EQ(out, std::string("\x04\x03\x02\x01"));
  out.clear();
  appendBytes(out, 1.0);  // IEEE 754: sign 0, exponent 0x3ff, mantissa 0
  EXPECT_EQ(out, std::string("\0\0\0\0\0\0\xf0\x3f", 8));
}

TEST(Bytes, WhatIsAppendedIsReadBack) {
  std::string out = "x";
  appendBytes(out, -std::numeric_limits<double>::denorm_min());
  appendBytes(out, 3.5f);
  EXPECT_EQ(readBytes<double>(&out[1]), -std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(readBytes<float>(&out[9]), 3.5f);
}

TEST(Crc32, HasTheCheckValueOfTheStandard) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);  // the "check" of CRC-32/ISO-HDLC
  EXPECT_EQ(crc32(""), 0u);
}

TEST(Crc32, ContinuesAnEarlierPart) { EXPECT_EQ(crc32("56789", crc32("1234")), 0xCBF43926u); }

TEST(Base64, AgreesWithTheVectorsOfRfc4648) {
  const auto encoded = [](std::string_view bytes) {
    std::string out;
    appendBase64(out, bytes);
    return out;
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace dynamy
