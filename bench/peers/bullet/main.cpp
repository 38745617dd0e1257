/// Bullet on the scenes of bench/work_precision.
///
/// Settings: double precision; where restitution matters the threshold of contact processing at
/// zero and split impulse always on, as its forum advises; 50 iterations, no sleeping, no damping;
/// open chains as multibodies with the Runge-Kutta integrator.
#include "../peer.hpp"
#include "bullet_world.hpp"

namespace {
using peer::Answer;
using peer::BulletWorld;
using peer::march;

void bouncingBall(double h, Answer& a) {
  BulletWorld w({0, 0, -9.81}, 50, true);
  w.ground();
  btRigidBody& ball = w.sphere(1.0, 0.1, 1.1, 0.0, 0.5);
  a.start();
  march(
      h, 1.6, {0.6, 1.0, 1.2, 1.3, 1.6}, a, [&] { w.step(h); },
      [&](std::size_t) { a.add(ball.getCenterOfMassPosition().z()); });
  a.stop();
}

void freeTop(double h, Answer& a) {
  BulletWorld w({0, 0, 0});
  btRigidBody& top = w.shapeless(1.0, {1, 2, 3}, {0, 0, 0});
  top.setAngularVelocity({0.01, 5, 0.01});
  a.start();
  march(
      h, 20.0, {}, a, [&] { w.step(h); }, [](std::size_t) {});
  a.stop();
  const btQuaternion q = top.getOrientation();
  const double sign = q.w() > 0 ? -1 : 1;
  for (const double v : {q.w(), q.x(), q.y(), q.z()}) a.add(sign * v);
}

/// Two links; the hinges turn by −y, so that angles from down are π/2 − sums of joint angles.
void pendulum(double h, Answer& a, bool rods, bool rk4) {
  const double half = 0.5 * std::acos(-1.0);
  BulletWorld w({0, 0, -9.81});
  const double centre = rods ? 0.5 : 1.0, inertia = rods ? 1.0 / 12 : 1e-15;
  w.chain({{1, 1, centre, inertia}, {1, 1, centre, inertia}}, rk4);
  const auto angles = [&](std::size_t) {
    const double upper = half - w.tree->getJointPos(0);
    a.add(upper), a.add(upper - w.tree->getJointPos(1));
  };
  a.start();
  march(
      h, 10.0, rods ? std::vector<double>{0.5, 1.0, 1.5, 2.0} : std::vector<double>{10.0}, a,
      [&] { w.step(h); }, angles);
  a.stop();
}

void rodPendulumOfBodies(double h, Answer& a) {
  BulletWorld w({0, 0, -9.81});
  btRigidBody& upper = w.shapeless(1, {1e-3, 1.0 / 12, 1.0 / 12}, {0.5, 0, 0});
  btRigidBody& lower = w.shapeless(1, {1e-3, 1.0 / 12, 1.0 / 12}, {1.5, 0, 0});
  w.add(std::make_unique<btHingeConstraint>(upper, btVector3(-0.5, 0, 0), btVector3(0, 1, 0)));
  w.add(std::make_unique<btHingeConstraint>(upper, lower, btVector3(0.5, 0, 0),
                                            btVector3(-0.5, 0, 0), btVector3(0, 1, 0),
                                            btVector3(0, 1, 0)));
  a.start();
  march(
      h, 10.0, {0.5, 1.0, 1.5, 2.0}, a, [&] { w.step(h); },
      [&](std::size_t) {
        for (const btRigidBody* b : {&upper, &lower}) {
          const btVector3 d = b->getCenterOfMassTransform().getBasis().getColumn(0);
          a.add(peer::angleFromDown(d.x(), d.z()));
        }
      });
  a.stop();
}

void bob(double h, Answer& a) {
  BulletWorld w({0, 0, -9.81});
  w.chain({{1, 1, 1, 1e-15}}, true);
  w.tree->setJointPos(0, std::acos(-1.0));
  a.start();
  march(
      h, 10.0, {1.0, 2.0, 5.0, 10.0}, a, [&] { w.step(h); },
      [&](std::size_t) {
        const double q = w.tree->getJointPos(0);
        a.add(std::cos(q)), a.add(-std::sin(q));
      });
  a.stop();
}

void fourBars(double h, Answer& a) {
  BulletWorld w({0, 0, -9.81});
  const btVector3 y(0, 1, 0);
  const double third = 1.0 / 12;
  std::vector<btRigidBody*> cranks;
  for (int i = 0; i < 3; ++i) {
    btRigidBody& crank = w.shapeless(1, {third, third, 1e-3}, {double(i), 0, 0.5});
    crank.setLinearVelocity({0.5, 0, 0}), crank.setAngularVelocity({0, 1, 0});
    w.add(std::make_unique<btHingeConstraint>(crank, btVector3(0, 0, -0.5), y));
    cranks.push_back(&crank);
  }
  for (int i = 0; i < 2; ++i) {
    btRigidBody& coupler = w.shapeless(1, {1e-3, third, third}, {i + 0.5, 0, 1});
    coupler.setLinearVelocity({1, 0, 0});
    for (const int end : {0, 1})
      w.add(std::make_unique<btHingeConstraint>(*cranks[i + end], coupler, btVector3(0, 0, 0.5),
                                                btVector3(end - 0.5, 0, 0), y, y));
  }
  a.start();
  march(
      h, 10.0, {1.0, 10.0}, a, [&] { w.step(h); },
      [&](std::size_t) {
        const btVector3 p = cranks[0]->getCenterOfMassPosition();
        a.add(p.x()), a.add(p.z());
      });
  a.stop();
}

void slope(double h, Answer& a, bool stick) {
  const double angle = 20.0 * std::acos(-1.0) / 180.0, g = 9.81;
  BulletWorld w({-g * std::sin(angle), 0, -g * std::cos(angle)});
  w.ground();
  btRigidBody& box = w.box(1.0, {0.2, 0.1, 0.1}, 0.05, stick ? 0.5 : 0.3);
  if (!stick) box.setLinearVelocity({2, 0, 0});
  a.start();
  march(
      h, stick ? 10.0 : 2.0, stick ? std::vector<double>{10.0} : std::vector<double>{0.2, 1.0, 2.0},
      a, [&] { w.step(h); },
      [&](std::size_t) { a.add(peer::placeOnSlope(box.getCenterOfMassPosition().x())); });
  a.stop();
}

void slideToRoll(double h, Answer& a) {
  BulletWorld w({0, 0, -9.81});
  w.ground();
  btRigidBody& ball = w.sphere(1.0, 0.1, 0.1, 0.3, 0.0);
  ball.setLinearVelocity({3, 0, 0});
  a.start();
  march(
      h, 0.5, {0.2, 0.5}, a, [&] { w.step(h); },
      [&](std::size_t) {
        a.add(ball.getCenterOfMassPosition().x()), a.add(ball.getLinearVelocity().x());
      });
  a.stop();
}

void stack(double h, Answer& a, int iterations, int count, double ratio, double until) {
  BulletWorld w({0, 0, -9.81}, iterations);
  w.ground();
  std::vector<btRigidBody*> cubes;
  double mass = 1.0;
  for (int i = 0; i < count; ++i, mass *= ratio)
    cubes.push_back(&w.box(mass, {1, 1, 1}, i + 0.5, i == 0 ? 0.5 : std::sqrt(0.5)));
  if (count > 1) cubes[0]->setFriction(std::sqrt(0.5));
  a.start();
  march(
      h, until, {}, a, [&] { w.step(h); }, [](std::size_t) {});
  a.stop();
  for (const btRigidBody* b : {cubes.front(), cubes.back()})
    a.add(b->getCenterOfMassPosition().x()), a.add(b->getCenterOfMassPosition().z());
}

void heavyChain(double h, Answer& a) {
  const double turn = 0.25 * std::acos(-1.0);
  BulletWorld w({0, 0, -9.81});
  std::vector<BulletWorld::Link> links(20, {0.1, 0.1, 0.05, 8.333333333333333e-5});
  links.push_back({100.0, 0.0, 0.0, 0.4});
  w.chain(links, true);
  w.tree->setJointPos(0, turn);
  a.start();
  march(
      h, 2.0, {1.0, 2.0}, a, [&] { w.step(h); },
      [&](std::size_t) {
        double x = 0.0, z = 0.0, sum = 0.0;
        for (int i = 0; i < 20; ++i) {
          sum += w.tree->getJointPos(i);
          x += 0.1 * std::cos(sum), z -= 0.1 * std::sin(sum);
        }
        a.add(x), a.add(z);
      });
  a.stop();
}

}  // namespace

