#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/simulation/report/checks.hpp>

namespace dynamy {
namespace {

using Measure = CheckSettings::Measure;
constexpr int kWithin = 32;  ///< samples of a step that a scheme chose
constexpr std::size_t kMostSamples = std::size_t{1} << 20;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const char* measureText(Measure m) {
  switch (m) {
    case Measure::value:
      return "value";
    case Measure::mean:
      return "mean";
    case Measure::min:
      return "min";
    case Measure::max:
      return "max";
    case Measure::period:
      return "period";
    case Measure::count:
      return "count";
  }
  return "";
}

std::vector<const NamedSignal*> signalsOf(const Model& model) {
  std::vector<const NamedSignal*> out;
  Diagnostics faults;
  for (const CheckSettings& c : model.checks) {
    if (runFigure(c.signal) != nullptr) continue;
    out.push_back(model.signal(c.signal));
    if (out.back() != nullptr) continue;
    std::vector<std::string> known;
    for (const NamedSignal& s : model.signals()) known.push_back(s.name);
    Diagnostic d;
    d.place = c.place, d.element = "check";
    d.text = "no signal named \"" + c.signal + "\"";
    d.hint = unknownNameHint(c.signal, known);
    faults.add(d);
  }
  faults.throwIfAny();
  return out;
}

}  // namespace

void Measurement::reserve(std::size_t samples) {
  if (settings_.measure != Measure::period) return;
  times_.reserve(std::min(samples, kMostSamples));
  values_.reserve(std::min(samples, kMostSamples));
}

void Measurement::add(double t, double s, double area) {
  if (samples_ == 0) {
    t0_ = t, min_ = max_ = s;
  } else {
    integral_.add(area);
    min_ = std::min(min_, s), max_ = std::max(max_, s);
    if (s >= s_ + 0.5) ++jumps_;
  }
  if (s != std::floor(s)) whole_ = false;
  const int sign = s > 0.0 ? 1 : s < 0.0 ? -1 : sign_;
  if (sign * sign_ < 0) ++signs_;
  sign_ = sign;
  if (settings_.measure == Measure::period && samples_ % stride_ == 0) keep(t, s);
  t_ = t, s_ = s;
  ++samples_;
}

void Measurement::keep(double t, double s) {
  if (times_.size() >= kMostSamples) {  // twice the distance, half of the pairs
    for (std::size_t i = 0; 2 * i < times_.size(); ++i)
      times_[i] = times_[2 * i], values_[i] = values_[2 * i];
    times_.resize((times_.size() + 1) / 2), values_.resize(times_.size());
    stride_ *= 2;
  }
  times_.push_back(t), values_.push_back(s);
}

double Measurement::period() const {
  const double level = 0.5 * (min_ + max_), band = 0.05 * (max_ - min_);
  if (!(band > 0.0)) return kNaN;
  double first = 0.0, last = 0.0;
  long crossings = 0;
  bool armed = false;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    const double a = values_[i - 1], b = values_[i];
    if (a < level - band) armed = true;
    if (!armed || a >= level || b < level) continue;
    armed = false;
    last = times_[i - 1] + (times_[i] - times_[i - 1]) * (level - a) / (b - a);
    if (crossings++ == 0) first = last;
  }
  return crossings < 2 ? kNaN : (last - first) / static_cast<double>(crossings - 1);
}

double Measurement::result() const {
  if (samples_ == 0) return kNaN;
  switch (settings_.measure) {
    case Measure::value:
      return s_;
    case Measure::mean:
      return t_ > t0_ ? integral_.value() / (t_ - t0_) : s_;
    case Measure::min:
      return min_;
    case Measure::max:
      return max_;
    case Measure::period:
      return period();
    case Measure::count:
      return static_cast<double>(whole_ ? jumps_ : signs_);
  }
  return kNaN;
}

