/// KinematicMonitors: the monitors of gaps, slips, latches and features, which need no force:
///
///   open      gap g                       slip in one direction   s γ_T
///   beside the notch of a preloaded spring  s x
///   latch (an element that switches)        minus the number that it reports
///   closed by two features                  how far they lie over one another (presence)
#pragma once
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/located/switching/contact_probe.hpp>
#include <dynamy/located/switching/switch.hpp>

namespace dynamy {

/// Numbers below which monitors count as zero.
struct MonitorLimits {
  double gapNoise = 0.0;    ///< of gaps [m]
  double speedNoise = 0.0;  ///< of velocities [m/s]
  double touch = 0.0;       ///< bodies lie on each other at gaps and overlaps up to this [m]
  double flat = 0.0;        ///< circles with the lowest point less below the middle lie flat [m]
  double same = 0.0;        ///< nearer contacts of one pair of bodies count as one [m]
  double gone = 0.0;        ///< features whose presence is less take no part in events [m]
};

struct KinematicMonitor {
  enum class Kind : std::uint8_t { gap, slip, latch, presence } kind = Kind::gap;
  int contact = 0;  ///< index in the probe; number of a latch
  int row = 0;      ///< of γ within the contact
  double sign = 1.0;
  ContactKey key = {};
  bool features = false;  ///< a gap of two features that come and go
  /// Of the lowest point of a circle that is tilted little: MonitorLimits::flat; else 0.
  double flat = 0.0;
  bool behind = false;     ///< such a gap that starts below zero
  double above = 0.0;      ///< added to the gap of a contact that joints bear
  double noise = 0.0;      ///< values below this count as zero
  bool zeroStart = false;  ///< it starts near zero

  bool isGap() const { return kind == Kind::gap; }
  /// Value, rate of a gap (else 0), and presence of its features, at the last look of the probe.
  double value(const ContactProbe& probe) const;
  double rate(const ContactProbe& probe) const {
    return isGap() ? sign * probe.gaps().gamma(contact) : 0.0;
  }
  bool present(const ContactProbe& probe) const {
    return !features || probe.gaps().presence(contact) > 0.0;
  }
};

class KinematicMonitors {
 public:
  static constexpr double kStart = 1e3;  ///< of the noise: a monitor below this starts at zero
  void prepare(const MonitorLimits& limits) { limits_ = limits; }
  const MonitorLimits& limits() const { return limits_; }
  /// Until the next call: joints bear the open contacts `keys`. Their gaps are the drift of the
  /// joints, and switch only where they fall below −`deep` [m].
  void borne(const std::vector<ContactKey>& keys, double deep) { borne_ = keys, deep_ = deep; }
  /// Sets up the monitors for the contacts that `probe` follows, at the start x of a step. `idle`:
  /// per held part, not 0 if its set is idle. False: contacts changed.
  bool watch(ContactProbe& probe, const FrozenPhase& phase, const State& x,
             const std::vector<char>& idle);
  /// As SwitchSearch::closedBefore.
  bool closedBefore(ContactProbe& probe, const State& x, Switch& w) const;

  bool any() const { return !monitors_.empty(); }
  /// True: there are open contacts.
  bool gaps() const { return any() && monitors_.front().isGap(); }
  int size() const { return static_cast<int>(monitors_.size()); }
  const KinematicMonitor& operator[](int i) const { return monitors_[static_cast<std::size_t>(i)]; }

 private:
  void watchOpen(const ContactProbe& probe, const FrozenPhase& phase);
  void watchHeld(const ContactProbe& probe, const FrozenPhase& phase, double t,
                 const std::vector<char>& idle);
  MonitorLimits limits_;
  std::vector<KinematicMonitor> monitors_;
  std::vector<ContactKey> borne_;
  double deep_ = 0.0;
};

}  // namespace dynamy
