/// EventDriven: the event-driven scheme of the textbooks (theory 51.7), for comparison.
///
///   phase     index sets fixed: q̇ = Fu + β, M u̇ = h + Wλ, Wᵀu̇ + w̄ = 0 in the rows that hold
///   events    g = 0, λ_N = 0, γ_T = 0, |λ_T| = μ λ_N, each by its root
///   at each   the impact law, then one inclusion on the level of accelerations, at the instant:
///                 −γ̇_N ∈ N(λ_N) where g = γ_N = 0,   −γ̇_T ∈ N(λ_T) where γ_T = 0 too
///
/// Phases, search and impacts are those of LocatedMotion, with EventPolicy::textbook(): without the
/// look ahead of decisions (here stick ends in slip because its bound was reached), the passage of
/// accumulations, the ends of slip in space, and monitors ignored for a while after empty events.
/// There are no steps in time. Where impacts accumulate the scheme stalls, and reports it.
#pragma once
#include <dynamy/located/step/located_motion.hpp>

namespace dynamy {

class EventDriven final : public OneStep {
 public:
  EventDriven();
  explicit EventDriven(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return motion_.settings().table().order; }
  bool choosesSteps() const override { return true; }
  bool findsContacts() const override { return true; }
  void aim(const Accuracy& accuracy) override { motion_.aim(accuracy); }
  double nextStep(const State& x) const override { return x.scheme.size() > 0 ? x.scheme[0] : 0.0; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;
  bool contactsAt(const MechanicalSystem& s, const State& at, bool after,
                  ContactInstant& out) const override;

 private:
  /// What State::scheme holds.
  struct Kept {
    HeldState held;
    double time = 0.0;      ///< T of the scene [s]
    Eigen::VectorXd times;  ///< T of each system [s]
    void archive(NumberArchive& a) { a(held), a(time), a(times); }
  };
  bool load(const MechanicalSystem& s, const State& x);
  /// Interpolation evaluates stages of the last step when it is first requested.
  mutable LocatedMotion motion_;
  Kept kept_;
  Eigen::VectorXd stored_;  // x.scheme as written last
  std::string refusal_;
};

}  // namespace dynamy
