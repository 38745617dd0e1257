/// Trees from the joints of a model: `<simulation coordinates="minimal">`.
///
///   1. joints that leave simple motions free connect rigid bodies, in space or in one plane
///   2. a spanning tree of these joints, the ones with the fewest free motions first (Kruskal), so
///      that the joints that close loops have few rows
///   3. one system for each branch that starts at something at rest, and for each loose mechanism
///
/// The rows of a joint that the tree does not replace remain a law between frames.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// Puts the bodies of `model` into trees if its simulation requests minimal coordinates, and lists
/// the systems made in Model::composed. Throws ModelError if no joint makes a tree.
void composeTrees(Model& model);

}  // namespace dynamy
