/// SwitchSearch: finds on the path through a trial step where the status of a contact ends
/// (theory 50.3).
///
/// A monitor is a number that is positive while the status holds. KinematicSearch samples those of
/// gaps and slips at eight points without any force; ForceSearch those of forces at the middle and
/// the end. The first switch of all is found.
#pragma once
#include <dynamy/located/switching/force_search.hpp>
#include <dynamy/located/switching/kinematic_search.hpp>

namespace dynamy {

class SwitchSearch {
 public:
  void prepare(const MonitorLimits& limits) { kinematic_.monitors.prepare(limits); }
  /// Sets up the monitors of `phase` and their values at the start `x` of a step, where the phase
  /// has evaluated its forces. False: contacts changed.
  bool begin(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  /// Until the next begin(): joints bear the open contacts `keys`, see KinematicMonitors.
  void borne(const std::vector<ContactKey>& keys, double deep) {
    kinematic_.monitors.borne(keys, deep);
  }
  /// Sets up the kinematic monitors anew, for the contacts that `probe` follows now.
  bool watch(ContactProbe& probe, const FrozenPhase& phase, const State& x);
  static constexpr int kSamples = KinematicSearch::kSamples;
  /// Finds the first switch on `path`, after atEnd() for its end. `looked`: gaps that come near
  /// zero are not examined again. `width`: accuracy of a root of forces, as a part of the step.
  /// False: a fault of the phase or of contacts.
  bool find(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase, const QuinticPath& path,
            bool looked, double width, Switch& out);
  /// Value of the monitor of `w` at x, from kinematics or from the forces of the phase there.
  bool value(ContactProbe& probe, const FrozenPhase& phase, const State& x, const Switch& w,
             double& out);
  /// True: at x, where `w` was found, another contact has closed before; w becomes its switch. Two
  /// contacts that close shortly after each other may do so in another order on the path than in
  /// the true motion.
  bool closedBefore(ContactProbe& probe, const State& x, Switch& w) {
    return kinematic_.monitors.closedBefore(probe, x, w);
  }
  /// The contact of a switch that was found.
  ContactKey contact(const FrozenPhase& phase, const Switch& w) const;
  /// True: an element switches there (Announcements).
  bool latches(const Switch& w) const { return is(w, KinematicMonitor::Kind::latch); }
  /// True: a monitor of this kind switches there.
  bool is(const Switch& w, KinematicMonitor::Kind kind) const {
    return w && !w.force && kinematic_.monitors[w.monitor].kind == kind;
  }
  /// True: two features of a closed contact leave one another there.
  bool leaves(const Switch& w) const { return is(w, KinematicMonitor::Kind::presence); }
  /// True: the gap of two features that come and go.
  bool isOfFeatures(const Switch& w) const {
    return w && !w.force && kinematic_.monitors[w.monitor].features;
  }
  /// True: there are open contacts.
  bool gaps() const { return kinematic_.monitors.gaps(); }
  /// True: forces or slips on the last path, from one state at rest to another, change faster than
  /// the samples resolve. Evaluates the monitors between the samples, once those of forces.
  bool rough(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase, const QuinticPath& path);
  bool any() const { return kinematic_.monitors.any() || force_.any(); }
  /// True: find() evaluates forces, and leaves those of its last look in the phase.
  bool looksAtForces() const { return force_.any(); }
  /// True: before θ on the path a circle rolls past lying flat faster than the samples resolve.
  bool passesFlat(double theta) const { return kinematic_.passesFlat(theta); }
  /// Notes the forces at the end of the path, time t; to be called before find().
  void atEnd(const FrozenPhase& phase, double t) { force_.atEnd(phase, t); }
  /// Forgets all noted forces, because statuses have changed.
  void forget() { force_.forget(); }
  /// Forgets the forces noted at time t, because the state there has changed.
  void forget(double t) { force_.forget(t); }

 private:
  KinematicSearch kinematic_;
  ForceSearch force_;
};

}  // namespace dynamy
