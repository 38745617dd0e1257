/// The Open Dynamics Engine on the scenes of bench/work_precision.
///
/// Settings by its manual and its users: the direct step for joints and few contacts, the quick
/// step with 50 iterations else; no contact surface layer, threshold of bouncing at zero, no
/// disabling, no damping; erp 0.8 where joints have to hold.
#include <ode/ode.h>

#include "../peer.hpp"
#include "ode_world.hpp"

namespace {
using peer::Answer;
using peer::march;
using peer::OdeSettings;
using peer::OdeWorld;

void bouncingBall(double h, Answer& a, bool direct) {
  OdeSettings s;
  s.direct = direct, s.e = 0.5;
  OdeWorld w(s);
  w.ground();
  dBodyID ball = w.sphere(1.0, 0.1, 1.1);
  a.start();
  march(
      h, 1.6, {0.6, 1.0, 1.2, 1.3, 1.6}, a, [&] { w.step(h); },
      [&](std::size_t) { a.add(dBodyGetPosition(ball)[2]); });
  a.stop();
}

void freeTop(double h, Answer& a) {
  OdeSettings s;
  s.gravity = {0, 0, 0};
  OdeWorld w(s);
  dBodyID top = w.body(1, 1, 2, 3, 0, 0, 0);
  dBodySetAngularVel(top, 0.01, 5, 0.01);
  a.start();
  march(
      h, 20.0, {}, a, [&] { w.step(h); }, [](std::size_t) {});
  a.stop();
  const dReal* q = dBodyGetQuaternion(top);
  const double sign = q[0] > 0 ? -1 : 1;
  for (int i = 0; i < 4; ++i) a.add(sign * q[i]);
}

dJointID hinge(OdeWorld& w, dBodyID a, dBodyID b, double x) {
  dJointID j = dJointCreateHinge(w.world, nullptr);
  dJointAttach(j, a, b);
  dJointSetHingeAnchor(j, x, 0, 0);
  dJointSetHingeAxis(j, 0, 1, 0);
  return j;
}

void rodPendulum(double h, Answer& a, double erp) {
  OdeSettings s;
  s.direct = true, s.erp = erp;
  OdeWorld w(s);
  dBodyID upper = w.body(1, 1e-3, 1.0 / 12, 1.0 / 12, 0.5, 0, 0);
  dBodyID lower = w.body(1, 1e-3, 1.0 / 12, 1.0 / 12, 1.5, 0, 0);
  hinge(w, upper, nullptr, 0);
  hinge(w, upper, lower, 1);
  a.start();
  march(
      h, 10.0, {0.5, 1.0, 1.5, 2.0}, a, [&] { w.step(h); },
      [&](std::size_t) {
        for (dBodyID b : {upper, lower}) {
          const dReal* r = dBodyGetRotation(b);  // rows of 4; the rod is the body's x axis
          a.add(peer::angleFromDown(r[0], r[8]));
        }
      });
  a.stop();
}

/// A box on a plane tilted by 20 degrees; the frame is the plane's.
void slope(double h, Answer& a, bool direct, bool stick) {
  const double angle = 20.0 * std::acos(-1.0) / 180.0, g = 9.81;
  OdeSettings s;
  s.direct = direct, s.mu = stick ? 0.5 : 0.3;
  s.gravity = {-g * std::sin(angle), 0, -g * std::cos(angle)};
  OdeWorld w(s);
  w.ground();
  dBodyID box = w.box(1.0, 0.2, 0.1, 0.1, 0.05 - 1e-9);  // or the first step falls freely
  if (!stick) dBodySetLinearVel(box, 2.0, 0, 0);
  a.start();
  march(
      h, stick ? 10.0 : 2.0, stick ? std::vector<double>{10.0} : std::vector<double>{0.2, 1.0, 2.0},
      a, [&] { w.step(h); },
      [&](std::size_t) { a.add(peer::placeOnSlope(dBodyGetPosition(box)[0])); });
  a.stop();
}

void slideToRoll(double h, Answer& a, bool direct) {
  OdeSettings s;
  s.direct = direct, s.mu = 0.3;
  OdeWorld w(s);
  w.ground();
  dBodyID ball = w.sphere(1.0, 0.1, 0.1);
  dBodySetLinearVel(ball, 3.0, 0, 0);
  a.start();
  march(
      h, 0.5, {0.2, 0.5}, a, [&] { w.step(h); },
      [&](std::size_t) { a.add(dBodyGetPosition(ball)[0]), a.add(dBodyGetLinearVel(ball)[0]); });
  a.stop();
}

/// Unit cubes without gaps; the displacement of each is what is asked for.
void stack(double h, Answer& a, bool direct, int count, double ratio, double until) {
  OdeSettings s;
  s.direct = direct, s.mu = 0.5;
  OdeWorld w(s);
  w.ground();
  std::vector<dBodyID> cubes;
  double mass = 1.0;
  for (int i = 0; i < count; ++i, mass *= ratio)
    cubes.push_back(w.box(mass, 1, 1, 1, i + 0.5 - 1e-9 * (i + 1)));
  a.start();
  march(
      h, until, {}, a, [&] { w.step(h); }, [](std::size_t) {});
  a.stop();
  for (int i : {0, count - 1}) {
    const dReal* p = dBodyGetPosition(cubes[static_cast<std::size_t>(i)]);
    a.add(p[0]), a.add(p[2]);
  }
}

void heavyChain(double h, Answer& a, bool direct) {
  OdeSettings s;
  s.direct = direct, s.erp = 0.8;
  OdeWorld w(s);
  const double c = std::sqrt(0.5);
  dBodyID before = nullptr;
  const auto join = [&](dBodyID b, double at) {
    dJointID j = dJointCreateBall(w.world, nullptr);
    dJointAttach(j, b, before);
    dJointSetBallAnchor(j, c * at, 0, -c * at);
    before = b;
  };
  for (int i = 0; i < 20; ++i) {
    dBodyID b = w.body(0.1, 5e-6, 8.333333333333333e-5, 8.333333333333333e-5, c * 0.1 * (i + 0.5),
                       0, -c * 0.1 * (i + 0.5));
    const dQuaternion q = {std::cos(std::acos(-1.0) / 8), 0, std::sin(std::acos(-1.0) / 8), 0};
    dBodySetQuaternion(b, q);
    join(b, 0.1 * i);
  }
  dBodyID end = w.body(100, 0.4, 0.4, 0.4, 2 * c, 0, -2 * c);
  join(end, 2.0);
  a.start();
  march(
      h, 2.0, {1.0, 2.0}, a, [&] { w.step(h); },
      [&](std::size_t) { a.add(dBodyGetPosition(end)[0]), a.add(dBodyGetPosition(end)[2]); });
  a.stop();
}

}  // namespace

