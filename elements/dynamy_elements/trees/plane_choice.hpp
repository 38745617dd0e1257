/// Motion in a plane: where every element of a model and its start are their own mirror image at a
/// plane, the motion of its bodies stays in it, and they are computed there (theory 39.10).
///
/// Decided from the structure, element by element (Element::isMirrored). What cannot tell, a plug-in
/// or a formula, keeps the model in space.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// Replaces rigid bodies in space by FlatBody if the simulation asks to find a plane and there is one.
/// A completion of models; before composeTrees(), whose joints then connect bodies in a plane.
void flattenBodies(Model& model);

}  // namespace dynamy
