/// Friction with an internal state in a joint coordinate x, for the small motions before slip:
///
///   Dahl    ṡ = (σ/F_c) ẋ (1 − s sgn ẋ)^α                       F = −F_c s
///   LuGre   ṡ = (σ/F_c) (ẋ − |ẋ| s F_c/g),  g = F_c + (F_s − F_c) exp(−(ẋ/v_s)²)
///                                                   F = −(F_c s + d (F_c/σ) ṡ + c ẋ)
///
/// [Dahl 1968; Canudas de Wit, Olsson, Åström, Lischinsky 1995]. s = σ z/F_c is the deflection z of
/// the bristles in units of that at which they slip: of size 1, so that the error control counts it
/// like a velocity of the scene. A load scales F_c, F_s and σ. Set-valued laws are their limit
/// σ → ∞, without the state and without its stiffness (JointFriction).
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/joints/joint_coordinate.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

/// Base of both laws. A leaf class gives ṡ and the force.
class Presliding : public ExternalForce {
 public:
  explicit Presliding(const Parameters& x);
  std::unique_ptr<PartialMechanicalSystem> ownSystem() const final;
  void connect(Topology& topology) final;
  void remember(const Kinematics& k, Vec memory) const final { coordinate_.remember(k, memory); }
  void addTo(const Kinematics& k, ForceSink& sink) const final;
  bool stiff() const final { return stiff_; }
  void addStiffness(const Kinematics& k, StiffnessSink& sink) const final;
  void describe(Description& d) const final;

 protected:
  static void declarePresliding(Attributes& a);
  /// ṡ F_c/σ [m/s or rad/s]; *byState: its derivative by s.
  virtual double flow(double v, double s, double* byState) const = 0;
  /// Parts of the force beside F_c s, for ṡ F_c/σ = `flow` [N or N m].
  virtual double more(double /*v*/, double /*flow*/) const { return 0.0; }
  double level() const { return level_; }
  void hasUnits(const Parameters& x, const char* name, Unit ofAngle, Unit ofDisplacement) {
    coordinate_.hasUnits(x, name, ofAngle, ofDisplacement);
  }

 private:
  double loaded(const Kinematics& k) const;
  double force(const Kinematics& k) const;
  JointCoordinate coordinate_;
  SystemHandle state_;
  SignalFormulas load_;
  double stiffness_, level_;
  bool stiff_;
};

class DahlFriction final : public Presliding {
 public:
  static void declare(Attributes& a);
  explicit DahlFriction(const Parameters& x) : Presliding(x), exponent_(x["exponent"]) {}

 private:
  double flow(double v, double s, double* byState) const override;
  double exponent_;
};

class LuGreFriction final : public Presliding {
 public:
  static void declare(Attributes& a);
  explicit LuGreFriction(const Parameters& x);

 private:
  double flow(double v, double s, double* byState) const override;
  double more(double v, double flow) const override { return damping_ * flow + viscous_ * v; }
  double static_, speed_, damping_, viscous_;
};

}  // namespace dynamy
