/// Bodies that turn far in a step, up to several times round: attitudes stay rotations, a constant
/// spin is exact, and a scheme that cannot follow a tumbling body says so.
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kRotationStep = 1e-3;

const char* const kSchemes[] = {"MoreauMidpoint",    "StaggeredMoreau",  "EnergyMomentum",
                                "HalfExplicitEuler", "HalfExplicitHeun", "StewartTrinkle",
                                "AnitescuPotra",     "PaoliSchatzman",   "ThetaMethod",
                                "NonsmoothRattle",   "GeneralizedAlpha", "Ggl",
                                "ConstraintIndex"};

std::string body(const std::string& scheme, const std::string& inertia, const std::string& Omega) {
  return "<dynamy version=\"1\"><systems><RigidBody name=\"body\" mass=\"1\" inertia=\"" + inertia +
         "\" angularVelocity=\"" + Omega +
         "\"/><Ground name=\"world\"/></systems><simulation until=\"0.1\" step=\"1e-3\"><" +
         scheme + "/></simulation></dynamy>";
}

class LargeRotation : public testing::TestWithParam<const char*> {};

TEST_P(LargeRotation, ASpinAboutAPrincipalAxisIsExact) {
  // 1e4 rad/s: 1.6 turns per step. A ball about any axis, a body of three moments about its own.
  struct Case {
    const char *inertia, *Omega;
    Vec3 axis;
  };
  const double w = 1e4;
  for (const Case& c :
       {Case{"1 1 1", "6000 0 8000", Vec3(0.6, 0.0, 0.8)},
        Case{"1 2 2.5", "0 0 1e4", Vec3::UnitZ()}, Case{"1 2 2.5", "0 1e4 0", Vec3::UnitY()}}) {
    Scene scene("body", {.text = body(GetParam(), c.inertia, c.Omega)});
    double norm = 0.0, off = 0.0;
    scene.run(0.1, kRotationStep, [&] {
      const Eigen::VectorXd p = scene.q("body").tail<4>();
      norm = std::max(norm, std::abs(p.norm() - 1.0));
      double truth[4];
      axisQuaternion(c.axis, w * scene.state().t, truth);
      const Eigen::Map<const Eigen::Vector4d> q(truth);
      off = std::max(off, std::min((p - q).norm(), (p + q).norm()));
    });
    EXPECT_LT(norm, 1e-12) << c.Omega;  // F10
    // 100 half angles of 5 rad, each rounded to eps/2 of 5 rad by the product Δt Ω and of 500 rad
    // by the truth's: 1e-13.
    EXPECT_LT(off, 1e-12) << c.Omega;
    EXPECT_NEAR(scene.u("body").tail<3>().norm(), w, 1e-8) << c.Omega;
    EXPECT_TRUE(scene.solved()) << c.Omega;
  }
}

TEST_P(LargeRotation, ATumblingBodyKeepsItsQuaternionOrTheRunSaysWhyNot) {
  // Three moments, off the axes: 0.02 … 15 rad per step. Explicit gyroscopic terms gain energy and
  // end in numbers that are not finite; implicit ones miss their equations.
  for (const double w : {10.0, 100.0, 1000.0, 6000.0}) {
    Scene scene("body", {.text = body(GetParam(), "1 2 2.5",
                                      std::to_string(w) + " " + std::to_string(w) + " " +
                                          std::to_string(2.0 * w))});
    Simulation simulation(scene.model());
    const RunReport& r = simulation.run();
    if (r.ended == RunReport::Ended::failed) {
      EXPECT_NE(r.reason.find("<RigidBody name=\"body\">"), std::string::npos) << r.reason;
      continue;
    }
    EXPECT_LT(std::abs(simulation.state().q.tail<4>().norm() - 1.0), 1e-12) << w;
    const double change = std::abs(r.energy.end() - r.energy.start()) / r.energy.start();
    // Not in silence: the ledger books it, or the step is reported as not solved.
    EXPECT_TRUE(r.solver.unconverged > 0 ||
                std::abs(r.energy.discretisation) > 0.99 * change * r.energy.start() - 1e-9)
        << w << ": " << change;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, LargeRotation, testing::ValuesIn(kSchemes));

}  // namespace
}  // namespace dynamy::reference
