/// Forces in one joint coordinate x:                                               (theory 40.5)
///
///   JointSpring    F = −c (x − x0) − d ẋ                          V = ½ c (x − x0)²
///   JointForce     F(t, x, ẋ, signals) by a formula
///   PdController   F = k(t) (s(t) − x) + d(t) (ṡ(t) − ẋ) + f(t), cut off at ±limit
///
/// F is the force or moment on B in the direction of x. Stiff forces are integrated implicitly with
/// −∂F/∂x and −∂F/∂ẋ.
#pragma once
#include <dynamy/system/announced_signals.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/joints/joint_coordinate.hpp>
#include <dynamy_elements/signal_formulas.hpp>
#include <dynamy_elements/time_formulas.hpp>
#include <limits>

namespace dynamy {

/// Base of the forces in one joint coordinate; a leaf class gives F and its derivatives.
class CoordinateForce : public ExternalForce {
 public:
  explicit CoordinateForce(const Parameters& x);
  void connect(Topology& topology) final;
  void remember(const Kinematics& k, Vec memory) const final { coordinate_.remember(k, memory); }
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool stiff() const final { return stiff_; }
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const final;
  void describe(Description& d) const final;

 protected:
  static void declareForce(Attributes& a);
  /// F [N or N m] at (k, x, ẋ); c = −∂F/∂x, d = −∂F/∂ẋ if not null.
  virtual double force(const Kinematics& k, double x, double rate, double* c, double* d) const = 0;
  /// The formulas that may read signals.
  virtual std::vector<SignalFormulas*> formulas() { return {}; }
  /// First instant after t at which a formula jumps or has a kink [s].
  virtual double nextInstant(double) const { return std::numeric_limits<double>::infinity(); }
  const JointCoordinate& coordinate() const { return coordinate_; }
  void hasUnits(const Parameters& x, const char* name, Unit ofAngle, Unit ofDisplacement) {
    coordinate_.hasUnits(x, name, ofAngle, ofDisplacement);
  }

 private:
  JointCoordinate coordinate_;
  bool stiff_;
};

class JointSpring final : public CoordinateForce {
 public:
  static void declare(Attributes& a);
  explicit JointSpring(const Parameters& x);
  bool isMirrored(const MirrorPlane& plane) const override {
    return coordinate().isMirrored(plane, *this);
  }
  void addTo(const Kinematics& k, ForceSink& sink) const override;
  bool hasPotential() const override { return damping_ == 0.0; }
  double potentialEnergy(const Kinematics& k) const override;

 private:
  double force(const Kinematics& k, double x, double rate, double* c, double* d) const override;
  double stiffness_, damping_, rest_;
};

class JointForce final : public CoordinateForce {
 public:
  static void declare(Attributes& a);
  explicit JointForce(const Parameters& x);

 private:
  double force(const Kinematics& k, double x, double rate, double* c, double* d) const override;
  double nextInstant(double t) const override { return formula_.nextInstant(t); }
  std::vector<SignalFormulas*> formulas() override { return {&formula_}; }
  SignalFormulas formula_;
};

class PdController final : public CoordinateForce {
 public:
  static void declare(Attributes& a);
  explicit PdController(const Parameters& x);

 private:
  double force(const Kinematics& k, double x, double rate, double* c, double* d) const override;
  double nextInstant(double t) const override;
  std::vector<SignalFormulas*> formulas() override;
  TimeFormulas target_;  // without signals
  SignalFormulas targetOfSignals_, targetRate_, stiffness_, damping_, feedforward_;
  double limit_;
};

}  // namespace dynamy
