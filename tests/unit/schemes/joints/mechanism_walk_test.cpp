// The order of bodies and joints, on a chain and a free body.
#include <gtest/gtest.h>

#include <dynamy/schemes/joints/mechanism_walk.hpp>

namespace dynamy {
namespace {

/// Blocks 0 … 3; joint 0 connects blocks 0 and 2, joint 1 blocks 2 and 3; block 1 is free.
MechanismWalk walkedChain() {
  const std::vector<std::vector<int>> near{{4, 2}, {}, {4, 5, 0, 3}, {5, 2}, {0, 2}, {2, 3}};
  MechanismWalk walk;
  walk.order(near, {6, 6, 3, 6}, {3, 5});
  return walk;
}

TEST(MechanismWalk, PutsWhatIsCoupledSideBySide) {
  const MechanismWalk walk = walkedChain();
  EXPECT_EQ(walk.unknowns(), 6 + 6 + 3 + 6 + 3 + 5);
  ASSERT_EQ(walk.ends().size(), 2u);
  EXPECT_EQ(walk.ends().back(), walk.unknowns());
  EXPECT_EQ(walk.partOfBlock(0), walk.partOfBlock(2));
  EXPECT_EQ(walk.partOfBlock(0), walk.partOfBlock(3));
  EXPECT_NE(walk.partOfBlock(0), walk.partOfBlock(1));
  // The free body alone has 6 unknowns, and each unknown stands in its part.
  const MechanismWalk::Part& free = walk.part(walk.partOfBlock(1));
  EXPECT_EQ(free.last - free.first, 6);
  EXPECT_EQ(walk.block(1), free.first);
  const MechanismWalk::Part& mechanism = walk.part(walk.partOfBlock(0));
  for (const int first :
       {walk.block(0), walk.block(2), walk.block(3), walk.joint(0), walk.joint(1)})
    EXPECT_TRUE(mechanism.first <= first && first < mechanism.last);
}

TEST(MechanismWalk, BandReachesFromEachNodeToItsNeighbours) {
  const MechanismWalk walk = walkedChain();
  EXPECT_GE(walk.band(), 6 - 1);  // within a body
  EXPECT_LT(walk.band(),
            walk.part(walk.partOfBlock(0)).last - walk.part(walk.partOfBlock(0)).first);
}

}  // namespace
}  // namespace dynamy
