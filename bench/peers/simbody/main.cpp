/// Simbody on the smooth scenes of bench/work_precision: bodies in joint coordinates, and its
/// error-controlled Runge–Kutta–Merson integrator, the default of its examples; the setting is
/// its accuracy.
#include <Simbody.h>

#include <string>

#include "../peer.hpp"

namespace {
using namespace SimTK;
using peer::Answer;

/// A system under construction; gravity along −z.
struct World {
  MultibodySystem system;
  SimbodyMatterSubsystem matter{system};
  GeneralForceSubsystem forces{system};
  /// The pins turn about y.
  const Rotation aboutY{-Pi / 2, XAxis};

  explicit World(double g) {
    if (g > 0) Force::UniformGravity(forces, matter, Vec3(0, 0, -g));
  }
  MobilizedBody pin(MobilizedBody& parent, double at, double mass, double centre, double slender,
                    double inertia) {
    const Inertia central(slender, inertia, inertia);
    const Body::Rigid body(MassProperties(mass, Vec3(centre, 0, 0),
                                          central.shiftFromMassCenter(Vec3(centre, 0, 0), mass)));
    return MobilizedBody::Pin(parent, Transform(aboutY, Vec3(at, 0, 0)), body, Transform(aboutY));
  }
};

template <class Sample>
void integrate(const MultibodySystem& system, const State& start, double accuracy, double until,
               const std::vector<double>& times, Answer& a, Sample&& sample) {
  RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(accuracy);
  integrator.setFinalTime(until);
  TimeStepper stepper(system, integrator);
  stepper.initialize(start);
  a.start();
  for (const double t : times) {
    stepper.stepTo(t);
    sample(integrator.getState());
  }
  if (times.empty() || times.back() < until) stepper.stepTo(until);
  a.stop();
  a.evaluations = integrator.getNumRealizations();
}

void freeTop(double accuracy, Answer& a) {
  World w(0.0);
  const Body::Rigid body(MassProperties(1.0, Vec3(0), Inertia(1, 2, 3)));
  MobilizedBody::Free top(w.matter.Ground(), body);
  State s = w.system.realizeTopology();
  top.setUToFitAngularVelocity(s, Vec3(0.01, 5, 0.01));
  integrate(w.system, s, accuracy, 20.0, {20.0}, a, [&](const State& x) {
    const Quaternion q = top.getBodyRotation(x).convertRotationToQuaternion();
    const double sign = q[0] > 0 ? -1 : 1;
    for (int i = 0; i < 4; ++i) a.add(sign * q[i]);
  });
}

void pendulum(double accuracy, Answer& a, bool rods) {
  World w(9.81);
  const double centre = rods ? 0.5 : 1.0, inertia = rods ? 1.0 / 12 : 0.0;
  MobilizedBody ground = w.matter.Ground();
  MobilizedBody upper = w.pin(ground, 0, 1, centre, 0, inertia);
  MobilizedBody lower = w.pin(upper, 1, 1, centre, 0, inertia);
  const State s = w.system.realizeTopology();
  const std::vector<double> times =
      rods ? std::vector<double>{0.5, 1.0, 1.5, 2.0} : std::vector<double>{10.0};
  integrate(w.system, s, accuracy, 10.0, times, a, [&](const State& x) {
    const double first = Pi / 2 - upper.getOneQ(x, 0);
    a.add(first), a.add(first - lower.getOneQ(x, 0));
  });
}

void bob(double accuracy, Answer& a) {
  World w(9.81);
  MobilizedBody ground = w.matter.Ground();
  MobilizedBody bar = w.pin(ground, 0, 1, 1, 0, 0);
  State s = w.system.realizeTopology();
  bar.setOneQ(s, 0, Pi);
  integrate(w.system, s, accuracy, 10.0, {1.0, 2.0, 5.0, 10.0}, a, [&](const State& x) {
    const double q = bar.getOneQ(x, 0);
    a.add(std::cos(q)), a.add(-std::sin(q));
  });
}

/// The point (x, y) or (x, z) of a body is held at a point of another one in their plane.
void close(MobilizedBody& a, const Vec3& at, MobilizedBody& b, const Vec3& point,
           CoordinateAxis second) {
  Constraint::PointInPlane(a, UnitVec3(XAxis), at[0], b, point);
  Constraint::PointInPlane(a, UnitVec3(second), at[second], b, point);
}

void fourBars(double accuracy, Answer& a) {
  World w(9.81);
  MobilizedBody ground = w.matter.Ground();
  std::vector<MobilizedBody> cranks, couplers;
  for (int i = 0; i < 3; ++i) cranks.push_back(w.pin(ground, i, 1, 0.5, 0, 1.0 / 12));
  for (int i = 0; i < 2; ++i) {
    couplers.push_back(w.pin(cranks[i], 1, 1, 0.5, 0, 1.0 / 12));
    close(cranks[i + 1], Vec3(1, 0, 0), couplers[i], Vec3(1, 0, 0), ZAxis);
  }
  State s = w.system.realizeTopology();
  for (MobilizedBody& c : cranks) c.setOneQ(s, 0, -Pi / 2), c.setOneU(s, 0, 1);
  for (MobilizedBody& c : couplers) c.setOneQ(s, 0, Pi / 2), c.setOneU(s, 0, -1);
  integrate(w.system, s, accuracy, 10.0, {1.0, 10.0}, a, [&](const State& x) {
    const double q = cranks[0].getOneQ(x, 0);
    a.add(0.5 * std::cos(q)), a.add(-0.5 * std::sin(q));
  });
}

/// Parameters and start as in the test set of initial value problems (CWI, Bari).
void andrews(double accuracy, Answer& a) {
  World w(0.0);
  const auto link = [&](MobilizedBody& on, double x, double y, double mass, double inertia,
                        double cx, double cy) {
    const Inertia central(0.5 * inertia, 0.5 * inertia, inertia);
    const Body::Rigid body(
        MassProperties(mass, Vec3(cx, cy, 0), central.shiftFromMassCenter(Vec3(cx, cy, 0), mass)));
    return MobilizedBody::Pin(on, Transform(Vec3(x, y, 0)), body, Transform());
  };
  MobilizedBody ground = w.matter.Ground();
  MobilizedBody k1 = link(ground, 0, 0, 0.04325, 2.194e-6, 0.00092, 0);
  MobilizedBody k2 = link(k1, 0.007, 0, 0.00365, 4.410e-7, -0.0115, 0);
  MobilizedBody k3 = link(ground, -0.03635, 0.03273, 0.02373, 5.255e-6, 0.01043, -0.01874);
  MobilizedBody k5 = link(ground, -0.06934, -0.00227, 0.07050, 1.169e-5, 0.02308, 0.00916);
  MobilizedBody k4 = link(k5, 0.04, 0, 0.00706, 5.667e-7, 0, -0.00579);
  MobilizedBody k7 = link(ground, -0.06934, -0.00227, 0.05498, 1.912e-5, 0.00449, -0.01228);
  MobilizedBody k6 = link(k7, 0, -0.04, 0.00706, 5.667e-7, 0.00579, 0);
  const Vec3 E(-0.028, 0, 0);
  close(k2, E, k3, Vec3(0, -0.035, 0), YAxis);
  close(k2, E, k4, Vec3(0, -0.02, 0), YAxis);
  close(k2, E, k6, Vec3(0.02, 0, 0), YAxis);
  Force::MobilityConstantForce(w.forces, k1, 0, 0.033);
  Force::TwoPointLinearSpring(w.forces, ground, Vec3(0.014, 0.072, 0), k3, Vec3(0.02, -0.018, 0),
                              4530, 0.07785);
  State s = w.system.realizeTopology();
  // β, Θ, γ, Φ, δ, Ω, ε
  const std::vector<MobilizedBody*> angles = {&k1, &k2, &k3, &k4, &k5, &k6, &k7};
  const double q0[] = {-0.0617138900142764496, 0.0,
                       0.455279819163070380,   0.222668390165885885,
                       0.487364979543842550,   -0.222668390165885885,
                       1.23054744454982119};
  for (std::size_t i = 0; i < 7; ++i) angles[i]->setOneQ(s, 0, q0[i]);
  integrate(w.system, s, accuracy, 0.03, {0.03}, a, [&](const State& x) {
    for (MobilizedBody* b : angles) a.add(b->getOneQ(x, 0));
  });
}

void heavyTop(double accuracy, Answer& a) {
  World w(0.0);
  // No body has (0.5, 0.5, 1) kg m² about a point beside its centre; so the weight is a force on a
  // body whose centre is held.
  const Body::Rigid body(MassProperties(1.0, Vec3(0), Inertia(0.5, 0.5, 1.0)));
  MobilizedBody::Ball top(w.matter.Ground(), body);
  Force::ConstantForce(w.forces, top, Vec3(0, 0, 0.5), Vec3(0, 0, -9.81));
  State s = w.system.realizeTopology();
  const Rotation tilt(Pi / 6, XAxis);
  top.setQToFitRotation(s, tilt);
  top.setUToFitAngularVelocity(s, tilt * Vec3(0, 0, 10));
  integrate(w.system, s, accuracy, 3.282429945789357, {3.282429945789357}, a, [&](const State& x) {
    const Vec3 axis = top.getBodyRotation(x) * Vec3(0, 0, 1);
    a.add(std::atan2(axis[0], -axis[1]));  // the node line is x at φ = 0
    a.add(std::atan2(std::hypot(axis[0], axis[1]), axis[2]));
  });
}

void heavyChain(double accuracy, Answer& a) {
  World w(9.81);
  std::vector<MobilizedBody> links = {w.matter.Ground()};
  for (int i = 0; i < 20; ++i)
    links.push_back(w.pin(links.back(), i == 0 ? 0 : 0.1, 0.1, 0.05, 5e-6, 8.333333333333333e-5));
  links.push_back(w.pin(links.back(), 0.1, 100, 0, 0.4, 0.4));
  State s = w.system.realizeTopology();
  links[1].setOneQ(s, 0, Pi / 4);
  integrate(w.system, s, accuracy, 2.0, {1.0, 2.0}, a, [&](const State& x) {
    const Vec3 end = links.back().getBodyOriginLocation(x);
    a.add(end[0]), a.add(end[2]);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> accuracies = {"1e-2",  "1e-3", "1e-4*", "1e-5",
                                               "1e-6*", "1e-8", "1e-10", "1e-12"};
  const std::string method = "Runge-Kutta-Merson, accuracy";
  int major = 0, minor = 0, build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return peer::serve(
      argc, argv,
      "Simbody " + std::to_string(major) + "." + std::to_string(minor) + ", of the distribution",
      {"joints in reduced coordinates, error control",
       "scenes with contact are left out: its rigid contact is a prototype without detection, its "
       "other contact yields and creeps"},
      {{"free_top", method, accuracies, freeTop},
       {"double_pendulum", method, accuracies, [](double h, Answer& a) { pendulum(h, a, false); }},
       {"rod_pendulum", method, accuracies, [](double h, Answer& a) { pendulum(h, a, true); }},
       {"pendulum", method, accuracies, bob},
       {"four_bars", method, accuracies, fourBars},
       {"andrews", method, accuracies, andrews},
       {"heavy_top", method, accuracies, heavyTop},
       {"heavy_chain", method, accuracies, heavyChain}});
}
