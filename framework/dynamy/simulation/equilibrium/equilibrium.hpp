/// Equilibrium of a model near a state: at rest, or a steady motion (theory 57):
///
///   h(q, u) + W λ = M u̇ = 0,   −γ ∈ N_C(λ)     with u = 0, or u constant
///
/// Statics with friction is an inclusion: forces that the laws permit exist, or they do not. The
/// start itself is taken if it permits rest. If not, Newton's method with the contacts that are
/// closed there looks for a state near it. Where that is none, or one from which disturbances grow,
/// the motion from the start, stopped at each maximum of its kinetic energy, leads to another.
#pragma once
#include <dynamy/simulation/linear/held_motion.hpp>
#include <utility>

namespace dynamy {

struct EquilibriumOptions {
  /// Gaps up to this share of the scene's length count as closed, slips up to this share of the
  /// fastest velocity, or of 1 m/s, as sticking.
  double near = 1e-6;
  /// False: the motion from the start is not followed; the rest must be near.
  bool relax = true;
};

/// A joint or a closed contact at an equilibrium.
struct CarryingContact {
  std::string name, status;    ///< status: "is held", "is closed", "sticks" or "slips"
  std::vector<double> lambda;  ///< its rows [N]
  /// Distance from the bound of the law [N]; negative: not permitted; positive infinity: no bound.
  double margin = 0.0;
};

struct Equilibrium {
  State at;
  bool rest = true;       ///< false: a steady motion
  double moved = 0.0;     ///< by Newton's method from the start, or from the end of the relaxation
  double residual = 0.0;  ///< largest |u̇| left [m/s², rad/s²]
  /// Distance of the forces from the bounds of their laws, over the largest force: of all forces
  /// that hold the equilibrium, those with the largest distance. Positive infinity: no bounds.
  double margin = 0.0;
  /// Small disturbances that grow, with the statuses of all contacts; −1: not known, or a motion.
  int growing = -1;
  std::string start;    ///< why the start and its surroundings are none; empty: they are
  int relaxations = 0;  ///< maxima of the kinetic energy that were passed
  long steps = 0;       ///< of the scheme, on the way
  std::vector<std::string> sampled;  ///< as Linearisation
  std::vector<CarryingContact> contacts;
  std::vector<std::pair<std::string, double>>
      state;  ///< by signals: coordinates; velocities if it moves
};

/// Changes the end of the model's run. Throws ModelError if there is no equilibrium near `from`, with
/// what keeps it from resting.
Equilibrium equilibrium(Model& model, const State& from, const EquilibriumOptions& options = {});

}  // namespace dynamy
