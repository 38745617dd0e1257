// The table of pairs: one kernel for two kinds, in any order, in space and in a plane.
#include <gtest/gtest.h>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy_elements/contacts/kernels/given_pair.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>

namespace dynamy {
namespace {

using Kind = TouchingShape::Kind;
using enum PairTable::Room;

ContactPoint nothing(const PosedPair&) { return {}; }
using Nothing = OneContact<nothing>;

TouchingShape shape(Kind kind, double size = 0.1) {
  TouchingShape s;
  s.kind = kind, s.bound = s.thickness = size;
  s.features.emplace_back();
  return s;
}

TEST(PairTable, FindsAKernelInTheRoomItIsMadeFor) {
  PairTable table;
  table.add(std::make_unique<Nothing>(), {space}, {{Kind::ball, Kind::cylinder}});
  const TouchingShape ball = shape(Kind::ball), cylinder = shape(Kind::cylinder);
  EXPECT_NE(table.find(cylinder, ball, space), nullptr);
  EXPECT_EQ(table.find(cylinder, ball, plane), nullptr);
  EXPECT_EQ(table.find(cylinder, cylinder, space), nullptr);
}

TEST(PairTable, RefusesASecondKernelOfTheSamePair) {
  PairTable table;
  table.add(std::make_unique<Nothing>(), {space}, {{Kind::ball, Kind::cylinder}});
  EXPECT_THROW(table.add(std::make_unique<Nothing>(), {space}, {{Kind::cylinder, Kind::ball}}),
               ModelError);
}

TEST(PairTable, HasNoKernelForShapesThatWouldPassThroughEachOther) {
  PairTable table;
  addStandardPairs(table);
  const TouchingShape line = shape(Kind::capsule, 0.0), rod = shape(Kind::capsule);
  EXPECT_NE(table.find(rod, line, space), nullptr);
  EXPECT_EQ(table.find(line, line, space), nullptr);
}

TEST(PairTable, KnowsWhichGapsCostMost) {
  // Two boxes take 0.3 µs, a rim on a capsule 9 and two rims 25 (bench_gaps): budgets of work count
  // them as such.
  PairTable table;
  addStandardPairs(table);
  const auto work = [&](Kind a, Kind b) {
    const TouchingShape A = shape(a), B = shape(b);
    return table.find(A, B, space)->work(A, B);
  };
  EXPECT_EQ(work(Kind::box, Kind::box), kGapWork);
  EXPECT_GT(work(Kind::cylinder, Kind::capsule), 5.0 * kGapWork);
  EXPECT_GT(work(Kind::cylinder, Kind::cylinder), 2.0 * work(Kind::cylinder, Kind::capsule));
  EXPECT_GT(work(Kind::smooth, Kind::smooth), kDearWork);
}

TEST(PairTable, KnowsThatHalfSpacesAndPointsNeverTouch) {
  EXPECT_TRUE(PairTable::neverTouch(shape(Kind::halfSpace), shape(Kind::halfSpace)));
  EXPECT_TRUE(PairTable::neverTouch(shape(Kind::ball, 0.0), shape(Kind::ball, 0.0)));
  EXPECT_FALSE(PairTable::neverTouch(shape(Kind::ball), shape(Kind::ball, 0.0)));
}

TEST(PairTable, TellsFamiliesOfPluginsApart) {
  const auto touch = [](const ShapeAt&, const ShapeAt&, int) { return PairContact{}; };
  const ShapeFamily one{"One", {{&ShapeFamily::ball, touch}}},
      two{"Two", {{&one, touch}, {&ShapeFamily::halfSpace, touch}}};
  PairTable table;
  addStandardPairs(table);
  addFamily(table, one), addFamily(table, two);
  TouchingShape a = shape(Kind::own), b = shape(Kind::own);
  a.family = &one, b.family = &two;
  const TouchingShape ball = shape(Kind::ball), ground = shape(Kind::halfSpace);
  EXPECT_NE(table.find(a, ball, space), nullptr);
  EXPECT_EQ(table.find(b, ball, space), nullptr);
  EXPECT_EQ(table.find(ground, a, space), nullptr);
  EXPECT_NE(table.find(ground, b, space), nullptr);
  EXPECT_EQ(table.find(a, b, space), table.find(b, a, space));
  EXPECT_NE(table.find(a, b, space), nullptr);
  EXPECT_EQ(table.find(a, a, space), nullptr);
  EXPECT_THROW(addFamily(table, two), ModelError);
}

}  // namespace
}  // namespace dynamy
