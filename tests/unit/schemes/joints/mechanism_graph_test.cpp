// Couplings of a chain of masses.
#include <gtest/gtest.h>

#include <dynamy/schemes/joints/joint_equations.hpp>

#include "unit/stages/linked_masses.hpp"

namespace dynamy {
namespace {

using Eigen::VectorXd;
using fixture::LinkedMasses;

/// Four masses in a row, with a rod between each and the next.
const MechanismGraph& graphOfAChain(JointEquations& equations, LinkedMasses& s) {
  EXPECT_TRUE(equations.begin(*s.system, s.x, 1e-2));
  return equations.graph();
}

LinkedMasses chainOfMasses() {
  return {VectorXd::Ones(4),
          VectorXd::LinSpaced(4, 3.0, 0.0),
          VectorXd::Zero(4),
          {{0, 1, 1.0}, {1, 2, 1.0}, {2, 3, 1.0}},
          {},
          0.0,
          [](double, ConstVec, ConstVec, Vec h) { h.setZero(); }};
}

TEST(MechanismGraph, CouplesTheBlocksOfAJoint) {
  LinkedMasses s = chainOfMasses();
  JointEquations equations;
  const MechanismGraph& graph = graphOfAChain(equations, s);
  EXPECT_EQ(graph.blocks(), 4);
  EXPECT_EQ(graph.rows(), 3);
  EXPECT_EQ(graph.nearBlocks(0), (std::vector<int>{0, 1}));
  EXPECT_EQ(graph.nearBlocks(2), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(graph.nearJoints(2), (std::vector<int>{1, 2}));
}

TEST(MechanismGraph, GivesBlocksWithACommonNeighbourDifferentColours) {
  LinkedMasses s = chainOfMasses();
  JointEquations equations;
  const MechanismGraph& graph = graphOfAChain(equations, s);
  EXPECT_EQ(graph.colours(), 3);
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) {
      const bool far = b - a > 2;  // the ends alone have no common neighbour
      EXPECT_EQ(graph.colour(a) == graph.colour(b), far) << a << ", " << b;
    }
}

}  // namespace
}  // namespace dynamy
