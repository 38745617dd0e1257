/// One point of a work–precision chart: a scene, a method, a step or tolerance; its error and cost.
///
///   error = max over the scene's <check>s of |got − value| / tolerance
///
/// where `value` is a closed form or a number certified by other means and `tolerance` is the unit
/// the error is told in, so that own schemes and the programs of others (bench/peers) are judged by
/// the same line of code. The cost is the CPU time of the process from the first step to the last.
#pragma once
#include <string>
#include <vector>

#include "program.hpp"

namespace dynamy::app {

/// A scene in one or more forms, such as minimal and absolute coordinates, with the same checks.
struct PrecisionScene {
  std::string name, title, about;
  std::vector<std::string> forms;  ///< names, "" for the only one
  std::vector<std::string> texts;  ///< the models
  std::vector<std::string> steps;  ///< [s], as written; those with * are quick
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
  int form = 0;         ///< of own points
  PrecisionMethod own;  ///< of own points
  std::string program;  ///< of a peer's points; empty: an own one
};

/// What came of it; error NaN: nothing, `note` says why.
struct PrecisionResult {
  double error = 0.0, cpu = 0.0;  ///< [unit of the scene], [s]
  long evaluations = 0;
  std::string note;
};

/// An engine found installed, with the version and the remarks it tells.
struct PrecisionPeer {
  std::string name, program, version;
  std::vector<std::string> notes;
};

/// The catalogue: of the program itself, or of a folder of the user's with scenes.txt and
/// methods.txt beside its models. Throws FileError, std::runtime_error.
std::vector<PrecisionScene> precisionScenes(const std::string& folder);
std::vector<PrecisionMethod> precisionMethods(const std::string& folder);

/// The points of the own methods on one scene.
std::vector<PrecisionPoint> ownPoints(const std::vector<PrecisionScene>& scenes, int scene,
                                      const std::vector<PrecisionMethod>& methods);

/// Asks the program of a peer what it can do. Throws std::runtime_error.
PrecisionPeer askPeer(const std::string& program, const std::vector<PrecisionScene>& scenes,
                      std::vector<PrecisionPoint>& points);

/// Runs a point in a process of its own, which may take `limit` seconds of CPU time. Throws
/// ModelError where the scene itself is at fault.
PrecisionResult runPoint(Program& program, const std::vector<PrecisionScene>& scenes,
                         const PrecisionPoint& point, double limit);

}  // namespace dynamy::app