int main(int argc, char** argv) {
  dInitODE2(0);
  dSetMessageHandler([](int, const char*, va_list) {});
  std::vector<peer::Line> lines;
  const auto both = [&](const std::string& scene, const std::vector<std::string>& settings,
                        const std::function<void(double, Answer&, bool)>& run) {
    lines.push_back(
        {scene, "direct step", settings, [=](double h, Answer& a) { run(h, a, true); }});
    lines.push_back(
        {scene, "quick step, 50", settings, [=](double h, Answer& a) { run(h, a, false); }});
  };
  both("bouncing_ball", peer::kBallSteps, bouncingBall);
  lines.push_back({"free_top", "default", peer::kSmoothSteps, freeTop});
  lines.push_back({"rod_pendulum", "direct step, erp 0.8", peer::kSmoothSteps,
                   [](double h, Answer& a) { rodPendulum(h, a, 0.8); }});
  both("slope_slide", peer::kBallSteps,
       [](double h, Answer& a, bool direct) { slope(h, a, direct, false); });
  both("slope_stick", peer::kRestSteps,
       [](double h, Answer& a, bool direct) { slope(h, a, direct, true); });
  both("slide_to_roll", peer::kBallSteps, slideToRoll);
  both("ratio_stack", peer::kRestSteps,
       [](double h, Answer& a, bool direct) { stack(h, a, direct, 5, 10, 5); });
  both("tower", peer::kRestSteps,
       [](double h, Answer& a, bool direct) { stack(h, a, direct, 10, 1, 10); });
  both("heavy_chain", {"1e-2", "5e-3", "2e-3", "1e-3*", "5e-4", "2e-4", "1e-4"}, heavyChain);
  return peer::serve(
      argc, argv, "ODE 0.16.2, double, of the distribution",
      {"hard contact, friction as a pyramid; errors of joints are pulled back by erp",
       "first order by construction: semi-implicit Euler"},
      lines);
}
