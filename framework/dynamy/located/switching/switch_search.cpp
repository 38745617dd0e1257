#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <dynamy/located/switching/switch_search.hpp>

namespace dynamy {
namespace {

constexpr int kStartHalvings = 46;  ///< for monitors that start at zero: θ down to 1e-15
constexpr int kForceHalvings = 20;
constexpr int kMostRefinements = 160;
constexpr double kJump = 0.1;         ///< of the fall of a force over the first bracket
constexpr double kRootWidth = 1e-14;  ///< width of roots of gaps and slips
constexpr double kAside = 0.25;       ///< of the fall: deviation of the middle; a jump has half
constexpr double kJumpWidth = 1e-13;  ///< least width to which a jump is found, of the step
/// Of the fall over a bracket: a larger value is no root, even if it seems close to one by the last
/// slope, which may be that over a jump.
constexpr double kSmallValue = 1e-2;
/// A gap whose smallest value is below this share of its range in the step is examined again.
constexpr double kNearRoot = 0.02;
// Deviation from which a force bends much: kRough of the largest force; or kRoughMargin of the
// distance to its bound, if that exceeds kRoughNear of the largest force.
constexpr double kRough = 0.1, kRoughNear = 1e-3, kRoughMargin = 0.5;
constexpr double kRoughSamples = 0.3;         ///< the same for a slip, of its range
constexpr double kBetweenSamples = 0.381966;  ///< place between two samples: no simple fraction
constexpr double kMinimum = 1e-5;  ///< accuracy of the place of a minimum, as a part of the step

}  // namespace

bool SwitchSearch::kinematicAt(ContactProbe& probe, const QuinticPath& path, int monitor,
                               double theta, double& v) {
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  path.at(theta, at_);
  const bool ofContact = k.kind != Monitor::Kind::latch;
  if (!(ofContact ? probe.lookAt(at_, k.contact) : probe.look(at_))) return false;
  v = measure(probe, k);
  return true;
}

bool SwitchSearch::forceAt(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path,
                           int monitor, double theta, double& v) {
  path.at(theta, at_);
  s.evaluate(at_, 1);
  Eigen::VectorXd& a = work_;
  if (!phase.accelerate(s.slot(1), at_.u, a)) return false;
  phase.margin(static_cast<std::size_t>(force_[static_cast<std::size_t>(monitor)].contact), v);
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
  scale_ = std::max({startScale_, forces(phase, middleForces_), endScale_});
  return true;
}

bool SwitchSearch::roughSamples() const {
  for (Eigen::Index m = 0; m < startForces_.size() && !force_.empty(); ++m)
    if (bends(m, startForces_[m] - 2.0 * middleForces_[m] + endForces_[m])) return true;
  for (std::size_t m = 0; m < kinematic_.size(); ++m) {
    const auto row = values_.row(static_cast<Eigen::Index>(m));
    const double range = row.maxCoeff() - row.minCoeff();
    for (Eigen::Index j = 0; j + 2 < row.size() && range > kStart * noise(kinematic_[m]); ++j)
      if (std::abs(row[j] - 2.0 * row[j + 1] + row[j + 2]) > kRoughSamples * range) return true;
  }
  return false;
}

bool SwitchSearch::rough(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase,
                         const QuinticPath& path) {
  if (roughSamples()) return true;
  // An oscillation with the frequency of the samples seems to rest: samples between them show it.
  for (int j = 0; j < kSamples && !kinematic_.empty(); ++j) {
    path.at((j + kBetweenSamples) / kSamples, at_);
    if (!probe.look(at_)) return true;
    for (std::size_t m = 0; m < kinematic_.size(); ++m) {
      const auto row = values_.row(static_cast<Eigen::Index>(m));
      const double range = std::max(row.maxCoeff() - row.minCoeff(), kStart * noise(kinematic_[m]));
      const double line = row[j] + kBetweenSamples * (row[j + 1] - row[j]);
      if (std::abs(measure(probe, kinematic_[m]) - line) > kRoughSamples * range) return true;
    }
  }
  double unused = 0.0;
  if (force_.empty() || !forceAt(s, phase, path, 0, 0.5 * kBetweenSamples, unused)) return false;
  forces(phase, work_);
  const double b = 0.5 * kBetweenSamples, l0 = (1.0 - b) * (1.0 - 2.0 * b),
               l1 = 4.0 * b * (1.0 - b), l2 = b * (2.0 * b - 1.0);
  work_ -= l0 * startForces_ + l1 * middleForces_ + l2 * endForces_;
  for (Eigen::Index m = 0; m < work_.size(); ++m)
    if (bends(m, work_[m])) return true;
  return false;
}

bool SwitchSearch::bends(Eigen::Index monitor, double by) const {
  // The deviation is large as a part of the largest force, or of the force's own distance to zero.
  const double least =
      std::min({startForces_[monitor], middleForces_[monitor], endForces_[monitor]});
  return std::abs(by) > kRough * scale_ ||
         std::abs(by) > std::max(kRoughNear * scale_, kRoughMargin * least);
}

template <class Value>
bool SwitchSearch::refine(Bracket& at, double width, double zero, Value&& value, double& root,
                          double& slope) {
  // [alefeld_potra_shi1995]: both ends converge, with the final order 1.65 per evaluation.
  auto& [a, fa, b, fb] = at;
  if (!(fa > 0.0 && fb < 0.0)) {  // one end is zero up to rounding
    slope = (fb - fa) / (b - a);
    root = fa > 0.0 ? b : a;
    return true;
  }
  bool known = true;
  double last = a, fLast = fa;
  slope = (fb - fa) / (b - a);
  const double small = kSmallValue * (fa - fb);
  const auto f = [&](double t) {
    double v = 0.0;
    known = known && value(t, v);
    if (t != last && v != fLast) slope = (v - fLast) / (t - last);
    last = t, fLast = v;
    const double near = std::max(zero, 0.5 * width * std::abs(slope));
    if (!known || std::abs(v) <= std::min(near, small)) {
      a = b = slope < 0.0 ? t - v / slope : t, fa = fb = 0.0;
      return 0.0;  // close enough, though one end of the bracket may be far away
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

bool SwitchSearch::presentAt(ContactProbe& probe, const QuinticPath& path, int monitor,
                             double theta, bool& there) {
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  there = true;
  if (!k.features) return true;
  double v = 0.0;
  if (!kinematicAt(probe, path, monitor, theta, v)) return false;
  // Where the normal of two edges reverses, their gap jumps from one sign to the other.
  const double range = values_.row(monitor).maxCoeff() - values_.row(monitor).minCoeff();
  there = present(probe, k) && std::abs(v) <= kSmallValue * range + touch_;
  return true;
}

bool SwitchSearch::endSwitch(ContactProbe& probe, const QuinticPath& path, int monitor,
                             Switch& first) {
  // A gap that closes right at the end is a switch of this step, not of the start of the next one.
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  const double end = values_(monitor, kSamples), rate = rates_(monitor, kSamples);
  if (!isGap(k) || k.zeroStart || end > kStart * noise(k) || end < -noise(k) || rate >= 0.0 ||
      first.theta <= 1.0)
    return true;
  bool there = true;
  if (!presentAt(probe, path, monitor, 1.0, there)) return false;
  if (there) first = {Switch::Kind::root, 1.0, false, monitor, rate};
  return true;
}

bool SwitchSearch::kinematicSwitch(ContactProbe& probe, const QuinticPath& path, int monitor,
                                   Switch& first) {
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  // A gap that starts behind the plane of its feature has to become positive first.
  const auto falls = [&](int j) {
    const bool before = !k.features || values_(monitor, j - 1) > 0.0 || (j == 1 && k.zeroStart);
    return before && values_(monitor, j) < -noise(k) && mayBePresent(k, monitor, j);
  };
  for (int j = 1; j <= kSamples; ++j) {
    if (!falls(j)) continue;
    bool there = true;
    if (!fallSwitch(probe, path, monitor, j, first, there)) return false;
    if (there) return true;
  }
  return endSwitch(probe, path, monitor, first);
}

bool SwitchSearch::fallSwitch(ContactProbe& probe, const QuinticPath& path, int monitor, int j,
                              Switch& first, bool& there) {
  const Monitor& k = kinematic_[static_cast<std::size_t>(monitor)];
  double b = static_cast<double>(j) / kSamples, a = b - 1.0 / kSamples;
  if (a >= first.theta) return true;
  double fb = values_(monitor, j), fa = values_(monitor, j - 1);
  if (j == 1 && k.zeroStart) {
    for (int i = 0;; ++i) {
      if (i == kStartHalvings) {
        if (!presentAt(probe, path, monitor, 0.0, there)) return false;
        if (there) first = {Switch::Kind::atStart, 0.0, false, monitor, 0.0};
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
  if (!presentAt(probe, path, monitor, root, there)) return false;
  if (!there) return true;
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
  const double noise = kForceNoise * scale_;
  int j = 1;
  while (j <= 2 && !(samples[j] < -noise)) ++j;
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
      if (v > noise) {
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
    // The bracket has shrunk, the fall has not: a jump, unless the middle value is near the mean.
    double middle = 0.0;
    if (!value(0.5 * (at.a + at.b), middle)) return false;
    if (std::abs(middle - 0.5 * (at.fa + at.fb)) > kAside * (at.fa - at.fb)) {
      const double fine = std::max(kJumpWidth, width * width * width);  // no slope: 1e-5 tol
      if (!refine(at, fine, 0.0, value, root, slope)) return false;
      root = at.b, slope = 0.0;  // right after the jump
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
    if (!mayBePresent(kinematic_[static_cast<std::size_t>(monitor)], monitor, j + 1)) continue;
    if (j == 0 && kinematic_[static_cast<std::size_t>(monitor)].zeroStart) continue;
    // The range of the gap so far: later values may belong to a fall that no contact stops.
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
    bool there = present(probe, kinematic_[static_cast<std::size_t>(monitor)]);
    if (v < -gapNoise_) {  // a dip between two samples: the root lies before it
      const double behind = values_(monitor, j + 1);
      values_(monitor, j + 1) = v;
      double root = 0.0, slope = 0.0;
      Bracket at{static_cast<double>(j) / kSamples, values_(monitor, j), c, v};
      if (at.fa < 0.0 && kinematic_[static_cast<std::size_t>(monitor)].features) continue;
      if (!refineKinematic(probe, path, monitor, at, root, slope)) return false;
      if (!presentAt(probe, path, monitor, root, there)) return false;
      if (!there) {
        values_(monitor, j + 1) = behind;
        continue;
      }
      if (root < first.theta) first = {Switch::Kind::root, root, false, monitor, slope};
      return true;
    }
    if (there && v < kNearRoot * high && c < first.theta && c > 0.0)
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
    if (k.behind || !present(probe, k)) continue;
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
    phase.margin(static_cast<std::size_t>(force_[static_cast<std::size_t>(w.monitor)].contact),
                 out);
    return true;
  }
  if (!probe.look(x)) return false;
  out = measure(probe, kinematic_[static_cast<std::size_t>(w.monitor)]);
  return true;
}

}  // namespace dynamy
