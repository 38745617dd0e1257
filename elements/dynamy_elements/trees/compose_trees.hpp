/// Trees from the joints of a model: `<simulation coordinates="minimal">`.
///
///   1. joints that leave simple motions free connect rigid bodies, in space or in one plane
///   2. a spanning tree of them, those that leave least free first (Kruskal): what closes loops has
///      few rows
///   3. one system for each branch that hangs on what stands still, and for each loose mechanism
///
/// What is left of the joints stays what it was: a law between frames.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// Puts the bodies of `model` into trees if its simulation asks for minimal coordinates, and notes
/// in Model::composed what it made. Throws ModelError if no joint makes a tree.
void composeTrees(Model& model);

}  // namespace dynamy
