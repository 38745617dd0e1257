#include <algorithm>
#include <cmath>
#include <dynamy/located/switching/force_search.hpp>

namespace dynamy {
namespace {

constexpr double kForceNoise = 1e-12;  ///< of the largest force on the path
constexpr int kForceHalvings = 20;     ///< for monitors that start at zero
constexpr double kJump = 0.1;          ///< of the fall of a force over the first bracket
constexpr double kAside = 0.25;        ///< of the fall: deviation of the middle; a jump has half
constexpr double kJumpWidth = 1e-13;   ///< least width to which a jump is found, of the step
// Deviation from which a force bends much: kRough of the largest force; or kRoughMargin of the
// distance to its bound, if that exceeds kRoughNear of the largest force.
constexpr double kRough = 0.1, kRoughNear = 1e-3, kRoughMargin = 0.5;
// Of a contact's forces: rows contradict each other if a larger one is missing somewhere on the path
// (drift of what sticks reaches a tenth of it), from where more than the second is missing.
constexpr double kContradiction = 1e-3, kBegins = 1e-6;
constexpr double kBetween = 0.190983;  ///< place between the start and the middle

}  // namespace

void ForceSearch::idleAtStart(const FrozenPhase& phase, const State& x) {
  if (x.t == start_ && startIdle_.size() == phase.held.size()) return;
  if (x.t == end_ && endIdle_.size() == phase.held.size())
    startIdle_ = endIdle_;
  else
    idles(phase, startIdle_);
}

void ForceSearch::idles(const FrozenPhase& phase, std::vector<char>& out) {
  out.resize(phase.held.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = phase.rows().set(i).idle() ? 1 : 0;
}

void ForceSearch::watch(const FrozenPhase& phase, const State& x) {
  monitors_.clear();
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const Held& h = phase.held[i];
    double margin = 0.0;
    const bool muted = h.mutedUntil > x.t;
    if (phase.margin(i, margin) &&
        (!muted || phase.rows().set(i).form == ForceSet::Form::normal || h.slips))
      monitors_.push_back({i});
  }
  const auto sticks = std::find_if(monitors_.begin(), monitors_.end(),
                                   [&](const Monitor& m) { return !phase.held[m.held].slips; });
  const bool ignored = std::any_of(phase.held.begin(), phase.held.end(),
                                   [&](const Held& h) { return h.mutedUntil > x.t; });
  if (sticks != monitors_.end() && phase.mayContradict() && !ignored)
    monitors_.push_back({sticks->held, true});
  const auto size = static_cast<Eigen::Index>(monitors_.size());
  if (x.t == end_ && endForces_.size() == size)
    startForces_ = endForces_, startScale_ = endScale_;
  else if (x.t != start_ || startForces_.size() != size)
    startScale_ = forces(phase, startForces_);
  start_ = x.t, at_.memory = x.memory;
  for (std::size_t m = 0; m < monitors_.size(); ++m)
    monitors_[m].zeroStart =
        startForces_[static_cast<Eigen::Index>(m)] <= kForceNoise * startScale_;
}

void ForceSearch::forget(double t) {
  if (end_ == t) end_ = std::numeric_limits<double>::quiet_NaN();
  if (start_ == t) start_ = std::numeric_limits<double>::quiet_NaN();
}

double ForceSearch::forces(const FrozenPhase& phase, Eigen::VectorXd& out) const {
  out.setZero(static_cast<Eigen::Index>(monitors_.size()));
  for (std::size_t m = 0; m < monitors_.size(); ++m)
    out[static_cast<Eigen::Index>(m)] = distance(phase, monitors_[m]);
  return phase.forceScale();
}

double ForceSearch::distance(const FrozenPhase& phase, const Monitor& m) const {
  double out = 0.0;
  if (m.contradicts) return phase.forceScale() * (kBegins - phase.contradiction());
  phase.margin(m.held, out);
  return out;
}

void ForceSearch::value(const FrozenPhase& phase, int monitor, double& out) const {
  out = distance(phase, monitors_[static_cast<std::size_t>(monitor)]);
}

bool ForceSearch::valueAt(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path,
                          int monitor, double theta, double& v) {
  path.at(theta, at_);
  s.evaluate(at_, phase.request.ofStage());
  Eigen::VectorXd& a = work_;
  if (!phase.accelerate(s.slot(1), at_.u, a)) return false;
  value(phase, monitor, v);
  return true;
}

bool ForceSearch::sample(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path) {
  if (monitors_.empty()) return true;
  double unused = 0.0;
  if (!valueAt(s, phase, path, 0, 0.5, unused)) return false;
  scale_ = std::max({startScale_, forces(phase, middleForces_), endScale_});
  return true;
}

bool ForceSearch::bends(Eigen::Index monitor, double by) const {
  // The deviation is large as a part of the largest force, or of the force's own distance to zero.
  const double least =
      std::min({startForces_[monitor], middleForces_[monitor], endForces_[monitor]});
  return std::abs(by) > kRough * scale_ ||
         std::abs(by) > std::max(kRoughNear * scale_, kRoughMargin * least);
}

bool ForceSearch::roughSamples() const {
  for (Eigen::Index m = 0; m < startForces_.size() && any(); ++m)
    if (bends(m, startForces_[m] - 2.0 * middleForces_[m] + endForces_[m])) return true;
  return false;
}

bool ForceSearch::rough(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path) {
  double unused = 0.0;
  const double b = kBetween;
  if (!any() || !valueAt(s, phase, path, 0, b, unused)) return false;
  forces(phase, work_);
  const double l0 = (1.0 - b) * (1.0 - 2.0 * b), l1 = 4.0 * b * (1.0 - b), l2 = b * (2.0 * b - 1.0);
  work_ -= l0 * startForces_ + l1 * middleForces_ + l2 * endForces_;
  for (Eigen::Index m = 0; m < work_.size(); ++m)
    if (bends(m, work_[m])) return true;
  return false;
}

bool ForceSearch::find(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path,
                       double width, Switch& first) {
  for (int m = 0; m < static_cast<int>(monitors_.size()); ++m)
    if (!findOf(s, phase, path, m, width, first)) return false;
  return true;
}

bool ForceSearch::findOf(MechanicalSystem& s, FrozenPhase& phase, const QuinticPath& path,
                         int monitor, double width, Switch& first) {
  const Monitor& k = monitors_[static_cast<std::size_t>(monitor)];
  const double samples[3] = {startForces_[monitor], middleForces_[monitor], endForces_[monitor]};
  const double noise = kForceNoise * scale_;
  if (k.contradicts && !(std::min(samples[1], samples[2]) < -kContradiction * scale_)) return true;
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
      if (!valueAt(s, phase, path, monitor, 0.5 * b, v)) return false;
      if (v > noise) {
        a = 0.5 * b, fa = v;
        break;
      }
      b *= 0.5, fb = v;
    }
  }
  double root = a, slope = 0.0;
  const auto value = [&](double t, double& v) { return valueAt(s, phase, path, monitor, t, v); };
  const double fall = fa - fb;
  const bool wide = b - a > 2.0 * width;
  Bracket at{a, fa, b, fb};
  if (fa > 0.0 && !at.refine(width, 0.0, value, root, slope)) return false;
  if (wide && fa > 0.0 && at.fa - at.fb > kJump * fall) {
    // The bracket has shrunk, the fall has not: a jump, unless the middle value is near the mean.
    double middle = 0.0;
    if (!value(0.5 * (at.a + at.b), middle)) return false;
    if (std::abs(middle - 0.5 * (at.fa + at.fb)) > kAside * (at.fa - at.fb)) {
      const double fine = std::max(kJumpWidth, width * width * width);  // no slope: 1e-5 tol
      if (!at.refine(fine, 0.0, value, root, slope)) return false;
      root = at.b, slope = 0.0;  // right after the jump
    }
  }
  if (!(root < first.theta)) return true;
  first = {root > 0.0 ? Switch::Kind::root : Switch::Kind::atStart, root, true, monitor,
           slope / path.length()};
  return true;
}

}  // namespace dynamy
