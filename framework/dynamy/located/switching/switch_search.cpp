#include <dynamy/located/switching/switch_search.hpp>

namespace dynamy {

bool SwitchSearch::begin(ContactProbe& probe, const FrozenPhase& phase, const State& x) {
  borne({}, 0.0);
  force_.idleAtStart(phase, x);
  if (!watch(probe, phase, x)) return false;
  force_.watch(phase, x);
  return true;
}

bool SwitchSearch::watch(ContactProbe& probe, const FrozenPhase& phase, const State& x) {
  if (!kinematic_.monitors.watch(probe, phase, x, force_.idle())) return false;
  kinematic_.start(probe, x);
  return true;
}

bool SwitchSearch::find(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase,
                        const QuinticPath& path, bool looked, double width, Switch& out) {
  out = {};
  if (!any()) return true;
  if (!kinematic_.sample(probe, path) || !force_.sample(s, phase, path)) return false;
  Switch first;
  first.theta = 2.0;
  if (!kinematic_.find(probe, path, looked, first) || !force_.find(s, phase, path, width, first))
    return false;
  if (first) out = first;
  return true;
}

bool SwitchSearch::rough(MechanicalSystem& s, ContactProbe& probe, FrozenPhase& phase,
                         const QuinticPath& path) {
  return force_.roughSamples() || kinematic_.roughSamples() || kinematic_.rough(probe, path) ||
         force_.rough(s, phase, path);
}

ContactKey SwitchSearch::contact(const FrozenPhase& phase, const Switch& w) const {
  return w.force ? phase.held[force_.held(w.monitor)].key : kinematic_.monitors[w.monitor].key;
}

bool SwitchSearch::value(ContactProbe& probe, const FrozenPhase& phase, const State& x,
                         const Switch& w, double& out) {
  if (w.force) {
    force_.value(phase, w.monitor, out);
    return true;
  }
  if (!probe.look(x)) return false;
  out = kinematic_.monitors[w.monitor].value(probe);
  return true;
}

}  // namespace dynamy
