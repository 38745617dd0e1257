// Sets on a displacement x, before and at x = 0.
#include <gtest/gtest.h>

#include <dynamy/located/switching/notches.hpp>

#include "unit/located/switching/sledge_event.hpp"

namespace dynamy {
namespace {

using fixture::SledgeEvent, fixture::SledgeScene;

/// A spring preloaded by 3 N in both directions.
class Preloaded final : public SetValuedForceLaw {
 public:
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  void prox(const LawInput&, const double*, const double*, double*) const override {}
  Status status(const LawInput&, const double*) const override { return Status::locked; }
  bool notched(const LawInput&, NotchedForce& out) const override {
    out = {.below = 3.0, .above = -3.0};
    return true;
  }
};

/// One contact with this law at x.
struct Notch {
  explicit Notch(double x) : s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(0.0), 0.0), e(s) {
    c.key = {contactKey(0, 0)}, c.law = {&law}, c.row0 = {0, 1}, c.position = {x};
  }
  double side(double gamma) const { return notchSide(c, 0, &gamma, e.at); }
  Preloaded law;
  SledgeScene s;
  SledgeEvent e;
  ContactSet c;
};

TEST(Notches, HaveTheSideOfTheDisplacementElseOfTheVelocity) {
  EXPECT_TRUE(notched(Notch(0.0).c, 0));
  EXPECT_EQ(Notch(1e-3).side(-2.0), 1.0);
  EXPECT_EQ(Notch(-1e-3).side(2.0), -1.0);
  EXPECT_EQ(Notch(0.0).side(2.0), 1.0);
  EXPECT_EQ(Notch(0.0).side(-2.0), -1.0);
  EXPECT_EQ(Notch(0.0).side(0.0), 0.0);
}

TEST(Notches, RestAtExactlyZero) {
  Notch near(1e-13), far(1e-6), passing(1e-13);
  restInNotches(near.c, Eigen::VectorXd::Zero(1), near.e.at);
  restInNotches(far.c, Eigen::VectorXd::Zero(1), far.e.at);
  restInNotches(passing.c, Eigen::VectorXd::Ones(1), passing.e.at);
  EXPECT_EQ(near.c.position[0], 0.0);
  EXPECT_EQ(far.c.position[0], 1e-6);
  EXPECT_EQ(passing.c.position[0], 1e-13);
}

}  // namespace
}  // namespace dynamy
