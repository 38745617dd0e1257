/// orbitBranch: a periodic orbit followed over a parameter, through folds, with the instabilities
/// and the changes of its switches on the way (theory 54.5).
///
/// Rejected: stepping in the parameter itself, which ends at every fold; and going on blindly where
/// the switches change, where the curve has a kink or an end.
#pragma once
#include <dynamy/simulation/orbit/orbit_curve.hpp>

namespace dynamy {

struct BranchRequest {
  double from = 0.0, to = 0.0;  ///< of the parameter
  double at = 0.0;              ///< where the search begins: the first orbit is there
  int points = 100;             ///< about as many between from and to
  double tolerance = 0.0;       ///< of the runs; 0: 1e-12
  double residual = 1e-11;      ///< of orbits, in units of the range of each coordinate
};

struct BranchPoint {
  double p = 0.0, period = 0.0;
  State at;                      ///< at the section
  std::vector<double> state;     ///< the same by OrbitBranch::signals
  Eigen::VectorXcd multipliers;  ///< by falling modulus, without zeros
  int zeros = 0;
  double residual = 0.0;
  bool stable = false;
  /// "fold", "flip", "symmetry", "Neimark-Sacker", "branching", "grazing", "sliding", "switch",
  /// "kink", "coincidence", "end"
  std::string kind;
  std::string text;  ///< what happens here
};

struct OrbitBranch {
  OrbitSection section;
  std::vector<std::string> signals;
  std::vector<std::string> ignorable;  ///< of these: nothing depends on them
  std::vector<BranchPoint> points;     ///< along the branch; the first and the last are its ends
  std::size_t start = 0;               ///< the first orbit among them
  long cycles = 0;                     ///< runs over one period that this took
  /// State of the point nearest to a value of the parameter.
  const State& near(double p) const;
};

/// If `at` is outside of the range, the branch begins at the end of it that is followed from there.
/// Throws ModelError if no orbit is found at `at`. `start`: near that orbit, null: the initial
/// state of the model.
OrbitBranch orbitBranch(const OrbitMaker& make, const BranchRequest& request,
                        const State* start = nullptr);

/// State of the orbit at the value `to` of the parameter, followed there from the one at `from`.
/// Throws ModelError if the branch ends before.
State followedOrbit(const OrbitMaker& make, double from, double to, double tolerance,
                    const State* start = nullptr);

}  // namespace dynamy
