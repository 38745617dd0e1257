#include <algorithm>
#include <dynamy/located/islands/divided_state.hpp>
#include <iterator>

namespace dynamy {
namespace {

Eigen::VectorXd numbersOf(GovernedState& state) {
  NumberArchive numbers;
  numbers(state);
  Eigen::VectorXd out;
  numbers.copyTo(out);
  return out;
}

bool locates(const GovernedState& state) {
  return state.governor.mode() == SwitchGovernor::Mode::locate;
}

/// Copies the numbers of systems, in slices of q or of u, from one island to another.
template <class Slice>
void copySlices(const std::vector<int>& from, const Eigen::VectorXd& numbers,
                const std::vector<int>& to, Slice&& size, Eigen::VectorXd& out) {
  Eigen::Index read = 0, write = 0;
  auto next = to.begin();
  for (const int i : from) {
    for (; next != to.end() && *next < i; ++next) write += size(*next);
    if (next != to.end() && *next == i)
      out.segment(write, size(i)) = numbers.segment(read, size(i));
    read += size(i);
  }
}

/// Gives `to` the positions and velocities of its systems that `from` has as well.
void copyStates(const ClockState& from, const Topology& topology, ClockState& to) {
  const auto nq = [&](int i) { return Eigen::Index{topology.system(i).nq}; };
  const auto nu = [&](int i) { return Eigen::Index{topology.system(i).nu}; };
  copySlices(from.systems, from.q, to.systems, nq, to.q);
  copySlices(from.systems, from.u, to.systems, nu, to.u);
}

void makeRoom(const Topology& topology, ClockState& x) {
  Eigen::Index nq = 0, nu = 0;
  for (const int i : x.systems) nq += topology.system(i).nq, nu += topology.system(i).nu;
  x.q.setZero(nq), x.u.setZero(nu);
}

/// Gives `to` the times and works of the systems that `from` has as well.
void copyTimes(const std::vector<int>& from, const GovernedState& state, const std::vector<int>& to,
               GovernedState& out) {
  const auto one = [](int) { return Eigen::Index{1}; };
  copySlices(from, state.times, to, one, out.times);
  const auto n = static_cast<Eigen::Index>(from.size()), m = static_cast<Eigen::Index>(to.size());
  for (Eigen::Index k = 0; k < 2 && state.charged.size() == 2 * n && out.charged.size() == 2 * m;
       ++k) {
    Eigen::VectorXd works = out.charged.segment(k * m, m);
    copySlices(from, state.charged.segment(k * n, n), to, one, works);
    out.charged.segment(k * m, m) = works;
  }
}

}  // namespace

ClockState partOf(const ClockState& all, const Topology& topology, std::vector<int> systems,
                  std::span<const ContactKey> keys) {
  ClockState out;
  out.systems = std::move(systems), out.t = all.t, out.end = all.end;
  makeRoom(topology, out);
  copyStates(all, topology, out);
  for (const HeldStatus& status : all.statuses)
    if (std::binary_search(keys.begin(), keys.end(), status.key)) out.statuses.push_back(status);
  GovernedState state;
  if (!state.read(all.scheme)) return out;
  GovernedState own = state;
  const std::vector<int> view = viewOf(topology, out.systems);
  const auto n = static_cast<Eigen::Index>(view.size());
  own.times.setZero(n);
  if (locates(state)) own.charged.setZero(2 * n);
  copyTimes(viewOf(topology, all.systems), state, view, own);
  std::erase_if(own.held.held, [&](const Held& h) {
    return !std::binary_search(keys.begin(), keys.end(), h.key);
  });
  own.held.jacobian.resize(0);
  out.scheme = numbersOf(own);
  return out;
}

ClockState unionOf(const ClockState& a, const ClockState& b, const Topology& topology) {
  ClockState out;
  out.t = a.t, out.end = a.end;
  std::merge(a.systems.begin(), a.systems.end(), b.systems.begin(), b.systems.end(),
             std::back_inserter(out.systems));
  makeRoom(topology, out);
  copyStates(a, topology, out), copyStates(b, topology, out);
  out.statuses = a.statuses;
  out.statuses.insert(out.statuses.end(), b.statuses.begin(), b.statuses.end());
  GovernedState state, other;
  if (!state.read(a.scheme) || !other.read(b.scheme)) return out;
  GovernedState both = locates(state) ? other : state;
  if (locates(state) && locates(other)) {
    both = state;
    HeldState& held = both.held;
    const HeldState& more = other.held;
    held.held.insert(held.held.end(), more.held.begin(), more.held.end());
    held.missing.clear();
    std::set_union(state.held.missing.begin(), state.held.missing.end(), more.missing.begin(),
                   more.missing.end(), std::back_inserter(held.missing));
    if (more.pace.lastEvent > held.pace.lastEvent)
      held.pace.lastEvent = more.pace.lastEvent, held.pace.empty = more.pace.empty;
    held.pace.next = std::min(held.pace.next, more.pace.next);
    held.pace.lookAhead = std::min(held.pace.lookAhead, more.pace.lookAhead);
    held.pace.energyFrom = std::max(held.pace.energyFrom, more.pace.energyFrom);
    held.pace.energyPause = std::max(held.pace.energyPause, more.pace.energyPause);
    held.implicit = held.implicit || more.implicit;
    held.jacobian.resize(0);
    both.next = held.pace.next;
  }
  const std::vector<int> view = viewOf(topology, out.systems);
  const auto n = static_cast<Eigen::Index>(view.size());
  both.times.setZero(n);
  if (locates(both)) both.charged.setZero(2 * n);
  copyTimes(viewOf(topology, b.systems), other, view, both);
  copyTimes(viewOf(topology, a.systems), state, view, both);
  out.scheme = numbersOf(both);
  return out;
}

ClockState stateOf(const Topology& topology, std::vector<int> systems, const State& x,
                   const Eigen::VectorXd& scheme) {
  ClockState all;
  for (int i = 0; i < static_cast<int>(topology.systems().size()); ++i)
    if (topology.system(i).nu > 0) all.systems.push_back(i);
  all.t = x.t, all.q = x.q, all.u = x.u, all.scheme = scheme;
  return partOf(all, topology, std::move(systems), {});
}

Eigen::VectorXd inOrder(const Eigen::VectorXd& scheme, std::span<const ContactKey> keys) {
  GovernedState state;
  if (!state.read(scheme) || !locates(state)) return scheme;
  const auto place = [&](const Held& h) { return std::find(keys.begin(), keys.end(), h.key); };
  std::stable_sort(state.held.held.begin(), state.held.held.end(),
                   [&](const Held& a, const Held& b) { return place(a) < place(b); });
  return numbersOf(state);
}

}  // namespace dynamy
