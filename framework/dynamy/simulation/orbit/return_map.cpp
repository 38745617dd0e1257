#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/simulation/orbit/return_map.hpp>
#include <dynamy/simulation/orbit/section_watch.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

/// Steps of the differences, as parts of the range of each coordinate: of second order for Newton's
/// method, of fourth for results, the widest of several. Their errors are about δ² and δ⁴ (forward
/// ones: δ), in unknown units; rounding adds 1e-15/δ.
constexpr double kForwardDelta = 3e-7, kCoarseDelta = 5e-6, kFineDelta = 3e-4;
constexpr double kLess = 0.2;  ///< factor on δ where the switches differ
constexpr int kAttempts = 6;
constexpr int kPeriodCorrections = 6;
/// Steps of the first return. Trial states far from the orbit may fall and tumble ever faster.
constexpr long kMostSteps = 20'000;
constexpr double kFirstStep = 1e-300;  ///< [s]: a run that begins on the section has passed it
/// A return takes at least and at most so many periods of the last one, and so many of its steps or
/// a few more.
constexpr double kLeastPeriods = 0.5, kMostPeriods = 10.0;
constexpr long kMoreSteps = 20, kFewSteps = 500;
constexpr double kLinear = 1e-10;     ///< shorter corrections take the rate that is known
constexpr double kTellsSlope = 1e-7;  ///< shorter corrections of the period drown in rounding
constexpr double kNoRange = 1e-9;     ///< a coordinate with a smaller range does not change

/// A state as the start of a run.
State asStart(State x) {
  x.t = 0.0, x.scheme.resize(0), x.impulses = {};
  return x;
}

}  // namespace

std::string OrbitSection::text() const {
  const std::string times = returns > 1 ? fmt::format(", {} times", returns) : "";
  const std::string half =
      mirror.empty() ? ""
                     : fmt::format("; mirrored after half a period: {}", fmt::join(mirror, " "));
  if (signal.empty()) return fmt::format("every {:.12g} s{}{}", period, times, half);
  return fmt::format("{} {} through {:g}{}{}", signal, falling ? "falls" : "rises", value, times,
                     half);
}

struct ReturnMap::Pass {
  double t = 0.0, slope = 0.0;
  Eigen::VectorXd range;
};

ReturnMap::ReturnMap(Model& model, OrbitSection section, double tolerance)
    : model_(model),
      section_(std::move(section)),
      mirror_(model, section_.mirror),
      end_(mirror_(section_)),
      tolerance_(tolerance),
      until_(model.simulation.until),
      variation_(model) {
  if (!section_.signal.empty()) signalNamed(model_, section_.signal);
  model_.checks.clear();
  forced_ = section_.period * section_.returns / halves();
}

/// The pass number `count` from a state on, by a run that chooses its steps.
ReturnMap::Pass ReturnMap::pass(const State& from, const Limits& limits, int count) {
  ++cycles_;
  model_.simulation.until = section_.signal.empty() ? forced_ : limits.until;
  model_.askTolerance(tolerance_);
  model_.scheme(locatedScheme(false));
  StepPlan plan;
  plan.from = &from;
  SectionWatch watch(model_, end_, limits.least, count);
  Simulation simulation(model_, &plan);
  simulation.observe(watch);
  while (!watch.found() && simulation.report().steps < limits.steps && simulation.step() &&
         !(limits.located && simulation.lastStep().counts.stepped)) {
  }
  model_.simulation.until = until_;
  const RunReport& report = simulation.report();
  if (report.ended != RunReport::Ended::finished)
    throw ModelError(fmt::format("the run ended at {:.6g} s: {}", report.t, report.reason));
  const double t = simulation.state().t;
  if (limits.located && simulation.lastStep().counts.stepped)
    throw denseSwitches(t - simulation.lastStep().dt);
  if (!watch.found() && report.steps >= limits.steps)
    throw ModelError(
        fmt::format("the motion takes {} steps in {:.3g} s, and has not come back to the "
                    "section ({})",
                    report.steps, t, end_.text()));
  if (!watch.found() && !section_.signal.empty()) throw noPass(limits.until);
  Pass out;
  out.t = section_.signal.empty() ? forced_ : watch.t(), out.slope = watch.slope();
  const Eigen::VectorXd range = watch.ranges();
  out.range = Eigen::VectorXd::Ones(variation_.size());
  const Eigen::Index nu = variation_.size() / 2;
  for (int i = 0; i < static_cast<int>(model_.systems().size()); ++i) {
    const SystemHandle& s = model_.topology().system(i);
    for (int k = 0; k < s.nu; ++k) {
      const double v = range[from.q.size() + s.u0 + k];
      if (v > kNoRange) out.range[nu + s.u0 + k] = v;
      if (s.nq == s.nu && range[s.q0 + k] > kNoRange) out.range[s.u0 + k] = range[s.q0 + k];
    }
  }
  return out;
}

