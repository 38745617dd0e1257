/// One point of a work–precision chart: a scene, a method and a step or tolerance, with the error
/// and the cost of the run.
///
///   error = max over the scene's <check>s of |got − value| / tolerance
///
/// where `value` is a closed form or a number certified by other means, and `tolerance` is the unit
/// of the error. The same line of code judges the schemes of this program and the programs of
/// others (bench/peers). The cost is the CPU time of the process from the first step to the last.
#pragma once
#include <string>
#include <vector>

#include "program.hpp"

namespace dynamy::app {

/// A scene in one or more forms, such as minimal and absolute coordinates, with the same checks.
struct PrecisionScene {
  std::string name, title, about;
  std::vector<std::string> forms;  ///< names of the forms; "" for a single form
  std::vector<std::string> texts;  ///< the model file of each form
  std::vector<std::string> steps;  ///< [s], as written; a * marks a step of the quick part
};

/// A line of methods.txt.
struct PrecisionMethod {
  std::string label;
  bool byTolerance = false;         ///< the setting is a tolerance and not a step
  std::string words;                ///< scheme with attributes; empty: the program's default
  std::vector<std::string> scenes;  ///< empty: all
  std::vector<std::string> tolerances;
};

struct PrecisionPoint {
  int scene = 0;
  std::string engine, method, setting;
  bool quick = false;
  int form = 0;         ///< index of the form; for points of this program
  PrecisionMethod own;  ///< the method; for points of this program
  std::string program;  ///< program of the peer; empty: a point of this program
};

/// Result of one point. If the error is NaN there is no result, and `note` gives the reason.
struct PrecisionResult {
  double error = 0.0, cpu = 0.0;  ///< [unit of the scene], [s]
  long evaluations = 0;
  std::string note;
};

/// Another engine that is installed, with the version and the remarks that its program prints.
struct PrecisionPeer {
  std::string name, program, version;
  std::vector<std::string> notes;
};

/// Scenes and methods of the catalogue. It is that of the program if `folder` is empty, else a
/// folder of the user with scenes.txt and methods.txt beside its models. Throws FileError,
/// std::runtime_error.
std::vector<PrecisionScene> precisionScenes(const std::string& folder);
std::vector<PrecisionMethod> precisionMethods(const std::string& folder);

/// The points of this program's methods on one scene.
std::vector<PrecisionPoint> ownPoints(const std::vector<PrecisionScene>& scenes, int scene,
                                      const std::vector<PrecisionMethod>& methods);

/// Calls the program of a peer without arguments and adds the points that it offers to `points`.
/// Throws std::runtime_error.
PrecisionPeer askPeer(const std::string& program, const std::vector<PrecisionScene>& scenes,
                      std::vector<PrecisionPoint>& points);

/// Runs a point in a separate process, which may take `limit` seconds of CPU time. Throws
/// ModelError if the scene itself is faulty.
PrecisionResult runPoint(Program& program, const std::vector<PrecisionScene>& scenes,
                         const PrecisionPoint& point, double limit);

}  // namespace dynamy::app
