/// ExplicitStep: a step by an explicit Runge–Kutta method (ButcherTableau), with a lighter method
/// for simple motions.
#pragma once
#include <dynamy/located/phase/butcher_tableau.hpp>
#include <dynamy/located/phase/smooth_method.hpp>

namespace dynamy {

class ExplicitStep final : public SmoothMethod {
 public:
  /// `light`: a method of half the work for simple motions, or null. `plain`: q̇ = u throughout.
  void prepare(const Topology& topology, const ButcherTableau& table, const ButcherTableau* light,
               bool plain);
  bool take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
            State& to) override;
  int errorOrder() const override { return table_->order; }
  bool errorNeedsEnd() const override { return table_->error3 == nullptr; }
  void end(const PhasePoint& to) override {
    Q_.col(table_->stages) = to.qdot, U_.col(table_->stages) = to.a;
  }
  double error(const ErrorNorm& norm, const State& from, const State& to) override;
  int worst() const override { return worst_; }
  bool prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                    const PhasePoint& to) override;
  void dense(double theta, State& out) const override;

  /// Takes steps with the light method from now on, or with the full one again.
  void light(bool wanted) { table_ = wanted && light_ ? light_ : full_; }
  bool light() const { return table_ == light_; }
  /// Called for a step that a switch shortens: the light method takes over if its error in the
  /// longer step would have been far below the tolerance.
  void lighten() {
    if (!light() && lighter_ <= enough_) light(true);
  }
  /// True: the last step, with this error, was taken by the light method and has to be repeated by
  /// the full one.
  bool tooLight(double error);
  /// The error that counts as far below the tolerance; it falls each time that the light method was
  /// too inaccurate.
  double enough() const { return enough_; }
  void enough(double value) { enough_ = value; }
  static constexpr double kEnough = 1e-2;

  /// How near the last step was to the bound of stability.
  struct Stiffness {
    double product = 0.0;  ///< h |λ|, with λ the fastest rate of the motion
    double bound = 0.0;    ///< the largest product of a stable step
    bool damped = false;   ///< the fast part draws states together along its direction
  };
  /// False: the method has no two states at the end of a step that could be compared.
  bool stiffness(const ErrorNorm& norm, const PhasePoint& to, Stiffness& out) const;
  /// Evaluations of a step.
  int evaluations() const { return table_->stages; }

 private:
  bool stage(MechanicalSystem& s, FrozenPhase& phase, int i);
  void combine(const PhasePoint& from, int row, State& out) const;
  const ButcherTableau *table_ = nullptr, *full_ = nullptr, *light_ = nullptr;
  // Error of the embedded method of order 5 in the last step of order 8, and the error that counts
  // as far below the tolerance.
  double lighter_ = 0.0, enough_ = kEnough;
  bool plain_ = false;
  int worst_ = -1;
  State stage_;
  Eigen::VectorXd rate_, a_;  // of a stage
  Eigen::MatrixXd Q_, U_;     // derivatives of stage i in column i
  std::array<Eigen::VectorXd, 8> denseQ_, denseU_;
};

}  // namespace dynamy