ModelError ReturnMap::noPass(double until) const {
  return ModelError(
      fmt::format("the motion does not pass the section ({}) within {:g} s", end_.text(), until),
      "choose a value that the signal passes, or let the model run longer");
}

FollowedRun ReturnMap::run(const State& from, double T, const MotionSequence* steps, bool located) {
  model_.simulation.until = T;
  ++cycles_;
  std::vector<SignalAt> of;
  if (!section_.signal.empty()) of.push_back({end_.signal, T});
  try {
    FollowedRun out =
        followedRun(model_, of, tolerance_,
                    {.like = steps, .from = &from, .most = kMostSteps, .located = located});
    model_.simulation.until = until_;
    return out;
  } catch (...) {
    model_.simulation.until = until_;
    throw;
  }
}

/// Corrects the period of r until its end is on the section.
bool ReturnMap::locate(const MotionSequence* steps, Return& r, bool located) {
  const auto take = [&](const MotionSequence* plan) {
    FollowedRun f = run(r.start, r.period, plan, located);
    difference_ = plan != nullptr ? f.sequence.from(*plan) : MotionSequence::Difference();
    r.end = mirror_(f.end);
    r.sequence = std::move(f.sequence);
    return f.values.empty() ? 0.0 : f.values[0] - end_.value;
  };
  double off = take(steps);
  for (int i = 0; i < kPeriodCorrections && !difference_.any && !section_.signal.empty(); ++i) {
    const double dT = -off / r.slope;
    if (!(r.period + dT > 0.0) || !(r.period + dT <= until_)) throw noPass(until_);
    if (r.rate.size() > 0 && std::abs(dT) < kLinear * r.period) {
      r.end = variation_.added(r.end, dT * r.rate.head(variation_.size()));
      r.period += dT;
      break;
    }
    if (!(std::abs(dT) > 4.0 * std::numeric_limits<double>::epsilon() * r.period)) break;
    r.period += dT;
    const double now = take(&r.sequence);
    if (std::abs(dT) > kTellsSlope * r.period) r.slope = (now - off) / dT;
    off = now;
  }
  return !difference_.any;
}

State ReturnMap::start() {
  State x = asStart(model_.initialState());
  if (section_.signal.empty()) return x;
  if (mirror_.any()) {
    OrbitSection whole = section_;
    whole.mirror.clear();
    return ReturnMap(model_, whole, tolerance_).start();
  }
  Return r;
  const Pass p = pass(x, {-1.0, until_, kMostSteps, false}, 1);
  r.start = x, r.period = p.t, r.slope = p.slope;
  locate(nullptr, r, false);
  return asStart(r.end);
}

Return ReturnMap::from(const State& x, const Return* last) {
  Limits limits{kFirstStep, until_, kMostSteps};
  if (last != nullptr) {
    limits.least = kLeastPeriods * last->period / section_.returns;
    limits.until = std::min(until_, kMostPeriods * last->period);
    limits.steps = std::max(kFewSteps, kMoreSteps * static_cast<long>(last->sequence.steps.size()));
  }
  const Pass p = pass(x, limits, section_.returns);
  Return r;
  r.start = asStart(x), r.period = p.t, r.slope = p.slope, r.range = p.range;
  if (last != nullptr) r.rate = last->rate;
  for (int i = 0; i < 2 && !locate(nullptr, r); ++i) {
  }
  return r;
}

bool ReturnMap::like(const Return& other, const State& x, Return& out) {
  out.start = asStart(x), out.slope = other.slope;
  out.period = section_.signal.empty() ? forced_ : other.period;
  out.range = other.range, out.rate = other.rate;
  return locate(&other.sequence, out);
}

/// Change of the end and of the signal, if the start changes by z and the end time by dT.
Eigen::VectorXd ReturnMap::change(const Return& r, const Eigen::VectorXd& z, double dT,
                                  bool& same) {
  const FollowedRun f = run(variation_.added(r.start, z), r.period + dT, &r.sequence);
  difference_ = f.sequence.from(r.sequence);
  same = !difference_.any;
  Eigen::VectorXd out(variation_.size() + 1);
  out << variation_.between(mirror_(f.end), r.end),
      f.values.empty() ? 0.0 : f.values[0] - end_.value;
  return out;
}

