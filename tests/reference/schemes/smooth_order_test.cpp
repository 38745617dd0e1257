/// Orders of the methods for smooth phases in a contact that lasts: a point slides with friction
/// through a curved bowl (theory 52.2). Fixed steps of SmoothStep, no projection.
#include <gtest/gtest.h>

#include <complex>
#include <dynamy/located/phase/gragg_tableau.hpp>
#include <dynamy/located/phase/smooth_step.hpp>
#include <reference/located/located_run.hpp>
#include <reference/order.hpp>
#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

constexpr double kMu = 0.2, kEnd = 0.8;

/// A method by its table, half-explicit by its columns, or neither: Radau IIA.
struct Method {
  const char* name;
  double order;
  const ButcherTableau* table = nullptr;
  int columns = 0;
  int fewest = 1;  ///< steps: in longer ones the powers after the first show
};

/// Slides from 0 to kEnd in n steps with the status of the contact held; error of q and u.
double slideError(const Method& method, int n) {
  const ButcherTableau* table = method.table;
  Scene scene("bowl", {.text = modelWith("MoreauMidpoint", Bowl::sections(kMu))});
  MechanicalSystem& s = scene.system();
  SmoothStep smooth;
  smooth.prepare(s, table ? *table : dormandPrince8());
  PhasePoint from, to;
  from.x = scene.state();
  s.evaluate(from.x, {.bias = true});
  ErrorNorm norm;
  norm.start(s, from.x, 0, 1e-12, 1.0,
             s.slot(0).contacts);  // what Newton's method leaves of Radau's equations
  smooth.halfExplicit(method.columns);
  smooth.implicit(table == nullptr && method.columns == 0, s, norm);
  FrozenPhase phase;
  Held held;
  held.key = s.slot(0).contacts.key.at(0);
  held.slips = true, held.sign = 1.0;
  phase.held = {held};
  phase.request.keys = {held.key};
  const auto accelerate = [&](PhasePoint& p) {
    s.evaluate(p.x, phase.request.in(0));
    EXPECT_TRUE(phase.accelerate(s.slot(0), p.x.u, p.a)) << phase.fault();
    p.lambda = phase.lambda(), p.power = phase.power();
    smooth.rates(s, p);
  };
  accelerate(from);
  for (int k = 0; k < n; ++k) {
    to.x.memory = from.x.memory;
    if (!smooth.take(s, phase, from, kEnd / n, to.x)) return 1.0;  // too long for Newton's method
    accelerate(to);
    std::swap(from, to);
  }
  const Truth truth = Bowl::truth(kMu, kEnd);
  return std::max((from.x.q - truth.q).norm(), (from.x.u - truth.u).norm());
}

/// The same motion by n blocks of Studer's extrapolation of Moreau's rule, `order` rows.
double augmentedError(int order, int n) {
  Scene scene("bowl", {.text = modelWith("AugmentedMoreau order=\"" + std::to_string(order) +
                                             "\" dtMin=\"1e-12\"",
                                         Bowl::sections(kMu))});
  scene.run(kEnd, kEnd / n);
  EXPECT_TRUE(scene.solved());
  const Truth truth = Bowl::truth(kMu, kEnd);
  return std::max((scene.q("p") - truth.q).norm(), (scene.u("p") - truth.u).norm());
}

/// Slope over those of 1, √2, 2, 2√2 … steps whose error lies between `least` and 1e-4.
template <class Error>
Fit orderOf(const Error& errorOf, double least, int fewest, std::ostringstream& log) {
  std::vector<double> h, error;
  for (int k = 0; k <= 24; ++k) {
    const int n = static_cast<int>(std::lround(std::exp2(0.5 * k)));
    const double e = errorOf(n);
    if (e < least) break;
    if (e > 1e-4 || n < fewest) continue;
    h.push_back(kEnd / n), error.push_back(e);
    log << "  " << n << " steps: " << e << '\n';
  }
  EXPECT_GE(h.size(), 3U);
  return fitOrder(h, error);
}

