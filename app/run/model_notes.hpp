/// What a model says without effect, or twice, though nothing of it is an error.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <string>

namespace dynamy::app {

/// Lines that begin with " note: ": rules between materials that no shapes need, several fields of
/// gravity, a step that is longer than the run. "" if there is none.
std::string modelNotes(const Model& model);

}  // namespace dynamy::app
