/// orbit: periodic orbits of runs to a tolerance, by Newton's method on the return map of a section
/// (theory 54):
///
///   P(x) ⊖ x = shift of the coordinates on which nothing depends,   (DP − 1) z = −(P(x) ⊖ x)
///
/// Stable and unstable orbits are found alike. The multipliers are the eigenvalues of DP without
/// those of the section and of the ignorable coordinates; null spaces are split off first and
/// counted, since impacts without rebound and sticking kill directions exactly.
///
/// Rejected: shooting with state and period as unknowns. Where a trial ends before an impact in
/// place of after it, its equation jumps; a return always ends at the section.
#pragma once
#include <dynamy/simulation/orbit/return_map.hpp>

namespace dynamy {

struct OrbitRequest {
  OrbitSection section;
  double tolerance = 0.0;   ///< of the runs; 0: 1e-12
  double residual = 1e-12;  ///< wanted, in units of the range of each coordinate
};

struct Orbit {
  OrbitSection section;
  double tolerance = 0.0;
  double period = 0.0, periodError = 0.0;             ///< [s]
  std::vector<std::pair<std::string, double>> state;  ///< at the section, by signals
  std::vector<std::pair<std::string, double>> shift;  ///< a period, of ignorable coordinates
  Eigen::VectorXcd multipliers;                       ///< by falling modulus, without zeros
  Eigen::VectorXcd
      half;  ///< those of half an orbit, if it is mirrored; their squares are multipliers
  double multiplierError = 0.0;  ///< of the worst
  int zeros = 0;                 ///< multipliers that are exactly zero
  double residual = 0.0;         ///< largest part of a coordinate's range that is missing
  int newton = 0;                ///< steps of Newton's method
  double away = 0.0;             ///< residual of the first return
  long switches = 0, impacts = 0;
  State at;                ///< at the section, at t = 0
  double largest() const;  ///< modulus of a multiplier
};

/// Throws ModelError: no pass of the section, no derivative of the return, no orbit near the start.
/// `model` is changed by its runs. `start`: near the orbit; null: the model's initial state.
Orbit orbit(Model& model, const OrbitRequest& request, const State* start = nullptr);

}  // namespace dynamy
