#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/step/missing_bias.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using fixture::Sledge;

/// As the floor of a sledge, but its normal turns by rounding from place to place.
class RoughFloor final : public NonSmoothElement {
 public:
  /// `shapes`: its contact is one of two shapes.
  RoughFloor(const SetValuedForceLaw& law, double bias, bool shapes)
      : law_(law), bias_(bias), shapes_(shapes) {}
  bool framesOf(std::uint64_t, std::vector<FrameHandle>&) const override { return shapes_; }
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    auto rows = sink.add(0, k.q(system_)[1], law_, 2);
    if (!rows) return;
    Block W = rows.segment(BlockPlace{0, 0, 2});
    W(0, 0) = 1e-16 * std::sin(1e15 * k.q(system_)[0]), W(0, 1) = 1.0;
    W(1, 0) = 1.0;
    if (rows.wantsBias()) rows.bias(0) = bias_;
  }

 private:
  const SetValuedForceLaw& law_;
  double bias_;
  bool shapes_;
  SystemHandle system_;
};

/// Whether a sledge at 64 m/s that an engine drives with 1e9 m/s², held to the floor, is told that
/// the floor's `bias` is wrong. The engine makes the differences short: some 1e-9 s.
MissingBias::Verdict verdictOn(double bias, bool shapes, std::string& why) {
  Sledge sledge({0.3, 0.0}, {64.0, 0.0},
                [](double, ConstVec, ConstVec) { return Eigen::Vector2d(1e9, 0.0); });
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  RoughFloor floor(law, bias, shapes);
  Topology topology({&sledge});
  floor.connect(topology);
  NewtonImpact impact;
  SystemParts parts;
  parts.topology = &topology, parts.contacts = {&floor}, parts.impactLaw = &impact;
  MechanicalSystem s(parts, 2);
  PhasePoint p;
  sledge.initialState({(p.x.q = Eigen::VectorXd(2)).data(), 2},
                      {(p.x.u = Eigen::VectorXd(2)).data(), 2});
  p.a = Eigen::Vector2d(1e9, 0.0);
  const std::vector<ContactKey> held{contactKey(0, 0)};
  PhaseRequest phase;
  phase.keys = held;
  s.evaluate(p.x, phase.holding(held, 0));
  ErrorNorm norm;
  const double time = 1.0;
  norm.resume(s, 1e-6, 1.0, time, {&time, 1});
  MissingBias missing;
  missing.use(norm);
  const MissingBias::Verdict verdict = missing.check(s, p, norm, phase);
  why = missing.why();
  return verdict;
}

TEST(MissingBias, RoundingOfAFastContactIsNoWrongBias) {
  // γ of the normal row is 64e-16 m/s of rounding, its difference over 1e-9 s up to 1e-5 m/s²: more
  // than the 1e-12 L/T² that count as zero. The bias of 1e-30 only says that one is told.
  std::string why;
  EXPECT_EQ(verdictOn(1e-30, false, why), MissingBias::Verdict::right);
}

TEST(MissingBias, AWrongBiasIsTold) {
  // 1e-6 of the engine's acceleration; the difference is good to 1e-8 of it.
  std::string why;
  EXPECT_EQ(verdictOn(1e3, false, why), MissingBias::Verdict::wrong);
  EXPECT_NE(why.find("tells a wrong bias of its row 0: with it γ changes by "), std::string::npos)
      << why;
}

TEST(MissingBias, ShapesMayHaveAKinkThere) {
  std::string why;
  EXPECT_EQ(verdictOn(1e3, true, why), MissingBias::Verdict::kinked);
  EXPECT_NE(why.find("has a kink, or its shapes tell a wrong bias of its row 0"), std::string::npos)
      << why;
}

}  // namespace
}  // namespace dynamy
