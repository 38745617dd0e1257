#include <algorithm>
#include <dynamy/located/islands/divided_state.hpp>
#include <dynamy/located/islands/located_islands.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Part of a step after which it is worth to go on alone up to a meeting.
constexpr double kWorth = 0.05;
/// Part of a step that is too short for a step of its own.
constexpr double kTooShort = 1e-6;
/// Part of T in which shapes must not come near each other for an island to fall apart.
constexpr double kApart = 0.01;

bool contains(const std::vector<int>& ascending, int i) {
  return std::binary_search(ascending.begin(), ascending.end(), i);
}

bool stops(const MechanicalSystem& s) {
  return s.limits.stop != nullptr && s.limits.stop->load(std::memory_order_relaxed);
}

/// Fills an ascending list of the systems with velocities for which `f` is true.
template <class F>
std::vector<int> systemsWhere(const Topology& topology, F&& f) {
  std::vector<int> out;
  for (int i = 0; i < static_cast<int>(topology.systems().size()); ++i)
    if (topology.system(i).nu > 0 && f(static_cast<std::size_t>(i))) out.push_back(i);
  return out;
}

void drop(IslandClocks& clocks, std::size_t i) {
  clocks.erase(clocks.begin() + static_cast<std::ptrdiff_t>(i));
}

}  // namespace

void LocatedIslands::learn(const MechanicalSystem& s, const GovernedMotion& whole) {
  clocks_.clear();
  division_.learn(s);
  settings_ = whole.motion().settings(), decidedAnew_ = whole.decidedAnew();
}

/// Adds a clock for an island of s in state x.
IslandClock& LocatedIslands::add(const MechanicalSystem& s, const ClockState& x) {
  return *clocks_.emplace_back(std::make_unique<IslandClock>(s, settings_, x));
}

void LocatedIslands::addParts(const MechanicalSystem& s, const IslandDivision::Groups& groups,
                              const std::vector<IslandDivision::Joined>& joined,
                              const ClockState& x) {
  const std::size_t room =
      division_.most() > clocks_.size() ? division_.most() - clocks_.size() : 1;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::vector<int> systems = groups[g];
    if (g + 1 >= room) {  // there is no memory for more clocks
      for (std::size_t more = g + 1; more < groups.size(); ++more)
        systems.insert(systems.end(), groups[more].begin(), groups[more].end());
      std::sort(systems.begin(), systems.end());
      g = groups.size();
    }
    std::vector<ContactKey> keys;
    for (const IslandDivision::Joined& contact : joined)
      if (!contact.systems.empty() && contains(systems, contact.systems.front()))
        keys.push_back(contact.key);
    std::sort(keys.begin(), keys.end());
    add(s, partOf(x, *s.parts().topology, std::move(systems), keys));
  }
}

bool LocatedIslands::divide(MechanicalSystem& s, const GovernedMotion& whole, const State& x,
                            const StepReport& report) {
  division_.learn(s);
  const LocatedParts& parts = whole.motion().parts();
  if (!division_.possible(x) || !parts.bias.elements().empty()) return false;
  const std::vector<int> all = systemsWhere(*s.parts().topology, [](std::size_t) { return true; });
  const auto joined = IslandDivision::joinedAt(s, x);
  const double h = std::min(kApart * parts.norm.time(), parts.pace.next);
  const IslandDivision::Groups groups = division_.groups(all, joined, x, h);
  if (groups.size() < 2) return false;
  learn(s, whole);
  addParts(s, groups, joined,
           {all, x.t, x.t, x.q, x.u, x.scheme, {report.statuses.begin(), report.statuses.end()}});
  at_ = x;
  return true;
}

void LocatedIslands::stand(MechanicalSystem& s, InclusionSolver& solver,
                           const GovernedMotion& whole, const State& x,
                           const SteppedState& stepped) {
  const Topology& topology = *s.parts().topology;
  const std::vector<int> apart =
      systemsWhere(topology, [&](std::size_t i) { return stepped.systems[i] == 0; });
  std::size_t covered = 0;
  for (const auto& c : clocks_) covered += c->systems().size();
  const auto isHere = [&] {
    for (const auto& c : clocks_)
      for (const int i : c->systems()) {
        const SystemHandle& h = topology.system(i);
        if (at_.q.segment(h.q0, h.nq) != x.q.segment(h.q0, h.nq) ||
            at_.u.segment(h.u0, h.nu) != x.u.segment(h.u0, h.nu))
          return false;
      }
    return true;
  };
  if (at_.t == x.t && at_.q.size() == x.q.size() && kept_ == stepped.clocks &&
      kept_.size() == clocks_.size() && covered == apart.size() && isHere())
    return;
  learn(s, whole);
  kept_ = stepped.clocks;
  at_ = x;
  std::vector<int> kept;
  bool good = true;
  for (const ClockState& own : kept_) {
    IslandClock& c = add(s, own);
    // A clock that was set there has taken no step.
    const bool taken = !(own.end > own.t) || (!c.again(s, solver, own.end) && !c.now().turned);
    good = good && taken && c.now().from.t <= x.t && x.t <= c.now().to.t;
    kept.insert(kept.end(), own.systems.begin(), own.systems.end());
    if (!good) break;
    c.findPath(s, division_.shapes());
    c.place(s, x.t, at_, true);
    c.counted = c.now().to.t == x.t;
    // What was booked before the run was stopped.
    if (!c.counted) record_.begin(), record_.pass(s, c, x.t);
  }
  std::sort(kept.begin(), kept.end());
  if (good && kept == apart && isHere()) {
    record_ = {};
    return;
  }
  record_ = {};
  learn(s, whole);
  kept_.clear();
  at_ = x;
  if (apart.empty()) return;
  add(s, stateOf(topology, apart, x, decidedAnew_));
}