void Measurement::archive(Archive& a) {
  a(t0_), a(t_), a(s_), a(min_), a(max_), a(samples_), a(jumps_), a(signs_), a(stride_);
  a(sign_), a(whole_), a(integral_), a(times_), a(values_);
  if (samples_ < 0 || stride_ < 1 || times_.size() != values_.size())
    throw ModelError("the checkpoint holds a check's samples that no run takes");
}

Checks::Checks(const Model& model) : all_(model.checks), sampler_(model, signalsOf(model)) {
  const double steps = model.simulation.step > 0.0 ? model.simulation.until / model.simulation.step
                                                   : static_cast<double>(kMostSamples);
  for (const CheckSettings& c : all_) {
    if (runFigure(c.signal) != nullptr) continue;
    measurements_.emplace_back(c);
    measurements_.back().reserve(static_cast<std::size_t>(std::clamp(steps, 0.0, 1e9)) + 4);
  }
  values_.resize(measurements_.size());
}

void Checks::start(const StepView& initial) {
  t_ = initial.after.t;
  sampler_.sample(initial, 1.0, values_);
  feedStart(t_, nullptr);
  waits_ = sampler_.readsForces();
}

/// Values at the start: of forces, from the first step on; of others, before it.
void Checks::feedStart(double t, const StepView* first) {
  if (first != nullptr) sampler_.sampleForces(*first, values_);
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const CheckSettings& c = measurements_[i].settings();
    const bool wanted = c.measure == Measure::value ? c.at <= t : c.from <= t;
    if (wanted && sampler_.readsForces(i) == (first != nullptr))
      measurements_[i].add(t, values_[i]);
  }
}

void Checks::step(const StepView& view) {
  t_ = view.after.t;
  if (measurements_.empty()) return;
  if (waits_) feedStart(view.before.t, &view);
  waits_ = false;
  sampler_.sample(view, 1.0, values_);
  for (std::size_t i = 0; i < measurements_.size(); ++i) feed(view, i, values_[i]);
}

void Checks::feed(const StepView& view, std::size_t i, double end) {
  Measurement& m = measurements_[i];
  const CheckSettings& c = m.settings();
  const double tA = view.before.t, tE = view.after.t;
  const auto inside = [&](double t) { return sampler_.sampleOne(view, (t - tA) / (tE - tA), i); };
  // An instant within 1e-9 of the step's length from its end counts as the end of the step.
  const double hair = 1e-9 * (tE - tA);
  if (c.measure == Measure::value) {
    if (std::isnan(c.at)) return m.add(tE, end);
    if (c.at > tA + hair && c.at <= tE + hair) m.add(c.at, c.at >= tE - hair ? end : inside(c.at));
    return;
  }
  if (c.from > tE + hair || c.to < tA + hair) return;
  if (c.from > tA + hair && c.from < tE - hair) m.add(c.from, inside(c.from));
  const bool changes = view.report.uBeforeImpact != nullptr || view.report.counts.switches > 0;
  const double before = changes ? sampler_.sampleBeforeImpact(view, i) : end;
  if (view.scheme.choosesSteps() && c.measure == Measure::mean) {
    const double to = std::min(c.to, tE);
    const bool whole = to >= tE - hair;
    m.add(to, whole ? before : inside(to), area(view, i, std::max(c.from, tA), to));
    if (whole && changes) m.add(tE, end);
    return;
  }
  if (view.scheme.choosesSteps()) feedWithin(view, i, before);
  if (c.to >= tE - hair) {
    if (changes) m.add(tE, before);
    m.add(tE, end);
  } else {
    m.add(c.to, inside(c.to));
  }
}

/// Gauss' rule of five points on both halves: exact for polynomials of degree 9, more than that by which
/// schemes interpolate.
double Checks::area(const StepView& view, std::size_t i, double a, double b) {
  using Gauss = boost::math::quadrature::gauss<double, 5>;
  const double tA = view.before.t, dt = view.after.t - tA, middle = 0.5 * (a + b);
  if (!(b > a)) return 0.0;
  const auto signal = [&](double t) {
    return sampler_.sampleOne(view, std::clamp((t - tA) / dt, 0.0, 1.0), i);
  };
  return Gauss::integrate(signal, a, middle) + Gauss::integrate(signal, middle, b);
}

