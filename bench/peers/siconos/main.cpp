/// Siconos on those scenes of bench/work_precision that its kernel states in a few lines: Moreau
/// and Jean's scheme with θ = 1/2, and its event-driven integrator LSODAR where there is no
/// friction.
#include <SiconosKernel.hpp>
#include <cmath>
#include <string>

#include "../peer.hpp"

namespace {
using peer::Answer;

constexpr double kGravity = 9.81;

/// A linear system with one contact or none, and the events or steps that move it.
class World {
 public:
  World(const std::vector<double>& q, const std::vector<double>& u, double until)
      : nsds_(std::make_shared<NonSmoothDynamicalSystem>(0.0, until)) {
    const auto n = static_cast<unsigned>(q.size());
    auto q0 = std::make_shared<SiconosVector>(n), u0 = std::make_shared<SiconosVector>(n);
    auto mass = std::make_shared<SimpleMatrix>(n, n);
    for (unsigned i = 0; i < n; ++i) (*q0)(i) = q[i], (*u0)(i) = u[i], (*mass)(i, i) = 1.0;
    system = std::make_shared<LagrangianLinearTIDS>(q0, u0, mass);
    nsds_->insertDynamicalSystem(system);
  }
  void stiffness(double k) {
    const auto n = static_cast<unsigned>(system->dimension());
    auto matrix = std::make_shared<SimpleMatrix>(n, n);
    (*matrix)(0, 0) = k;
    system->setKPtr(matrix);
  }
  void force(const std::vector<double>& f) {
    auto vector = std::make_shared<SiconosVector>(static_cast<unsigned>(f.size()));
    for (unsigned i = 0; i < f.size(); ++i) (*vector)(i) = f[i];
    system->setFExtPtr(vector);
  }
  /// Contact of the last coordinate with zero; friction along the first one if mu > 0.
  void contact(double e, double mu) {
    const auto n = static_cast<unsigned>(system->dimension());
    auto h = std::make_shared<SimpleMatrix>(mu > 0 ? 2 : 1, n);
    (*h)(0, n - 1) = 1.0;
    if (mu > 0) (*h)(1, 0) = 1.0;
    auto relation = std::make_shared<LagrangianLinearTIR>(h);
    SP::NonSmoothLaw law;
    if (mu > 0)
      law = std::make_shared<NewtonImpactFrictionNSL>(e, 0.0, mu, 2);
    else
      law = std::make_shared<NewtonImpactNSL>(e);
    nsds_->link(std::make_shared<Interaction>(law, relation), system);
    friction_ = mu > 0;
  }
  template <class Sample>
  void steps(double h, const std::vector<double>& times, Answer& a, Sample&& sample) {
    auto time = std::make_shared<TimeDiscretisation>(0.0, h);
    SP::OneStepNSProblem problem;
    if (friction_)
      problem = std::make_shared<FrictionContact>(2);
    else
      problem = std::make_shared<LCP>();
    auto s =
        std::make_shared<TimeStepping>(nsds_, time, std::make_shared<MoreauJeanOSI>(0.5), problem);
    s->initialize();
    a.start();
    peer::march(
        h, times.back(), times, a,
        [&] {
          s->computeOneStep();
          s->nextStep();
        },
        sample);
    a.stop();
  }
  template <class Sample>
  void events(double h, const std::vector<double>& times, Answer& a, Sample&& sample) {
    auto time = std::make_shared<TimeDiscretisation>(0.0, h);
    auto s = std::make_shared<EventDriven>(nsds_, time);
    s->insertIntegrator(std::make_shared<LsodarOSI>());
    s->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_IMPACT);
    s->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_SMOOTH_ACC);
    s->initialize();
    std::size_t next = 0;
    a.start();
    while (next < times.size() && s->hasNextEvent()) {
      s->advanceToEvent();
      s->processEvents();
      ++a.evaluations;
      if (std::abs(s->startingTime() - times[next]) < 1e-9) sample(next), ++next;
    }
    a.stop();
  }
  double q(unsigned i) const { return (*system->q())(i); }
  double u(unsigned i) const { return (*system->velocity())(i); }
  SP::LagrangianLinearTIDS system;

 private:
  SP::NonSmoothDynamicalSystem nsds_;
  bool friction_ = false;
};

