#include <dynamy/located/governed/governed_state.hpp>

namespace dynamy {

void ClockState::archive(NumberArchive& a) {
  a(systems), a(t), a(end), a(q), a(u), a(scheme);
  std::vector<ContactKey> keys;
  std::vector<char> now;
  for (const HeldStatus& s : statuses)
    keys.push_back(s.key), now.push_back(static_cast<char>(s.status));
  a(keys), a(now);
  if (!a.reading()) return;
  statuses.clear();
  for (std::size_t i = 0; i < std::min(keys.size(), now.size()); ++i)
    statuses.push_back({keys[i], static_cast<Status>(now[i])});
}

bool ClockState::operator==(const ClockState& other) const {
  const auto same = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return a.size() == b.size() && a == b;
  };
  return systems == other.systems && t == other.t && end == other.end && same(q, other.q) &&
         same(u, other.u) && same(scheme, other.scheme);
}

bool ClockState::fits(const SystemParts& parts) const {
  const auto n = static_cast<int>(parts.topology->systems().size());
  Eigen::Index nq = 0, nu = 0;
  int last = -1;
  for (const int i : systems) {
    if (i <= last || i >= n || parts.topology->system(i).nu == 0) return false;
    nq += parts.topology->system(i).nq, nu += parts.topology->system(i).nu, last = i;
  }
  const bool known = std::all_of(statuses.begin(), statuses.end(),
                                 [](const HeldStatus& s) { return s.status <= Status::locked; });
  GovernedState own;
  return !systems.empty() && q.size() == nq && u.size() == nu && known && own.read(scheme) &&
         own.fits({parts, viewOf(*parts.topology, systems).size(), nq, nu}) &&
         own.governor.mode() != SwitchGovernor::Mode::step;
}

std::vector<int> viewOf(const Topology& whole, const std::vector<int>& systems) {
  std::vector<int> out;
  auto next = systems.begin();
  for (int i = 0; i < static_cast<int>(whole.systems().size()); ++i) {
    const bool own = next != systems.end() && *next == i;
    if (own) ++next;
    if (own || whole.system(i).nu == 0) out.push_back(i);
  }
  return out;
}

void GovernedState::archive(NumberArchive& a) {
  a(next), a(governor), a(patience), a(pace), a(time), a(times);
  if (governor.mode() == Mode::locate) a(charged), a(held);
  if (governor.mode() == Mode::step) a(stepped);
}

bool GovernedState::read(const Eigen::VectorXd& numbers) {
  NumberArchive a(numbers);
  archive(a);
  return a.good() && a.atEnd();
}

bool GovernedState::fits(const Extent& view) const {
  const auto systems = static_cast<Eigen::Index>(view.systems);
  if (!(time > 0.0) || times.size() != systems) return false;
  if (governor.mode() == Mode::locate)
    return charged.size() == 2 * systems && held.fits(view.whole, view.nq + view.nu);
  if (governor.mode() != Mode::step) return true;
  const SteppedState& s = stepped;
  if (s.systems.size() != view.systems || (s.rate.size() != 0 && s.rate.size() != view.nu) ||
      !(s.time >= 0.0) || !s.searches.possible())
    return false;
  return std::all_of(s.clocks.begin(), s.clocks.end(),
                     [&](const ClockState& c) { return c.fits(view.whole); });
}

}  // namespace dynamy
