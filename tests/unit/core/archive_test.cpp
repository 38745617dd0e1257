#include <gtest/gtest.h>
#include <dynamy/core/archive.hpp>
#include <dynamy/core/compensated_sum.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/core/hash.hpp>

#include <bit>
#include <cmath>
#include <set>
#include <vector>

namespace dynamy {
namespace {

TEST(Archive, GivesBackEveryBit) {
  double x = -0.0, nan = std::nan("7");
  std::string text = "γ";
  std::vector<int> numbers = {-3, 5};
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(3, 0.0, 0.1);
  Archive out;
  out(x), out(nan), out(text), out(numbers), out(v);
  double y = 1.0, nan2 = 0.0;
  std::string text2;
  std::vector<int> numbers2;
  Eigen::VectorXd v2;
  Archive in(out.bytes());
  in(y), in(nan2), in(text2), in(numbers2), in(v2);
  EXPECT_TRUE(std::signbit(y) && y == 0.0);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(nan), std::bit_cast<std::uint64_t>(nan2));
  EXPECT_EQ(text, text2);
  EXPECT_EQ(numbers, numbers2);
  EXPECT_EQ(v, v2);
  EXPECT_TRUE(in.atEnd());
}

TEST(Archive, BytesThatEndEarlyAreAModelError) {
  Archive out;
  std::vector<double> v(5, 1.0);
  out(v);
  for (std::size_t n = 0; n < out.bytes().size(); ++n) {
    Archive in(out.bytes().substr(0, n));
    std::vector<double> w;
    EXPECT_THROW(in(w), ModelError);
  }
}

TEST(Archive, CountsAreBoundedByWhatIsLeft) {
  // An entry takes at least a word: 20 bytes are left for 3 of them, which are no three.
  for (const std::uint64_t count : {std::uint64_t{3}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::uint64_t n = count;
    Archive out;
    out(n);
    std::vector<std::string> texts;
    Eigen::VectorXd v;
    std::string text;
    Archive first(out.bytes() + std::string(20, '\0')), second = first, third = first;
    EXPECT_THROW(first(texts), ModelError);
    EXPECT_THROW(second(v), ModelError);
    if (count > 20) {
      EXPECT_THROW(third(text), ModelError);
    }
  }
}

TEST(Archive, SectionsOfAnotherOrderAreAModelError) {
  Archive out;
  out.section("state");
  Archive in(out.bytes());
  EXPECT_THROW(in.section("report"), ModelError);
}

TEST(CompensatedSum, KeepsWhatPlainSummationLoses) {
  CompensatedSum sum;
  for (const double x : {1.0, 1e100, 1.0, -1e100}) sum.add(x);
  EXPECT_EQ(sum.value(), 2.0);
}

TEST(Hash, ChangesWithEveryBitOfEveryNumber) {
  for (const std::size_t n : {1u, 5u, 32u, 70u}) {  // above 31 in four lanes
    std::vector<double> x(n, 0.25);
    std::set<std::uint64_t> seen;
    const auto hashOf = [&x] {
      Hash h;
      h.add(x);
      return h.value();
    };
    seen.insert(hashOf());
    for (double& number : x)
      for (int bit = 0; bit < 64; ++bit) {
        const double before = number;
        number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ 1ull << bit);
        EXPECT_TRUE(seen.insert(hashOf()).second) << n << ' ' << bit;
        number = before;
      }
  }
}

TEST(Hash, TellsOrderSignOfZeroAndLengthApart) {
  const auto hashOf = [](const std::vector<double>& x) {
    Hash h;
    h.add(x);
    return h.value();
  };
  EXPECT_NE(hashOf({1.0, 2.0}), hashOf({2.0, 1.0}));
  EXPECT_NE(hashOf({0.0}), hashOf({-0.0}));
  EXPECT_NE(hashOf({0.0}), hashOf({0.0, 0.0}));
  Hash a, b;
  a.addBytes("ab"), b.addBytes(std::string_view("ab\0", 3));
  EXPECT_NE(a.value(), b.value());
}

TEST(Hash, IsTheFormulaOfItsHead) {
  Hash h;
  h.add(std::uint64_t{7});
  std::uint64_t expected = (14695981039346656037u ^ 7u) * 0x9e3779b97f4a7c15u;
  expected ^= expected >> 32u;
  EXPECT_EQ(h.value(), expected);
}

}  // namespace
}  // namespace dynamy