Refusal LocatedIslands::follow(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                               double end, SteppedState& stepped, RunPatience& patience) {
  record_.begin(&patience);
  patience_ = &patience;
  for (;;) {
    std::size_t next = clocks_.size();
    for (std::size_t i = 0; i < clocks_.size(); ++i)
      if (clocks_[i]->now().to.t <= x.t &&
          (next == clocks_.size() ||
           clocks_[i]->systems().front() < clocks_[next]->systems().front()))
        next = i;
    if (next == clocks_.size()) return {};
    if (stops(s)) return {Refusal::Kind::fault, "the run is stopped within this step"};
    if (Refusal r = proceed(s, solver, end, next, stepped)) return r;
  }
}

/// Lets a clock at the end of its step take the next one.
Refusal LocatedIslands::proceed(MechanicalSystem& s, InclusionSolver& solver, double end,
                                std::size_t clock, SteppedState& stepped) {
  if (fallApart(s, clock)) return {};
  IslandClock& c = *clocks_[clock];
  record_.end(c);
  c.motion().allow(patience_->allowance(settings_.patience,
                                        static_cast<double>(s.parts().topology->nu()), c.now().to.t,
                                        s.limits.end));
  Refusal refusal = c.step(s, solver, end);
  // Taken again, a step does not turn for its work: that it was taken has been decided.
  c.motion().allow({});
  record_.effort(c);
  if (!c.now().turned) {
    if (refusal || clocks_.size() == 1) return refusal;  // one alone meets none
    c.findPath(s, division_.shapes());
    return meet(s, solver, clock);
  }
  turned_ = c.motion().governor();
  const std::vector<int> chosen = c.toStep();
  for (const int i : chosen) stepped.systems[static_cast<std::size_t>(i)] = 1;
  std::vector<int> rest;
  for (const int i : c.systems())
    if (!contains(chosen, i)) rest.push_back(i);
  if (!rest.empty()) addParts(s, {rest}, c.joined(false), c.state(false));
  drop(clocks_, clock);
  return {};
}

bool LocatedIslands::fallApart(MechanicalSystem& s, std::size_t clock) {
  IslandClock& c = *clocks_[clock];
  if (settings_.oneClock || c.now().justSet || division_.inseparable(c.systems())) return false;
  const auto joined = c.joined(true);
  const double T = c.motion().motion().parts().norm.time();
  if (ends_.q.size() != at_.q.size()) ends_ = at_;
  c.place(s, c.now().to.t, ends_), ends_.t = c.now().to.t;
  const auto groups =
      division_.groups(c.systems(), joined, ends_, std::min(kApart * T, c.now().next()));
  if (groups.size() < 2 || clocks_.size() >= division_.most()) return false;
  record_.end(c);
  addParts(s, groups, joined, c.state(true));
  drop(clocks_, clock);
  return true;
}

/// Looks where the step of a clock meets those of others.
Refusal LocatedIslands::meet(MechanicalSystem& s, InclusionSolver& solver, std::size_t clock) {
  IslandClock& c = *clocks_[clock];
  const double t = c.now().from.t;
  double first = std::numeric_limits<double>::infinity();
  std::size_t with = clock;
  for (std::size_t i = 0; i < clocks_.size(); ++i) {
    if (i == clock || clocks_[i]->now().to.t <= t) continue;
    const double at = c.path().meets(clocks_[i]->path(), t);
    if (at < first) first = at, with = i;
  }
  if (with == clock || first >= c.now().to.t) return {};
  if (first <= t + kWorth * (c.now().to.t - t)) return merge(s, solver, clock, with);
  Refusal refusal = c.again(s, solver, first);
  record_.effort(c);
  if (refusal || c.now().turned) return merge(s, solver, clock, with);
  c.findPath(s, division_.shapes());
  return {};
}

