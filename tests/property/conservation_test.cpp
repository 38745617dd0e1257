/// What a free motion keeps: momentum, moment of momentum, energy.
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <limits>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Two balls of different mass and a third one between them, flying and colliding with friction.
const char* const kBilliard = R"(<dynamy version="1"><systems>
  <RigidBody name="a" position="-1 0.02 0" velocity="3 0 0.1" angularVelocity="0 9 4"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
  <RigidBody name="b" position="0 0 0.03" velocity="0 0 0"><Sphere radius="0.15" mass="3" material="ball"/></RigidBody>
  <RigidBody name="c" position="1 -0.05 0.05" velocity="-2 0 0"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
  </systems><elements>
  <Contact between="ball ball"><UnilateralCoulomb mu="0.3" epsilonN="0.8"/></Contact></elements>
  <simulation until="1" step="1e-3"><MoreauMidpoint/></simulation></dynamy>)";

struct Sums {
  Vec3 p = Vec3::Zero(), L = Vec3::Zero();
};
Sums sums(const Scene& scene) {
  Sums out;
  const struct {
    const char* name;
    double m, r;
  } bodies[] = {{"a", 1.0, 0.1}, {"b", 3.0, 0.15}, {"c", 1.0, 0.1}};
  for (const auto& body : bodies) {
    const Eigen::VectorXd q = scene.q(body.name), u = scene.u(body.name);
    const Vec3 r = q.head<3>(), v = u.head<3>(), Omega_K = u.tail<3>();
    out.p += body.m * v;
    out.L += body.m * r.cross(v) +
             0.4 * body.m * body.r * body.r * (rotationMatrix(q.data() + 3) * Omega_K);
  }
  return out;
}

class Conservation : public testing::TestWithParam<Scheme> {};

TEST_P(Conservation, CollisionsKeepTheMomentumToRounding) {
  Scene scene("billiard", {.scheme = GetParam(), .text = kBilliard});
  const Sums start = sums(scene);
  double worst = 0.0, fastest = 0.0;
  scene.run(1.0, 1e-3, [&] {
    worst = std::max(worst, (sums(scene).p - start.p).norm());
    fastest = std::max(fastest, scene.u("b").norm());
  });
  EXPECT_GT(fastest, 0.1);  // there were collisions
  // Impulses on the two bodies are opposite to the last bit; each step rounds numbers of 3 N s.
  EXPECT_LT(worst, 1000.0 * kEps * 3.0);
}

TEST_P(Conservation, CollisionsKeepTheMomentOfMomentumWithinTheGap) {
  // Both forces act at one point each; the points differ by the penetration, at most |v| Δt = 5 mm
  // at 1 ms, so each collision may add Λ_T times that. It falls with Δt.
  std::vector<double> dt = halvings(2e-3, 4), error;
  for (const double h : dt)
    error.push_back(envelope(h, 8, [&](double s) {
      Scene scene("billiard", {.scheme = GetParam(), .text = kBilliard});
      const Sums start = sums(scene);
      scene.run(1.0, s);
      return (sums(scene).L - start.L).norm() + 1e-16;
    }));
  EXPECT_LT(error.back(), 5.0 * dt.back() * 3.0);
}

TEST_P(Conservation, FreeBodyKeepsTheMomentOfMomentumWithOrderOne) {
  const Vec3 J(1.0, 2.0, 3.0);
  const std::vector<double> dt = halvings(2e-3, 4);
  std::vector<double> error;
  for (const double h : dt) {
    Scene scene("free_top", {.scheme = GetParam()});
    const Vec3 L0 = J.cwiseProduct(Vec3(scene.u("top").tail<3>()));
    scene.run(5.0, h);
    const Eigen::VectorXd q = scene.q("top");
    const Vec3 L = rotationMatrix(q.data() + 3) * J.cwiseProduct(Vec3(scene.u("top").tail<3>()));
    error.push_back((L - L0).norm());
  }
  EXPECT_NEAR(fitOrder(dt, error).order, 1.0, 0.15) << fitOrder(dt, error);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Conservation, testing::ValuesIn(kBothSchemes));

/// The same flight with dissipation only: energy must never grow through contacts.
TEST(Energy, ContactsNeverAddAny) {
  for (const Scheme scheme : kBothSchemes) {
    Scene scene("billiard", {.scheme = scheme, .text = kBilliard});
    double before = scene.kineticEnergy();
    scene.run(1.0, 1e-3, [&] {
      const double now = scene.kineticEnergy();
      EXPECT_LE(now, before * (1.0 + 10.0 * kEps) + 1e-15);
      before = now;
    });
  }
}

}  // namespace
}  // namespace dynamy::reference
