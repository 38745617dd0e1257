// What an asked tolerance gives: error ≤ 10 K tol, K ≥ 1 the measured amplification of a disturbed
// start. Truth is a run at 1e-13; that such runs are true, located_switching_test.cpp shows. The
// table that is printed stands in doc/theory/50.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <reference/located_run.hpp>
#include <reference/located_scenes.hpp>

namespace dynamy::reference {
namespace {

using namespace scenes;

struct Case {
  const char* name;
  const std::string scene;
  double until;
  /// Which numbers of (q, u) may be disturbed without opening or breaking a contact.
  std::vector<int> disturbed;
};

struct End {
  State x;
  long evaluations = 0, switches = 0;
};

/// The scheme alone, from a start of which number `which` of (q, u) is moved by `by`.
End run(const Case& c, double tolerance, int which = -1, double by = 0.0) {
  LocatedRun loaded(c.scene, tolerance, c.until);
  Model& m = loaded.model();
  MechanicalSystem s = m.mechanicalSystem();
  End e;
  e.x = m.initialState();
  const auto nq = static_cast<int>(e.x.q.size());
  if (which >= nq)
    e.x.u[which - nq] += by;
  else if (which >= 0)
    e.x.q[which] += by;
  m.scheme().aim({tolerance, m.length()});
  while (c.until - e.x.t > 1e-14 * c.until) {
    const StepReport r = m.scheme().step(s, m.solver(), e.x, c.until - e.x.t);
    e.switches += r.counts.switches;
    if (!r.refused.empty()) {
      ADD_FAILURE() << c.name << ": " << r.refused;
      break;
    }
  }
  e.evaluations = s.evaluations();
  return e;
}

/// Largest difference in the norm of the scheme, without its tolerance.
double difference(const Case& c, const End& a, const End& b) {
  LocatedRun loaded(c.scene, 1.0, c.until);
  Model& m = loaded.model();
  MechanicalSystem s = m.mechanicalSystem();
  const State x = m.initialState();
  s.evaluate(x);
  ErrorNorm norm;
  norm.start(s, x, 0, 1.0, m.length());
  double worst = 0.0;
  for (Eigen::Index i = 0; i < x.q.size(); ++i)
    worst = std::max(worst, norm.position(i, a.x.q[i] - b.x.q[i], b.x.q[i]));
  for (Eigen::Index i = 0; i < x.u.size(); ++i)
    worst = std::max(worst, norm.velocity(i, a.x.u[i] - b.x.u[i], b.x.u[i]));
  return worst;
}

double amplification(const Case& c, const End& truth) {
  constexpr double kBy = 1e-7;
  double K = 1.0;
  for (const int i : c.disturbed) {
    const End e = run(c, 1e-12, i, kBy);
    K = std::max(K, difference(c, e, truth) / kBy);
  }
  return K;
}

TEST(LongLocatedCalibration, ErrorsAreWithinTenTimesKTimesTheTolerance) {
  const std::vector<Case> cases = {
      {"ball, e = 0.5, to rest", kBall, 1.6, {0, 1}},
      {"impact oscillator", kImpactOscillator, 10.0, {1}},
      {"belt, two levels", kBelt, 20.0, {0}},
      {"belt, weakening", kWeakeningBelt, 20.0, {0}},
      {"bead in a slot", kSlot, 0.5, {0}},
      {"ladder", kLadder, 0.65, {}},
      {"dry friction", "coulomb_oscillator", 5.0, {0}},
      {"rocking block", "rocking_block", 2.0, {}},
      {"woodpecker", "woodpecker", 0.16, {2, 5}},
      {"double pendulum", kDoublePendulum, 3.0, {0, 1}},
      {"two rods", kRodPendulum, 3.0, {}},
      {"free top", kTop, 10.0, {7, 8, 9}},
  };
  int all = 0, within = 0;
  for (const Case& c : cases) {
    const End truth = run(c, 1e-13);
    const double K = amplification(c, truth);
    std::printf("| %s | %.1f |", c.name, K);
    for (int d = 3; d <= 10; ++d) {
      const double tol = std::pow(10.0, -d);
      const End e = run(c, tol);
      const double error = difference(c, e, truth), ratio = error / (K * tol);
      std::printf(" %.2g (%ld) |", ratio, e.evaluations);
      ++all, within += ratio <= 10.0 ? 1 : 0;
      EXPECT_LE(ratio, 100.0) << c.name << " at " << tol;
    }
    std::printf("\n");
  }
  EXPECT_GE(within, static_cast<int>(std::ceil(0.98 * all)));
}

}  // namespace
}  // namespace dynamy::reference
