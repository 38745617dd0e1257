#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <dynamy/integrator/switch_search.hpp>

namespace dynamy {
namespace {

constexpr double kForceNoise = 1e-12;  ///< of the largest force
constexpr int kHalvings = 46;          ///< for monitors that start at zero: θ down to 1e-15
constexpr int kForceHalvings = 20;
constexpr int kMostRefinements = 160;
constexpr double kJump = 0.1;         ///< of the fall of a force over the first bracket
constexpr double kRootWidth = 1e-14;  ///< of roots of gaps and slips
constexpr double kAside = 0.25;       ///< of the fall; half of it for a jump
constexpr double kJumpWidth = 1e-13;  ///< a jump is not found more closely, as a part of the step
/// Of the fall over a bracket: a larger value is no root, though the last slope, which may be that
/// over a jump, says so.
constexpr double kSmall = 1e-2;
constexpr double kStart = 1e3;  ///< of the noise: a value that starts below starts at zero
/// A gap whose smallest value is below this share of its range in the step is looked at again.
constexpr double kNear = 0.02;
constexpr double kRough = 0.1;         ///< of the largest force: a second difference that is large,
constexpr double kRoughSamples = 0.3;  ///< of the range of a slip
constexpr double kMinimum = 1e-5;      ///< how closely the minimum is found, as a part of the step

}  // namespace

void SwitchSearch::prepare(double gapNoise, double speedNoise) {
  gapNoise_ = gapNoise, speedNoise_ = speedNoise;
}

bool SwitchSearch::begin(ContactProbe& probe, const FrozenPhase& phase, const State& x) {
  kinematic_.clear(), force_.clear();
  at_.memory = x.memory;
  if (!probe.look(x)) return false;
  using Watched = Monitor::Kind;
  for (int i = 0; i < probe.size(); ++i)
    if (probe.law(i).unilateral() && phase.find(probe.key(i)) == nullptr)
      kinematic_.push_back({Watched::gap, i, 0, 1.0, false, probe.key(i)});
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const Held& h = phase.held[i];
    const FrozenPhase::Form form = phase.form(i);
    double margin = 0.0;
    const bool muted = h.mutedUntil > x.t;
    const int row = h.first + phase.slip0(i) - phase.row0(i);
    if (h.slips && form == FrozenPhase::Form::notch)
      kinematic_.push_back({Watched::gap, probe.find(h.key), 0, h.sign, false, h.key});
    else if (h.slips && phase.slipRows(i) == 1 && !muted && !phase.idle(i))
      kinematic_.push_back({Watched::slip, probe.find(h.key), row, h.sign, false, h.key});
    if (phase.margin(i, margin) && (!muted || form == FrozenPhase::Form::normal || h.slips))
      force_.push_back({Watched::force, static_cast<int>(i), 0, 1.0, false, h.key});
  }
  for (std::size_t i = 0; i < probe.switching().size(); ++i)
    kinematic_.push_back(
        {Watched::latch, static_cast<int>(i), 0, 1.0, false, probe.announcements().switcher(i)});
  values_.resize(static_cast<Eigen::Index>(kinematic_.size()), kSamples + 1);
  rates_.setZero(values_.rows(), values_.cols());
  column(probe, 0);
  for (std::size_t m = 0; m < kinematic_.size(); ++m)
    kinematic_[m].zeroStart =
        values_(static_cast<Eigen::Index>(m), 0) <= kStart * noise(kinematic_[m]);
  if (x.t == end_ && endForces_.size() == static_cast<Eigen::Index>(force_.size()))
    startForces_ = endForces_;
  else
    forces(phase, startForces_);
  for (std::size_t m = 0; m < force_.size(); ++m)
    force_[m].zeroStart = startForces_[static_cast<Eigen::Index>(m)] <= kForceNoise;
  return true;
}

double SwitchSearch::measure(const ContactProbe& probe, const Monitor& m) const {
  if (m.kind == Monitor::Kind::latch)
    return -probe.switching()[static_cast<std::size_t>(m.contact)];
  return m.sign * (isGap(m) ? probe.gap(m.contact) : probe.gamma(m.contact, m.row));
}

double SwitchSearch::rate(const ContactProbe& probe, const Monitor& m) const {
  return isGap(m) ? m.sign * probe.gamma(m.contact) : 0.0;
}

