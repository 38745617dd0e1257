#include <algorithm>
#include <cmath>
#include <dynamy/located/switching/kinematic_search.hpp>

namespace dynamy {
namespace {

/// Features do not lie over one another between two samples if their presence is below zero by more
/// than this multiple of its change.
constexpr double kAway = 2.0;
constexpr int kStartHalvings = 46;    ///< for monitors that start at zero: θ down to 1e-15
constexpr double kRootWidth = 1e-14;  ///< width of roots
/// A gap whose smallest value is below this share of its range in the step is examined again.
constexpr double kNearRoot = 0.02;
constexpr double kFarFromRoot = 5.0;          ///< times as much: no minimum is searched there
constexpr double kMinimum = 1e-5;             ///< accuracy of the place of a minimum, of the step
constexpr double kRoughSamples = 0.3;         ///< deviation between samples, of the range
constexpr double kMostTilt = 0.5;             ///< change of a circle's tilt between samples, of it
constexpr double kBetweenSamples = 0.381966;  ///< place between two samples: no simple fraction

}  // namespace

void KinematicSearch::start(const ContactProbe& probe, const State& x) {
  at_.memory = x.memory;
  values_.resize(monitors.size(), kSamples + 1);
  rates_.setZero(values_.rows(), values_.cols());
  presences_.setZero(values_.rows(), values_.cols());
  column(probe, 0);
}

void KinematicSearch::column(const ContactProbe& probe, int sample) {
  for (int i = 0; i < monitors.size(); ++i) {
    const KinematicMonitor& m = monitors[i];
    values_(i, sample) = m.value(probe), rates_(i, sample) = m.rate(probe);
    if (m.features) presences_(i, sample) = probe.gaps().presence(m.contact);
  }
}

bool KinematicSearch::sample(ContactProbe& probe, const QuinticPath& path) {
  for (int j = 1; j <= kSamples && monitors.any(); ++j) {
    path.at(static_cast<double>(j) / kSamples, at_);
    if (!probe.look(at_)) return false;
    column(probe, j);
  }
  return true;
}

bool KinematicSearch::find(ContactProbe& probe, const QuinticPath& path, bool looked,
                           Switch& first) {
  for (int m = 0; m < monitors.size(); ++m) {
    if (!looked) untilItCloses(m, first);
    if (!findOf(probe, path, m, first)) return false;
  }
  for (int m = 0; m < monitors.size() && !looked; ++m)
    if (!near(probe, path, m, first)) return false;
  return true;
}

bool KinematicSearch::valueAt(ContactProbe& probe, const QuinticPath& path, int monitor,
                              double theta, double& v) {
  const KinematicMonitor& k = monitors[monitor];
  if (k.kind != KinematicMonitor::Kind::latch) {
    if (!probe.lookAt(path, theta, at_, k.contact)) return false;
  } else {
    path.at(theta, at_);
    if (!probe.look(at_)) return false;
  }
  v = k.value(probe);
  return true;
}

// The direction of the lowest point turns by less than the relative change of the tilt.
bool KinematicSearch::passesFlat(double theta) const {
  for (int m = 0; m < monitors.size(); ++m) {
    if (monitors[m].flat == 0.0 || monitors[m].isGap()) continue;
    const double lowest = ContactSink::kLowest * monitors[m].flat;
    const auto row = values_.row(m);
    for (int j = 1; j <= kSamples && j - 1 < theta * kSamples; ++j) {
      if (row[j] <= 0.0) break;  // it lies flat: a switch
      if (std::max(row[j], row[j - 1]) >= FollowedFeatures::kAlways) continue;  // far from flat
      const double change = std::abs(row[j] - row[j - 1]);
      if (change > kMostTilt * (std::min(row[j], row[j - 1]) + lowest)) return true;
    }
  }
  return false;
}

bool KinematicSearch::roughSamples() const {
  for (int m = 0; m < monitors.size(); ++m) {
    const auto row = values_.row(m);
    const double range = row.maxCoeff() - row.minCoeff();
    const double least = KinematicMonitors::kStart * monitors[m].noise;
    for (Eigen::Index j = 0; j + 2 < row.size() && range > least; ++j)
      if (std::abs(row[j] - 2.0 * row[j + 1] + row[j + 2]) > kRoughSamples * range) return true;
  }
  return false;
}

bool KinematicSearch::rough(ContactProbe& probe, const QuinticPath& path) {
  // An oscillation with the frequency of the samples seems to rest: samples between them show it.
  for (int j = 0; j < kSamples && monitors.any(); ++j) {
    path.at((j + kBetweenSamples) / kSamples, at_);
    if (!probe.look(at_)) return true;
    for (int m = 0; m < monitors.size(); ++m) {
      const auto row = values_.row(m);
      const double range =
          std::max(row.maxCoeff() - row.minCoeff(), KinematicMonitors::kStart * monitors[m].noise);
      const double line = row[j] + kBetweenSamples * (row[j + 1] - row[j]);
      if (std::abs(monitors[m].value(probe) - line) > kRoughSamples * range) return true;
    }
  }
  return false;
}

bool KinematicSearch::mayBePresent(int monitor, int j) const {
  if (!monitors[monitor].features) return true;
  const double a = presences_(monitor, j - 1), b = presences_(monitor, j);
  return std::max(a, b) > -kAway * std::abs(b - a);
}

bool KinematicSearch::refine(ContactProbe& probe, const QuinticPath& path, int monitor, Bracket& at,
                             double& root, double& slope) {
  const KinematicMonitor& k = monitors[monitor];
  const auto value = [&](double t, double& v) { return valueAt(probe, path, monitor, t, v); };
  if (!at.refine(kRootWidth, k.noise, value, root, slope)) return false;
  slope /= path.length();
  if (const double closing = k.rate(probe); closing < 0.0) {  // the last look was at the root
    slope = closing;
    return true;
  }
  const double d = 1e-4;
  double before = 0.0, after = 0.0;
  if (!value(root - d, before) || !value(root + d, after)) return false;
  slope = (after - before) / (2.0 * d * path.length());
  return true;
}

bool KinematicSearch::presentAt(ContactProbe& probe, const QuinticPath& path, int monitor,
                                double theta, bool& there) {
  const KinematicMonitor& k = monitors[monitor];
  there = true;
  if (!k.features) return true;
  double v = 0.0;
  if (!valueAt(probe, path, monitor, theta, v)) return false;
  // Where the normal of two edges reverses, their gap jumps from one sign to the other.
  const double range = values_.row(monitor).maxCoeff() - values_.row(monitor).minCoeff();
  there = k.present(probe) && std::abs(v) <= Bracket::kSmallValue * range + monitors.limits().touch;
  // Features that have just left take no part in an event at the start, which would be empty.
  if (theta == 0.0 && presences_(monitor, 0) <= monitors.limits().gone)
    there = there && presences_(monitor, 1) > 0.0;
  return true;
}

bool KinematicSearch::atEnd(ContactProbe& probe, const QuinticPath& path, int monitor,
                            Switch& first) {
  // A gap that closes right at the end is a switch of this step, not of the start of the next one.
  const KinematicMonitor& k = monitors[monitor];
  const double end = values_(monitor, kSamples), rate = rates_(monitor, kSamples);
  if (!k.isGap() || k.zeroStart || end > KinematicMonitors::kStart * k.noise || end < -k.noise ||
      rate >= 0.0 || first.theta <= 1.0)
    return true;
  bool there = true;
  if (!presentAt(probe, path, monitor, 1.0, there)) return false;
  if (there) first = {Switch::Kind::root, 1.0, false, monitor, rate};
  return true;
}

/// True: an overlap that becomes smaller at the start, in which no contact is held.
bool KinematicSearch::separates(int monitor) const {
  const KinematicMonitor& k = monitors[monitor];
  return k.isGap() && !k.features && values_(monitor, 0) < -k.noise &&
         rates_(monitor, 0) > monitors.limits().speedNoise;
}

/// Such a gap closes where it falls again before it is positive: a step that ends there finds it at
/// the start of the next one.
void KinematicSearch::untilItCloses(int monitor, Switch& first) const {
  if (!separates(monitor)) return;
  for (int j = 1; j <= kSamples && values_(monitor, j) < 0.0; ++j) {
    const double theta = static_cast<double>(j) / kSamples;
    if (theta >= first.theta) return;
    if (rates_(monitor, j) < 0.0) {
      first = {Switch::Kind::look, theta, false, monitor, 0.0};
      return;
    }
  }
}

bool KinematicSearch::findOf(ContactProbe& probe, const QuinticPath& path, int monitor,
                             Switch& first) {
  const KinematicMonitor& k = monitors[monitor];
  // A gap that starts behind the plane of its feature, or separates, has to become positive first.
  const bool apart = separates(monitor);
  const auto falls = [&](int j) {
    const bool before =
        values_(monitor, j - 1) > 0.0 || (!apart && (!k.features || (j == 1 && k.zeroStart)));
    return before && values_(monitor, j) < -k.noise && mayBePresent(monitor, j);
  };
  for (int j = 1; j <= kSamples; ++j) {
    if (!falls(j)) continue;
    bool there = true;
    if (!fall(probe, path, monitor, j, first, there)) return false;
    if (there) return true;
  }
  return atEnd(probe, path, monitor, first);
}

bool KinematicSearch::fromZero(ContactProbe& probe, const QuinticPath& path, int monitor,
                               Bracket& at, bool& positive) {
  positive = false;
  for (int i = 0; i < kStartHalvings && !positive; ++i) {
    double v = 0.0;
    if (!valueAt(probe, path, monitor, 0.5 * at.b, v)) return false;
    positive = v > 0.0;
    (positive ? at.a : at.b) = 0.5 * at.b;
    (positive ? at.fa : at.fb) = v;
  }
  return true;
}

bool KinematicSearch::fall(ContactProbe& probe, const QuinticPath& path, int monitor, int j,
                           Switch& first, bool& there) {
  const KinematicMonitor& k = monitors[monitor];
  double b = static_cast<double>(j) / kSamples, a = b - 1.0 / kSamples;
  if (a >= first.theta) return true;
  double fb = values_(monitor, j), fa = values_(monitor, j - 1);
  if (j == 1 && k.zeroStart) {
    Bracket at{a, fa, b, fb};
    // Bodies between others hit them in turn: what is left of the gap is rounding.
    const bool closes =
        k.isGap() && fa <= k.noise && rates_(monitor, 0) < -monitors.limits().speedNoise;
    bool positive = false;
    if (!closes && !fromZero(probe, path, monitor, at, positive)) return false;
    if (!positive) {
      if (!presentAt(probe, path, monitor, 0.0, there)) return false;
      if (there) first = {Switch::Kind::atStart, 0.0, false, monitor, 0.0};
      return true;
    }
    a = at.a, fa = at.fa, b = at.b, fb = at.fb;
  }
  if (first.theta < b && fa > 0.0 && !(j == 1 && k.zeroStart)) {
    // Of monitors that all fall, e.g. gaps of bodies above a floor, most are still positive there.
    double v = 0.0;
    if (!valueAt(probe, path, monitor, first.theta, v)) return false;
    if (v > k.noise) return true;
  }
  double root = a, slope = 0.0;
  Bracket at{a, fa, b, fb};
  if (fa > 0.0 && !refine(probe, path, monitor, at, root, slope)) return false;
  if (!(root < first.theta)) return true;
  if (!presentAt(probe, path, monitor, root, there)) return false;
  if (!there) return true;
  if (root > 0.0)
    first = {Switch::Kind::root, root, false, monitor, slope};
  else
    first = {Switch::Kind::atStart, 0.0, false, monitor, 0.0};
  return true;
}

/// True: the tangents of a gap at two samples meet far above the values that are examined. If it
/// bends upwards between them, its minimum lies above that place.
bool KinematicSearch::staysHigh(const QuinticPath& path, int monitor, int j, double high) const {
  const double fa = rates_(monitor, j), fb = rates_(monitor, j + 1);
  const double dt = path.length() / kSamples;
  const double rise = values_(monitor, j + 1) - values_(monitor, j);
  const double meet = values_(monitor, j) + fa * (fb * dt - rise) / (fb - fa);
  const bool resolved = high > KinematicMonitors::kStart * monitors[monitor].noise;
  return resolved && meet > kFarFromRoot * kNearRoot * high;
}

bool KinematicSearch::near(ContactProbe& probe, const QuinticPath& path, int monitor,
                           Switch& first) {
  if (!monitors[monitor].isGap() || separates(monitor)) return true;
  for (int j = 0; j < kSamples; ++j) {
    double a = static_cast<double>(j) / kSamples, b = a + 1.0 / kSamples;
    if (a >= first.theta) return true;
    if (!(rates_(monitor, j) < 0.0 && rates_(monitor, j + 1) > 0.0)) continue;
    if (!mayBePresent(monitor, j + 1)) continue;
    // A gap that starts at zero and falls by more than its noise dips as well.
    const bool zero = j == 0 && monitors[monitor].zeroStart;
    const double fell = -rates_(monitor, j) * path.length() / kSamples;
    if (zero && !(fell > KinematicMonitors::kStart * monitors[monitor].noise)) continue;
    // The range of the gap so far: later values may belong to a fall that no contact stops.
    const double high = values_.row(monitor).head(j + 1).maxCoeff();
    if (!zero && staysHigh(path, monitor, j, high)) continue;
    double fa = rates_(monitor, j), fb = rates_(monitor, j + 1), c = b, v = 0.0;
    for (int i = 0; i < 40 && b - a > kMinimum; ++i) {
      c = i % 2 == 1 ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
      if (!valueAt(probe, path, monitor, c, v)) return false;
      const double slope = monitors[monitor].rate(probe);
      if (slope < 0.0)
        a = c, fa = slope;
      else
        b = c, fb = slope;
      if (v < -monitors.limits().gapNoise) break;
    }
    bool there = monitors[monitor].present(probe);
    if (v < -monitors.limits().gapNoise) {  // a dip between two samples: the root lies before it
      const double behind = values_(monitor, j + 1);
      values_(monitor, j + 1) = v;
      double root = 0.0, slope = 0.0;
      Bracket at{static_cast<double>(j) / kSamples, values_(monitor, j), c, v};
      if (at.fa < 0.0 && monitors[monitor].features) continue;
      bool positive = !zero;
      if (zero && !fromZero(probe, path, monitor, at, positive)) return false;
      if (!positive) {
        first = {Switch::Kind::atStart, 0.0, false, monitor, 0.0};
        return true;
      }
      if (!refine(probe, path, monitor, at, root, slope)) return false;
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

}  // namespace dynamy
