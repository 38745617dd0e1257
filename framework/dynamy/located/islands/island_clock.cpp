#include <algorithm>
#include <dynamy/located/governed/stepped_islands.hpp>
#include <dynamy/located/islands/divided_state.hpp>
#include <dynamy/located/islands/island_clock.hpp>

namespace dynamy {
namespace {

constexpr int kSlots = 2;  ///< of a system whose switches are located
constexpr int kParts = 8;  ///< of a step, for the boxes of its path

}  // namespace

IslandClock::IslandClock(const SystemParts& whole, const LocatedSettings& settings)
    : motion_(settings) {
  SystemParts parts = whole;
  parts.subset = &subset_;
  view_ = std::make_unique<MechanicalSystem>(parts, kSlots);
}

void IslandClock::set(const MechanicalSystem& s, std::vector<int> systems, const State& x,
                      const Eigen::VectorXd& scheme, std::vector<HeldStatus> statuses) {
  const Topology& topology = *s.parts().topology;
  systems_ = std::move(systems);
  std::vector<char> without(topology.systems().size(), 0);
  for (std::size_t i = 0; i < without.size(); ++i)
    without[i] = topology.system(static_cast<int>(i)).nu > 0 ? 1 : 0;
  for (const int i : systems_) without[static_cast<std::size_t>(i)] = 0;
  subset_.assign(topology, std::move(without), s.parts().forces, s.parts().contacts);
  view_->gTol(s.gTol());
  to_.t = x.t, to_.q = x.q, to_.u.setZero(x.u.size());
  for (const int i : systems_) {
    const SystemHandle& h = topology.system(i);
    to_.u.segment(h.u0, h.nu) = x.u.segment(h.u0, h.nu);
  }
  to_.memory = x.memory, to_.impulses = {}, to_.scheme = scheme;
  from_ = to_, end_ = x.t;
  report_ = {}, booked = {}, counted = true, turned_ = false;
  before_ = after_ = std::move(statuses);
  justSet_ = true, path_.clear();
}

void IslandClock::orderContacts() {
  std::vector<ContactKey> keys;
  for (const IslandDivision::Joined& contact : joinedAt(to_)) keys.push_back(contact.key);
  if (keys.size() > 1) to_.scheme = from_.scheme = inOrder(to_.scheme, view_->parts(), keys);
}

void IslandClock::set(const MechanicalSystem& s, const ClockState& kept, const State& x) {
  State from = x;
  from.t = kept.t;
  Eigen::Index q = 0, u = 0;
  for (const int i : kept.systems) {
    const SystemHandle& h = s.parts().topology->system(i);
    from.q.segment(h.q0, h.nq) = kept.q.segment(q, h.nq), q += h.nq;
    from.u.segment(h.u0, h.nu) = kept.u.segment(u, h.nu), u += h.nu;
  }
  set(s, kept.systems, from, kept.scheme, kept.statuses);
  end_ = kept.end;
}

void IslandClock::keep(ClockState& out) const {
  if (out.systems == systems_ && out.t == from_.t && out.end == end_ &&
      out.scheme.size() == from_.scheme.size() && out.scheme == from_.scheme)
    return;
  out.systems = systems_, out.t = from_.t, out.end = end_, out.scheme = from_.scheme;
  out.statuses = before_;
  const Topology& topology = *view_->parts().topology;
  Eigen::Index nq = 0, nu = 0;
  for (const int i : systems_) nq += topology.system(i).nq, nu += topology.system(i).nu;
  out.q.resize(nq), out.u.resize(nu);
  nq = nu = 0;
  for (const int i : systems_) {
    const SystemHandle& h = topology.system(i);
    out.q.segment(nq, h.nq) = from_.q.segment(h.q0, h.nq), nq += h.nq;
    out.u.segment(nu, h.nu) = from_.u.segment(h.u0, h.nu), nu += h.nu;
  }
}

Refusal IslandClock::step(MechanicalSystem& s, InclusionSolver& solver, double end) {
  from_ = to_, end_ = end;
  before_ = after_, booked = {}, justSet_ = false;
  return advance(s, solver);
}

Refusal IslandClock::again(MechanicalSystem& s, InclusionSolver& solver, double end) {
  to_ = from_, end_ = end, justSet_ = false;
  return advance(s, solver);
}

Refusal IslandClock::advance(MechanicalSystem& s, InclusionSolver& solver) {
  MechanicalSystem& view = *view_;
  view.limits = s.limits;
  report_ = {}, counted = false, path_.clear();
  const long evaluations = view.evaluations();
  Refusal refusal;
  if (!motion_.load(view, to_))
    refusal = {Refusal::Kind::fault,
               "the checkpoint holds what this scheme does not leave in a state"};
  else
    refusal = motion_.locate(view, solver, to_, end_ - from_.t, report_);
  s.count(view.evaluations() - evaluations);
  turned_ = motion_.turned();
  if (refusal || turned_) {
    to_ = from_, counted = true;
    return refusal;
  }
  after_.assign(report_.statuses.begin(), report_.statuses.end());
  return refusal;
}

std::vector<int> IslandClock::toStep() const {
  std::vector<int> out;
  const std::vector<char>& chosen = const_cast<GovernedMotion&>(motion_).state().stepped.systems;
  for (const int i : systems_)
    if (chosen[static_cast<std::size_t>(i)] != 0) out.push_back(i);
  return out.empty() ? systems_ : out;
}

/// The state at t, into at_. A step that ends with a slip has no interpolation of its own: its
/// accelerations are constant.
void IslandClock::within(double t) {
  const double theta = (t - from_.t) / (to_.t - from_.t);
  if (!motion_.motion().interpolate(*view_, from_, to_, theta, at_))
    SteppedIslands::linear(*view_, from_, to_, theta, at_);
}

void IslandClock::copy(const State& from, State& to) const {
  const Topology& topology = *view_->parts().topology;
  for (const int i : systems_) {
    const SystemHandle& h = topology.system(i);
    to.q.segment(h.q0, h.nq) = from.q.segment(h.q0, h.nq);
    to.u.segment(h.u0, h.nu) = from.u.segment(h.u0, h.nu);
  }
}

void IslandClock::place(MechanicalSystem& s, double t, State& out) {
  if (t >= to_.t || t <= from_.t) return copy(t >= to_.t ? to_ : from_, out);
  const long evaluations = view_->evaluations();
  within(t);
  s.count(view_->evaluations() - evaluations);
  copy(at_, out);
}

void IslandClock::findPath(MechanicalSystem& s, std::span<const MovingShape> shapes,
                           Kinematics& k) {
  shapes_.clear();
  for (const MovingShape& shape : shapes)
    if (std::binary_search(systems_.begin(), systems_.end(), shape.system))
      shapes_.push_back(shape);
  path_.clear();
  if (shapes_.empty()) return;
  const Topology& topology = *view_->parts().topology;
  const auto frames = [&](const State& x) {
    k.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory), &subset_);
  };
  frames(std::as_const(from_));
  path_.begin(shapes_, k);
  const long evaluations = view_->evaluations();
  for (int i = 1; i <= kParts && to_.t > from_.t; ++i) {
    // At the end of the step these are the velocities before an impact there.
    within(i < kParts ? from_.t + (to_.t - from_.t) * i / kParts : to_.t);
    at_.t = i < kParts ? at_.t : to_.t;
    frames(std::as_const(at_));
    path_.pass(k);
  }
  s.count(view_->evaluations() - evaluations);
}

}  // namespace dynamy