void SwitchSearch::column(const ContactProbe& probe, int sample) {
  for (std::size_t m = 0; m < kinematic_.size(); ++m) {
    values_(static_cast<Eigen::Index>(m), sample) = measure(probe, kinematic_[m]);
    rates_(static_cast<Eigen::Index>(m), sample) = rate(probe, kinematic_[m]);
  }
}

void SwitchSearch::forces(const FrozenPhase& phase, Eigen::VectorXd& out) const {
  out.resize(static_cast<Eigen::Index>(force_.size()));
  const double scale = phase.forceScale() > 0.0 ? phase.forceScale() : 1.0;
  for (std::size_t m = 0; m < force_.size(); ++m) {
    double value = 0.0;
    phase.margin(static_cast<std::size_t>(force_[m].contact), value);
    out[static_cast<Eigen::Index>(m)] = value / scale;
  }
}

bool SwitchSearch::kinematicAt(ContactProbe& probe, const QuinticPath& path, int monitor,
                               double theta, double& v) {
  path.at(theta, at_);
  if (!probe.look(at_)) return false;
  v = measure(probe, kinematic_[static_cast<std::size_t>(monitor)]);
  return true;
}

bool SwitchSearch::forceAt(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path,
                           int monitor, double theta, double& v) {
  path.at(theta, at_);
  s.evaluate(at_, 1);
  Eigen::VectorXd& a = work_;
  if (!phase.accelerate(s.slot(1), at_.u, a)) return false;
  const double scale = phase.forceScale() > 0.0 ? phase.forceScale() : 1.0;
  phase.margin(static_cast<std::size_t>(force_[static_cast<std::size_t>(monitor)].contact), v);
  v /= scale;
  return true;
}

bool SwitchSearch::sample(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase,
                          const QuinticPath& path) {
  for (int j = 1; j <= kSamples && !kinematic_.empty(); ++j) {
    path.at(static_cast<double>(j) / kSamples, at_);
    if (!probe.look(at_)) return false;
    column(probe, j);
  }
  if (force_.empty()) return true;
  double unused = 0.0;
  if (!forceAt(s, phase, path, 0, 0.5, unused)) return false;
  forces(phase, middleForces_);
  return true;
}

bool SwitchSearch::rough() const {
  for (Eigen::Index m = 0; m < startForces_.size() && !force_.empty(); ++m)
    if (std::abs(startForces_[m] - 2.0 * middleForces_[m] + endForces_[m]) > kRough) return true;
  for (std::size_t m = 0; m < kinematic_.size(); ++m) {
    const auto row = values_.row(static_cast<Eigen::Index>(m));
    const double range = row.maxCoeff() - row.minCoeff();
    for (Eigen::Index j = 0; j + 2 < row.size() && range > kStart * noise(kinematic_[m]); ++j)
      if (std::abs(row[j] - 2.0 * row[j + 1] + row[j + 2]) > kRoughSamples * range) return true;
  }
  return false;
}

template <class Value>
bool SwitchSearch::refine(Bracket& at, double width, double zero, Value&& value, double& root,
                          double& slope) {
  // [alefeld_potra_shi1995]: both ends close in, with order 1.65 a look in the end.
  auto& [a, fa, b, fb] = at;
  if (!(fa > 0.0 && fb < 0.0)) {  // an end that is zero but for rounding
    slope = (fb - fa) / (b - a);
    root = fa > 0.0 ? b : a;
    return true;
  }
  bool known = true;
  double last = a, fLast = fa;
  slope = (fb - fa) / (b - a);
  const double small = kSmall * (fa - fb);
  const auto f = [&](double t) {
    double v = 0.0;
    known = known && value(t, v);
    if (t != last && v != fLast) slope = (v - fLast) / (t - last);
    last = t, fLast = v;
    const double near = std::max(zero, 0.5 * width * std::abs(slope));
    if (!known || std::abs(v) <= std::min(near, small)) {
      a = b = slope < 0.0 ? t - v / slope : t, fa = fb = 0.0;
      return 0.0;  // near enough, though one end of the bracket may be far
    }
    (v > 0.0 ? a : b) = t, (v > 0.0 ? fa : fb) = v;
    return v;
  };
  const auto near = [&](double l, double r) { return r - l <= width; };
  std::uintmax_t most = kMostRefinements;
  if (!near(a, b))
    boost::math::tools::toms748_solve(f, double(a), double(b), double(fa), double(fb), near, most);
  root = b > a ? (a * fb - b * fa) / (fb - fa) : a;
  return known;
}