/// Makes one island of two: a stands where its step begins, b may have begun its step before.
Refusal LocatedIslands::merge(MechanicalSystem& s, InclusionSolver& solver, std::size_t a,
                              std::size_t b) {
  IslandClock &A = *clocks_[a], &B = *clocks_[b];
  const double t = A.now().from.t;
  const Topology& topology = *s.parts().topology;
  // Where its step cannot be taken again, b decides everything anew.
  if (ends_.q.size() != at_.q.size()) ends_ = at_;
  B.place(s, t, ends_), ends_.t = t;
  ClockState with = stateOf(topology, B.systems(), ends_, decidedAnew_);
  with.statuses = B.now().before;
  if (t - B.now().from.t > kTooShort * (B.now().to.t - B.now().from.t)) {
    Refusal refusal = B.again(s, solver, t);
    record_.effort(B);
    while (!refusal && !B.now().turned && B.now().to.t < t) {
      record_.end(B);
      refusal = B.step(s, solver, t);
      record_.effort(B);
    }
    if (!refusal && !B.now().turned) {
      record_.end(B);
      with = B.state(true);
    }
  } else {
    with.scheme = B.state(false).scheme;
  }
  add(s, unionOf(A.state(false), with, topology)).orderContacts();
  drop(clocks_, std::max(a, b)), drop(clocks_, std::min(a, b));
  return {};
}

void LocatedIslands::place(MechanicalSystem& s, double t) {
  for (const auto& c : clocks_) c->place(s, t, at_, true);
  at_.t = t;
}

void LocatedIslands::join(const MechanicalSystem& s, State& x) const {
  for (const auto& c : clocks_)
    for (const int i : c->systems()) {
      const SystemHandle& h = s.parts().topology->system(i);
      x.q.segment(h.q0, h.nq) = at_.q.segment(h.q0, h.nq);
      x.u.segment(h.u0, h.nu) = at_.u.segment(h.u0, h.nu);
    }
}

void LocatedIslands::touch(MechanicalSystem& s, double t, SteppedState& stepped) {
  const Topology& topology = *s.parts().topology;
  // This step, which included the contact of systems that touched, counts as the first of their
  // steps in time.
  const ContactSet& c = s.slot(0).contacts;
  const ConstVec Lambda = s.problem().Lambda();
  Islands islands;
  islands.start(s.parts());
  for (int i = 0; i < c.size(); ++i) {
    const auto row = c.row0[static_cast<std::size_t>(i)];
    const bool acts = !c.law[static_cast<std::size_t>(i)]->unilateral() ||
                      c.position[static_cast<std::size_t>(row)] <= 0.0 ||
                      !Lambda.segment(row, c.dim(i)).isZero(0.0);
    if (acts) islands.join(c, i);
  }
  islands.spread(stepped.systems);
  for (const auto& clock : clocks_)
    if (stepped.heldUp && clock->now().to.t == t)
      for (const int k : clock->systems()) stepped.systems[static_cast<std::size_t>(k)] = 1;
  for (std::size_t i = clocks_.size(); i-- > 0;) {
    IslandClock& clock = *clocks_[i];
    std::vector<int> rest;
    for (const int k : clock.systems())
      if (stepped.systems[static_cast<std::size_t>(k)] == 0) rest.push_back(k);
    if (rest.size() == clock.systems().size()) continue;
    clock.now().to.t == t ? record_.end(clock) : record_.pass(s, clock, t);
    drop(clocks_, i);
    at_.t = t;
    if (!rest.empty()) add(s, stateOf(topology, std::move(rest), at_, decidedAnew_));
  }
}

void LocatedIslands::report(MechanicalSystem& s, const State& x, SteppedState& stepped,
                            StepReport& report) {
  for (const auto& c : clocks_) c->now().to.t == x.t ? record_.end(*c) : record_.pass(s, *c, x.t);
  const bool all = !stepped.any();
  if (all) contacts_.report(s, clocks_, x, record_.percussions(), report);
  record_.report(report);
  report.counts.islands = static_cast<int>(clocks_.size());
  report.works.given = all, report.impacts = record_.impacts();
  if (all) {
    report.solved = record_.solved();
  } else if (!clocks_.empty()) {
    report.statuses = contacts_.statuses(clocks_, x.t);
    apart_.assign(stepped.systems.size(), 0);
    for (const auto& c : clocks_)
      for (const int i : c->systems()) apart_[static_cast<std::size_t>(i)] = 1;
    report.apart = apart_;
  }
  keep(stepped);
}

void LocatedIslands::keep(SteppedState& stepped) {
  kept_.resize(clocks_.size());
  for (std::size_t i = 0; i < clocks_.size(); ++i) clocks_[i]->keep(kept_[i]);
  stepped.clocks = kept_;
}

void LocatedIslands::show(MechanicalSystem& s, double t, State& out) {
  for (const auto& c : clocks_)
    if (c->now().from.t <= t && t <= c->now().to.t) c->place(s, t, out);
}

bool LocatedIslands::contactsAt(MechanicalSystem& s, const State& at, bool after,
                                ContactInstant& out) {
  return contacts_.at(s, clocks_, at, after, out);
}

}  // namespace dynamy
