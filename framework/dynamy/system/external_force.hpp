/// ExternalForce: an element that adds to h (spring, drive, gravity).   h ← h + J_Sᵀ F + J_Rᵀ M
#pragma once
#include <dynamy/system/kinematics.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/stiffness_sink.hpp>
#include <memory>

namespace dynamy {

/// Receives the forces of elements. Generalised forces of elements without potential are also
/// summed separately, for the energy ledger.
class ForceSink {
 public:
  /// `some`: the systems that feel forces; null: all.
  ForceSink(Vec h, Vec nonPotential, const SystemSubset* some = nullptr)
      : h_(h), nonPotential_(nonPotential), some_(some) {}
  /// Force F_I [N] at lever arm rho_I from S of the frame.
  void force(const Frame& frame, const Vec3& rho_I, const Vec3& F_I);
  /// Moment M_I [N m].
  void moment(const Frame& frame, const Vec3& M_I);
  /// Adds the generalised force on a whole system, or on its velocity i, to h.
  void generalised(const SystemHandle& system, ConstVec force);
  void generalised(const SystemHandle& system, int i, double force);
  /// Set by the framework before each element: true if the element's forces have the potential it
  /// states.
  void hasPotential(bool yes) { potential_ = yes; }

 private:
  void add(int i, double value) {
    h_[i] += value;
    if (!potential_) nonPotential_[i] += value;
  }
  bool feels(int system) const { return some_ == nullptr || !some_->leavesOut(system); }
  int first(const SystemHandle& system) const { return ownHandle(some_, system).u0; }
  Vec h_, nonPotential_;
  const SystemSubset* some_;
  bool potential_ = false;
};

class ExternalForce : public Element {
 public:
  static constexpr Kind kKind = Kind::force;
  using Element::Element;
  /// A system of the same name with states of the element's own, which Model::build() adds to the
  /// model: the state of an integrator. Default: none.
  virtual std::unique_ptr<PartialMechanicalSystem> ownSystem() const { return nullptr; }
  virtual void connect(Topology& topology) = 0;
  virtual void addTo(const Kinematics& k, ForceSink& sink) const = 0;
  /// Asked of a force that has requested no system, frame or signal by its name in connect(). True:
  /// it may act on a system by what another one does, so that all systems are one island. False: it
  /// acts on each system alone, as gravity does, or on none.
  virtual bool mayCouple() const { return true; }
  /// Updates the numbers reserved by Topology::memory. Called at the end of an accepted step and
  /// wherever any element switches; a second call at the same state must have no further effect.
  /// A rejected step is rolled back.
  virtual void remember(const Kinematics&, Vec /*memory*/) const {}
  /// Why `memory`, read from a checkpoint, cannot be numbers of this element; empty (default): it
  /// can. Elements that take an index from their memory check it here, once, and never within a step.
  virtual std::string memoryFault(ConstVec /*memory*/) const { return {}; }
  /// True: all of the force derives from potentialEnergy.
  virtual bool hasPotential() const { return false; }
  virtual double potentialEnergy(const Kinematics&) const { return 0.0; }
  /// True: the force is stiff. Schemes integrate it linearly implicitly, by means of addStiffness.
  virtual bool stiff() const { return false; }
  /// Adds the derivatives of the force from addTo, at the same kinematics. Useful also if the force
  /// is not stiff(): with them schemes recognise and damp a force that changes faster than their
  /// steps resolve.
  virtual void addStiffness(const Kinematics&, StiffnessSink&) const {}
};

}  // namespace dynamy
