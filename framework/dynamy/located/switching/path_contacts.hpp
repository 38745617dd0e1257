/// PathContacts: the contacts that can close on the path of a trial, from bounds of the motion
/// (theory 50.3).
///
/// Before a trial its path is predicted, with the accelerations at the start. After the trial, the
/// path itself tells whether it stayed within this. All other contacts need no look.
#pragma once
#include <dynamy/contact/near_contacts.hpp>
#include <dynamy/contact/path_reach.hpp>
#include <dynamy/located/phase/phase_point.hpp>

namespace dynamy {

class PathContacts {
 public:
  void prepare(const SystemParts& parts);
  /// The contacts that can close on a path of `time` [s] from p, where its derivatives are known.
  /// `margin`: gaps up to this count as closed [m]. Null: all can, as far as is known.
  const NearContacts* ahead(const PhasePoint& p, double time, double margin);
  /// True: the path, which begins at the p of ahead(), does not leave what was found last.
  bool cover(const QuinticPath& path);
  /// After a path that does: the contacts that can close on it; else as ahead().
  const NearContacts* along();
  /// True: some contacts have been left out.
  bool narrowed() const { return narrowed_; }

 private:
  const NearContacts* find();
  const Kinematics& at(const State& x, Kinematics& k) const;
  const SystemParts* parts_ = nullptr;
  Kinematics start_, later_;
  PathReach reach_, passed_;
  NearContacts near_;
  double margin_ = 0.0;
  bool narrowed_ = false, finite_ = true;
  State at_;
};

}  // namespace dynamy