int main(int argc, char** argv) {
  using peer::Line;
  std::vector<Line> lines;
  const std::string impulses = "sequential impulses, 50";
  lines.push_back({"bouncing_ball", impulses, peer::kBallSteps, bouncingBall});
  lines.push_back({"free_top", "implicit gyroscopic, default", peer::kSmoothSteps, freeTop});
  for (const bool rods : {true, false})
    lines.push_back({rods ? "rod_pendulum" : "double_pendulum", "multibody, Runge-Kutta 4",
                     peer::kSmoothSteps, [=](double h, Answer& a) { pendulum(h, a, rods, true); }});
  lines.push_back({"pendulum", "multibody, Runge-Kutta 4", peer::kSmoothSteps, bob});
  lines.push_back({"four_bars", "bodies with hinges, 50", peer::kSmoothSteps, fourBars});
  lines.push_back(
      {"rod_pendulum", "bodies with hinges, 50", peer::kSmoothSteps, rodPendulumOfBodies});
  lines.push_back(
      {"slope_slide", impulses, peer::kBallSteps, [](double h, Answer& a) { slope(h, a, false); }});
  lines.push_back(
      {"slope_stick", impulses, peer::kRestSteps, [](double h, Answer& a) { slope(h, a, true); }});
  lines.push_back({"slide_to_roll", impulses, peer::kBallSteps, slideToRoll});
  for (const int n : {50, 1000}) {
    const std::string method = "sequential impulses, " + std::to_string(n);
    lines.push_back({"ratio_stack", method, peer::kRestSteps,
                     [=](double h, Answer& a) { stack(h, a, n, 5, 10, 5); }});
    lines.push_back({"tower", method, peer::kRestSteps,
                     [=](double h, Answer& a) { stack(h, a, n, 10, 1, 10); }});
  }
  lines.push_back({"heavy_chain",
                   "multibody, Runge-Kutta 4",
                   {"1e-2", "5e-3", "2e-3", "1e-3*", "5e-4", "2e-4", "1e-4"},
                   heavyChain});
  return peer::serve(argc, argv,
                     "Bullet " + std::to_string(btGetVersion() / 100) + "." +
                         std::to_string(btGetVersion() % 100) + ", float64, of the distribution",
                     {"hard contact by sequential impulses, friction in two directions",
                      "first order but for multibodies, which have Runge-Kutta 4 without contact"},
                     lines);
}