/// Difference with the step δ, a central one if not asked otherwise; empty: runs have other switches.
Eigen::VectorXd ReturnMap::central(const Return& r, const Eigen::VectorXd& z, double dT,
                                   double delta, const MapDifferences& how) {
  bool same = true;
  const auto at = [&](double part) -> Eigen::VectorXd {
    bool one = true;
    Eigen::VectorXd out = change(r, part * delta * z, part * delta * dT, one);
    same = same && one;
    return out;
  };
  Eigen::VectorXd out = at(1.0);
  if (same && how.forward) return out / delta;
  if (same) out -= at(-1.0);
  if (same && how.fine <= 0.0) return out / (2.0 * delta);
  if (!same) return {};
  const Eigen::VectorXd wide = at(2.0);
  if (same) out = (8.0 * out - (wide - at(-2.0))) / (12.0 * delta);
  return same ? out : Eigen::VectorXd();
}

Eigen::VectorXd ReturnMap::difference(const Return& r, const Eigen::VectorXd& z, double dT,
                                      const MapDifferences& how, const std::string& of) {
  const double first = how.forward      ? kForwardDelta
                       : how.fine > 0.0 ? how.fine * kFineDelta
                                        : kCoarseDelta;
  // Of three fine ones in a row, the wider of the two that agree best.
  std::vector<Eigen::VectorXd> found;
  double delta = first;
  for (int tries = 0; tries < kAttempts && found.size() < 3; ++tries, delta *= kLess) {
    Eigen::VectorXd d = central(r, z, dT, delta, how);
    if (d.size() == 0 && found.empty()) continue;
    if (d.size() == 0 || how.fine <= 0.0) {
      if (d.size() > 0) return d;
      break;
    }
    found.push_back(std::move(d));
  }
  const auto apart = [&](int i, int k) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
    return (found[a] - found[b]).head(r.range.size()).cwiseQuotient(r.range).norm();
  };
  if (found.size() == 3) return apart(0, 1) < apart(1, 2) ? found[0] : found[1];
  if (!found.empty()) return found.back();
  refuse(difference_, of);
}

/// Throws: motions have other switches as soon as `of` changes.
void ReturnMap::refuse(const MotionSequence::Difference& d, const std::string& of) const {
  throw ModelError(
      fmt::format(
          "{:.6g} s after the section {} otherwise as soon as {} changes: the return has no "
          "derivative",
          d.t,
          d.contact == kNoContact ? "the motion goes on"
                                  : contactText(model_, d.contact) + " switches",
          of),
      "choose a section at which no contact is closed, and a start further from grazing");
}

ReturnDerivative ReturnMap::derivative(const Return& r, const MapDifferences& how) {
  const Eigen::Index n = variation_.size();
  const std::vector<std::string> names = variation_.names();
  Eigen::MatrixXd D(n + 1, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    z[i] = r.range[i];
    D.col(i) = difference(r, z, 0.0, how, names[static_cast<std::size_t>(i)]) / r.range[i];
  }
  ReturnDerivative out{D.topRows(n), Eigen::VectorXd::Zero(n), {}};
  if (section_.signal.empty()) return out;
  const double dT = r.sequence.steps.back().step.dt;
  out.rate = difference(r, Eigen::VectorXd::Zero(n), dT, how, "the time") / dT;
  out.period = -D.row(n).transpose() / out.rate[n];
  out.P += out.rate.head(n) * out.period.transpose();
  return out;
}

Eigen::VectorXd ReturnMap::byParameter(const Return& r, const ReturnDerivative& d, ReturnMap& other,
                                       double apart) {
  const Eigen::Index n = variation_.size();
  const double longer = section_.signal.empty() ? other.forced_ - r.period : 0.0;
  bool same = true;
  Eigen::VectorXd out = other.change(r, Eigen::VectorXd::Zero(n), longer, same) / apart;
  if (!same) refuse(other.difference_, "the parameter");
  if (!section_.signal.empty()) out.head(n) -= d.rate.head(n) * (out[n] / d.rate[n]);
  return out.head(n);
}

State ReturnMap::after(const Return& r) {
  State x = asStart(mirror_(r.end));  // the motion itself
  x.t = r.period;
  return run(x, 2.0 * r.period, nullptr).end;
}

}  // namespace dynamy
