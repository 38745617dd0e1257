#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/simulation/orbit/return_map.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

/// Steps of the differences, as parts of the range of each coordinate: of second order for Newton's
/// method, of fourth for results, the widest of several. Their errors are about δ² and δ⁴ (forward
/// ones: δ), in unknown units; rounding adds 1e-15/δ.
constexpr double kForwardDelta = 3e-8, kCoarseDelta = 5e-6, kFineDelta = 3e-4;
constexpr double kLess = 0.2;  ///< factor on δ where the switches differ
constexpr int kAttempts = 6;
constexpr int kBisections = 60;  ///< to find a pass on the path of a step
constexpr int kPeriodCorrections = 6;
/// Steps of one return. Trial states far from the orbit may fall and tumble ever faster.
constexpr long kMostSteps = 20'000;
constexpr double kLinear = 1e-10;     ///< shorter corrections take the rate that is known
constexpr double kTellsSlope = 1e-7;  ///< shorter corrections of the period drown in rounding
constexpr double kNoRange = 1e-9;     ///< a coordinate with a smaller range does not change

const NamedSignal* sectionSignal(const Model& model, const std::string& name) {
  return name.empty() ? nullptr : signalNamed(model, name);
}

/// Finds the pass of the section in the steps of a run, and the ranges of its state.
class SectionWatch final : public Observer {
 public:
  SectionWatch(const Model& model, const OrbitSection& section, double least, int count)
      : section_(section),
        least_(least),
        left_(count),
        sampler_(model, section.signal.empty() ? std::vector<const NamedSignal*>()
                                               : std::vector<const NamedSignal*>{
                                                     sectionSignal(model, section.signal)}) {}
  void start(const StepView& initial) override { low = high = all(initial.after); }
  void step(const StepView& view) override {
    const Eigen::VectorXd x = all(view.after);
    low = low.cwiseMin(x), high = high.cwiseMax(x);
    if (section_.signal.empty()) return;
    const double before = side(view, 0.0);
    const bool jumps = view.report.uBeforeImpact != nullptr;
    const double reached =
        jumps ? sign() * (sampler_.sampleBeforeImpact(view, 0) - section_.value) : side(view, 1.0);
    if (view.before.t < least_ || !(before < 0.0 && reached >= 0.0) || --left_ > 0) return;
    double a = 0.0, b = 1.0;
    for (int i = 0; i < kBisections; ++i) (side(view, 0.5 * (a + b)) < 0.0 ? a : b) = 0.5 * (a + b);
    found = true;
    t = view.before.t + b * view.report.dt;
    const double part = std::min(1e-3, b);
    slope = -side(view, b - part) / (part * view.report.dt);
  }
  bool found = false;
  double t = 0.0, slope = 0.0;
  Eigen::VectorXd low, high;  ///< of q and u

 private:
  double sign() const { return section_.falling ? -1.0 : 1.0; }
  double side(const StepView& view, double theta) {
    return section_.signal.empty() ? 0.0
                                   : sign() * (sampler_.sampleOne(view, theta, 0) - section_.value);
  }
  static Eigen::VectorXd all(const State& x) {
    Eigen::VectorXd out(x.q.size() + x.u.size());
    out << x.q, x.u;
    return out;
  }
  const OrbitSection& section_;
  double least_;
  int left_;
  SignalSampler sampler_;
};

/// A state as the start of a run.
State asStart(State x) {
  x.t = 0.0, x.scheme.resize(0), x.impulses = {};
  return x;
}

}  // namespace

std::string OrbitSection::text() const {
  const std::string times = returns > 1 ? fmt::format(", {} times", returns) : "";
  if (signal.empty()) return fmt::format("every {:.12g} s{}", period, times);
  return fmt::format("{} {} through {:g}{}", signal, falling ? "falls" : "rises", value, times);
}

struct ReturnMap::Pass {
  double t = 0.0, slope = 0.0;
  Eigen::VectorXd range;
};

ReturnMap::ReturnMap(Model& model, OrbitSection section, double tolerance)
    : model_(model),
      section_(std::move(section)),
      tolerance_(tolerance),
      until_(model.simulation.until),
      variation_(model) {
  sectionSignal(model_, section_.signal);
  model_.checks.clear();
}

