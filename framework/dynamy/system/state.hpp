/// State: everything that changes in a run: t, q, u, memory of elements, remembered percussions. A
/// rejected step restores it; a checkpoint stores it.
#pragma once
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy {

/// Percussions of the last step by contact key: the warm start of the next step.
struct RememberedImpulses {
  std::vector<ContactKey> key;
  std::vector<int> first;      ///< index of the first row; one more entry than keys
  std::vector<double> Lambda;  ///< [N s]
  double dt = 0.0;             ///< length of the step they belong to [s]
  /// True: the solver changed its start in that step. Λ then contains an impulse that corrected the
  /// velocities once, and as a start of the next step it is wrong by this impulse.
  bool corrected = false;
};

struct State {
  double t = 0.0;
  Eigen::VectorXd q, u;
  Eigen::VectorXd memory;
  Eigen::VectorXd scheme;  ///< numbers a scheme carries from step to step; most carry none
  RememberedImpulses impulses;
};

}  // namespace dynamy
