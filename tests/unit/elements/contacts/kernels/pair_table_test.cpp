// The table of pairs: one kernel for two kinds, in any order, in space and in a plane.
#include <gtest/gtest.h>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy_elements/contacts/kernels/given_pair.hpp>
#include <dynamy_elements/contacts/kernels/one_contact.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;
using enum PairTable::Room;

ContactPoint nothing(const PosedPair&) { return {}; }
using Nothing = OneContact<nothing>;

TouchingShape shape(Touch kind, double size = 0.1) {
  TouchingShape s;
  s.kind = kind, s.bound = s.thickness = size;
  s.features.emplace_back();
  return s;
}

TEST(PairTable, FindsAKernelInTheRoomItIsMadeFor) {
  PairTable table;
  table.add(std::make_unique<Nothing>(), {space}, {{Touch::ball, Touch::cylinder}});
  const TouchingShape ball = shape(Touch::ball), cylinder = shape(Touch::cylinder);
  EXPECT_NE(table.find(cylinder, ball, space), nullptr);
  EXPECT_EQ(table.find(cylinder, ball, plane), nullptr);
  EXPECT_EQ(table.find(cylinder, cylinder, space), nullptr);
}

TEST(PairTable, RefusesASecondKernelOfTheSamePair) {
  PairTable table;
  table.add(std::make_unique<Nothing>(), {space}, {{Touch::ball, Touch::cylinder}});
  EXPECT_THROW(table.add(std::make_unique<Nothing>(), {space}, {{Touch::cylinder, Touch::ball}}),
               ModelError);
}

TEST(PairTable, HasNoKernelForShapesThatWouldPassThroughEachOther) {
  PairTable table;
  addStandardPairs(table);
  const TouchingShape line = shape(Touch::capsule, 0.0), rod = shape(Touch::capsule);
  EXPECT_NE(table.find(rod, line, space), nullptr);
  EXPECT_EQ(table.find(line, line, space), nullptr);
}

TEST(PairTable, KnowsWhichGapsCostMost) {
  // Two boxes take 0.3 µs, a rim on a capsule 9 and two rims 25 (bench_gaps): budgets of work count
  // them as such.
  PairTable table;
  addStandardPairs(table);
  const auto work = [&](Touch a, Touch b) {
    const TouchingShape A = shape(a), B = shape(b);
    return table.find(A, B, space)->work(A, B);
  };
  EXPECT_EQ(work(Touch::box, Touch::box), kGapWork);
  EXPECT_GT(work(Touch::cylinder, Touch::capsule), 5.0 * kGapWork);
  EXPECT_GT(work(Touch::cylinder, Touch::cylinder), 2.0 * work(Touch::cylinder, Touch::capsule));
  EXPECT_GT(work(Touch::smooth, Touch::smooth), kDearWork);
}

TEST(PairTable, KnowsThatHalfSpacesAndPointsNeverTouch) {
  EXPECT_TRUE(PairTable::neverTouch(shape(Touch::halfSpace), shape(Touch::halfSpace)));
  EXPECT_TRUE(PairTable::neverTouch(shape(Touch::ball, 0.0), shape(Touch::ball, 0.0)));
  EXPECT_FALSE(PairTable::neverTouch(shape(Touch::ball), shape(Touch::ball, 0.0)));
}

TEST(PairTable, TellsFamiliesOfPluginsApart) {
  const auto touch = [](const ShapeAt&, const ShapeAt&, int) { return PairContact{}; };
  const ShapeFamily one{"One", {{&ShapeFamily::ball, touch}}},
      two{"Two", {{&one, touch}, {&ShapeFamily::halfSpace, touch}}};
  PairTable table;
  addStandardPairs(table);
  addFamily(table, one), addFamily(table, two);
  TouchingShape a = shape(Touch::own), b = shape(Touch::own);
  a.family = &one, b.family = &two;
  const TouchingShape ball = shape(Touch::ball), ground = shape(Touch::halfSpace);
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
