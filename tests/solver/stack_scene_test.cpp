// A tower of boxes as a simulated scene: problems above the dense form, step after step. Boxes turn
// by small angles only, so that gaps are linear in q and the truth is plain statics.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/solver/automatic.hpp>
#include <support/contact_problems.hpp>
#include <support/gravity.hpp>

namespace dynamy {
namespace {

/// Unit cube, q = (displacement, small rotation), u = q̇.
class Cube final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a) {
    a.optional("mass", Unit::mass, 1.0, "mass");
    a.optional("pull", Unit::none, 0.0, "part of the weight along x, in turns of 1 s");
  }
  explicit Cube(const Parameters& x)
      : PartialMechanicalSystem(x), mass_(x["mass"]), pull_(x["pull"]) {}
  Blocks blocks() const override { return {6, 6, 1, true}; }
  void initialState(Vec q, Vec u) const override { q.setZero(), u.setZero(); }
  void M(double, ConstVec, MassBlocks M) const override {
    M[0].setZero();
    M[0].diagonal() << mass_, mass_, mass_, mass_ / 6.0, mass_ / 6.0, mass_ / 6.0;
  }
  void h(double t, ConstVec, ConstVec, Vec h) const override {
    h.setZero();
    h[0] = pull_ * mass_ * kG * std::sin(2.0 * std::acos(-1.0) * t);
    h[2] = -mass_ * kG;
  }
  void describe(Description& d) const override { d.coordinate("x", Unit::length, 0); }

 private:
  double mass_, pull_;
};

/// Four contacts between every two boxes, and between the lowest and the ground.
class Faces final : public NonSmoothElement {
 public:
  Faces(int boxes, double mu, double groundMu)
      : boxes_(boxes), law_(0.0, 0.0, mu), groundLaw_(0.0, 0.0, groundMu) {}
  void connect(Topology& topology) override {
    for (int b = 0; b < boxes_; ++b) boxes0_.push_back(topology.system(b));
  }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    for (int b = 0; b < boxes_; ++b)
      for (int c = 0; c < 4; ++c) {
        const double x = (c & 1) ? 0.5 : -0.5, y = (c & 2) ? 0.5 : -0.5;
        const auto upper = contactRows({x, y, -0.5}, 1.0), lower = contactRows({x, y, 0.5}, -1.0);
        const SystemHandle& on = boxes0_[static_cast<std::size_t>(b)];
        double g = upper.row(0).dot(k.q(on));
        if (b > 0) g += lower.row(0).dot(k.q(boxes0_[static_cast<std::size_t>(b - 1)]));
        auto rows =
            sink.add(static_cast<std::uint64_t>(4 * b + c), g, b > 0 ? law_ : groundLaw_, 3);
        if (!rows) continue;
        rows.segment(on) = upper;
        if (b == 0) continue;
        const SystemHandle& by = boxes0_[static_cast<std::size_t>(b - 1)];
        rows.segment(by) = lower;
      }
  }

 private:
  int boxes_;
  UnilateralCoulomb law_, groundLaw_;
  std::vector<SystemHandle> boxes0_;
};

struct Tower {
  Tower(int boxes, double ratio, double mu, double groundMu, double pull, double until) {
    for (int b = 0; b < boxes; ++b)
      model.add<Cube>(
          "box" + std::to_string(b),
          {{"mass", std::pow(ratio, static_cast<double>(b) / (boxes - 1))}, {"pull", pull}});
    model.add(std::make_unique<Faces>(boxes, mu, groundMu));
    model.add(std::make_unique<MoreauMidpoint>());
    AutomaticOptions options;
    options.tolerance = 1e-9;
    model.add(std::make_unique<Automatic>(options));
    model.simulation.gTol = 1e-11;  // contacts that rounding would open stay closed
    model.simulation.until = until, model.simulation.step = 1e-3;
    model.build();
  }
  Model model;
};

TEST(StackScene, ATowerOfTenBoxesStandsWhileItIsPulledToAndFro) {
  for (const double ratio : {1.0, 1e4}) {
    Tower tower(10, ratio, 0.5, 0.5, 0.05, 1.0);
    Simulation simulation(tower.model);
    const RunReport& r = simulation.run();
    EXPECT_EQ(r.ended, RunReport::Ended::finished);
    EXPECT_EQ(r.contacts.most, 40);
    EXPECT_EQ(r.solver.unconverged, 0) << r.solver.unsolved.tried << r.solver.unsolved.findings;
    // Velocities of at most tolerance · g Δt in every step: 1 s · 1e-9 · 9.81e-3, for ten boxes on
    // top of each other.
    EXPECT_LT(simulation.state().q.lpNorm<Eigen::Infinity>(), 1e-10) << ratio;
    std::printf("tower of 10, masses 1:%g: %.3g iterations a step, at most %d\n", ratio,
                r.solver.iterationsMean(), r.solver.iterationsMax);
  }
}

TEST(StackScene, ATowerOnSlipperyGroundMovesAsOneBlock) {
  // 0.08 g sin 2πt against μ = 0.05 at the ground: sticks until t0 = asin(5/8)/2π, then
  //   x = ∫∫ g (0.08 sin 2πτ − 0.05),  v(t) = g (0.08 (cos ωt0 − cos ωt)/ω − 0.05 (t − t0)).
  // It would tip above 0.1 g.
  const double omega = 2.0 * std::acos(-1.0), t0 = std::asin(0.05 / 0.08) / omega, t = 0.3;
  Tower tower(10, 1.0, 0.5, 0.05, 0.08, t);
  Simulation simulation(tower.model);
  const RunReport& r = simulation.run();
  EXPECT_EQ(r.solver.unconverged, 0) << r.solver.unsolved.tried << r.solver.unsolved.findings;
  const double x = kG * (0.08 / omega *
                             (std::cos(omega * t0) * (t - t0) -
                              (std::sin(omega * t) - std::sin(omega * t0)) / omega) -
                         0.025 * (t - t0) * (t - t0));
  for (int b = 0; b < 10; ++b) {
    // The step in which sliding begins is off by g · 0.05 Δt²/2 of velocity at most, times 0.2 s.
    EXPECT_NEAR(simulation.state().q[6 * b], x, 2e-7) << b;
    EXPECT_NEAR(simulation.state().q[6 * b + 2], 0.0, 1e-10) << b;
  }
}

}  // namespace
}  // namespace dynamy
