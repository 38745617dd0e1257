#include <algorithm>
#include <dynamy/located/governed/charged_work.hpp>
#include <numeric>

namespace dynamy {

void ChargedWork::begin(const SystemParts& parts, Eigen::Index systems) {
  islands_.start(parts);
  work_.setZero(systems, 2);
}

void ChargedWork::resume(const SystemParts& parts, const Eigen::VectorXd& numbers) {
  islands_.start(parts);
  work_ = numbers.reshaped(numbers.size() / 2, 2);
}

void ChargedWork::charge(const MechanicalSystem& s, const LocatedMotion& motion, double work,
                         bool switched) {
  // A switch without a contact, or of a contact no longer reported, is charged to no system.
  int system = -1;
  const ContactGaps& gaps = motion.parts().probe.gaps();
  const int worst = motion.parts().motion.step.last().worst();
  if (switched) {
    if (const int i = gaps.find(motion.lastSwitched()); i >= 0)
      system = islands_.systemOf(gaps.contacts, i);
  } else if (worst >= 0) {
    system = islands_.systemOfVelocity(*s.parts().topology, worst);
  }
  if (system >= 0) work_(system, switched ? 0 : 1) += work;
}

void ChargedWork::choose(const MechanicalSystem& s, const State& x, const LocatedMotion& motion,
                         const SwitchGovernor& governor, bool lost, std::vector<char>& stepped) {
  const auto& systems = s.parts().topology->systems();
  stepped.assign(systems.size(), 1);
  const bool renews = std::any_of(systems.begin(), systems.end(), [](const auto* e) {
    return e->abilities().renewable != nullptr;
  });
  const LocatedParts& parts = motion.parts();
  const bool known = islands_.start(s.parts()) && Islands::forcesAreKnown(s.parts());
  if (!known || x.memory.size() > 0 || !parts.bias.elements().empty() || renews) return;
  const ContactGaps& gaps = parts.probe.gaps();
  const double touch = parts.norm.tolerance() * parts.norm.length();
  for (int i = 0; i < gaps.size(); ++i)
    if (lost ? !gaps.law(i).unilateral() || gaps.gap(i) <= touch
             : findHeld(parts.motion.phase.held, gaps.key(i)) != nullptr)
      islands_.join(gaps.contacts, i);
  std::vector<char> chosen(systems.size(), 0);
  if (governor.turnedBy() != TurnedBy::stall)
    chooseExpensive(governor, chosen);
  else if (!chooseStalled(motion, lost, touch, chosen))
    return;
  islands_.spread(chosen);
  stepped = chosen;
}

/// Chooses the system of the contact at which a step stalled. False: it has none.
bool ChargedWork::chooseStalled(const LocatedMotion& motion, bool lost, double touch,
                                std::vector<char>& chosen) const {
  const ContactGaps& gaps = motion.parts().probe.gaps();
  const int last = gaps.find(motion.lastSwitched());
  const int first = last < 0 ? -1 : islands_.systemOf(gaps.contacts, last);
  if (first < 0) return false;
  chosen[static_cast<std::size_t>(first)] = 1;
  // Other systems that overlap each other cannot be located either.
  for (int i = 0; lost && i < gaps.size(); ++i)
    if (const int system = islands_.systemOf(gaps.contacts, i);
        system >= 0 && gaps.law(i).unilateral() && gaps.gap(i) < -touch)
      chosen[static_cast<std::size_t>(system)] = 1;
  return true;
}

/// Chooses the islands with most work charged to them, until the work of the others is bearable.
void ChargedWork::chooseExpensive(const SwitchGovernor& governor, std::vector<char>& chosen) const {
  const std::size_t n = chosen.size();
  const Eigen::VectorXd all = governor.tooFast() ? work_.rowwise().sum() : work_.col(0).eval();
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
    if (rest <= governor.bearable() && i != order[0]) break;
    chosen[i] = 1, rest -= work[i];
  }
}

}  // namespace dynamy
