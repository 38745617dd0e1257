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
  now_.to.t = x.t, now_.to.q = x.q, now_.to.u.setZero(x.u.size());
  for (const int i : systems_) {
    const SystemHandle& h = topology.system(i);
    now_.to.u.segment(h.u0, h.nu) = x.u.segment(h.u0, h.nu);
  }
  now_.to.memory = x.memory, now_.to.impulses = {}, now_.to.scheme = scheme;
  now_.from = now_.to, now_.end = x.t;
  now_.report = {}, booked = {}, counted = true, now_.turned = false;
  now_.before = now_.after = std::move(statuses);
  now_.justSet = true, path_.clear();
}

void IslandClock::orderContacts() {
  std::vector<ContactKey> keys;
  for (const IslandDivision::Joined& contact : joinedAt(now_.to)) keys.push_back(contact.key);
  if (keys.size() > 1)
    now_.to.scheme = now_.from.scheme = inOrder(now_.to.scheme, view_->parts(), keys);
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
  now_.end = kept.end;
}

void IslandClock::keep(ClockState& out) const {
  if (out.systems == systems_ && out.t == now_.from.t && out.end == now_.end &&
      out.scheme.size() == now_.from.scheme.size() && out.scheme == now_.from.scheme)
    return;
  out.systems = systems_, out.t = now_.from.t, out.end = now_.end, out.scheme = now_.from.scheme;
  out.statuses = now_.before;
  const Topology& topology = *view_->parts().topology;
  Eigen::Index nq = 0, nu = 0;
  for (const int i : systems_) nq += topology.system(i).nq, nu += topology.system(i).nu;
  out.q.resize(nq), out.u.resize(nu);
  nq = nu = 0;
  for (const int i : systems_) {
    const SystemHandle& h = topology.system(i);
    out.q.segment(nq, h.nq) = now_.from.q.segment(h.q0, h.nq), nq += h.nq;
    out.u.segment(nu, h.nu) = now_.from.u.segment(h.u0, h.nu), nu += h.nu;
  }
}

Refusal IslandClock::step(MechanicalSystem& s, InclusionSolver& solver, double end) {
  now_.from = now_.to, now_.end = end;
  now_.before = now_.after, booked = {}, now_.justSet = false;
  return advance(s, solver);
}

Refusal IslandClock::again(MechanicalSystem& s, InclusionSolver& solver, double end) {
  now_.to = now_.from, now_.end = end, now_.justSet = false;
  return advance(s, solver);
}

Refusal IslandClock::advance(MechanicalSystem& s, InclusionSolver& solver) {
  MechanicalSystem& view = *view_;
  view.limits = s.limits;
  now_.report = {}, counted = false, path_.clear();
  const long evaluations = view.evaluations();
  Refusal refusal;
  if (!motion_.load(view, now_.to))
    refusal = {Refusal::Kind::fault,
               "the checkpoint holds what this scheme does not leave in a state"};
  else
    refusal = motion_.locate(view, solver, now_.to, now_.end - now_.from.t, now_.report);
  s.count(view.evaluations() - evaluations);
  now_.turned = motion_.turned();
  if (refusal || now_.turned) {
    now_.to = now_.from, counted = true;
    return refusal;
  }
  now_.after.assign(now_.report.statuses.begin(), now_.report.statuses.end());
  return refusal;
}

std::vector<int> IslandClock::toStep() const {
  std::vector<int> out;
  const std::vector<char>& chosen = motion_.state().stepped.systems;
  for (const int i : systems_)
    if (chosen[static_cast<std::size_t>(i)] != 0) out.push_back(i);
  return out.empty() ? systems_ : out;
}

/// The state at t, into at_. A step that ends with a slip has no interpolation of its own: its
/// accelerations are constant.
void IslandClock::within(double t) {
  const double theta = (t - now_.from.t) / (now_.to.t - now_.from.t);
  if (!motion_.motion().interpolate(*view_, now_.from, now_.to, theta, at_))
    SteppedIslands::linear(*view_, now_.from, now_.to, theta, at_);
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
  if (t >= now_.to.t || t <= now_.from.t) return copy(t >= now_.to.t ? now_.to : now_.from, out);
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
  frames(std::as_const(now_.from));
  path_.begin(shapes_, k);
  const long evaluations = view_->evaluations();
  for (int i = 1; i <= kParts && now_.to.t > now_.from.t; ++i) {
    // At the end of the step these are the velocities before an impact there.
    within(i < kParts ? now_.from.t + (now_.to.t - now_.from.t) * i / kParts : now_.to.t);
    at_.t = i < kParts ? at_.t : now_.to.t;
    frames(std::as_const(at_));
    path_.pass(k);
  }
  s.count(view_->evaluations() - evaluations);
}

}  // namespace dynamy
