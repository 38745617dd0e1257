/// The stability matrix as a CSV table, an SVG picture and an HTML page.
#pragma once
#include "stability/stability_cell.hpp"

namespace dynamy::app {

struct StabilityMatrix {
  std::vector<StabilityScene> scenes;
  std::vector<StabilityTask> tasks;
  std::vector<StabilityResult> results;
  std::string scheme, solver;  ///< the defaults of the program
};

/// stability.csv: scene,scheme,solver,step,verdict,figure,passmark.
std::string stabilityCsv(const StabilityMatrix& m);
/// stability.svg: one row for each scene, one column for each scheme and then for each solver, one
/// field for each step.
std::string stabilitySvg(const StabilityMatrix& m);
/// stability.html: a page of one file with figure, pass mark, report and command line of each cell.
/// `folder` holds the scenes; the command lines refer to it.
std::string stabilityPage(const StabilityMatrix& m, const std::string& folder);

}  // namespace dynamy::app