TEST(SmoothOrder, MethodsHaveTheirOrderInLastingFrictionOnACurvedSurface) {
  const Method rows[] = {{"Gragg 2", 2, &graggTableau(2)},
                         {"Gragg 4", 4, &graggTableau(4)},
                         {"Gragg 6", 6, &graggTableau(6)},
                         {"Gragg 8", 8, &graggTableau(8), 0, 8},
                         {"half-explicit Gragg 2", 2, nullptr, 1},
                         {"half-explicit Gragg 4", 4, nullptr, 2},
                         {"half-explicit Gragg 6", 6, nullptr, 3},
                         {"half-explicit Gragg 8", 8, nullptr, 4, 8},
                         {"Dormand and Prince 8", 8, &dormandPrince8()},
                         {"Radau IIA", 5}};
  for (const Method& row : rows) {
    std::ostringstream log;
    // Of implicit steps what Newton's method leaves of 1e-12 in each has a part below that.
    const double least = row.table != nullptr || row.columns > 0 ? 1e-13 : 1e-12;
    const Fit fit = orderOf([&](int n) { return slideError(row, n); }, least, row.fewest, log);
    // Dormand and Prince's has so small a principal error that the next power shows: 8.2.
    const double above = row.table == &dormandPrince8() ? 0.3 : 0.2;
    EXPECT_GT(fit.order, row.order - 0.2) << row.name << '\n' << log.str();
    EXPECT_LT(fit.order, row.order + above) << row.name << '\n' << log.str();
    RecordProperty(row.name, std::to_string(fit.order));
  }
}

TEST(SmoothOrder, StudersExtrapolationLosesOneThere) {
  for (const int order : {2, 3, 4, 6}) {
    std::ostringstream log;
    // What the solver leaves of each sub-step is 1e-12 in the end.
    const Fit fit = orderOf([&](int n) { return augmentedError(order, n); }, 3e-12, 8, log);
    EXPECT_NEAR(fit.order, order - 1, 0.2) << order << '\n' << log.str();
    RecordProperty("Studer " + std::to_string(order), std::to_string(fit.order));
  }
}

/// x'' = −10⁶(x − sin t) − 2·10⁴x', −50.13 and −19950 1/s, beside y'' = −y − 0.1y'.
const char* const kStiff =
    "<dynamy version=\"1\"><simulation until=\"10\" tolerance=\"1e-6\"/><systems><Coordinates "
    "name=\"x\" q=\"x y\" q0=\"0 1\" u0=\"0 0\" M=\"1 ; 0 ; 1\" h=\"-1e6*(x - sin(t)) - 2e4*x_dot "
    "; "
    "-y - 0.1*y_dot\"/></systems></dynamy>";

TEST(StiffForces, ATakenToleranceIsMetWithImplicitSteps) {
  // x → Im(10⁶/(10⁶ − 1 + 2·10⁴i) e^{it}); its own motion, e^{−501} at 10 s, has gone.
  const std::complex<double> i(0.0, 1.0), e = std::exp(10.0 * i);
  const std::complex<double> x = 1e6 / (1e6 - 1.0 + 2e4 * i) * e;
  const double w = std::sqrt(1.0 - 0.05 * 0.05);
  const double y = std::exp(-0.5) * (std::cos(10.0 * w) + 0.05 / w * std::sin(10.0 * w));
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-11}) {
    LocatedRun run(kStiff, tolerance, 10.0);
    run.run();
    const State& end = run.state();
    // The error of a step is within the tolerance, and the motion damps errors.
    EXPECT_NEAR(end.q[0], x.imag(), 10.0 * tolerance);
    EXPECT_NEAR(end.u[0], (i * x).imag(), 10.0 * tolerance);
    EXPECT_NEAR(end.q[1], y, 10.0 * tolerance);
    // Explicit steps are as short as 6/19950 s: 33 000 steps of 12.
    // A Jacobian of four unknowns in each of 1300 steps at 1e-9 would take 5000 more.
    // At 1e-11 explicit steps are at h|λ| = 1.4 and took 1.7 million.
    EXPECT_LT(run.report().cost.evaluations, tolerance < 1e-10  ? 35000
                                             : tolerance < 1e-8 ? 12000
                                                                : 2500)
        << tolerance;
  }
}

