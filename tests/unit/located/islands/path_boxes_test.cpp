// Boxes of paths: they hold the shapes at all times, and paths meet where their shapes come near.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/islands/path_boxes.hpp>
#include <limits>
#include <string>
#include <utility>

namespace dynamy {
namespace {

/// A point with velocity u in space: q = r, u = v, one frame.
class Point final : public PartialMechanicalSystem {
 public:
  explicit Point(const std::string& name)
      : PartialMechanicalSystem(Parameters::of<Point>("Point", name, {})) {}
  static void declare(Attributes&) {}
  Blocks blocks() const override { return {.nq = 3, .nu = 3, .constantMass = true}; }
  void initialState(Vec, Vec) const override {}
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double, ConstVec, ConstVec, Vec) const override {}
  int frames() const override { return 1; }
  void frame(double, ConstVec q, ConstVec u, int, Frame& f) const override {
    f.r_OS_I = q, f.v_S_I = u;
  }
};

/// Two points with balls of 0.1 m about them.
struct TwoPaths {
  using State = Eigen::Matrix<double, 6, 1>;
  TwoPaths() {
    for (int i = 0; i < 2; ++i) frames[i] = topology.frame(topology.system(i), 0);
    for (int i = 0; i < 2; ++i) shapes[i] = {frames[i], i, Vec3::Zero(), 0.1};
    q.setZero(6), u.setZero(6);
  }
  void at(double t) { k.evaluate(topology, t, view(std::as_const(q)), view(std::as_const(u))); }
  std::span<const MovingShape> shape(int i) const { return {shapes + i, 1}; }
  Point a{"a"}, b{"b"};
  Topology topology{{&a, &b}};
  FrameHandle frames[2];
  MovingShape shapes[2];
  Eigen::VectorXd q, u;
  Kinematics k;
  PathBoxes paths[2];
};

TEST(PathBoxes, MeetInThePartInWhichTheirShapesComeNear) {
  TwoPaths s;
  // Towards each other with 1 m/s from 2 m: boxes of parts of 0.1 s, which are enlarged by a fifth of
  // the way in a part and the balls, meet in the part before the balls touch at 0.9 s or in this one.
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    s.q << t, 0.0, 0.0, 2.0 - t, 0.0, 0.0;
    s.u << 1.0, 0.0, 0.0, -1.0, 0.0, 0.0;
    s.at(t);
    for (int p = 0; p < 2; ++p) i == 0 ? s.paths[p].begin(s.shape(p), s.k) : s.paths[p].pass(s.k);
  }
  const double first = s.paths[0].meets(s.paths[1], 0.0);
  EXPECT_LE(first, 0.9);
  EXPECT_GE(first, 0.9 - 0.1 - 1e-12);
  EXPECT_TRUE(s.paths[0].meets(s.paths[1]));
  // From a later time on they meet at once as long as the balls overlap, up to 1.1 s.
  EXPECT_EQ(s.paths[0].meets(s.paths[1], 1.05), 1.05);
  EXPECT_EQ(s.paths[0].meets(s.paths[1], 1.35), std::numeric_limits<double>::infinity());
}

TEST(PathBoxes, HoldAThrow) {
  TwoPaths s;
  // A throw over the other ball, which rests at the apex of the throw, 0.25 m under it: the cubic of a part is the
  // parabola itself. It passes at 0.25 m, the balls reach 0.2 m.
  const double g = 10.0;
  const auto fly = [&](double t, double below) {
    s.q << t, 0.0, 5.0 * t - 0.5 * g * t * t, 0.5, 0.0, 1.25 - below;
    s.u << 1.0, 0.0, 5.0 - g * t, 0.0, 0.0, 0.0;
    s.at(t);
  };
  for (const double below : {0.25, 0.19}) {
    for (int i = 0; i <= 8; ++i) {
      fly(i / 8.0, below);
      for (int p = 0; p < 2; ++p) i == 0 ? s.paths[p].begin(s.shape(p), s.k) : s.paths[p].pass(s.k);
    }
    // The box of an eighth is 0.08 m high at the apex: below 0.25 m it must meet at 0.19 m.
    if (below < 0.2) {
      EXPECT_LE(s.paths[0].meets(s.paths[1], 0.0), 0.5);
    }
  }
  s.paths[0].clear();
  EXPECT_FALSE(s.paths[0].meets(s.paths[1]));
}

TEST(PathBoxes, ExpectGoesOnWithConstantVelocities) {
  TwoPaths s;
  s.q << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  s.u << 1.0, 0.0, 0.0, 0.0, 0.0, 0.0;
  s.at(0.0);
  const auto meet = [&](double h) {
    for (int p = 0; p < 2; ++p) s.paths[p].expect(s.shape(p), s.k, h);
    return s.paths[0].meets(s.paths[1]);
  };
  // The balls touch after 0.8 s; a box is enlarged by a tenth of the way at each end.
  EXPECT_FALSE(meet(0.5));
  EXPECT_TRUE(meet(0.8));
}

}  // namespace
}  // namespace dynamy