bool SwitchSearch::refineKinematic(ContactProbe& probe, const QuinticPath& path, int monitor,
                                   Bracket& at, double& root, double& slope) {
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  const auto value = [&](double t, double& v) { return kinematicAt(probe, path, monitor, t, v); };
  if (!refine(at, kRootWidth, noise(k), value, root, slope)) return false;
  slope /= path.length();
  if (const double closing = rate(probe, k); closing < 0.0) {  // the last look was at the root
    slope = closing;
    return true;
  }
  const double d = 1e-4;
  double before = 0.0, after = 0.0;
  if (!value(root - d, before) || !value(root + d, after)) return false;
  slope = (after - before) / (2.0 * d * path.length());
  return true;
}

bool SwitchSearch::kinematicSwitch(ContactProbe& probe, const QuinticPath& path, int monitor,
                                   Switch& first) {
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  int j = 1;
  while (j <= kSamples && !(values_(monitor, j) < -noise(k))) ++j;
  if (j > kSamples) {
    // A gap that closes right at the end is a switch there, not one at the start of the next step.
    const double end = values_(monitor, kSamples), rate = rates_(monitor, kSamples);
    if (isGap(k) && !k.zeroStart && end <= kStart * noise(k) && rate < 0.0 && first.theta > 1.0)
      first = {Switch::Kind::root, 1.0, false, monitor, rate};
    return true;
  }
  double b = static_cast<double>(j) / kSamples, a = b - 1.0 / kSamples;
  if (a >= first.theta) return true;
  double fb = values_(monitor, j), fa = values_(monitor, j - 1);
  if (j == 1 && k.zeroStart) {
    for (int i = 0;; ++i) {
      if (i == kHalvings) {
        first = {Switch::Kind::atStart, 0.0, false, monitor, 0.0};
        return true;
      }
      double v = 0.0;
      if (!kinematicAt(probe, path, monitor, 0.5 * b, v)) return false;
      if (v > 0.0) {
        a = 0.5 * b, fa = v;
        break;
      }
      b *= 0.5, fb = v;
    }
  }
  double root = a, slope = 0.0;
  Bracket at{a, fa, b, fb};
  if (fa > 0.0 && !refineKinematic(probe, path, monitor, at, root, slope)) return false;
  if (!(root < first.theta)) return true;
  if (root > 0.0)
    first = {Switch::Kind::root, root, false, monitor, slope};
  else
    first = {Switch::Kind::atStart, 0.0, false, monitor, 0.0};
  return true;
}

bool SwitchSearch::forceSwitch(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path,
                               int monitor, double width, Switch& first) {
  const Monitor& k = force_[static_cast<std::size_t>(monitor)];
  const double samples[3] = {startForces_[monitor], middleForces_[monitor], endForces_[monitor]};
  int j = 1;
  while (j <= 2 && !(samples[j] < -kForceNoise)) ++j;
  if (j > 2) return true;
  double b = 0.5 * j, a = b - 0.5, fb = samples[j], fa = samples[j - 1];
  if (a >= first.theta) return true;
  if (j == 1 && k.zeroStart) {
    for (int i = 0;; ++i) {
      if (i == kForceHalvings) {
        first = {Switch::Kind::atStart, 0.0, true, monitor, 0.0};
        return true;
      }
      double v = 0.0;
      if (!forceAt(s, phase, path, monitor, 0.5 * b, v)) return false;
      if (v > kForceNoise) {
        a = 0.5 * b, fa = v;
        break;
      }
      b *= 0.5, fb = v;
    }
  }
  double root = a, slope = 0.0;
  const auto value = [&](double t, double& v) { return forceAt(s, phase, path, monitor, t, v); };
  const double fall = fa - fb;
  const bool wide = b - a > 2.0 * width;
  Bracket at{a, fa, b, fb};
  if (fa > 0.0 && !refine(at, width, 0.0, value, root, slope)) return false;
  if (wide && fa > 0.0 && at.fa - at.fb > kJump * fall) {
    // The bracket has shrunk, the fall has not: a jump, unless the middle lies in the middle.
    double middle = 0.0;
    if (!value(0.5 * (at.a + at.b), middle)) return false;
    if (std::abs(middle - 0.5 * (at.fa + at.fb)) > kAside * (at.fa - at.fb)) {
      const double fine = std::max(kJumpWidth, width * width * width);  // no slope: 1e-5 tol
      if (!refine(at, fine, 0.0, value, root, slope)) return false;
      root = at.b, slope = 0.0;  // behind the jump
    }
  }
  if (!(root < first.theta)) return true;
  first = {root > 0.0 ? Switch::Kind::root : Switch::Kind::atStart, root, true, monitor,
           slope / path.length()};
  return true;
}

