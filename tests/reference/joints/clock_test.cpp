/// Where the energy of a clock's weight goes, from its two angles alone: into the air, into
/// landings of pins on pallets, into the swing.
#include <gtest/gtest.h>

#include <numbers>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

// models/clock_escapement.xml
constexpr double kTorque = 2e-3, kAir = 2e-3;
constexpr double kL = 0.248, kM = 0.3, kJp = 1e-4 + kM * kL * kL, kJw = 5e-6, kG = 9.81;
const double kStart = 7.94 * std::numbers::pi / 180.0;
const double kPivot = 0.05 / std::cos(37.5 * std::numbers::pi / 180.0);

/// Angle and rate of pendulum and wheel.
struct Angles {
  double phi, omega, wheel, spin;
  /// T + V of the pendulum, T of the wheel [J].
  double energy() const {
    return 0.5 * kJp * omega * omega - kM * kG * kL * std::cos(phi) + 0.5 * kJw * spin * spin;
  }
};

class Clock {
 public:
  explicit Clock(double dt)
      : dt_(dt),
        scene_("clock_escapement", {.set = {{"A", "7.94deg"}}}),
        pendulum_(of("pendulum.phi")),
        wheel_(of("wheel.phi")) {}
  Angles angles() {
    const State& x = scene_.state();
    // Joints count from where they were put together.
    return {kStart + x.q[pendulum_.q0], x.u[pendulum_.u0], x.q[wheel_.q0], x.u[wheel_.u0]};
  }
  bool solved() const { return scene_.solved(); }
  /// One step; returns what the contacts in it take, from the angles and the arms of the normal.
  /// With the mass m = 1/(l_p²/J_p + l_w²/J_w) along it the percussion is what is missing to the
  /// rate γ_free, with which the other forces of the step alone would end:
  ///   T⁻ − T⁺ = −Λ (γ_A + γ_E)/2,   Λ = m (γ_E − γ_free)
  double step() {
    const Angles before = angles();
    scene_.oneStep(dt_);
    const Angles after = angles();
    const ContactSet& c = scene_.system().slot(0).contacts;
    double lost = 0.0;
    for (int i = 0; i < c.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!(c.law[at]->unilateral() && scene_.Lambda()[c.row0[at]] > 0.0)) continue;
      const Vec3 &n = c.places.normal[at], &P = c.places.point[at];
      const auto arm = [&](double z) { return n.z() * P.x() - n.x() * (P.z() - z); };
      const double lp = arm(kPivot), lw = arm(0.0);
      const double mass = 1.0 / (lp * lp / kJp + lw * lw / kJw);
      const auto rate = [&](double omega, double spin) { return lp * omega - lw * spin; };
      const double omega =
          before.omega - dt_ * (kM * kG * kL * std::sin(before.phi) + kAir * before.omega) / kJp;
      const double free = rate(omega, before.spin - dt_ * kTorque / kJw);
      const double from = rate(before.omega, before.spin), to = rate(after.omega, after.spin);
      if (std::abs(from - to) > kLanding) ++landings, late += kTorque * std::abs(from / lw) * dt_;
      lost += 0.5 * mass * (free - to) * (from + to);
    }
    return lost;
  }
  int landings = 0;
  double late = 0.0;  ///< what the weight can do while landings are lifted back [J]

 private:
  /// Changes of rate in a step that count as a landing [m/s].
  static constexpr double kLanding = 1e-2;
  SystemHandle of(const char* signal) {
    const NamedSignal* found = scene_.model().signal(signal);
    return scene_.model().topology().system(found->system);
  }
  double dt_;
  Scene scene_;
  SystemHandle pendulum_, wheel_;
};

/// From the swing of the clock at 1 s to that five periods later.
struct Balance {
  double weight = 0.0, air = 0.0, landings = 0.0, swing = 0.0, late = 0.0;
  int count = 0;
  double missing() const { return weight - air - landings - swing; }
};

Balance balance(double dt) {
  constexpr double kBegin = 1.0, kEnd = kBegin + 5.0 * 1.00429;
  Clock clock(dt);
  const auto steps = [&](double t) { return std::lround(t / dt); };
  for (long i = 0; i < steps(kBegin); ++i) clock.step();
  const Angles start = clock.angles();
  clock.landings = 0, clock.late = 0.0;
  Balance out;
  Angles last = start;
  for (long i = steps(kBegin); i < steps(kEnd); ++i) {
    out.landings += clock.step();
    const Angles now = clock.angles();
    const double mean = 0.5 * (last.omega + now.omega);
    out.air += dt * kAir * mean * mean;
    last = now;
  }
  EXPECT_TRUE(clock.solved());
  out.weight = -kTorque * (last.wheel - start.wheel);
  out.swing = last.energy() - start.energy();
  out.late = clock.late, out.count = clock.landings;
  return out;
}

TEST(Clock, TheWeightPaysForAirAndLandings) {
  constexpr double kTooth = kTorque * std::numbers::pi / 6.0;
  for (const double dt : {2e-4, 1e-4}) {
    const Balance b = balance(dt);
    // A tooth passes in each period, half of it in each beat: 2π/12 of a turn. Windows of whole
    // steps and swings that still settle leave a part of a thousand.
    EXPECT_NEAR(b.weight, 5.0 * kTooth, 5e-3 * kTooth);
    EXPECT_EQ(b.count, 10);
    // Air takes π c ω a²/2 of a beat at the amplitude a = 0.1385, 0.377 mJ, as far as the swing is
    // a sine: impulses of 4° in the middle of 8° bend it by some per cent.
    EXPECT_NEAR(b.air, 10.0 * 0.377e-3, 0.05e-3);
    // What is in is out. The scheme lifts what landed too deep, by less than γ_A Δt, which the
    // weight falls again: this much is paid for twice, a part that falls with Δt.
    EXPECT_GT(b.missing(), 0.0) << dt;
    EXPECT_LT(b.missing(), b.late) << dt;
    EXPECT_LT(b.late, 0.01 * b.weight * dt / 2e-4);
  }
}

}  // namespace
}  // namespace dynamy::reference
