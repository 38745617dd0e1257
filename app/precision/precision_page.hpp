/// Work–precision charts as a CSV table, SVG pictures and an HTML page.
#pragma once
#include "precision/precision_point.hpp"

namespace dynamy::app {

struct PrecisionChart {
  std::vector<PrecisionScene> scenes;
  std::vector<PrecisionPoint> points;
  std::vector<PrecisionResult> results;
  std::vector<PrecisionPeer> peers;
  std::string machine;  ///< processor, versions, load: one line each
};

/// work_precision.csv: scene,engine,method,setting,error,cpu_s,evaluations,note.
std::string precisionCsv(const PrecisionChart& chart);
/// The picture of one scene: error against CPU time, both logarithmic, one line for each method.
std::string precisionSvg(const PrecisionChart& chart, int scene);
/// work_precision.html: one file with all pictures and tables.
std::string precisionPage(const PrecisionChart& chart);

}  // namespace dynamy::app
