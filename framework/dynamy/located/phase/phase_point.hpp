/// PhasePoint: a state with its derivatives in the present phase, and the path between two of them.
#pragma once
#include <array>
#include <dynamy/stages/mechanical_system.hpp>
#include <span>

namespace dynamy {

/// q̇ of all systems at x.
void configurationRate(const Topology& topology, const State& x, Eigen::VectorXd& qdot);
/// True: q̇ = u in all systems.
bool ratesArePlain(const Topology& topology);

struct PhasePoint {
  State x;
  Eigen::VectorXd qdot, qddot, a;
  Eigen::VectorXd lambda;         ///< rows of the phase [N]
  std::array<double, 5> power{};  ///< as FrozenPhase::power [W]
  double T = 0.0, V = 0.0;        ///< kinetic and potential energy [J]
};

/// Quintic through positions, velocities and accelerations of two points; it needs no evaluation.
class QuinticPath {
 public:
  void through(const MechanicalSystem& s, const PhasePoint& from, const PhasePoint& to);
  void at(double theta, State& out) const;
  /// Sets t and those q and u on which these frames depend.
  void at(double theta, const SystemParts& parts, std::span<const FrameHandle> frames,
          State& out) const;
  double length() const { return h_; }

 private:
  /// Weights of the values at both ends in q and in u at one place.
  struct Weights;
  void position(const Weights& w, Eigen::Index first, Eigen::Index n, Eigen::VectorXd& q) const;
  void velocity(const Weights& w, Eigen::Index first, Eigen::Index n, Eigen::VectorXd& u) const;
  const PhasePoint *from_ = nullptr, *to_ = nullptr;
  double h_ = 0.0;
  bool derivative_ = false;  // u = q̇ in all systems
};

}  // namespace dynamy