bool SwitchSearch::near(ContactProbe& probe, const QuinticPath& path, int monitor, Switch& first) {
  if (!isGap(kinematic_[static_cast<std::size_t>(monitor)])) return true;
  for (int j = 0; j < kSamples; ++j) {
    double a = static_cast<double>(j) / kSamples, b = a + 1.0 / kSamples;
    if (a >= first.theta) return true;
    if (!(rates_(monitor, j) < 0.0 && rates_(monitor, j + 1) > 0.0)) continue;
    if (j == 0 && kinematic_[static_cast<std::size_t>(monitor)].zeroStart) continue;
    // The range of the gap so far; what lies behind may be a fall that no contact stops.
    const double high = values_.row(monitor).head(j + 1).maxCoeff();
    double fa = rates_(monitor, j), fb = rates_(monitor, j + 1), c = b, v = 0.0;
    for (int i = 0; i < 40 && b - a > kMinimum; ++i) {
      c = i % 2 == 1 ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
      if (!kinematicAt(probe, path, monitor, c, v)) return false;
      const double slope = rate(probe, kinematic_[static_cast<std::size_t>(monitor)]);
      if (slope < 0.0)
        a = c, fa = slope;
      else
        b = c, fb = slope;
      if (v < -gapNoise_) break;
    }
    if (v < -gapNoise_) {  // a dip between two samples: the root lies before it
      values_(monitor, j + 1) = v;
      double root = 0.0, slope = 0.0;
      Bracket at{static_cast<double>(j) / kSamples, values_(monitor, j), c, v};
      if (!refineKinematic(probe, path, monitor, at, root, slope)) return false;
      if (root < first.theta) first = {Switch::Kind::root, root, false, monitor, slope};
      return true;
    }
    if (v < kNear * high && c < first.theta && c > 0.0)
      first = {Switch::Kind::look, c, false, monitor, 0.0};
  }
  return true;
}

bool SwitchSearch::find(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase,
                        const QuinticPath& path, bool looked, double width, Switch& out) {
  out = {};
  if (!any()) return true;
  if (!sample(s, probe, phase, path)) return false;
  Switch first;
  first.theta = 2.0;
  for (int m = 0; m < static_cast<int>(kinematic_.size()); ++m)
    if (!kinematicSwitch(probe, path, m, first)) return false;
  for (int m = 0; m < static_cast<int>(kinematic_.size()) && !looked; ++m)
    if (!near(probe, path, m, first)) return false;
  for (int m = 0; m < static_cast<int>(force_.size()); ++m)
    if (!forceSwitch(s, phase, path, m, width, first)) return false;
  if (first) out = first;
  return true;
}

bool SwitchSearch::closedBefore(ContactProbe& probe, const State& x, Switch& w) {
  if (!gaps() || !probe.look(x)) return false;
  Switch first;
  double longest = 0.0;
  for (std::size_t m = 0; m < kinematic_.size(); ++m) {
    const Monitor& k = kinematic_[m];
    if (!isGap(k) || (!w.force && static_cast<int>(m) == w.monitor)) continue;
    const double gap = measure(probe, k), closing = rate(probe, k);
    if (!(gap < -gapNoise_ && closing < 0.0 && gap / closing > longest)) continue;
    longest = gap / closing;
    first = {Switch::Kind::root, w.theta, false, static_cast<int>(m), closing};
  }
  if (first) w = first;
  return bool(first);
}

ContactKey SwitchSearch::contact(const FrozenPhase& phase, const Switch& w) const {
  const auto m = static_cast<std::size_t>(w.monitor);
  return w.force ? phase.held[static_cast<std::size_t>(force_[m].contact)].key : kinematic_[m].key;
}

bool SwitchSearch::value(ContactProbe& probe, const FrozenPhase& phase, const State& x,
                         const Switch& w, double& out) {
  if (w.force) {
    const double scale = phase.forceScale() > 0.0 ? phase.forceScale() : 1.0;
    phase.margin(static_cast<std::size_t>(force_[static_cast<std::size_t>(w.monitor)].contact),
                 out);
    out /= scale;
    return true;
  }
  if (!probe.look(x)) return false;
  out = measure(probe, kinematic_[static_cast<std::size_t>(w.monitor)]);
  return true;
}

}  // namespace dynamy
