/// Announcements: what elements tell by their signals nextInstant and switching
/// (system/announced_signals.hpp).
#pragma once
#include <dynamy/stages/mechanical_system.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

class Announcements {
 public:
  /// Asks all elements what they have to tell.
  void read(const SystemParts& parts);
  /// First instant after t at which one jumps by the time alone; infinity: none. Systems are asked
  /// with their state as switching() saw it last.
  double nextInstant(double t) const;
  /// Numbers that are positive where contact elements would switch. `k` outlives the next question.
  void switching(const Kinematics& k, std::vector<double>& out);
  /// A contact of the element that tells number i of them.
  ContactKey switcher(std::size_t i) const { return contactKey(switchers_[i].element, 0); }

 private:
  struct Switcher {
    SignalFunction value;
    int element = 0;
  };
  struct Instant {
    SignalFunction value;
    SystemHandle system;  ///< or one without coordinates
  };
  std::vector<Instant> instants_;
  const Kinematics* seen_ = nullptr;
  std::vector<Switcher> switchers_;
};

}  // namespace dynamy
