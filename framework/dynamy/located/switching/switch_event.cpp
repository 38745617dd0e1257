#include <algorithm>
#include <dynamy/located/switching/switch_event.hpp>

namespace dynamy {
namespace {

constexpr int kMostDecisions = 12;
constexpr int kMostPushes = 20;

/// True: some status has changed.
bool differ(const std::vector<Held>& a, const std::vector<Held>& b) {
  return !std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Held& x, const Held& y) {
    return x.key == y.key && x.first == y.first && x.slips == y.slips && x.sign == y.sign;
  });
}

}  // namespace

void SwitchEvent::projectHeld(OngoingEvent& at, const std::vector<Held>& held) {
  // Faces that lie on each other touch with all their features, up to the drift of those features
  // that are held: this drift is removed first.
  keys_.clear();
  heldKeys(held, keys_);
  if (keys_.empty()) return;
  at.evaluate(at.p.x, keys_);
  projection_.positions(at, keys_, held);
  projection_.velocities(at.s, held, at.p.x);
}

/// Finds the contacts that take part, and projects with the old statuses `held`.
bool SwitchEvent::begin(OngoingEvent& at, ContactProbe& probe, const std::vector<Held>& held) {
  State& x = at.p.x;
  impact_.clear(), resting_.clear();
  if (probe.gaps().comeAndGo()) projectHeld(at, held);
  const auto gather = [&] {
    const bool known = contacts_.find(probe, held, left_, at);
    if (!known) return false;
    at.evaluate(x, contacts_.keys(), 0, true);
    contacts_.leaveToJoints(at);
    projection_.positions(at, contacts_.keys(), held);
    return true;
  };
  bool known = true;
  // Bodies that are pushed apart at the start may be pushed into others. Those that separate are
  // pushed, too, but have no impact.
  for (int pushes = 0; known && at.starts; ++pushes) {
    known = gather();
    at.starts = contacts_.overlap() && pushes < kMostPushes;
  }
  known = known && gather();
  left_ = kNoContact;
  if (!known) {
    at.result.fault = ContactProbe::kUnfollowed;
    return false;
  }
  projection_.velocities(at.s, held, x);
  uBefore_ = x.u, aBefore_ = at.p.a;
  return true;
}

/// Impact, decision and accelerations, repeated until no contact returns within the tolerance.
bool SwitchEvent::settle(OngoingEvent& at, const std::vector<Held>& old, double lookAhead,
                         const std::vector<HeldKey>& stopped) {
  State& x = at.p.x;
  for (int turn = 0;; ++turn) {
    x.u = uBefore_;
    impact_.take(at, resting_.plastic());
    if (resting_.shuts()) resting_.shut(at, impact_, projection_);
    const bool hit = !impact_.percussions().empty();
    at.result.impact = hit;
    decision_.decide(at,
                     {lookAhead, old, aBefore_, stopped, impact_.leaves(), hit,
                      hit || resting_.shuts(), plain_, released_},
                     next_.held);
    at.evaluate(x, contacts_.keys());
    uEvaluated_ = x.u;
    projection_.velocities(at.s, next_.held, x);
    const bool same = !hit && !differ(old, next_.held);
    if (same && impact_.stop(at)) at.evaluate(x, contacts_.keys()), uEvaluated_ = x.u;
    if (!next_.share(at.s.slot(0), x.u, at.p.a, same)) return false;
    if (plain_ || turn == kMostDecisions) return true;
    const bool closed = resting_.findClosed(at, impact_, next_.held),
               rests = resting_.findInNotch(at, aBefore_, old, next_.held);
    if (!closed && !rests && !(same && resting_.close(at, impact_))) return true;
  }
}

bool SwitchEvent::accelerateAlone(OngoingEvent& at) {
  // Elements may place a contact according to others that are closed, too. Those that have left no
  // longer count, and the phase has to begin with the same accelerations with which it continues.
  // It knows which rows follow from others, and rounds as it goes on to, not as forces were shared: a
  // run that is resumed here has the same bits.
  next_.findImplied();
  keys_.clear();
  heldKeys(next_.held, keys_);
  const bool all = keys_.size() == contacts_.keys().size() && at.p.x.u == uEvaluated_;
  if (!all) at.evaluate(at.p.x, keys_, 1, true);
  return next_.accelerate(at.s.slot(all ? 0 : 1), at.p.x.u, at.p.a);
}

EventResult SwitchEvent::process(MechanicalSystem& s, InclusionSolver& solver, ContactProbe& probe,
                                 FrozenPhase& phase, PhasePoint& p, const SmoothStep& smooth,
                                 double lookAhead, const std::vector<HeldKey>& stopped) {
  EventResult r;
  OngoingEvent at{s, solver, *norm_, p, r, phase.request, closes_, starts_};
  closes_ = kNoContact, starts_ = false;
  next_.request = phase.request;
  if (!begin(at, probe, phase.held)) return r;
  if (!settle(at, phase.held, lookAhead, stopped) || !accelerateAlone(at)) {
    r.fault = next_.fault(), r.lost = next_.lost();
    return r;
  }
  p.lambda = next_.lambda(), p.power = next_.power();
  smooth.rates(s, p);
  r.changed = differ(next_.held, phase.held);
  phase = next_;
  return r;
}

}  // namespace dynamy
