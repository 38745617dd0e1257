/// IslandContacts: contacts of islands with clocks of their own, put together.
#pragma once
#include <dynamy/contact/key_index.hpp>
#include <dynamy/located/islands/island_clock.hpp>

namespace dynamy {

using IslandClocks = std::vector<std::unique_ptr<IslandClock>>;

class IslandContacts {
 public:
  /// Statuses of all contacts at t, ascending by key, valid until the next call.
  std::span<const HeldStatus> statuses(const IslandClocks& clocks, double t);
  /// Evaluates all contacts at x, with those held and those of `percussions`, in slot 0, writes these
  /// percussions into its problem, and reports statuses and velocities before impacts at x.
  void report(MechanicalSystem& s, const IslandClocks& clocks, const State& x,
              std::span<const Percussion> percussions, StepReport& report);
  /// As OneStep::contactsAt.
  bool at(MechanicalSystem& s, const IslandClocks& clocks, const State& at, bool after,
          ContactInstant& out);

 private:
  const NearContacts* near(const IslandClocks& clocks);
  void write(MechanicalSystem& s, std::span<const Percussion> percussions, const State& x,
             double dt);
  std::vector<HeldStatus> statuses_;
  std::vector<ContactKey> keys_;
  NearContacts near_;
  KeyIndex index_;
  Eigen::VectorXd uBefore_;
};

}  // namespace dynamy
