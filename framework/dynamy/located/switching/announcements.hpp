/// Announcements: instants and switches that elements report by their signals nextInstant and
/// switching (system/announced_signals.hpp).
#pragma once
#include <dynamy/stages/mechanical_system.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

class Announcements {
 public:
  /// Collects these signals from all elements.
  void read(const SystemParts& parts);
  /// First instant after t at which an element jumps as a function of time; infinity: none. Signals
  /// of systems are evaluated with the state of the last call of switching().
  double nextInstant(double t) const;
  /// Numbers that are positive where contact elements would switch. `k` must outlive the next call
  /// of nextInstant().
  void switching(const Kinematics& k, std::vector<double>& out);
  /// A contact of the element that reports number i of switching().
  ContactKey switcher(std::size_t i) const { return contactKey(switchers_[i].element, 0); }

 private:
  struct Switcher {
    SignalFunction value;
    int element = 0;
  };
  struct Instant {
    SignalFunction value;
    SystemHandle system;  ///< of the element; without coordinates if it is no system
  };
  std::vector<Instant> instants_;
  const Kinematics* seen_ = nullptr;
  std::vector<Switcher> switchers_;
};

}  // namespace dynamy
