#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/core/number_archive.hpp>
#include <support/archived_numbers.hpp>

namespace dynamy {
namespace {

enum class Mode : std::uint8_t { first, second, third };

struct Part {
  int index = 0;
  double value = 0.0;
  void archive(NumberArchive& a) { a(index), a(value); }
  bool operator==(const Part&) const = default;
};

struct Values {
  double x = 0.0;
  bool flag = false;
  Mode mode = Mode::first;
  ContactKey key{};
  Eigen::VectorXd v;
  std::array<double, 2> pair{};
  std::vector<Part> parts;
  void archive(NumberArchive& a) {
    a(x), a(flag), a.choice(mode, 3), a(key), a(v), a(pair), a(parts);
  }
};

Values someValues() {
  Values out;
  out.x = 0.1, out.flag = true, out.mode = Mode::third;
  out.key = {(std::uint64_t{77} << 40) + 123456789012};
  out.v = Eigen::Vector3d(1.0, -0.0, 1e300), out.pair = {2.5, -1e-300};
  out.parts = {{-4, 0.25}, {1 << 30, 3.0}};
  return out;
}

TEST(NumberArchive, ReadsWhatItWrote) {
  const Values written = someValues();
  const Eigen::VectorXd numbers = numbersOf(written);
  Values read;
  NumberArchive a(numbers);
  a(read);
  EXPECT_TRUE(a.good());
  EXPECT_TRUE(a.atEnd());
  EXPECT_EQ(read.x, written.x);
  EXPECT_EQ(read.flag, written.flag);
  EXPECT_EQ(read.mode, written.mode);
  EXPECT_EQ(read.key.value, written.key.value);
  EXPECT_EQ(read.v, written.v);
  EXPECT_EQ(read.pair, written.pair);
  EXPECT_EQ(read.parts, written.parts);
}

TEST(NumberArchive, KeepsTheKeyThatMeansNone) {
  ContactKey key{~std::uint64_t{0}};
  NumberArchive write;
  write(key);
  Eigen::VectorXd numbers;
  write.copyTo(numbers);
  ContactKey read{};
  NumberArchive a(numbers);
  a(read);
  EXPECT_TRUE(a.good());
  EXPECT_EQ(read.value, key.value);
}

TEST(NumberArchive, NotesEveryNumberThatIsMissing) {
  const Eigen::VectorXd numbers = numbersOf(someValues());
  for (Eigen::Index n = 0; n < numbers.size(); ++n) {
    const Eigen::VectorXd cut = numbers.head(n);
    Values read;
    NumberArchive a(cut);
    a(read);
    EXPECT_FALSE(a.good()) << n;
  }
}

// Flag, enumerator, element and number of the key, three sizes and indices: each is a whole number
// in a range.
TEST(NumberArchive, NotesNumbersThatCannotHaveBeenWritten) {
  const Eigen::VectorXd numbers = numbersOf(someValues());
  for (const Eigen::Index i : {1, 2, 3, 4, 5, 11, 12})
    for (const double wrong : {0.5, -3e9, 1e17, std::nan("")}) {
      Eigen::VectorXd changed = numbers;
      changed[i] = wrong;
      Values read;
      NumberArchive a(changed);
      a(read);
      EXPECT_FALSE(a.good()) << i << ": " << wrong;
    }
}

}  // namespace
}  // namespace dynamy
