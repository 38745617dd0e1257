/// Pictures of a branch of periodic orbits: stable parts solid, unstable ones dashed.
#pragma once
#include <dynamy/io/model/file_branch.hpp>

namespace dynamy::app {

/// A chart over the parameter. `quantity`: a signal, "period", or "multiplier": the largest modulus.
std::string branchSvg(const NamedBranch& branch, const std::string& quantity);

/// The signal that shows most of the branch: the one that changes most on it, over its size.
std::string shownSignal(const NamedBranch& branch);

/// The page with all charts, and a table of what was found.
std::string branchPage(const std::string& model, const NamedBranch& branch);

}  // namespace dynamy::app
