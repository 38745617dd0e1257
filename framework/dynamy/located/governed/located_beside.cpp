#include <algorithm>
#include <dynamy/located/governed/located_beside.hpp>
#include <dynamy/located/governed/stepped_islands.hpp>

namespace dynamy {
namespace {

constexpr int kSlots = 2;  ///< of a system whose switches are located

void add(StepEffort& sum, const StepEffort& e) {
  sum.smooth += e.smooth, sum.rejected += e.rejected;
  sum.switches += e.switches, sum.events += e.events;
  sum.looks += e.looks, sum.gaps += e.gaps;
}

void add(StepCounts& sum, const StepCounts& c) {
  add(sum.effort, c.effort);
  sum.rejected += c.rejected, sum.switches += c.switches, sum.impacts += c.impacts;
  sum.accumulations += c.accumulations, sum.undecided += c.undecided;
  if (c.accumulations > 0) sum.accumulationEnd = c.accumulationEnd;
  sum.unseen = std::max(sum.unseen, c.unseen);
}

/// Calls `f` for each system with velocities whose flag is `which`.
template <class F>
void forSystems(const Topology& topology, const std::vector<char>& flags, bool which, F&& f) {
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (const SystemHandle& s = topology.system(static_cast<int>(i));
        s.nu > 0 && (flags[i] != 0) == which)
      f(s);
}

}  // namespace

bool LocatedBeside::any(const Topology& topology, const SteppedState& stepped) {
  bool any = false;
  forSystems(topology, stepped.systems, false, [&](const SystemHandle&) { any = true; });
  return any;
}

int LocatedBeside::steppedSystems(const Topology& topology, const SteppedState& stepped) {
  int n = 0;
  forSystems(topology, stepped.systems, true, [&](const SystemHandle&) { ++n; });
  return n;
}

MechanicalSystem& LocatedBeside::viewOf(const MechanicalSystem& s, const SteppedState& stepped) {
  const SystemParts& whole = s.parts();
  if (!view_ || view_->parts().topology != whole.topology ||
      view_->parts().forces != whole.forces || view_->parts().contacts != whole.contacts) {
    SystemParts parts = whole;
    parts.subset = &subset_, subset_ = {};
    view_ = std::make_unique<MechanicalSystem>(parts, kSlots);
    motion_.reset(), known_ = false;  // they were of another model
  }
  subset_.assign(*whole.topology, stepped.systems, whole.forces, whole.contacts);
  view_->gTol(s.gTol()), view_->limits = s.limits;
  return *view_;
}

/// Sets the start of a step of the located islands, which may reach up to `end`: as it was kept,
/// else at x.
void LocatedBeside::start(const MechanicalSystem& s, const Beginning& beginning, const State& x,
                          double end, const SteppedState& stepped) {
  const BesideState& kept = stepped.beside;
  from_.memory = x.memory, from_.impulses = {};
  if (kept.known) {
    from_.t = kept.t, end_ = kept.end;
    from_.q = kept.q, from_.u = kept.u, from_.scheme = kept.scheme;
    return;
  }
  from_.t = x.t, from_.q = x.q, from_.u = x.u, end_ = end;
  forSystems(*s.parts().topology, stepped.systems, true,
             [&](const SystemHandle& h) { from_.u.segment(h.u0, h.nu).setZero(); });
  from_.scheme = beginning.whole.decidedAnew();
}

/// Takes one step of the located islands from from_. False: some of them have to be stepped in time
/// as well from now on.
bool LocatedBeside::step(MechanicalSystem& s, InclusionSolver& solver, bool again,
                         SteppedState& stepped, StepCounts& counts) {
  to_ = from_;
  StepReport report;
  MechanicalSystem& view = viewOf(s, stepped);
  const long evaluations = view.evaluations();
  bool good = motion_->load(view, to_) &&
              !motion_->locate(view, solver, to_, end_ - from_.t, report) && report.solved.ok();
  s.count(view.evaluations() - evaluations);
  works_ = report.works;
  const bool dense = motion_->turned();
  good = good && !dense;
  // Of a step that is not accepted, or that was counted before, only the effort counts.
  again || !good ? add(counts.effort, report.counts.effort) : add(counts, report.counts);
  if (good) return true;
  std::vector<char>& systems = stepped.systems;
  const std::vector<char> before = systems;
  const std::vector<char>& more = motion_->state().stepped.systems;
  for (std::size_t i = 0; dense && i < systems.size(); ++i)
    if (more[i] != 0) systems[i] = 1;
  if (systems == before) systems.assign(systems.size(), 1);
  stepped.beside = {}, known_ = false;
  return false;
}

double LocatedBeside::follow(MechanicalSystem& s, InclusionSolver& solver,
                             const Beginning& beginning, const State& x, double end,
                             SteppedState& stepped, StepCounts& counts) {
  while (any(*s.parts().topology, stepped)) {
    viewOf(s, stepped);
    if (!motion_) {
      motion_ = std::make_unique<GovernedMotion>(beginning.settings);
      motion_->motion().aim(beginning.settings.accuracy);
    }
    bool good = true;
    const bool kept = stepped.beside.known;
    if (!known_ || !kept || !(kept_ == stepped.beside))
      start(s, beginning, x, end, stepped), good = step(s, solver, kept, stepped, counts);
    while (good && to_.t <= x.t) {
      from_ = to_, end_ = end;
      good = step(s, solver, false, stepped, counts);
    }
    if (!good) continue;
    known_ = true;
    return to_.t;
  }
  return end;
}

void LocatedBeside::within(double t, State& out) {
  const double theta = (t - from_.t) / (to_.t - from_.t);
  if (!motion_->motion().interpolate(*view_, from_, to_, theta, out))
    SteppedIslands::linear(*view_, from_, to_, theta, out);
}

void LocatedBeside::place(MechanicalSystem& s, double t, const SteppedState& stepped) {
  if (!any(*s.parts().topology, stepped)) return;
  MechanicalSystem& view = viewOf(s, stepped);
  const long evaluations = view.evaluations();
  within(t, at_);
  s.count(view.evaluations() - evaluations);
  if (to_.t == t) at_ = to_;  // the state after a switch there
}

void LocatedBeside::join(MechanicalSystem& s, State& x, SteppedState& stepped, StepReport& report) {
  // This step, which included the contact of systems that touched, counts as the first of their
  // steps in time.
  const Topology& topology = *s.parts().topology;
  const std::vector<char> before = stepped.systems;
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
  stepped.beside = {};
  apart_.assign(stepped.systems.size(), 0);
  forSystems(topology, stepped.systems, false, [&](const SystemHandle& h) {
    x.q.segment(h.q0, h.nq) = at_.q.segment(h.q0, h.nq);
    x.u.segment(h.u0, h.nu) = at_.u.segment(h.u0, h.nu);
    apart_[static_cast<std::size_t>(h.index)] = 1;
  });
  if (!any(topology, stepped)) {
    known_ = false;
    return;
  }
  report.apart = apart_;
  if (to_.t == x.t) report.works = works_, report.works.given = false;
  if (stepped.systems != before) {
    known_ = false;
    return;
  }
  kept_ = {true, from_.t, end_, from_.q, from_.u, from_.scheme};
  stepped.beside = kept_;
}

double LocatedBeside::nextStep(double t, double h, double first) const {
  if (!known_) return first;
  return to_.t > t ? std::min(h, to_.t - t) : to_.scheme[0];
}

void LocatedBeside::show(const MechanicalSystem& s, double t, const SteppedState& stepped,
                         State& out) {
  if (!known_ || t < from_.t || t > to_.t) return;
  within(t, shown_);
  forSystems(*s.parts().topology, stepped.systems, false, [&](const SystemHandle& h) {
    out.q.segment(h.q0, h.nq) = shown_.q.segment(h.q0, h.nq);
    out.u.segment(h.u0, h.nu) = shown_.u.segment(h.u0, h.nu);
  });
}

}  // namespace dynamy
