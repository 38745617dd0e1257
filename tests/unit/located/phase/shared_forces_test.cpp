// Forces of redundant rows: a sledge of 1 kg on two equal contacts.
#include <gtest/gtest.h>

#include <dynamy/located/phase/held_forces.hpp>
#include <dynamy/located/phase/shared_forces.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using fixture::kSledgeG, fixture::SledgeScene;

/// Newton's method ends at a decrement of 1e-9: the square root of it, times forces of size 10.
constexpr double kCentred = 1e-3;

/// Two contacts, the first of which carries everything; both stick, or both slip to the right.
struct Shared {
  explicit Shared(double pull, bool slips = false)
      : s({0.0, 0.0}, {slips ? 1.0 : 0.0, 0.0}, SledgeScene::pull(pull), 0.5, 0.0, 2) {
    for (int i = 0; i < 2; ++i) {
      Held h;
      h.key = s.key(i), h.slips = slips, h.sign = slips ? 1.0 : 0.0;
      held.push_back(h);
    }
    const Evaluation& e = s.evaluate(s.x);
    EXPECT_TRUE(rows.read(held, e, s.x.u, fault) && rows.readSets(held, e, fault)) << fault.why;
    forces.solve(held, rows, e, rows.present());
    shared.open(held, rows, forces.open());
    const double tangent = slips ? -0.5 * kSledgeG : -pull;
    lambda = Eigen::Vector4d(kSledgeG, tangent, 0.0, 0.0);
    found = shared.centre(held, rows, lambda);
  }
  SledgeScene s;
  std::vector<Held> held;
  HeldRows rows;
  PhaseFault fault;
  HeldForces forces;
  SharedForces shared;
  Eigen::VectorXd lambda;
  bool found = false;
};

TEST(SharedForces, OpenForcesChangeNoHeldRow) {
  const Shared stick(3.0), slip(3.0, true);
  const Eigen::MatrixXd N = stick.forces.open();
  EXPECT_EQ(N.cols(), 2);
  EXPECT_NEAR((stick.rows.W() * N).norm(), 0.0, 1e-14);  // of size 1, from an orthogonal basis
  EXPECT_EQ(slip.forces.open().cols(), 1);
}

TEST(SharedForces, TheCentreIsTheSameForEqualContacts) {
  const Shared stick(3.0), slip(3.0, true);
  ASSERT_TRUE(stick.found);
  EXPECT_NEAR((stick.lambda - Eigen::Vector4d(5.0, -1.5, 5.0, -1.5)).norm(), 0.0, kCentred);
  ASSERT_TRUE(slip.found);
  EXPECT_NEAR((slip.lambda - Eigen::Vector4d(5.0, -2.5, 5.0, -2.5)).norm(), 0.0, kCentred);
}

TEST(SharedForces, AreWithinTheirBoundsUpToTheLast) {
  // Friction holds up to 5 N.
  const Shared held(4.9999);
  ASSERT_TRUE(held.found);
  for (const int i : {0, 2}) EXPECT_LT(std::abs(held.lambda[i + 1]), 0.5 * held.lambda[i]);
  EXPECT_FALSE(Shared(5.0001).found);
}

}  // namespace
}  // namespace dynamy
