// Stages of a step: problem, scales, warm start.
#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/stages/bias_differences.hpp>
#include <limits>
#include <support/gravity.hpp>

#include "unit/stages/stage_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::VectorXd;
using fixture::Pair;
using fixture::Scene;

const InclusionProblem& pose(Scene& s, double dt) {
  s.system->evaluate(s.x);
  return s.system->impactProblem(s.x, dt);
}

/// n masses at rest on each other, the lowest on the ground; contact id = index.
Scene restingStack(int n, double extra = 0.0) {
  VectorXd m = VectorXd::Ones(n), zero = VectorXd::Zero(n), u = zero;
  std::vector<Pair> pairs;
  for (int k = 0; k < n; ++k) pairs.push_back({static_cast<std::uint64_t>(k), k, k - 1});
  if (extra != 0.0) {
    m.conservativeResizeLike(VectorXd::Ones(n + 1));
    zero.conservativeResizeLike(VectorXd::Zero(n + 1));
    u = zero, u[n] = extra;
    pairs.push_back({static_cast<std::uint64_t>(n), n, -1});
  }
  return Scene(m, zero, u, pairs);
}

/// Friction whose size an element varies: it becomes hot, or wet.
class WetFriction final : public UnilateralCoulomb {
 public:
  using UnilateralCoulomb::UnilateralCoulomb;
  bool scales() const override { return true; }
};

/// A contact that also pulls, with up to 10 N times the scale that an element gives:
/// C = [−10 s Δt, ∞).
class Sticky final : public SetValuedForceLaw {
 public:
  int dim(int) const override { return 1; }
  bool unilateral() const override { return true; }
  bool scales() const override { return true; }
  RowKind rowKind(int) const override { return RowKind::normal; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    Lambda[0] = std::max(Lambda[0] - r[0] * xi[0], -10.0 * in.scale * in.dt);
  }
  Status status(const LawInput&, const double*) const override { return Status::locked; }
};

/// The lowest mass over the ground, half as rough or as sticky as its law says.
class Varied final : public NonSmoothElement {
 public:
  explicit Varied(const SetValuedForceLaw& law) : law_(law) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    auto rows = sink.add(0, k.q(system_)[0], law_, 2);
    if (!rows) return;
    rows.segment(BlockPlace{0, 0, 1})(0, 0) = 1.0;
    rows.scale(0.5);
  }

 private:
  const SetValuedForceLaw& law_;
  SystemHandle system_;
};

/// Scale of a contact that closes within the step.
double scaleAhead(const SetValuedForceLaw& law) {
  const VectorXd one = VectorXd::Ones(1), q = 0.01 * one, u = -3.0 * one;
  fixture::Masses masses(one, q, u, fixture::Masses::weight(one));
  Varied contact(law);
  Topology topology({&masses});
  contact.connect(topology);
  NewtonImpact impact;
  SystemParts parts;
  parts.topology = &topology, parts.contacts = {&contact}, parts.impactLaw = &impact;
  MechanicalSystem system(parts);
  system.gTol(1e-12);
  State x;
  x.q = q, x.u = u;
  const ContactSet& c = system.evaluate(x, {.ahead = 0.1}).contacts;
  return c.size() == 1 ? c.scale[0] : -1.0;
}

TEST(MechanicalSystem, AnOpenContactInReachPullsNotButHasItsFriction) {
  EXPECT_EQ(scaleAhead(Sticky()), 0.0);
  EXPECT_EQ(scaleAhead(WetFriction(0.0, 0.0, 0.5)), 0.5);
}

/// Point on a circle of radius 1 without its bias; behind x = `edge` there is a second contact.
class Bead final : public NonSmoothElement {
 public:
  explicit Bead(double edge) : edge_(edge) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    const ConstVec q = k.q(system_);
    for (int id = 0; id < (q[0] > edge_ ? 2 : 1); ++id)
      if (auto rows = sink.add(static_cast<std::uint64_t>(id), 0.0, law_, 1)) {
        rows.segment(BlockPlace{0, 0, 1})(0, 0) = q[0] / q.norm();
        rows.segment(BlockPlace{1, 1, 1})(0, 0) = q[1] / q.norm();
      }
  }

 private:
  double edge_;
  Unilateral law_{0.0};
  SystemHandle system_;
};

