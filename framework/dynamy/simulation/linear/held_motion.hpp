/// HeldMotion: the motion of a model whose closed contacts keep the status they have at one state,
/// as a smooth function of the state that can be differentiated:
///
///   (q, u)  ↦  u̇,  γ of the rows that are held,  g and position errors of the same rows
///
/// Joints, sticking and frictionless closed contacts are constraints, slipping ones a force that
/// follows from λ_N and the direction of slip (FrozenPhase). Rolling without slip is a sticking
/// contact: its rows γ_T = 0 are nonholonomic.
#pragma once
#include <dynamy/simulation/linear/widest_forces.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <optional>

namespace dynamy {

/// Accelerations, velocities and position errors at one state.
struct MotionSample {
  Eigen::VectorXd a;         ///< u̇ [m/s², rad/s²]
  Eigen::VectorXd gamma;     ///< of the held rows [m/s]
  Eigen::VectorXd position;  ///< of the same rows; 0 where they have none [m]
};

class HeldMotion {
 public:
  /// Contacts with g ≤ gap [m] at x are closed, and stick if they slip by no more than `slip`
  /// [m/s].
  HeldMotion(Model& model, const State& x, double gap, double slip);

  /// Throws ModelError if a law has no smooth phases, a held contact no longer exists, or M is
  /// singular.
  MotionSample at(const State& x);
  /// The part of q̇ that is linear in the velocities, for velocities v: F(q) v.
  Eigen::VectorXd rate(const State& x, const Eigen::VectorXd& v) const;
  /// q̇ = F u + β.
  Eigen::VectorXd qdot(const State& x, const Eigen::VectorXd& u) const;
  /// x with q ← q + F(q) delta, where q is then brought back onto its manifold.
  State displaced(const State& x, const Eigen::VectorXd& delta) const;
  /// x after the time τ of steady motion, in which u is constant.
  State movedOn(const State& x, double tau) const;

  /// Of the forces that keep the motion sampled last, takes those that stay furthest from the bounds
  /// of their laws; the accelerations are the same.
  void shareWidely();
  /// The least margin of contacts(), over their largest force; positive infinity without bounds.
  double margin() const;
  /// A held contact at the state that was sampled last.
  struct Contact {
    std::string name;
    const SetValuedForceLaw* law = nullptr;
    bool slips = false;
    std::vector<double> lambda;  ///< its rows [N]
    /// Distance from the bound of the law [N]; negative: the law does not permit this force. Positive
    /// infinity: there is no bound.
    double margin = 0.0;
  };
  std::vector<Contact> contacts() const;
  /// Size of accelerations by the forces alone, max |M⁻¹h| of the last sample.
  double freeAcceleration() const { return freeAcceleration_; }

 private:
  Model& model_;
  MechanicalSystem system_;
  FrozenPhase phase_;
  std::optional<WidestForces> widest_;
  std::vector<ContactKey> keys_;
  double freeAcceleration_ = 0.0;
};

}  // namespace dynamy
