/// Blocks with continuous states x, from which they form the signal `out` that formulas read
/// (theory 55):
///
///   Integrator         ẋ = f(t, x, signals)                            out = x
///   Filter             ẋ = (f(t, signals) − x)/T                       out = x
///   TransferFunction   ẋ₁ = x₂, …, ẋ_n = f − Σ a_i x_{i+1}             out = Σ c_i x_{i+1} + d f
///   ContinuousPid      İ = ki e, ẇ = (e − w)/Tf                        out = clamp(kp e + I + D + f)
///                                                                      D = kd (e − w)/Tf
///
/// States are the velocities u of a system of its own, with a small mass m and the forces m ẋ. They
/// are thereby integrated by every scheme with the order of the scheme and under its error control,
/// and are part of states, checkpoints, derivatives and eigenvalues. Rejected: an integration of x
/// beside the schemes, of an order of its own.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy_elements/blocks/pid_settings.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

/// The forces of a block on its states. A leaf class gives ẋ.
class StateBlock : public ExternalForce {
 public:
  /// `initial`: the states at the start.
  StateBlock(const Parameters& x, std::vector<double> initial);
  std::unique_ptr<PartialMechanicalSystem> ownSystem() const final;
  void connect(Topology& topology) final;
  bool mayCouple() const override { return false; }
  void addTo(const Kinematics& k, ForceSink& sink) const final;
  bool stiff() const final { return stiff_; }
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const final;
  void describe(Description& d) const override;

 protected:
  static void declareState(Attributes& a);
  static void declareStiff(Attributes& a);
  /// Names of the states as signals; the only one is `out`.
  virtual std::vector<std::string> stateNames() const { return {"out"}; }
  virtual std::vector<SignalFormulas*> formulas() { return {&of_}; }
  /// ẋ at k; *byState = ∂ẋ/∂x, row after row, if not null.
  virtual void rates(const Kinematics& k, const double* x, double* rate, double* byState) const = 0;
  const double* states(const Kinematics& k) const { return k.u(system_).data(); }
  SignalFormulas of_;

 private:
  SystemHandle system_;
  std::vector<double> initial_;
  bool stiff_;
  mutable std::vector<double> rate_, byState_;  // scratch
};

class Integrator final : public StateBlock {
 public:
  static void declare(Attributes& a);
  explicit Integrator(const Parameters& x) : StateBlock(x, {x["initial"]}) {
    of_ = {x, "rate", 1, {"x"}};
  }

 private:
  void rates(const Kinematics& k, const double* x, double* rate, double* byState) const override;
};

class Filter final : public StateBlock {
 public:
  static void declare(Attributes& a);
  explicit Filter(const Parameters& x) : StateBlock(x, {x["initial"]}), time_(x["time"]) {
    of_ = {x, "of", 1};
  }

 private:
  void rates(const Kinematics& k, const double* x, double* rate, double* byState) const override;
  double time_;
};

class TransferFunction final : public StateBlock {
 public:
  static void declare(Attributes& a);
  explicit TransferFunction(const Parameters& x);
  void describe(Description& d) const override;

 private:
  std::vector<std::string> stateNames() const override;
  void rates(const Kinematics& k, const double* x, double* rate, double* byState) const override;
  double out(const Kinematics& k) const;
  std::vector<double> a_, c_;  // of s⁰, s¹, …
  double d_ = 0.0;
};

class ContinuousPid final : public StateBlock {
 public:
  static void declare(Attributes& a);
  explicit ContinuousPid(const Parameters& x);
  void describe(Description& d) const override;

 private:
  std::vector<std::string> stateNames() const override { return {"integral", "filtered"}; }
  std::vector<SignalFormulas*> formulas() override { return pid_.formulas(); }
  void rates(const Kinematics& k, const double* x, double* rate, double* byState) const override;
  /// D, from the states (I, w) and the error.
  double derivative(const Kinematics& k, const double* x, double e) const;
  /// The output without limits.
  double wanted(const Kinematics& k, const double* x, double e) const;
  PidSettings pid_;
};

}  // namespace dynamy
