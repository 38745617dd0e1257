#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/event_driven.hpp>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

LocatedSettings textbook(StiffSteps stiff) {
  return {.stiff = stiff, .method = &dormandPrince5(), .events = EventPolicy::textbook()};
}

}  // namespace

EventDriven::EventDriven() : motion_(textbook(StiffSteps::automatic)) {}

EventDriven::EventDriven(const Parameters& x)
    : OneStep(x), motion_(textbook(LocatedDormandPrince::stiffOf(x))) {}

void EventDriven::declare(Attributes& a) {
  a.about(
      "The event-driven scheme of the textbooks: Dormand and Prince's method of order 5 between "
      "events, which are found by roots; there the impact law and one inclusion on the level of "
      "accelerations. It stalls where impacts accumulate; for comparison.");
  LocatedDormandPrince::declareStiff(a);
  a.example("<simulation until=\"1\" tolerance=\"1e-6\"><EventDriven/></simulation>");
}

/// Reads the state of x. False: it is not one of this scheme and model.
bool EventDriven::load(const MechanicalSystem& s, const State& x) {
  NumberArchive numbers(x.scheme);
  numbers(kept_);
  const auto systems = static_cast<Eigen::Index>(s.parts().topology->systems().size());
  if (!numbers.good() || !numbers.atEnd() || !kept_.held.fits(s.parts()) || !(kept_.time > 0.0) ||
      kept_.times.size() != systems)
    return false;
  motion_.scales(s, kept_.time, kept_.times);
  return true;
}

StepReport EventDriven::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  StepReport report;
  LocatedMotion::Start start;
  const bool first = x.scheme.size() == 0;
  start.goesOn =
      !first && x.scheme.size() == stored_.size() && x.scheme == stored_ && motion_.endsAt(s, x);
  if (!first && !start.goesOn) {
    if (!load(s, x)) {
      report.refused = "the checkpoint holds what this scheme does not leave in a state";
      return report;
    }
    start.held = &kept_.held;
  }
  stored_.resize(0);
  if (const Refusal refusal = motion_.advance(s, solver, x, start, dt, report)) {
    refusal_ = refusal.why;
    report.refused = refusal_;
    return report;
  }
  const State& end = motion_.end();
  const double t = x.t;
  x.t = end.t == t + dt ? t + dt : end.t;
  x.q = end.q, x.u = end.u, x.memory = end.memory;
  report.dt = x.t - t;
  const ErrorNorm& norm = motion_.parts().norm;
  motion_.keep(kept_.held);
  kept_.time = norm.time(), kept_.times = norm.times();
  NumberArchive numbers;
  numbers(kept_);
  numbers.copyTo(x.scheme);
  stored_ = x.scheme;
  motion_.report(s, x, report);
  return report;
}

void EventDriven::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                              double theta, State& out) const {
  if (!motion_.interpolate(s, a, b, theta, out)) OneStep::interpolate(s, a, b, theta, out);
}

bool EventDriven::contactsAt(const MechanicalSystem& s, const State& at, bool after,
                             ContactInstant& out) const {
  return motion_.contactsAt(s, at, after, out);
}

}  // namespace dynamy
