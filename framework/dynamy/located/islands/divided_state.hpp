/// State data of islands (State::scheme) where one divides or two become one.
#pragma once
#include <dynamy/located/governed/governed_state.hpp>
#include <span>

namespace dynamy {

/// The state data of a part of an island, which holds the contacts `keys`, ascending, of those held.
Eigen::VectorXd partOf(const Eigen::VectorXd& scheme, const SystemParts& parts,
                       std::span<const ContactKey> keys);
/// The state data of the island that two islands become. Its contacts are to be put inOrder().
Eigen::VectorXd unionOf(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                        const SystemParts& parts);

/// The same state data with the contacts that are held in the order of `keys`.
Eigen::VectorXd inOrder(const Eigen::VectorXd& scheme, const SystemParts& parts,
                        std::span<const ContactKey> keys);

}  // namespace dynamy
