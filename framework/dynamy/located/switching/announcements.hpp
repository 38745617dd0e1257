/// Announcements: instants and switches that elements report by their signals nextInstant and
/// switching (system/announced_signals.hpp).
#pragma once
#include <dynamy/located/switching/contact_gaps.hpp>
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
  /// Numbers that are positive where contact elements would switch, or systems renew themselves.
  /// `k` must outlive the next call of nextInstant().
  void switching(const Kinematics& k, std::vector<double>& out);
  /// A contact of the element that reports number i of switching(); none if it is a system.
  ContactKey switcher(std::size_t i) const {
    const int element = switchers_[i].element;
    return element < 0 ? kNoContact : contactKey(element, 0);
  }

 private:
  struct Switcher {
    SignalFunction value;
    int element = -1;  ///< contact element; −1: a system
    SystemHandle system;
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
