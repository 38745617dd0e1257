#include <gtest/gtest.h>

#include <cmath>
#include <dynamy_elements/contacts/search/first_below.hpp>

namespace dynamy {
namespace {

/// Counts how often a gap is asked for.
template <class G>
struct Counted {
  G g;
  int count = 0;
  double operator()(double s) {
    ++count;
    return g(s);
  }
};

template <class G>
FirstBelow::Place search(const FirstBelow& in, Counted<G>& gap) {
  return in.in(gap, 0.0, gap(0.0), 1.0, gap(1.0));
}

TEST(FirstBelow, FindsTheFirstOfTwoPlaces) {
  // Two valleys, at 0.3 and 0.8, both 0.01 deep; |g'| ≤ 6π/2 < 10.
  Counted gap{[](double s) { return 0.49 + 0.5 * std::cos(4.0 * M_PI * (s - 0.05)); }};
  const FirstBelow in{0.0, 10.0, 1.0 / 64.0, 1e-9};
  const FirstBelow::Place place = search(in, gap);
  ASSERT_TRUE(place);
  EXPECT_LT(gap(place.at), 0.0);
  EXPECT_NEAR(place.at, 0.3, 0.05);
  EXPECT_LE(place.from, place.at);
  EXPECT_GE(place.value, 0.0);
}

TEST(FirstBelow, TellsAGrazeFromAMissByTheLimit) {
  // The nearest place of a flight past a point, s = 0.4321: g there is known exactly.
  const auto flight = [](double least) {
    return Counted{[least](double s) { return std::hypot(1.0, 3.0 * (s - 0.4321)) - 1.0 + least; }};
  };
  const FirstBelow in{-1e-6, 3.0, 1.0, 1e-8};
  auto hit = flight(-1.1e-6), miss = flight(-0.9e-6);
  EXPECT_NEAR(search(in, hit).at, 0.4321, 1e-3);
  EXPECT_FALSE(search(in, miss));
}

TEST(FirstBelow, AsksOnceWhereNothingIsNear) {
  Counted gap{[](double s) { return 5.0 + std::sin(40.0 * s); }};
  EXPECT_FALSE(search({-1e-6, 8.0, 1.0 / 64.0, 1e-8}, gap));
  EXPECT_EQ(gap.count, 2);
}

TEST(FirstBelow, LooksCloselyOnlyAtTheNearPart) {
  // Near the limit in the middle alone: most of the 65 places between parts are never looked at.
  Counted gap{[](double s) { return std::abs(s - 0.5) * 4.0 + 1e-3; }};
  EXPECT_FALSE(search({-1e-6, 5.0, 1.0 / 64.0, 1e-8}, gap));
  EXPECT_LE(gap.count, 24);
}

TEST(FirstBelow, EndsAtOnceWhereAContactSlides) {
  // A gap of rounding all along the way: Lipschitz' bound never decides it, two secants do.
  Counted gap{[](double s) { return 1e-12 * s; }};
  EXPECT_FALSE(search({-1e-6, 4.0, 1.0, 1e-8}, gap));
  EXPECT_LE(gap.count, 4);
}

}  // namespace
}  // namespace dynamy
