// Names of frames, of systems with one body and with several.
#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/frame_names.hpp>

namespace dynamy {
namespace {

class Framed final : public PartialMechanicalSystem {
 public:
  explicit Framed(const std::string& name)
      : PartialMechanicalSystem(Parameters::of<Framed>("Framed", name, {})) {}
  static void declare(Attributes&) {}
  Blocks blocks() const override { return {.nq = 1, .nu = 1}; }
  void initialState(Vec, Vec) const override {}
  void M(double, ConstVec, MassBlocks) const override {}
  void h(double, ConstVec, ConstVec, Vec) const override {}
  int frames() const override { return 4; }
};

struct Named {
  Named() {
    Description one, several;
    one.frame("tip", 2);
    names.add(ball, one);
    several.body({.name = "upper", .frame = 0, .frames = 2, .place = {}});
    several.body({.name = "lower", .frame = 2, .frames = 2, .place = {}});
    several.frame("end", 3);
    names.add(tree, several);
  }
  std::pair<int, int> find(const std::string& name) { return names.find(name, known); }
  Framed ball{"ball"}, tree{"tree"};
  FrameNames names{JointList()};
  std::vector<std::string> known;
};

TEST(FrameNames, FindsFramesOfBodies) {
  Named s;
  EXPECT_EQ(s.find("ball"), std::pair(0, 0));
  EXPECT_EQ(s.find("ball.tip"), std::pair(0, 2));
  EXPECT_EQ(s.find("lower"), std::pair(1, 2));
  EXPECT_EQ(s.find("lower.end"), std::pair(1, 3));
}

TEST(FrameNames, ListsAllNamesIfNoneFits) {
  Named s;
  EXPECT_EQ(s.find("tree"), std::pair(-1, -1));  // its bodies have names
  EXPECT_EQ(s.known, (std::vector<std::string>{"ball", "ball.tip", "upper", "lower", "lower.end"}));
}

TEST(FrameNames, KnowsTheBodyOfAFrame) {
  const Named s;
  EXPECT_EQ(s.names.body(0, 2), nullptr);
  EXPECT_EQ(s.names.body(1, 1)->name, "upper");
  EXPECT_EQ(s.names.body(1, 3)->name, "lower");
}

}  // namespace
}  // namespace dynamy