void bouncingBall(double h, Answer& a, bool events) {
  World w({1.0}, {0.0}, 1.7);
  w.force({-kGravity});
  w.contact(0.5, 0.0);
  const std::vector<double> times = {0.6, 1.0, 1.2, 1.3, 1.6};
  const auto sample = [&](std::size_t) { a.add(0.1 + w.q(0)); };
  if (events)
    w.events(h, times, a, sample);
  else
    w.steps(h, times, a, sample);
}

void slope(double h, Answer& a, bool stick) {
  const double angle = 20.0 * std::acos(-1.0) / 180.0;
  World w({0.0, 0.0}, {stick ? 0.0 : 2.0, 0.0}, stick ? 11.0 : 2.1);
  w.force({-kGravity * std::sin(angle), -kGravity * std::cos(angle)});
  w.contact(0.0, stick ? 0.5 : 0.3);
  w.steps(h, stick ? std::vector<double>{10.0} : std::vector<double>{0.2, 1.0, 2.0}, a,
          [&](std::size_t) { a.add(peer::placeOnSlope(w.q(0))); });
}

void coulombOscillator(double h, Answer& a) {
  World w({0.5, 0.0}, {0.0, 0.0}, 5.1);
  w.stiffness(100.0);
  w.force({0.0, -kGravity});
  w.contact(0.0, 0.2);
  w.steps(h, {1.0, 2.1, 3.3, 4.0, 5.0}, a, [&](std::size_t) { a.add(w.q(0)); });
}

/// In z = −x, so that the wall is at zero.
void impactOscillator(double h, Answer& a, bool events) {
  World w({0.0}, {0.8 * 1.8987487383113}, 30.5);
  w.stiffness(1.0);
  w.system->setComputeFExtFunction([](double t, unsigned, double* f, unsigned, double*) {
    f[0] = -std::cos(2.2 * t + 2.8037865749721);
  });
  w.contact(0.8, 0.0);
  const auto sample = [&](std::size_t) { a.add(-w.q(0)), a.add(-w.u(0)); };
  if (events)
    w.events(h, {28.0, 30.0}, a, sample);
  else
    w.steps(h, {28.0, 30.0}, a, sample);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> oscillator = {"5e-2*", "2e-2*", "1e-2", "5e-3",
                                               "2e-3",  "1e-3",  "2e-4"};
  const std::string moreau = "Moreau-Jean, theta 1/2", lsodar = "event-driven, LSODAR";
  return peer::serve(
      argc, argv, "Siconos 4.4.0, kernel of the distribution",
      {"hard contact and exact Coulomb friction in the plane; a block on a slope is a point",
       "its event-driven integrators take no friction; only scenes of linear systems are stated"},
      {{"bouncing_ball", moreau, peer::kBallSteps,
        [](double h, Answer& a) { bouncingBall(h, a, false); }},
       {"bouncing_ball", lsodar, {"0.1*"}, [](double h, Answer& a) { bouncingBall(h, a, true); }},
       {"slope_slide", moreau, peer::kBallSteps, [](double h, Answer& a) { slope(h, a, false); }},
       {"slope_stick", moreau, peer::kRestSteps, [](double h, Answer& a) { slope(h, a, true); }},
       {"coulomb_oscillator",
        moreau,
        {"2e-2", "1e-2*", "5e-3", "2e-3", "1e-3", "2e-4", "1e-4"},
        coulombOscillator},
       {"impact_oscillator", moreau, oscillator,
        [](double h, Answer& a) { impactOscillator(h, a, false); }},
       {"impact_oscillator", lsodar, {"1*", "0.1", "0.01"}, [](double h, Answer& a) {
          impactOscillator(h, a, true);
        }}});
}
