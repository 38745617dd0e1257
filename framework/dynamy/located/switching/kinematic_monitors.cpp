#include <algorithm>
#include <cmath>
#include <dynamy/located/switching/kinematic_monitors.hpp>

namespace dynamy {
namespace {

/// An open circle is tilted by more than a closed one that comes to lie flat, by this part of the
/// height of flat ones.
constexpr double kTilted = 0.25;

}  // namespace

double KinematicMonitor::value(const ContactProbe& probe) const {
  if (kind == Kind::latch) return -probe.switching()[static_cast<std::size_t>(contact)];
  const ContactGaps& gaps = probe.gaps();
  if (kind == Kind::presence) return gaps.presence(contact);
  if (!isGap()) return sign * gaps.gamma(contact, row);
  const double gap = sign * gaps.gap(contact) + above;
  // The lowest point of a circle that ceases to lie flat closes even if it is below already.
  return flat > 0.0 ? std::max(gap, kTilted * flat - gaps.presence(contact)) : gap;
}

void KinematicMonitors::watchOpen(const ContactProbe& probe, const FrozenPhase& phase) {
  const ContactGaps& gaps = probe.gaps();
  // An open contact at the place of a closed contact of the same bodies is the same contact.
  std::vector<int> closed;
  for (int i = 0; i < gaps.size(); ++i)
    if (gaps.comesAndGoes(i) && findHeld(phase.held, gaps.key(i)) != nullptr) closed.push_back(i);
  for (int i = 0; i < gaps.size(); ++i) {
    if (!gaps.law(i).unilateral() || findHeld(phase.held, gaps.key(i)) != nullptr) continue;
    KinematicMonitor m;
    m.contact = i, m.key = gaps.key(i), m.flat = gaps.isOnCircle(i) ? limits_.flat : 0.0;
    m.features = gaps.comesAndGoes(i) && m.flat == 0.0;
    if (m.features && std::any_of(closed.begin(), closed.end(),
                                  [&](int c) { return gaps.coincide(i, c, limits_.same); }))
      continue;
    const double gap = gaps.gap(i);
    m.behind =
        m.features && (gap < -limits_.touch || (gap < limits_.gapNoise && gaps.presence(i) <= 0.0));
    const bool borne = std::find(borne_.begin(), borne_.end(), m.key) != borne_.end();
    m.above = borne ? deep_ + 2.0 * (kStart * limits_.gapNoise + std::abs(gap)) : 0.0;
    monitors_.push_back(m);
  }
}

void KinematicMonitors::watchHeld(const ContactProbe& probe, const FrozenPhase& phase, double t,
                                  const std::vector<char>& idle) {
  using Kind = KinematicMonitor::Kind;
  const ContactGaps& gaps = probe.gaps();
  const HeldRows& rows = phase.rows();
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const Held& h = phase.held[i];
    KinematicMonitor m;
    m.contact = gaps.find(h.key), m.key = h.key;
    const bool notch = rows.set(i).form == ForceSet::Form::notch, muted = h.mutedUntil > t;
    if (h.slips && (notch || (rows.slipRows(i) == 1 && !muted && idle[i] == 0))) {
      m.kind = notch ? Kind::gap : Kind::slip, m.sign = h.sign;
      if (!notch) m.row = h.first + rows.slip0(i) - rows.row0(i);
      monitors_.push_back(m);
    }
    if (h.first != 0 || m.contact < 0 || !gaps.comesAndGoes(m.contact)) continue;
    m.kind = Kind::presence, m.row = 0, m.sign = 1.0;
    m.flat = gaps.isOnCircle(m.contact) ? limits_.flat : 0.0;
    monitors_.push_back(m);
  }
}

bool KinematicMonitors::watch(ContactProbe& probe, const FrozenPhase& phase, const State& x,
                              const std::vector<char>& idle) {
  using Kind = KinematicMonitor::Kind;
  monitors_.clear();
  if (!probe.look(x)) return false;
  watchOpen(probe, phase);
  watchHeld(probe, phase, x.t, idle);
  for (std::size_t i = 0; i < probe.switching().size(); ++i) {
    KinematicMonitor m;
    m.kind = Kind::latch, m.contact = static_cast<int>(i);
    m.key = probe.announcements().switcher(i);
    monitors_.push_back(m);
  }
  for (KinematicMonitor& m : monitors_) {
    const bool speed = m.kind == Kind::slip || m.kind == Kind::latch;
    m.noise = speed ? limits_.speedNoise : limits_.gapNoise;
    m.zeroStart = !m.behind && m.value(probe) <= kStart * m.noise;
  }
  return true;
}

bool KinematicMonitors::closedBefore(ContactProbe& probe, const State& x, Switch& w) const {
  if (!gaps() || !probe.look(x)) return false;
  Switch first;
  double longest = 0.0;
  for (int i = 0; i < size(); ++i) {
    const KinematicMonitor& m = (*this)[i];
    if (!m.isGap() || (!w.force && i == w.monitor)) continue;
    if (m.behind || !m.present(probe)) continue;
    const double gap = m.value(probe), closing = m.rate(probe);
    if (!(gap < -limits_.gapNoise && closing < 0.0 && gap / closing > longest)) continue;
    longest = gap / closing;
    first = {Switch::Kind::root, w.theta, false, i, closing};
  }
  if (first) w = first;
  return bool(first);
}

}  // namespace dynamy