TEST(MechanicalSystem, DifferencesOfTheBiasAreShorterWhereAContactComes) {
  const VectorXd one = VectorXd::Ones(2), q{{0.0, 1.0}}, u{{3.0, 0.0}};
  fixture::Masses masses(one, q, u, fixture::Masses::weight(one));
  // The motion of 2 · 1e-3 s, over which differences are taken, goes 6 mm.
  for (const double edge : {1.0, 4e-3}) {
    Bead bead(edge);
    Topology topology({&masses});
    bead.connect(topology);
    NewtonImpact impact;
    SystemParts parts;
    parts.topology = &topology, parts.contacts = {&bead}, parts.impactLaw = &impact;
    MechanicalSystem system(parts);
    system.gTol(1e-12);
    const std::vector<int> untold = {0};
    const VectorXd scales = VectorXd::Constant(2, 100.0);
    BiasDifferences differences;
    differences.of(untold, scales, 1.0);
    State x;
    x.q = q, x.u = u;
    const ContactSet& c = system.evaluate(x, {.bias = true, .differences = &differences}).contacts;
    ASSERT_EQ(c.size(), 1);
    // γ = n·u = 9 s/√(1 + 9 s²); truncation d⁴ γ⁽⁵⁾/30 = 1.1e-9 with d = 1e-3 s.
    EXPECT_NEAR(c.bias[0], 9.0, 1e-8) << edge;
  }
}

TEST(MechanicalSystem, PosesTheFreeVelocity) {
  Scene s(VectorXd{{2.0}}, VectorXd{{0.0}}, VectorXd{{-3.0}}, {{0, 0, -1}});
  const InclusionProblem& p = pose(s, 0.1);
  EXPECT_EQ(p.gammaA[0], -3.0);
  EXPECT_NEAR(p.gammaFree[0], -3.0 - 0.1 * kG, 1e-15);
  EXPECT_NEAR(p.G->diagonalBlock(0)[0], 0.5, 1e-15);  // 1/√2 squared
}

TEST(MechanicalSystem, LeavesOpenContactsOutOfTheProblem) {
  Scene s(VectorXd{{2.0}}, VectorXd{{0.1}}, VectorXd{{-3.0}}, {{0, 0, -1}});
  EXPECT_EQ(pose(s, 0.1).rows(), 0);
  EXPECT_EQ(s.system->slot(0).contacts.g[0], 0.1);
}

TEST(MechanicalSystem, ScalesByWhatIsAskedOfContacts) {
  // At rest: g Δt. Landing: the closing velocity. Beside a mass that leaves at 100 m/s: as before.
  Scene rest = restingStack(3), leaving = restingStack(3, 100.0), landing = restingStack(3, -7.0);
  EXPECT_NEAR(pose(rest, 1e-3).uRef, kG * 1e-3, 1e-16);
  EXPECT_NEAR(pose(leaving, 1e-3).uRef, kG * 1e-3, 1e-16);
  EXPECT_NEAR(pose(landing, 1e-3).uRef, 7.0 + kG * 1e-3, 1e-14);
}

TEST(MechanicalSystem, SolvesARestingStackBesideAFastLeavingMassAccurately) {
  Scene s = restingStack(6, 100.0);
  const double dt = 1e-5;
  ASSERT_TRUE(s.step(dt).solved.ok());
  // E_u ≤ 1e-10 of g Δt; |G⁻¹| ≤ n² of mass 1.
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(s.x.impulses.Lambda[static_cast<std::size_t>(k)], (6 - k) * kG * dt,
                36e-10 * kG * dt);
}

TEST(MechanicalSystem, EndsAtOnceWhereOnlyRoundingIsAsked) {
  // No forces; velocities differ by rounding of 1 m/s.
  const double up = std::nextafter(1.0, 2.0);
  Scene s(VectorXd{{1.0, 1.0}}, VectorXd{{0.0, 0.0}}, VectorXd{{1.0, up}}, {{0, 0, 1}}, 0.0,
          [](double, ConstVec, ConstVec, Vec h) { h.setZero(); });
  s.x.impulses = {{contactKey(0, 0)}, {0, 1}, {5.0}, 1e-3};
  const StepReport report = s.step(1e-3);
  EXPECT_TRUE(report.solved.ok());
  EXPECT_EQ(report.contacts, 1);
  EXPECT_EQ(report.solved.iterations, 0);
  EXPECT_EQ(s.x.impulses.Lambda[0], 0.0);
}

