// The bicycle of four bodies against accelerations that others have published.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <dynamy/simulation/linear/held_motion.hpp>
#include <numbers>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

/// A matrix or vector along a motion: its value and its first two derivatives at one instant.
template <class M>
struct Jet {
  M v, d, dd;
};

template <class A, class B>
auto operator*(const Jet<A>& a, const Jet<B>& b) {
  using M = Eigen::Matrix<double, A::RowsAtCompileTime, B::ColsAtCompileTime>;
  return Jet<M>{a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2.0 * a.d * b.d + a.v * b.dd};
}
template <class M>
Jet<M> operator+(const Jet<M>& a, const Jet<M>& b) {
  return {a.v + b.v, a.d + b.d, a.dd + b.dd};
}
template <class M>
Jet<M> fixed(const M& m) {
  return {m, M::Zero(), M::Zero()};
}

/// A coordinate with its rate and acceleration.
struct Coordinate {
  double v, d, dd;
};

Mat3 cross(const Vec3& n) {
  Mat3 out;
  out << 0.0, -n.z(), n.y(), n.z(), 0.0, -n.x(), -n.y(), n.x(), 0.0;
  return out;
}

/// Rotation by an angle about n: R' = α' N R, R'' = (α'' N + α'² N²) R.
Jet<Mat3> turn(const Vec3& n, const Coordinate& angle) {
  const Mat3 N = cross(n), R = Eigen::AngleAxisd(angle.v, n).toRotationMatrix();
  return {R, angle.d * N * R, (angle.dd * N + angle.d * angle.d * N * N) * R};
}

/// A body's centre and axes along a motion.
struct Motion {
  Jet<Vec3> r;
  Jet<Mat3> A;
  /// (position, quaternion), (v, Ω in its axes) and the derivatives of these.
  void put(int body, State& x, Eigen::VectorXd& a) const {
    const Eigen::Quaterniond p(A.v);
    x.q.segment<3>(7 * body) = r.v;
    x.q.segment<4>(7 * body + 3) << p.w(), p.x(), p.y(), p.z();
    const auto axial = [](const Mat3& m) { return Vec3(m(2, 1), m(0, 2), m(1, 0)); };
    x.u.segment<3>(6 * body) = r.d, x.u.segment<3>(6 * body + 3) = axial(A.v.transpose() * A.d);
    a.segment<3>(6 * body) = r.dd;
    // The derivative of AᵀA' is AᵀA'' + A'ᵀA', whose second part is symmetric: no axial vector.
    const Mat3 rate = A.v.transpose() * A.dd;
    a.segment<3>(6 * body + 3) = axial(0.5 * (rate - rate.transpose()));
  }
};

/// State and accelerations of table 1. Coordinates: centre of the rear wheel, z up; attitude
/// R_z(θ) R_x(ψ) R_z(φ), whose axes point forward, down and left at ψ = π/2, φ = π; steer about the
/// axis that points up; turns of the wheels relative to what carries them, forward.
struct PublishedState {
  Coordinate x{0.0, -2.8069345714545, -0.5041626315047};
  Coordinate y{0.0, -0.1480982396001, -0.3449706619454};
  Coordinate z{0.2440472102925, 0.1058778746261, -1.4604528332980};
  Coordinate theta{0.0, 0.7830033527065, 0.8353281706379};
  Coordinate psi{0.9501292851472, 0.6068425835418, -7.8555281128244};
  Coordinate phi{3.1257073014894, -0.0119185528069, 0.1205543897884};
  Coordinate steer{0.2311385135743, 0.4859824687093, -4.6198904039403};
  Coordinate rear{0.0, 8.9129896614890, 1.8472554144217};
  Coordinate front{0.0, 8.0133620584155, 2.4548072904550};
};

