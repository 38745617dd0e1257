// LocatedDormandPrince: islands whose switches are located while others are stepped in time
// (theory 50.7).
#include <algorithm>
#include <dynamy/located/located_dormand_prince.hpp>
#include <numeric>

namespace dynamy {
namespace {

/// Leaves systems out of the topology during its lifetime.
class LeftOut {
 public:
  LeftOut(Topology& topology, const std::vector<char>& systems) : topology_(topology) {
    topology_.leaveOut(systems);
  }
  LeftOut(const LeftOut&) = delete;
  LeftOut& operator=(const LeftOut&) = delete;
  ~LeftOut() { topology_.leaveOut({}); }

 private:
  Topology& topology_;
};

void add(StepEffort& sum, const StepEffort& e) {
  sum.smooth += e.smooth, sum.rejected += e.rejected;
  sum.switches += e.switches, sum.events += e.events;
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

void LocatedDormandPrince::owe(const MechanicalSystem& s, double work, bool switched) {
  // A switch without a contact, or of a contact no longer reported, is charged to no system.
  int system = -1;
  if (switched) {
    if (const int i = probe_.find(lastSwitched_); i >= 0)
      system = islands_.systemOf(probe_.contacts(), i);
  } else if (smooth_.worst() >= 0) {
    system = islands_.systemOfVelocity(*s.parts().topology, smooth_.worst());
  }
  if (system >= 0) owed_(system, switched ? 0 : 1) += work;
}

void LocatedDormandPrince::chooseStepped(const State& x) {
  const SystemParts& parts = system_->parts();
  const std::size_t n = parts.topology->systems().size();
  timed_.assign(n, 1), quietKept_.resize(0), quiet_.known = false;
  const auto& systems = parts.topology->systems();
  const bool renews =
      std::any_of(systems.begin(), systems.end(), [](const auto* s) { return s->renews(); });
  if (!islands_.start(parts) || x.memory.size() > 0 || !untold_.empty() || renews) return;
  const double touch = norm_.tolerance() * norm_.length();
  for (int i = 0; i < probe_.size(); ++i)
    if (lost_ ? !probe_.law(i).unilateral() || probe_.gap(i) <= touch
              : phase_.find(probe_.key(i)) != nullptr)
      islands_.join(probe_.contacts(), i);
  std::vector<char> chosen(n, 0);
  if (governor_.turnedBy() == TurnedBy::stall) {
    const int last = probe_.find(lastSwitched_);
    const int first = last < 0 ? -1 : islands_.systemOf(probe_.contacts(), last);
    if (first < 0) return;
    chosen[static_cast<std::size_t>(first)] = 1;
    // Other systems that overlap each other cannot be located either.
    for (int i = 0; lost_ && i < probe_.size(); ++i)
      if (const int system = islands_.systemOf(probe_.contacts(), i);
          system >= 0 && probe_.law(i).unilateral() && probe_.gap(i) < -touch)
        chosen[static_cast<std::size_t>(system)] = 1;
  } else {
    chooseDear(chosen);
  }
  islands_.spread(chosen);
  timed_ = chosen;
}

/// Chooses the islands with most work charged to them, until the work of the others is bearable.
void LocatedDormandPrince::chooseDear(std::vector<char>& chosen) const {
  const std::size_t n = chosen.size();
  const Eigen::VectorXd all = governor_.tooFast() ? owed_.rowwise().sum() : owed_.col(0).eval();
  std::vector<double> work(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    work[static_cast<std::size_t>(islands_.of(static_cast<int>(i)))] +=
        all[static_cast<Eigen::Index>(i)];
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
  double rest = all.sum();
  if (!(rest > 0.0)) chosen.assign(n, 1);  // no work is charged to any system
  for (const std::size_t i : order) {
    if (rest <= governor_.bearable() && i != order[0]) break;
    chosen[i] = 1, rest -= work[i];
  }
}

int LocatedDormandPrince::steppedSystems() const {
  int n = 0;
  forSystems(*system_->parts().topology, timed_, true, [&](const SystemHandle&) { ++n; });
  return n;
}

bool LocatedDormandPrince::anyQuiet() const {
  bool any = false;
  forSystems(*system_->parts().topology, timed_, false, [&](const SystemHandle&) { any = true; });
  return any;
}

/// Scheme data that a run of located islands begins with: everything is decided anew, in the norm
/// of the whole run.
Eigen::VectorXd LocatedDormandPrince::decidedAnew() const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(behindTimes());
  out[1] = norm_.time();
  auto numbers = SwitchGovernor().numbers();
  numbers[0] = static_cast<double>(SwitchGovernor::Mode::decideAnew);
  std::copy(numbers.begin(), numbers.end(), out.data() + kHead);
  out.segment(kBehind, norm_.times().size()) = norm_.times();
  return out;
}

/// Sets the start of a step of the located islands, which may reach up to `end`: as it was kept,
/// else at the start of the step in time.
void LocatedDormandPrince::startQuiet(const MechanicalSystem& s, double end) {
  State& from = quiet_.from;
  const Eigen::Index nq = steppedFrom_.q.size(), nu = steppedFrom_.u.size();
  from.memory = steppedFrom_.memory, from.impulses = {};
  if (quietKept_.size() > 0) {
    from.t = quietKept_[0], quiet_.end = quietKept_[1];
    from.q = quietKept_.segment(2, nq), from.u = quietKept_.segment(2 + nq, nu);
    from.scheme = quietKept_.tail(quietKept_.size() - 2 - nq - nu);
    return;
  }
  from.t = steppedFrom_.t, from.q = steppedFrom_.q, from.u = steppedFrom_.u, quiet_.end = end;
  forSystems(*s.parts().topology, timed_, true,
             [&](const SystemHandle& h) { from.u.segment(h.u0, h.nu).setZero(); });
  from.scheme = decidedAnew();
}

/// Takes one step of the located islands from quiet_.from. False: some of them have to be stepped
/// in time as well from now on.
bool LocatedDormandPrince::quietStep(MechanicalSystem& s, InclusionSolver& solver, bool again,
                                     StepCounts& counts) {
  LocatedDormandPrince& scheme = *quiet_.scheme;
  quiet_.to = quiet_.from;
  const StepReport r = scheme.step(s, solver, quiet_.to, quiet_.end - quiet_.from.t);
  quiet_.works = r.works;
  const bool dense = scheme.governor_.mode() == SwitchGovernor::Mode::step;
  const bool good = r.refused.empty() && r.solved.ok() && !dense;
  // Of a step that is not accepted, or that was counted before, only the effort counts.
  again || !good ? add(counts.effort, r.counts.effort) : add(counts, r.counts);
  if (good) return true;
  const std::vector<char> before = timed_;
  for (std::size_t i = 0; dense && i < timed_.size(); ++i)
    if (scheme.timed_[i] != 0) timed_[i] = 1;
  if (timed_ == before) timed_.assign(timed_.size(), 1);
  quietKept_.resize(0), quiet_.known = false;
  return false;
}

double LocatedDormandPrince::followQuiet(MechanicalSystem& s, InclusionSolver& solver, double end,
                                         StepCounts& counts) {
  while (anyQuiet()) {
    const LeftOut out(*s.parts().topology, timed_);
    if (!quiet_.scheme) {
      quiet_.scheme = std::make_unique<LocatedDormandPrince>();
      quiet_.scheme->stiff_ = stiff_, quiet_.scheme->quietOnly_ = true;
      quiet_.scheme->aim(accuracy_);
    }
    bool good = true;
    const bool kept = quietKept_.size() > 0;
    if (!quiet_.known || !kept || quiet_.kept != quietKept_)
      startQuiet(s, end), good = quietStep(s, solver, kept, counts);
    while (good && quiet_.to.t <= steppedFrom_.t) {
      quiet_.from = quiet_.to, quiet_.end = end;
      good = quietStep(s, solver, false, counts);
    }
    if (!good) continue;
    quiet_.known = true;
    return quiet_.to.t;
  }
  return end;
}

void LocatedDormandPrince::placeQuiet(MechanicalSystem& s, double t) {
  if (!anyQuiet()) return;
  const LeftOut out(*s.parts().topology, timed_);
  const double length = quiet_.to.t - quiet_.from.t;
  quiet_.scheme->interpolate(s, quiet_.from, quiet_.to, (t - quiet_.from.t) / length, quiet_.at);
  if (quiet_.to.t == t) quiet_.at = quiet_.to;  // the state after a switch there
}

void LocatedDormandPrince::joinQuiet(MechanicalSystem& s, State& x, StepReport& report) {
  // Systems that touched time-stepped ones are stepped in time from now on. This step, which
  // included the contact, counts as the first of these steps.
  const std::vector<char> before = timed_;
  const ContactSet& c = s.slot(0).contacts;
  const Vec Lambda = s.Lambda();
  islands_.start(s.parts());
  for (int i = 0; i < c.size(); ++i) {
    const auto row = c.row0[static_cast<std::size_t>(i)];
    const bool acts = !c.law[static_cast<std::size_t>(i)]->unilateral() ||
                      c.position[static_cast<std::size_t>(row)] <= 0.0 ||
                      !Lambda.segment(row, c.dim(i)).isZero(0.0);
    if (acts) islands_.join(c, i);
  }
  islands_.spread(timed_);
  quietKept_.resize(0);
  apart_.assign(timed_.size(), 0);
  forSystems(*s.parts().topology, timed_, false, [&](const SystemHandle& h) {
    x.q.segment(h.q0, h.nq) = quiet_.at.q.segment(h.q0, h.nq);
    x.u.segment(h.u0, h.nu) = quiet_.at.u.segment(h.u0, h.nu);
    apart_[static_cast<std::size_t>(h.index)] = 1;
  });
  if (!anyQuiet()) {
    quiet_.known = false;
    return;
  }
  report.apart = apart_;
  if (quiet_.to.t == x.t) report.works = quiet_.works, report.works.given = false;
  if (timed_ != before) {
    quiet_.known = false;
    return;
  }
  const State& from = quiet_.from;
  quietKept_.resize(2 + from.q.size() + from.u.size() + from.scheme.size());
  quietKept_ << from.t, quiet_.end, from.q, from.u, from.scheme;
  quiet_.kept = quietKept_;
}

/// Length that the step from t on tries, before outer bounds.
double LocatedDormandPrince::nextStepped(double t) const {
  const double h = governor_.h();
  if (!anyQuiet()) return h;
  if (!quiet_.known) return kFirstStep * norm_.time();
  return quiet_.to.t > t ? std::min(h, quiet_.to.t - t) : quiet_.scheme->nextStep(quiet_.to);
}

void LocatedDormandPrince::showQuiet(double t, State& out) const {
  if (!quiet_.known || t < quiet_.from.t || t > quiet_.to.t) return;
  const MechanicalSystem& s = *system_;
  quiet_.scheme->interpolate(s, quiet_.from, quiet_.to,
                             (t - quiet_.from.t) / (quiet_.to.t - quiet_.from.t), quiet_.shown);
  forSystems(*s.parts().topology, timed_, false, [&](const SystemHandle& h) {
    out.q.segment(h.q0, h.nq) = quiet_.shown.q.segment(h.q0, h.nq);
    out.u.segment(h.u0, h.nu) = quiet_.shown.u.segment(h.u0, h.nu);
  });
}

}  // namespace dynamy