TEST(MechanicalSystem, EndsAtOnceInASceneWithoutForcesAndMotion) {
  Scene s(VectorXd{{1.0, 1.0}}, VectorXd{{0.0, 0.0}}, VectorXd{{0.0, 0.0}}, {{0, 0, 1}, {1, 1, -1}},
          0.0, [](double, ConstVec, ConstVec, Vec h) { h.setZero(); });
  s.x.impulses = {{contactKey(0, 0), contactKey(0, 1)}, {0, 1, 2}, {5.0, 3.0}, 1e-3};
  const StepReport report = s.step(1e-3);
  EXPECT_TRUE(report.solved.ok());
  EXPECT_EQ(report.solved.iterations, 0);
  EXPECT_EQ(s.x.u.norm(), 0.0);
}

TEST(MechanicalSystem, DoesNotStallAtRoundingLevelHoweverSmallTheTolerance) {
  // A heavy mass on light ones: ξ of the lowest contact is a difference of numbers 1e4 times u_ref.
  const int n = 5;
  VectorXd m = VectorXd::Ones(n);
  m[n - 1] = 1e3;
  std::vector<Pair> pairs;
  for (int k = 0; k < n; ++k) pairs.push_back({static_cast<std::uint64_t>(k), k, k - 1});
  Scene s(m, VectorXd::Zero(n), VectorXd::Zero(n), pairs);
  ProxGaussSeidel solver(ProxOptions{1e-14, 1000000, Relaxation::exact, 1.0});
  const StepReport report = s.scheme.step(*s.system, solver, s.x, 1e-3);
  EXPECT_TRUE(report.solved.ok());
  // Errors below 4ε of |G||Λ| ~ 2·1e3·g Δt, times |G⁻¹| ≤ 1e3 n².
  EXPECT_NEAR(s.x.impulses.Lambda[0], (1e3 + n - 1) * kG * 1e-3, 1e-12 * 2e3 * kG * 25);
}

TEST(MechanicalSystem, StartsFromRememberedPercussionsByKeyInAnyOrder) {
  Scene s = restingStack(3);
  s.step(1e-3);
  const std::vector<double> before = s.x.impulses.Lambda;
  std::reverse(s.stack.pairs.begin(), s.stack.pairs.end());
  pose(s, 1e-3);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(s.system->problem().Lambda()[i], before[static_cast<std::size_t>(2 - i)]);
}

TEST(MechanicalSystem, ScalesTheStartWithTheStep) {
  Scene s = restingStack(2);
  s.step(1e-3);
  const double before = s.x.impulses.Lambda[0];
  pose(s, 5e-4);
  EXPECT_EQ(s.system->problem().Lambda()[0], 0.5 * before);
}

TEST(MechanicalSystem, StartsNewContactsFromZero) {
  Scene s = restingStack(3);
  s.step(1e-3);
  const double before = s.x.impulses.Lambda[1];
  s.stack.pairs = {{7, 0, -1}, {1, 1, 0}};
  pose(s, 1e-3);
  EXPECT_EQ(s.system->problem().Lambda()[0], 0.0);
  EXPECT_EQ(s.system->problem().Lambda()[1], before);
}

TEST(MechanicalSystem, NamesASystemWhoseMassIsNotPositiveDefinite) {
  Scene s(VectorXd{{1.0, -2.0}}, VectorXd{{0.0, 0.0}}, VectorXd{{0.0, 0.0}});
  s.system->evaluate(s.x);
  EXPECT_EQ(s.system->indefiniteMass(), 0);
}

TEST(MechanicalSystem, PushesOverlapsOutInTheTimeOfAWholeStep) {
  // A rough step, 0.1 m in the ground: γ_free = g/Δt, whatever the length of a part.
  Scene s(VectorXd::Ones(1), VectorXd::Constant(1, -0.1), VectorXd::Zero(1), {{0, 0, -1}});
  PositionAim aim;
  aim.dead = -std::numeric_limits<double>::infinity(), aim.cap = 100.0;  // of 10 m/s
  for (const double dt : {1e-9, 0.01, 0.1}) {
    s.system->limits.pushOut = 0.01;
    s.system->evaluate(s.x);
    const double gammaFree = s.system->impactProblem(s.x, dt, 0, &aim).gammaFree[0];
    EXPECT_NEAR(gammaFree, -0.1 / std::max(dt, 0.01) - kG * dt, 1e-12) << dt;
  }
}

}  // namespace
}  // namespace dynamy
