/// The frames whose rotation a step has to resolve: those of all bodies but balls. A ball looks the
/// same however it turns, so that a fast spin changes neither its contacts nor their gaps.
#pragma once
#include <dynamy/simulation/model/model.hpp>

namespace dynamy {

/// Handles of these frames, in the order of Topology::requestedFrames; `model` is built.
std::vector<FrameHandle> turningFrames(const Model& model);

}  // namespace dynamy
