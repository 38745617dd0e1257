/// States of islands where one divides or two become one.
#pragma once
#include <dynamy/located/governed/governed_state.hpp>
#include <span>

namespace dynamy {

/// The state of a part of an island: of these of its systems, with the contacts `keys`, ascending, of
/// those held.
ClockState partOf(const ClockState& all, const Topology& topology, std::vector<int> systems,
                  std::span<const ContactKey> keys);
/// The state of the island that two islands become, which are at the same time. Its contacts are to
/// be put inOrder(). Where one of them decides everything anew, so does the island.
ClockState unionOf(const ClockState& a, const ClockState& b, const Topology& topology);
/// The state of these systems in x, with the state data of a motion of the whole model.
ClockState stateOf(const Topology& topology, std::vector<int> systems, const State& x,
                   const Eigen::VectorXd& scheme);

/// The same state data with the contacts that are held in the order of `keys`.
Eigen::VectorXd inOrder(const Eigen::VectorXd& scheme, std::span<const ContactKey> keys);

}  // namespace dynamy