/// The pass number `count` from a state on, by a run that chooses its steps.
ReturnMap::Pass ReturnMap::pass(const State& from, double least, int count) {
  const double forced = section_.period * section_.returns;
  ++cycles_;
  model_.simulation.until = section_.signal.empty() ? forced : until_;
  model_.askTolerance(tolerance_);
  model_.scheme(locatedScheme(false));
  StepPlan plan;
  plan.from = &from;
  SectionWatch watch(model_, section_, least, count);
  Simulation simulation(model_, &plan);
  simulation.observe(watch);
  while (!watch.found && simulation.report().steps < kMostSteps && simulation.step()) {
  }
  model_.simulation.until = until_;
  const RunReport& report = simulation.report();
  if (report.ended != RunReport::Ended::finished)
    throw ModelError(fmt::format("the run ended at {:.6g} s: {}", report.t, report.reason));
  if (report.steps >= kMostSteps || (!watch.found && !section_.signal.empty())) throw noPass();
  Pass out;
  out.t = section_.signal.empty() ? forced : watch.t,
  out.slope = (section_.falling ? -1.0 : 1.0) * watch.slope;
  const Eigen::VectorXd range = watch.high - watch.low;
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

ModelError ReturnMap::noPass() const {
  return ModelError(fmt::format("the motion does not pass the section ({}) within {:g} s",
                                section_.text(), until_),
                    "choose a value that the signal passes, or let the model run longer");
}

FollowedRun ReturnMap::run(const State& from, double T, const MotionSequence* steps) {
  model_.simulation.until = T;
  ++cycles_;
  std::vector<SignalAt> of;
  if (!section_.signal.empty()) of.push_back({section_.signal, T});
  try {
    FollowedRun out =
        followedRun(model_, of, tolerance_, {.like = steps, .from = &from, .most = kMostSteps});
    model_.simulation.until = until_;
    return out;
  } catch (...) {
    model_.simulation.until = until_;
    throw;
  }
}

/// Corrects the period of r until its end is on the section.
bool ReturnMap::locate(const MotionSequence* steps, Return& r) {
  const auto take = [&](const MotionSequence* plan) {
    FollowedRun f = run(r.start, r.period, plan);
    difference_ = plan != nullptr ? f.sequence.from(*plan) : MotionSequence::Difference();
    r.end = std::move(f.end);
    r.sequence = std::move(f.sequence);
    return f.values.empty() ? 0.0 : f.values[0] - section_.value;
  };
  double off = take(steps);
  for (int i = 0; i < kPeriodCorrections && !difference_.any && !section_.signal.empty(); ++i) {
    const double dT = -off / r.slope;
    if (!(r.period + dT > 0.0) || !(r.period + dT <= until_)) throw noPass();
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
  Return r;
  const Pass p = pass(x, -1.0, 1);
  r.start = x, r.period = p.t, r.slope = p.slope;
  locate(nullptr, r);
  return asStart(r.end);
}

Return ReturnMap::from(const State& x, double least, const Eigen::VectorXd& rate) {
  const Pass p = pass(x, least, section_.returns);
  Return r;
  r.start = asStart(x), r.period = p.t, r.slope = p.slope, r.range = p.range;
  r.rate = rate;
  for (int i = 0; i < 2 && !locate(nullptr, r); ++i) {
  }
  for (const MotionSequence::Step& s : r.sequence.steps)
    if (s.inTime)
      throw ModelError(fmt::format("from t = {:.6g} s switches are so dense that the run steps in "
                                   "time: its return has no derivatives",
                                   s.t - s.step.dt),
                       "give a tolerance at which switches are located");
  return r;
}

bool ReturnMap::like(const Return& other, const State& x, Return& out) {
  out.start = asStart(x), out.slope = other.slope;
  out.period = section_.signal.empty() ? section_.period * section_.returns : other.period;
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
  out << variation_.between(f.end, r.end), f.values.empty() ? 0.0 : f.values[0] - section_.value;
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
  const double longer =
      section_.signal.empty() ? other.section_.period * other.section_.returns - r.period : 0.0;
  bool same = true;
  Eigen::VectorXd out = other.change(r, Eigen::VectorXd::Zero(n), longer, same) / apart;
  if (!same) refuse(other.difference_, "the parameter");
  if (!section_.signal.empty()) out.head(n) -= d.rate.head(n) * (out[n] / d.rate[n]);
  return out.head(n);
}

State ReturnMap::next(const State& x) {
  constexpr double kPassed = 1e-9;  // of the first instants: the start itself passes the section
  const Pass p = pass(x, kPassed, section_.returns);
  return asStart(run(x, p.t, nullptr).end);
}

State ReturnMap::after(const Return& r) {
  State x = asStart(r.end);
  x.t = r.period;
  return run(x, 2.0 * r.period, nullptr).end;
}

}  // namespace dynamy
