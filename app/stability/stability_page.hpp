/// The stability matrix as table, picture and page.
#pragma once
#include "stability/stability_cell.hpp"

namespace dynamy::app {

struct StabilityMatrix {
  std::vector<StabilityScene> scenes;
  std::vector<StabilityTask> tasks;
  std::vector<StabilityResult> results;
  std::string scheme, solver;  ///< the program's own choice
};

/// stability.csv: scene,scheme,solver,step,verdict,figure,passmark.
std::string stabilityCsv(const StabilityMatrix& m);
/// stability.svg: a row a scene, a column a scheme and then a solver, a field a step.
std::string stabilitySvg(const StabilityMatrix& m);
/// stability.html: one file, with figure, pass mark, words and command line of each cell.
/// `folder`: where the scenes lie, for the command lines.
std::string stabilityPage(const StabilityMatrix& m, const std::string& folder);

}  // namespace dynamy::app