/// Feeds samples within the step. `end`: the signal at its end, before what happens there.
void Checks::feedWithin(const StepView& view, std::size_t i, double end) {
  Measurement& m = measurements_[i];
  const CheckSettings& c = m.settings();
  const double tA = view.before.t, tE = view.after.t, hair = 1e-9 * (tE - tA);
  const bool extreme = c.measure == Measure::min || c.measure == Measure::max;
  const double sign = c.measure == Measure::min ? -1.0 : 1.0;
  const double from = std::max(c.from, tA), to = std::min(c.to, tE);
  double s[3] = {kNaN, kNaN, kNaN};  // the last three
  for (int k = 0; k <= kWithin; ++k) {
    const double t = tA + (tE - tA) * k / kWithin;
    const bool inner = t > from + hair && t < to - hair;
    // The ends of a step close a parabola, so that an extreme beside them is found as well.
    const bool atEnd = extreme && (k == 0 || k == kWithin) && t >= from - hair && t <= to + hair;
    if (!inner && !atEnd) continue;
    s[0] = s[1], s[1] = s[2];
    s[2] = k == kWithin ? end : sampler_.sampleOne(view, (t - tA) / (tE - tA), i);
    if (inner) m.add(t, s[2]);
    // An extreme between samples: the signal at the vertex of the parabola through the last three.
    // An error of that place changes the value by s̈/2 times the square of the error.
    const double left = sign * (s[1] - s[0]), right = sign * (s[1] - s[2]);
    if (!extreme || !(left + right > 0.0)) continue;
    const double top = 0.5 * (left - right) / (left + right);
    if (top >= -1.0 && top <= 1.0)
      m.between(sampler_.sampleOne(view, std::clamp((k - 1 + top) / kWithin, 0.0, 1.0), i));
  }
}

void Checks::finish(const StepView& last) { t_ = last.after.t; }

CheckResult Checks::measured(const Measurement& m) const {
  const CheckSettings& c = m.settings();
  CheckResult r;
  const bool value = c.measure == Measure::value;
  if (value)
    r.over = std::isnan(c.at) ? "at the end" : "at " + numberText(c.at) + " s";
  else if (c.from > 0.0 || std::isfinite(c.to))
    r.over = "over " + numberText(c.from) + " … " +
             (std::isfinite(c.to) ? numberText(c.to) : std::string("end")) + " s";
  r.got = m.result();
  // A run that ended before the interval did has not measured what the check requests.
  const double needed = value ? c.at : c.to;
  if (std::isfinite(needed) && t_ < needed * (1.0 - 1e-9))
    r.note = "the run ended at " + numberText(t_) + " s", r.got = kNaN;
  else if (std::isnan(r.got))
    r.note = c.measure == Measure::period ? "fewer than two crossings" : "no sample";
  return r;
}

std::vector<CheckResult> Checks::results(const RunReport& report) const {
  std::vector<CheckResult> out;
  auto m = measurements_.begin();
  for (const CheckSettings& c : all_) {
    const RunFigure* figure = runFigure(c.signal);
    CheckResult r;
    if (figure != nullptr)
      r.got = figure->value(report);
    else
      r = measured(*m++);
    r.signal = c.signal, r.measure = measureText(c.measure), r.expected = c.text;
    r.low = c.low, r.high = c.high, r.place = c.place;
    r.pass = r.got >= c.low && r.got <= c.high;
    out.push_back(std::move(r));
  }
  return out;
}

void Checks::archive(Archive& a) {
  a.section("checks 2");
  for (Measurement& m : measurements_) m.archive(a);
  a(t_), a(waits_);
}

}  // namespace dynamy
