#include <dynamy/located/governed/governed_state.hpp>

namespace dynamy {

bool BesideState::operator==(const BesideState& other) const {
  const auto same = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return a.size() == b.size() && a == b;
  };
  return known == other.known && t == other.t && end == other.end && same(q, other.q) &&
         same(u, other.u) && same(scheme, other.scheme);
}

void GovernedState::archive(NumberArchive& a) {
  a(next), a(governor), a(time), a(times);
  if (governor.mode() == Mode::locate) a(charged), a(held);
  if (governor.mode() == Mode::step) a(stepped);
}

bool GovernedState::read(const Eigen::VectorXd& numbers, const SystemParts& parts) {
  NumberArchive a(numbers);
  archive(a);
  return a.good() && a.atEnd() && fits(parts);
}

bool GovernedState::fits(const SystemParts& parts) const {
  const Topology& topology = *parts.topology;
  const auto systems = static_cast<Eigen::Index>(topology.systems().size());
  if (!(time > 0.0) || times.size() != systems) return false;
  if (governor.mode() == Mode::locate) return charged.size() == 2 * systems && held.fits(parts);
  if (governor.mode() != Mode::step) return true;
  const SteppedState& s = stepped;
  if (s.systems.size() != topology.systems().size() ||
      (s.rate.size() != 0 && s.rate.size() != topology.nu()) || !(s.time >= 0.0) ||
      !s.searches.possible())
    return false;
  if (!s.beside.known) return true;
  GovernedState beside;
  return s.beside.q.size() == topology.nq() && s.beside.u.size() == topology.nu() &&
         beside.read(s.beside.scheme, parts) && beside.governor.mode() != Mode::step;
}

}  // namespace dynamy
