/// GovernedState: what a governed run carries from step to step, in State::scheme: whether switches
/// are located or steps taken in time, and the state of what is done.
#pragma once
#include <algorithm>
#include <dynamy/located/governed/run_patience.hpp>
#include <dynamy/located/governed/switch_governor.hpp>
#include <dynamy/located/step/held_state.hpp>
#include <dynamy/stages/search_pauses.hpp>

namespace dynamy {

/// State of an island whose switches are located, at the start of its present step.
struct ClockState {
  std::vector<int> systems;  ///< of the island, those with velocities, ascending
  double t = 0.0;            ///< start of the step [s]
  double end = 0.0;          ///< time up to which it may go [s]
  Eigen::VectorXd q, u;      ///< of these systems
  Eigen::VectorXd scheme;    ///< its own state data, of viewOf(systems)
  std::vector<HeldStatus> statuses;
  void archive(NumberArchive& a);
  bool operator==(const ClockState& other) const;
  /// True: it is possible in this model.
  bool fits(const SystemParts& parts) const;
};

/// While islands have clocks of their own, or steps are taken in time.
struct SteppedState {
  std::vector<char> systems;  ///< not 0: the system is stepped in time; perhaps none is
  bool any() const {
    return std::any_of(systems.begin(), systems.end(), [](char c) { return c != 0; });
  }
  Eigen::VectorXd rate;    ///< Δu/h of the last step; empty: there was none
  double overlap = 0.0;    ///< at the end of that step [m]
  bool projected = false;  ///< joints are projected
  double time = 0.0;       ///< T of the motion at the start of the period [s]; 0: not known yet
  SearchPauses searches;
  std::vector<ClockState> clocks;  ///< of the islands whose switches are located
  Eigen::VectorXd scheme;          ///< of the time-stepping scheme
  WorkPace held;        ///< work of steps in time that end early, with a step of a located island
  bool heldUp = false;  ///< that work is too much
  double burst =
      0.0;  ///< length of the last step if longer ones diverged [s]; 0: it was no such step
  void archive(NumberArchive& a) {
    a(systems), a(rate), a(overlap), a(projected), a(time), a(searches), a(clocks), a(scheme);
    a(held), a(heldUp), a(burst);
  }
};

struct GovernedState {
  using Mode = SwitchGovernor::Mode;
  double next = 0.0;  ///< length of the next step [s]
  SwitchGovernor governor;
  RunPatience patience;     ///< of the run; decides in the state of all islands alone
  WorkPace pace;            ///< of the island
  double time = 0.0;        ///< T of the scene [s]
  Eigen::VectorXd times;    ///< T of each system [s]
  Eigen::VectorXd charged;  ///< works charged to each system (ChargedWork)
  HeldState held;           ///< in mode locate
  SteppedState stepped;     ///< in mode step

  void archive(NumberArchive& a);
  /// Reads the numbers of a state. False: they are not those of such a run.
  bool read(const Eigen::VectorXd& numbers);
  /// The same; false also if it is not a run of this model.
  bool read(const Eigen::VectorXd& numbers, const SystemParts& parts) {
    return read(numbers) && fits({parts, parts.topology->systems().size(), parts.topology->nq(),
                                  parts.topology->nu()});
  }
  /// A view on some systems of a model.
  struct Extent {
    const SystemParts& whole;
    std::size_t systems = 0;
    Eigen::Index nq = 0, nu = 0;
  };
  /// True: indices and sizes are possible there.
  bool fits(const Extent& view) const;
};

/// The systems of the view of an island of these systems, ascending: with those that have no
/// velocities, which take part in every view.
std::vector<int> viewOf(const Topology& whole, const std::vector<int>& systems);

}  // namespace dynamy
