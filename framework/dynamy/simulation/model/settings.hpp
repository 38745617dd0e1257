/// Settings of a run, as given in the sections `<simulation>`, `<record>` and `<check>`.
#pragma once
#include <dynamy/core/error.hpp>
#include <dynamy/system/state.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace dynamy {

/// What happens when an inclusion is not solved to its tolerance.
enum class NonConvergence { stop, warn, retry };

/// What is projected on the constraints after a step (theory 34.3).
enum class Project { none, positions, both };

/// Coordinates of bodies that joints connect (theory 39).
enum class JointCoordinates {
  absolute,  ///< of each body; joints are bilateral laws
  minimal,   ///< of the joints of spanning trees; joints that close loops are bilateral laws
  automatic  ///< of the joints of those trees for which that is better, of bodies elsewhere
};

/// Where a run starts.
enum class Start {
  given,       ///< as the systems say
  equilibrium  ///< rest or steady motion nearest to that (theory 57)
};

struct SimulationSettings {
  double until = 1.0;      ///< end time [s]
  double step = 0.0;       ///< Δt [s]; 0: not given
  double tolerance = 0.0;  ///< error tolerance, 0: not given (fixed step)
  double gTol = -1.0;      ///< closed: g ≤ gTol [m]; negative: 1e-12 of the scene's length
  double sampleEvery =
      0.0;             ///< steps end at multiples of it, as where a block samples [s]; 0: none
  double sleep = 0.0;  ///< speed below which bodies at rest may sleep [m/s]; 0: none do
  NonConvergence onNonConvergence = NonConvergence::warn;
  Project project = Project::none;
  JointCoordinates coordinates = JointCoordinates::absolute;
  Place coordinatesPlace;
  /// True: nobody reads q and u, so that they may be fewer than those of the bodies in the model.
  /// What moves in a plane, as the structure of the model shows, is computed in it (theory 39.10), and
  /// small mechanisms in coordinates of their joints with steps of a fixed length, too (theory 39.9).
  bool reduce = false;
  Start start = Start::given;
  /// Systems, velocities and coordinates that keep their values where joints correct the start.
  std::vector<std::string> keep;
  std::vector<Place> keepPlaces;      ///< of each name in the file
  std::shared_ptr<const State> from;  ///< where runs start; null: as the systems say
  Place place;
};

struct RecordSettings {
  std::vector<std::string>
      signals;                    ///< "ball.z", "beak.Lambda_N"; "*" after a dot: all of an element
  std::vector<Place> places;      ///< of each signal name in the file
  double every = 0.0;             ///< sample time [s]; 0: (until)/1000
  std::vector<double> at;         ///< instants of further rows [s]; without `every`: of all rows
  double framesPerSecond = 60.0;  ///< pictures of the replay
  bool packed = false;            ///< signals are HDF5 once the run has ended, else CSV
  std::string follow;             ///< system or frame that the replay goes with; "": none
  Place followPlace;
  Place place;
};

/// One `<check>`: a measure of a signal compared with a value ± tolerance or with a band.
struct CheckSettings {
  enum class Measure { value, mean, min, max, period, count };
  std::string signal;
  Measure measure = Measure::value;
  double at =
      std::numeric_limits<double>::quiet_NaN();  ///< time of `value` [s]; not given: the end
  double from = 0.0, to = std::numeric_limits<double>::infinity();  ///< `over` [s]
  double low = 0.0, high = 0.0;                                     ///< accepted band
  std::string text;  ///< as written: "1.25 ± 1e-4" or "0.7 … 0.8"
  Place place;
};

}  // namespace dynamy