/// The four bodies of models/bicycle_bodies.xml in this state, in the order of the model.
void place(const PublishedState& p, State& x, Eigen::VectorXd& a) {
  constexpr double l = std::numbers::pi / 10.0;
  Mat3 axes;  // forward, left and up from forward, down and left
  axes << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  const Vec3 hub(0.0, 0.0, 0.3), head(1.1 - 0.9 * std::tan(l), 0.0, 0.9), axle(1.02, 0.0, 0.35);
  const Mat3 wheel = Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vec3::UnitX()).toRotationMatrix();
  const auto vector = [](const Coordinate& i, const Coordinate& j, const Coordinate& k) {
    return Jet<Vec3>{{i.v, j.v, k.v}, {i.d, j.d, k.d}, {i.dd, j.dd, k.dd}};
  };
  const Jet<Mat3> A = turn(Vec3::UnitZ(), p.theta) * turn(Vec3::UnitX(), p.psi) *
                      turn(Vec3::UnitZ(), p.phi) * fixed(axes);
  const Jet<Vec3> r = vector(p.x, p.y, p.z);
  const auto on = [](const Jet<Vec3>& at, const Jet<Mat3>& axes_B, const Vec3& from,
                     const Vec3& to) { return at + axes_B * fixed(Vec3(to - from)); };
  const Jet<Mat3> fork = A * turn(Vec3(-std::sin(l), 0.0, std::cos(l)), p.steer);
  const Jet<Vec3> top = on(r, A, hub, head);
  const Motion bodies[] = {
      {on(r, A, hub, Vec3(0.3, 0.0, 0.9)), A},
      {on(top, fork, head, Vec3(0.9, 0.0, 0.7)), fork},
      {r, A * turn(Vec3::UnitY(), p.rear) * fixed(wheel)},
      {on(top, fork, head, axle), fork * turn(Vec3::UnitY(), p.front) * fixed(wheel)}};
  for (int i = 0; i < 4; ++i) bodies[i].put(i, x, a);
}

TEST(BicycleOfBodies, HasThePublishedAccelerationsInAGeneralState) {
  // Basu-Mandal, Chatterjee, Papadopoulos, Proc. R. Soc. A 463, 2007, table 1: 13 decimals.
  Registry registry;
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, registry);
  LoadOptions options;
  options.coordinates = JointCoordinates::absolute;
  Model model =
      loadModel(DYNAMY_SOURCE_DIR "/models/bicycle_bodies.xml", registry, plugins, options);
  State x = model.initialState();
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(x.u.size());
  place({}, x, expected);
  // Joints, and both wheels on the road, to the digits of the table.
  HeldMotion motion(model, x, 1e-9, 1e-9);
  const MotionSample sample = motion.at(x);
  ASSERT_EQ(sample.gamma.size(), 3 * 5 + 2 * 3);
  EXPECT_LT(sample.gamma.lpNorm<Eigen::Infinity>(), 1e-11);
  EXPECT_LT(sample.position.lpNorm<Eigen::Infinity>(), 1e-12);
  // Inputs are rounded to 5e-14 each. What that changes is taken from larger changes, of 1e-6; to it
  // come 1e-15 of the largest acceleration, for sums of some ten terms of its size.
  const auto missed = [&](const PublishedState& of) {
    State y = x;
    Eigen::VectorXd a = expected;
    place(of, y, a);
    return Eigen::VectorXd(motion.at(y).a - a);
  };
  using Numbers = std::array<double, 27>;
  const Eigen::VectorXd off = missed({});
  Eigen::VectorXd bound =
      Eigen::VectorXd::Constant(off.size(), 1e-14 * expected.lpNorm<Eigen::Infinity>());
  for (std::size_t k = 0; k < Numbers().size(); ++k) {
    auto numbers = std::bit_cast<Numbers>(PublishedState{});
    numbers[k] += 1e-6;
    bound += (5e-14 / 1e-6) * (missed(std::bit_cast<PublishedState>(numbers)) - off).cwiseAbs();
  }
  EXPECT_LT(bound.maxCoeff(), 1e-11);
  for (Eigen::Index i = 0; i < off.size(); ++i) EXPECT_LE(std::abs(off[i]), bound[i]) << i;
}

}  // namespace
}  // namespace dynamy
