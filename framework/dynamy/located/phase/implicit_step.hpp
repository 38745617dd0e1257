/// ImplicitStep: a step by the Radau IIA method of order 5 (RadauStep), for stiff motions.
#pragma once
#include <dynamy/located/phase/radau_step.hpp>
#include <dynamy/located/phase/smooth_method.hpp>

namespace dynamy {

class ImplicitStep final : public SmoothMethod {
 public:
  /// `norm` measures the changes of Newton's method.
  void prepare(const Topology& topology, const ErrorNorm& norm);
  bool take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
            State& to) override;
  int errorOrder() const override { return 4; }
  double error(const ErrorNorm&, const State&, const State&) override { return error_; }
  double mostGrowth() const override;
  bool prepareDense(MechanicalSystem&, FrozenPhase&, const PhasePoint&,
                    const PhasePoint&) override {
    return true;
  }
  void dense(double theta, State& out) const override;

  /// Place where the Jacobian of the next step was taken, as numbers; empty: none. keep() of
  /// another ImplicitStep takes the Jacobian there again, in slot 1.
  Eigen::VectorXd kept() const;
  void keep(MechanicalSystem& s, FrozenPhase& phase, const State& x, const Eigen::VectorXd& place);
  /// Drops the Jacobian, since the phase has changed: the next step takes a new one.
  void forget() { radau_.forget(), y_.resize(0); }
  /// Work of the last step in evaluations.
  double work() const;
  /// Work of a step with a Jacobian and without difficulties.
  static double usualWork(Eigen::Index unknowns);
  /// h |λ| of the last step, with λ the fastest rate of the motion.
  double product() const { return h_ * radau_.fastest(); }

 private:
  RadauStep::Field field(MechanicalSystem& s, FrozenPhase& phase);
  RadauStep radau_;
  double error_ = 0.0;
  bool failed_ = false;
  State stage_;
  Eigen::VectorXd qdot_, a_;  // of a stage
  Eigen::VectorXd y_, f_, yNew_,
      fNew_;  // (q, u) and its rate where the last step began, begins
  std::array<Eigen::VectorXd, 3> stageLambda_;
  std::array<std::array<double, 5>, 3> stagePower_{};
};

}  // namespace dynamy
