/// Bullet on the scene `pour` (models/pour.xml): N balls let fall into a box, friction 0.5.
///
///   pour_bullet N NX UNTIL STEP ITERATIONS [1]      the last: friction in one direction
///
/// Prints CPU time a step of the last quarter, and at the end the mean and the deepest overlap of
/// the pairs that overlap, the mean height, and the kinetic energy of a ball. Worlds of rigid
/// bodies alone have one friction row by default, along the slip: what pushes across it is not
/// held, and the heap is lower. Worlds of multibodies have two, as the law asks.
#include <cstdint>
#include <cstdlib>

#include "../peer.hpp"
#include "bullet_world.hpp"

namespace {

constexpr double kRadius = 0.05, kDensity = 1000.0, kPitch = 0.11, kJitter = 0.004, kMu = 0.5;

/// xorshift64*, uniform in −1 … 1.
double draw(std::uint64_t& x) {
  x ^= x >> 12, x ^= x << 25, x ^= x >> 27;
  return 2.0 * static_cast<double>((x * 0x2545F4914F6CDD1Du) >> 11) * 0x1p-53 - 1.0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) return 1;
  const int n = std::atoi(argv[1]), nx = std::atoi(argv[2]);
  const double until = std::atof(argv[3]), h = std::atof(argv[4]), W = 0.5 * kPitch * nx;
  peer::BulletWorld w({0, 0, -9.81}, std::atoi(argv[5]));
  if (argc > 6) w.world.getSolverInfo().m_solverMode &= ~SOLVER_USE_2_FRICTION_DIRECTIONS;
  const double mu = std::sqrt(kMu), R = kRadius,
               m = kDensity * 4.0 / 3.0 * std::acos(-1.0) * R * R * R;
  const btVector3 normal[5] = {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (int k = 0; k < 5; ++k)
    w.body(0, std::make_unique<btStaticPlaneShape>(normal[k], k == 0 ? 0.0 : -W), {0, 0, 0},
           {0, 0, 0}, mu, 0);
  std::vector<btRigidBody*> balls;
  std::uint64_t x = 88172645463325252u;
  for (int i = 0; i < n; ++i) {
    const int layer = i / (nx * nx), cell = i % (nx * nx);
    btVector3 at(-W + kPitch * (0.5 + cell % nx), -W + kPitch * (0.5 + cell / nx),
                 0.06 + kPitch * layer);
    for (int k = 0; k < 3; ++k) at[k] += kJitter * draw(x);
    balls.push_back(&w.body(m, std::make_unique<btSphereShape>(R), {0, 0, 0}, at, mu, 0));
  }
  const long steps = std::lround(until / h), last = steps / 4;
  double begin = 0.0;
  for (long i = 0; i < steps; ++i) {
    if (i == steps - last) begin = peer::processTime();
    w.step(h);
  }
  const double cpu = (peer::processTime() - begin) / static_cast<double>(last);
  double sum = 0.0, deepest = 0.0, height = 0.0, energy = 0.0;
  int overlaps = 0;
  const auto see = [&](double g) {
    if (g < 0.0) sum -= g, deepest = std::max(deepest, -g), ++overlaps;
  };
  for (int i = 0; i < n; ++i) {
    const btVector3 c = balls[static_cast<std::size_t>(i)]->getCenterOfMassPosition();
    for (int j = i + 1; j < n; ++j)
      see((balls[static_cast<std::size_t>(j)]->getCenterOfMassPosition() - c).length() - 2 * R);
    for (int k = 0; k < 5; ++k) see(normal[k].dot(c) + (k == 0 ? 0.0 : W) - R);
    height += c.z() / n;
    const btRigidBody& b = *balls[static_cast<std::size_t>(i)];
    energy += 0.5 * m *
              (b.getLinearVelocity().length2() + 0.4 * R * R * b.getAngularVelocity().length2());
  }
  std::printf(
      "Bullet n %d: %.2f ms a step, overlap mean %.2e m deepest %.2e m, mean height %.5f m, "
      "%.2e J a ball\n",
      n, 1e3 * cpu, overlaps > 0 ? sum / overlaps : 0.0, deepest, height, energy / n);
  return 0;
}
