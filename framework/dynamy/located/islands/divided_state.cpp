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

}  // namespace

Eigen::VectorXd partOf(const Eigen::VectorXd& scheme, const SystemParts& parts,
                       std::span<const ContactKey> keys) {
  GovernedState state;
  if (!state.read(scheme, parts) || !locates(state)) return scheme;
  std::erase_if(state.held.held, [&](const Held& h) {
    return !std::binary_search(keys.begin(), keys.end(), h.key);
  });
  state.held.jacobian.resize(0);
  return numbersOf(state);
}

Eigen::VectorXd unionOf(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                        const SystemParts& parts) {
  GovernedState state, other;
  if (!state.read(a, parts) || !locates(state)) return a;
  if (!other.read(b, parts) || !locates(other)) return b;
  HeldState& held = state.held;
  const HeldState& more = other.held;
  held.held.insert(held.held.end(), more.held.begin(), more.held.end());
  std::vector<int> missing;
  std::set_union(held.missing.begin(), held.missing.end(), more.missing.begin(), more.missing.end(),
                 std::back_inserter(missing));
  held.missing = std::move(missing);
  if (more.pace.lastEvent > held.pace.lastEvent)
    held.pace.lastEvent = more.pace.lastEvent, held.pace.empty = more.pace.empty;
  held.pace.next = std::min(held.pace.next, more.pace.next);
  held.pace.lookAhead = std::min(held.pace.lookAhead, more.pace.lookAhead);
  held.pace.energyFrom = std::max(held.pace.energyFrom, more.pace.energyFrom);
  held.implicit = held.implicit || more.implicit;
  held.jacobian.resize(0);
  state.next = held.pace.next;
  state.charged += other.charged;
  return numbersOf(state);
}

Eigen::VectorXd inOrder(const Eigen::VectorXd& scheme, const SystemParts& parts,
                        std::span<const ContactKey> keys) {
  GovernedState state;
  if (!state.read(scheme, parts) || !locates(state)) return scheme;
  const auto place = [&](const Held& h) { return std::find(keys.begin(), keys.end(), h.key); };
  std::stable_sort(state.held.held.begin(), state.held.held.end(),
                   [&](const Held& a, const Held& b) { return place(a) < place(b); });
  return numbersOf(state);
}

}  // namespace dynamy