TEST(StiffForces, AResumedRunTakesItsJacobianWhereItWasTaken) {
  LocatedRun whole(kStiff, 1e-6, 10.0), first(kStiff, 1e-6, 4.0), second(kStiff, 1e-6, 10.0);
  whole.run(), first.run();
  second.simulation().resume(first.simulation().checkpoint());
  second.run();
  EXPECT_EQ(second.state().q, whole.state().q);
  EXPECT_EQ(second.state().u, whole.state().u);
}

/// A bob of 10 g on a rod of 10⁶ N/m and 300 N s/m, 0.51 m, hung at 45° from a ball of 1 kg that
/// rolls: the rod relaxes at 26 000 and 3800 1/s, and turns.
const char* const kBob =
    "<dynamy version=\"1\"><systems><RigidBody name=\"ball\" position=\"0 0 0.1\"><Sphere "
    "radius=\"0.1\" mass=\"1\" material=\"stone\"/></RigidBody><PointMass name=\"bob\" "
    "position=\"{0.51*sqrt(0.5)} 0 {0.1 - 0.51*sqrt(0.5)}\" mass=\"0.01\"/><Ground "
    "name=\"world\"><HalfSpace material=\"floor\"/></Ground></systems><forces><Gravity "
    "acceleration=\"0 0 -9.81\"/><SpringDamper between=\"ball bob\" stiffness=\"1e6\" "
    "damping=\"300\" length=\"0.51\"/></forces><elements><Contact between=\"stone "
    "floor\"><UnilateralCoulomb mu=\"0.5\"/></Contact></elements><simulation until=\"5\" "
    "tolerance=\"1e-6\"/></dynamy>";

TEST(StiffForces, ImplicitStepsBeginAlsoWhereTheFastPartIsKeptAccurate) {
  // At 1e-9 explicit steps stay at h|λ| = 1.2, far below their bound of stability, and took 226 800
  // evaluations for 1 s; implicit ones from the start on (stiff="always") take kAlways. Before the
  // trial begins 150 steps of 12 evaluations go by; twice that.
  constexpr long kAlways = 23200;
  LocatedRun run(kBob, 1e-9, 1.0);
  EXPECT_EQ(run.run().ended, RunReport::Ended::finished);
  EXPECT_LT(run.report().cost.evaluations, kAlways + 2 * 150 * 12);
}

/// Twenty links of 0.1 kg with 100 kg at their end, let go taut from 45°, in the coordinates of the
/// joints: undamped frequencies up to 1700 rad/s that hardly move.
const char* const kTautChain =
    "<dynamy version=\"1\"><parameter name=\"s\" value=\"{0.1*sqrt(0.5)}\"/><systems><replicate "
    "count=\"20\"><RigidBody name=\"link\" position=\"{s*(i+0.5)} 0 {-s*(i+0.5)}\" euler=\"0 45deg "
    "0\" mass=\"0.1\" inertia=\"5e-6 8.333333333333333e-5 8.333333333333333e-5\"/></replicate>"
    "<RigidBody name=\"end\" position=\"{20*s} 0 {-20*s}\" mass=\"100\" inertia=\"0.4 0.4 0.4\"/>"
    "<Ground name=\"world\"/></systems><forces><Gravity acceleration=\"0 0 -9.81\"/></forces>"
    "<elements><Spherical between=\"world link[0]\" at=\"0 0 0\"/><replicate "
    "count=\"19\"><Spherical "
    "between=\"link[{i}] link[{i+1}]\" at=\"{s*(i+1)} 0 {-s*(i+1)}\"/></replicate><Spherical "
    "between=\"link[19] end\" at=\"{20*s} 0 {-20*s}\"/></elements><simulation until=\"1\" "
    "tolerance=\"1e-3\" coordinates=\"minimal\"/></dynamy>";

TEST(StiffForces, ImplicitStepsThatCostMoreAreGivenUp) {
  // A Jacobian of 147 unknowns and its factors are worth some 330 evaluations, a step of order 8
  // twelve. The explicit steps alone take about 2700 a second; a trial may cost what they did
  // before it, and one more: at most three times as much in all, and no more than a tenth after.
  LocatedRun run(kTautChain, 1e-3, 1.0);
  EXPECT_EQ(run.run().ended, RunReport::Ended::finished);
  EXPECT_LT(run.report().cost.evaluations, 5000);
}

}  // namespace
}  // namespace dynamy::reference
