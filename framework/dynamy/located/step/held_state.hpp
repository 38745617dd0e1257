/// HeldState: what a located run carries from step to step beside t, q and u.
#pragma once
#include <dynamy/located/phase/phase_motion.hpp>
#include <dynamy/stages/search_pauses.hpp>

namespace dynamy {

/// How the next step begins.
struct Pace {
  double next = 0.0;           ///< length of the next trial [s]
  double lookAhead = 1e-5;     ///< part of the step that decisions look ahead
  double lastEvent = -1e300;   ///< time of the last event [s]
  int empty = 0;               ///< events at that time that changed nothing
  double energyFrom = -1e300;  ///< from this time on energies bound steps [s]
  double energyPause = 0.0;    ///< length of the next pause of this bound, in trials
  SearchPauses searches{};     ///< of impacts and decisions
  void archive(NumberArchive& a) {
    a(next), a(lookAhead), a(lastEvent), a(empty), a(energyFrom), a(energyPause), a(searches);
  }
};

struct HeldState {
  Pace pace;
  std::vector<Held> held;
  std::vector<int> missing;  ///< elements without a bias, ascending
  bool implicit = false;
  SmoothStep::Counted counted{};
  Eigen::VectorXd jacobian;  ///< where the Jacobian of implicit steps was taken (SmoothStep::kept)

  void archive(NumberArchive& a) {
    a(pace), a(held), a(missing), a(implicit), a(counted), a(jacobian);
  }
  /// True: indices and sizes are possible in a view with `numbers` positions and velocities.
  bool fits(const SystemParts& parts, Eigen::Index numbers) const;
  /// The same of the whole model.
  bool fits(const SystemParts& parts) const {
    return fits(parts, parts.topology->nq() + parts.topology->nu());
  }
};

}  // namespace dynamy
