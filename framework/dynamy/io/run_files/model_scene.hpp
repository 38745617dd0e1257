/// The scene of a model: what its replay draws. Frames are those of `drawnFrames`, in that order.
#pragma once
#include <dynamy/io/run_files/scene.hpp>
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// `model` is built. Shapes of a type the viewer does not know are drawn as the line through their
/// points.
Scene modelScene(const Model& model);

}  // namespace dynamy
