// SwitchSearch: the choice of monitors, and their values.                         (theory 50.3)
#include <algorithm>
#include <cmath>
#include <dynamy/located/switching/switch_search.hpp>

namespace dynamy {
namespace {

/// Features do not lie over one another between two samples if their presence is below zero by more
/// than this multiple of its change.
constexpr double kAway = 2.0;

}  // namespace

void SwitchSearch::prepare(double gapNoise, double speedNoise, double touch, double same) {
  gapNoise_ = gapNoise, speedNoise_ = speedNoise, touch_ = touch, same_ = same;
}

bool SwitchSearch::begin(ContactProbe& probe, const FrozenPhase& phase, const State& x) {
  borne_.clear();
  if (x.t != start_ || startIdle_.size() != phase.held.size()) {
    const bool known = x.t == end_ && endIdle_.size() == phase.held.size();
    if (known)
      startIdle_ = endIdle_;
    else
      idles(phase, startIdle_);
  }
  if (!watch(probe, phase, x)) return false;
  watchForces(phase, x);
  return true;
}

void SwitchSearch::idles(const FrozenPhase& phase, std::vector<char>& out) {
  out.resize(phase.held.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = phase.idle(i) ? 1 : 0;
}

void SwitchSearch::watchForces(const FrozenPhase& phase, const State& x) {
  force_.clear();
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const Held& h = phase.held[i];
    double margin = 0.0;
    const bool muted = h.mutedUntil > x.t;
    if (phase.margin(i, margin) &&
        (!muted || phase.form(i) == FrozenPhase::Form::normal || h.slips))
      force_.push_back({Monitor::Kind::force, static_cast<int>(i), 0, 1.0, false, h.key});
  }
  const auto size = static_cast<Eigen::Index>(force_.size());
  if (x.t == end_ && endForces_.size() == size)
    startForces_ = endForces_, startScale_ = endScale_;
  else if (x.t != start_ || startForces_.size() != size)
    startScale_ = forces(phase, startForces_);
  start_ = x.t;
  for (std::size_t m = 0; m < force_.size(); ++m)
    force_[m].zeroStart = startForces_[static_cast<Eigen::Index>(m)] <= kForceNoise * startScale_;
}

void SwitchSearch::watchOpen(const ContactProbe& probe, const FrozenPhase& phase) {
  // An open contact at the place of a closed contact of the same bodies is the same contact.
  std::vector<int> closed;
  for (int i = 0; i < probe.size(); ++i)
    if (probe.comesAndGoes(i) && phase.find(probe.key(i)) != nullptr) closed.push_back(i);
  for (int i = 0; i < probe.size(); ++i) {
    if (!probe.law(i).unilateral() || phase.find(probe.key(i)) != nullptr) continue;
    const bool features = probe.comesAndGoes(i);
    if (features && std::any_of(closed.begin(), closed.end(),
                                [&](int c) { return probe.coincide(i, c, same_); }))
      continue;
    const bool behind = features && (probe.gap(i) < -touch_ ||
                                     (probe.gap(i) < gapNoise_ && probe.presence(i) <= 0.0));
    const bool borne = std::find(borne_.begin(), borne_.end(), probe.key(i)) != borne_.end();
    const double above = borne ? deep_ + 2.0 * (kStart * gapNoise_ + std::abs(probe.gap(i))) : 0.0;
    kinematic_.push_back(
        {Monitor::Kind::gap, i, 0, 1.0, false, probe.key(i), features, behind, above});
  }
}

bool SwitchSearch::watch(ContactProbe& probe, const FrozenPhase& phase, const State& x) {
  kinematic_.clear();
  at_.memory = x.memory;
  if (!probe.look(x)) return false;
  using Watched = Monitor::Kind;
  watchOpen(probe, phase);
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const Held& h = phase.held[i];
    const FrozenPhase::Form form = phase.form(i);
    const bool muted = h.mutedUntil > x.t;
    const int row = h.first + phase.slip0(i) - phase.row0(i), at = probe.find(h.key);
    if (h.slips && form == FrozenPhase::Form::notch)
      kinematic_.push_back({Watched::gap, at, 0, h.sign, false, h.key});
    else if (h.slips && phase.slipRows(i) == 1 && !muted && startIdle_[i] == 0)
      kinematic_.push_back({Watched::slip, at, row, h.sign, false, h.key});
    if (h.first == 0 && at >= 0 && probe.comesAndGoes(at))
      kinematic_.push_back({Watched::presence, at, 0, 1.0, false, h.key});
  }
  for (std::size_t i = 0; i < probe.switching().size(); ++i)
    kinematic_.push_back(
        {Watched::latch, static_cast<int>(i), 0, 1.0, false, probe.announcements().switcher(i)});
  values_.resize(static_cast<Eigen::Index>(kinematic_.size()), kSamples + 1);
  rates_.setZero(values_.rows(), values_.cols());
  presences_.setZero(values_.rows(), values_.cols());
  column(probe, 0);
  for (std::size_t m = 0; m < kinematic_.size(); ++m)
    kinematic_[m].zeroStart = !kinematic_[m].behind && values_(static_cast<Eigen::Index>(m), 0) <=
                                                           kStart * noise(kinematic_[m]);
  return true;
}

double SwitchSearch::measure(const ContactProbe& probe, const Monitor& m) const {
  if (m.kind == Monitor::Kind::latch)
    return -probe.switching()[static_cast<std::size_t>(m.contact)];
  if (m.kind == Monitor::Kind::presence) return probe.presence(m.contact);
  return isGap(m) ? m.sign * probe.gap(m.contact) + m.above
                  : m.sign * probe.gamma(m.contact, m.row);
}

double SwitchSearch::rate(const ContactProbe& probe, const Monitor& m) const {
  return isGap(m) ? m.sign * probe.gamma(m.contact) : 0.0;
}

void SwitchSearch::column(const ContactProbe& probe, int sample) {
  for (std::size_t m = 0; m < kinematic_.size(); ++m) {
    values_(static_cast<Eigen::Index>(m), sample) = measure(probe, kinematic_[m]);
    rates_(static_cast<Eigen::Index>(m), sample) = rate(probe, kinematic_[m]);
    if (kinematic_[m].features)
      presences_(static_cast<Eigen::Index>(m), sample) = probe.presence(kinematic_[m].contact);
  }
}

double SwitchSearch::forces(const FrozenPhase& phase, Eigen::VectorXd& out) const {
  out.setZero(static_cast<Eigen::Index>(force_.size()));
  for (std::size_t m = 0; m < force_.size(); ++m)
    phase.margin(static_cast<std::size_t>(force_[m].contact), out[static_cast<Eigen::Index>(m)]);
  return phase.forceScale();
}

bool SwitchSearch::present(const ContactProbe& probe, const Monitor& m) const {
  return !m.features || probe.presence(m.contact) > 0.0;
}

bool SwitchSearch::mayBePresent(const Monitor& m, int monitor, int j) const {
  if (!m.features) return true;
  const double a = presences_(monitor, j - 1), b = presences_(monitor, j);
  return std::max(a, b) > -kAway * std::abs(b - a);
}

}  // namespace dynamy
