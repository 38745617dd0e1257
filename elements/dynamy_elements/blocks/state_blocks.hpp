/// Blocks with a continuous state x, which formulas read as the signal `out` (theory 55):
///
///   Integrator   ẋ = f(t, x, signals)
///   Filter       ẋ = (f(t, signals) − x)/T
///
/// x is the velocity u of a system of its own, with a small mass m and the force m ẋ. It is thereby
/// integrated by every scheme with the order of the scheme and under its error control, and it is
/// part of states, checkpoints, derivatives and eigenvalues. Rejected: an integration of x beside
/// the schemes, of an order of its own.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

/// The force of a block on its state. A leaf class gives ẋ.
class StateBlock : public ExternalForce {
 public:
  explicit StateBlock(const Parameters& x);
  std::unique_ptr<PartialMechanicalSystem> ownSystem() const final;
  void connect(Topology& topology) final;
  void addTo(const Kinematics& k, ForceSink& sink) const final;
  bool stiff() const final { return stiff_; }
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const final;
  void describe(Description& d) const final;

 protected:
  static void declareState(Attributes& a);
  /// ẋ at k; *byState = ∂ẋ/∂x if not null.
  virtual double rate(const Kinematics& k, double x, double* byState) const = 0;
  SignalFormulas of_;

 private:
  SystemHandle system_;
  double initial_;
  bool stiff_;
};

class Integrator final : public StateBlock {
 public:
  static void declare(Attributes& a);
  explicit Integrator(const Parameters& x) : StateBlock(x) { of_ = {x, "rate", 1, {"x"}}; }

 private:
  double rate(const Kinematics& k, double x, double* byState) const override;
};

class Filter final : public StateBlock {
 public:
  static void declare(Attributes& a);
  explicit Filter(const Parameters& x) : StateBlock(x), time_(x["time"]) { of_ = {x, "of", 1}; }

 private:
  double rate(const Kinematics& k, double x, double* byState) const override;
  double time_;
};

}  // namespace dynamy
