/// ImplicitForces: the forces that a step takes implicitly: those of stiff elements, at its end those that
/// it does not resolve, and by the midpoint rule some that it does (StiffPart, UnresolvedForces).
///
///   M̂ (u_free − u^A) = Δt (h + Δt s K u^A),   M̂ = M − b Δt D − a Δt² K
#pragma once
#include <dynamy/stages/evaluation.hpp>

namespace dynamy {

/// How well a step resolves the forces that swing.
struct ForceResolution {
  double share = 0.0;   ///< of the stability limit of explicit rules (UnresolvedForces::swing)
  bool coarse = false;  ///< by more than the scheme takes without an error in the energy
  /// Share above which an explicit step is coarse: ωΔt = 0.5 between two equal bodies, whose energy
  /// swings by 3 %. The implicit midpoint rule keeps it up to the limit.
  static constexpr double kExplicit = 1.0 / 32.0;
};

class ImplicitForces {
 public:
  explicit ImplicitForces(const SystemParts& parts);
  /// True: the model has stiff elements.
  bool any() const { return stiff_.any(); }
  StiffPart& stiff() { return stiff_; }

  /// At `e`, evaluated at x: finds the forces that a step Δt damps or keeps (UnresolvedForces), and
  /// factorises M̂ with them, with weights `declared` of stiff elements. unresolved() says whether there
  /// are any.
  void resolve(const SystemParts& parts, const Evaluation& e, const State& x, double dt,
               const ImplicitWeights& declared, Keeping keeping);
  /// M̂ contains forces of elements that are not declared stiff.
  bool unresolved() const { return unresolved_; }
  void forget() { unresolved_ = false; }
  /// Number of forces that the present step takes at its end, or that are withheld.
  int damped() const { return damped_; }
  /// Those by index, 1 for each; valid until the next step.
  std::span<const char> dampedForces() const { return which_; }
  void damp(std::span<const char> forces);
  /// Work of the parts with potential of these forces, as the present step used them [J]: Δt h_d·ū.
  double dampedWork() const { return dampedWork_; }
  void dampedWork(double work) { dampedWork_ = work; }
  /// The same for a step with M̂ from u^A to u^E, evaluated at `e`.
  void bookDampedWork(const SystemParts& parts, const Evaluation& e, double dt,
                      const Eigen::VectorXd& uA, const Eigen::VectorXd& uE);
  /// How well the present step resolves the forces.
  const ForceResolution& resolution() const { return resolution_; }
  void resolution(const ForceResolution& r) { resolution_ = r; }

  /// See ImplicitMass::work().
  double work() const { return stiff_.work(); }

  /// u_free − u^A with the factorised M̂, nu numbers.
  const Eigen::VectorXd& change(const Evaluation& e, const Eigen::VectorXd& uA, double dt);
  /// Accelerations by the forces at `e` [m/s²]: M⁻¹h, or where some are unresolved (u_free − u^A)/Δt
  /// of the last resolve().
  const Eigen::VectorXd& acceleration(const Evaluation& e) const;
  /// K and D at `e`, evaluated at x, and M̂ with `mass`. Only with stiff elements.
  void factor(const SystemParts& parts, const Evaluation& e, const State& x, const MassMatrix& mass,
              double dt, const ImplicitWeights& weights);
  /// True: a rule that is explicit in h and stable up to ωΔt = `limit` is not so for the stiff
  /// elements at `e`, evaluated at x.
  bool explicitIsUnstable(const SystemParts& parts, const Evaluation& e, const State& x, double dt,
                          double limit);
  /// Takes gyroscopic terms in h of `e` at the mean velocity of a step Δt from x. Where forces are
  /// unresolved, after resolve().
  void gyroscopicAtMean(const SystemParts& parts, Evaluation& e, const State& x, double dt);

 private:
  StiffPart stiff_;
  bool unresolved_ = false;
  int damped_ = 0;
  std::span<const char> which_;
  double dampedWork_ = 0.0;
  ForceResolution resolution_;
  Eigen::VectorXd change_, work_;
  mutable Eigen::VectorXd acceleration_;
};

}  // namespace dynamy
