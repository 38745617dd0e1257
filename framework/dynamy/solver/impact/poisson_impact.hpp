/// Impact laws in two phases, compression and expansion:
///
///   compression  ξ = γ^C,   −ξ_i ∈ N_{C_i}(Λ_i^C)                      (ε = 0, forces of the step)
///   expansion    ξ = γ^E,   Λ_N^E ≥ κ Λ_N^I,  ξ_N ≥ 0 complementary,  Λ_T^E ∈ C_T(Λ_N^E)
///
/// Λ^I: percussions of the compression of the velocities γ^A alone, without forces, so that a
/// contact at rest under weight does not rebound. PoissonImpact: κ = ε_N. EnergeticImpact: κ is
/// chosen such that the normal percussions of a group of contacts return the sum of ε_N² times the
/// work that each of them absorbed in compression. Tangential ε are not used.
#pragma once
#include <dynamy/solver/impact/impact_law.hpp>
#include <memory>

namespace dynamy {

/// A law with a normal row, for the expansion: its normal percussion is at least `floor`.
class FloorLaw final : public SetValuedForceLaw {
 public:
  void set(const SetValuedForceLaw& law, double floor) { law_ = &law, floor_ = floor; }
  int dim(int geometric) const override { return law_->dim(geometric); }
  bool unilateral() const override { return true; }
  RowKind rowKind(int row) const override { return law_->rowKind(row); }
  int groupEnd(int row, int dim) const override { return law_->groupEnd(row, dim); }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  Status status(const LawInput& in, const double* argument) const override {
    return law_->status(in, argument);
  }

 private:
  const SetValuedForceLaw* law_ = nullptr;
  double floor_ = 0.0;
};

/// The two phases of an impact; derived laws choose the floor of the expansion.
class TwoPhaseImpact : public ImpactLaw {
 public:
  using ImpactLaw::ImpactLaw;

 protected:
  /// Solves the compression: Λ^C, with the step's forces, goes into Lambda, Λ^I into impact().
  /// False: no contact rebounds.
  bool compress(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda,
                SolveReport& report) const;
  /// Solves the expansion with Λ_N ≥ kappa[i] Λ_N^I; Λ^E goes into expansion().
  SolveReport expand(const InclusionProblem& problem, InclusionSolver& solver, ConstVec compression,
                     const std::vector<double>& kappa) const;
  ConstVec impact() const { return view(impact_); }
  ConstVec expansion() const { return view(expansion_); }
  /// γ^C after the compression with the step's forces.
  const std::vector<double>& gammaC() const { return expansionProblem_.c; }

 private:
  static ConstVec view(const std::vector<double>& v) {
    return {v.data(), static_cast<Eigen::Index>(v.size())};
  }
  mutable std::vector<double> impact_, expansion_;
  mutable InclusionProblem expansionProblem_;
  mutable ContactSet contacts_;
  mutable std::vector<std::unique_ptr<FloorLaw>> laws_;
};

class PoissonImpact final : public TwoPhaseImpact {
 public:
  PoissonImpact() = default;
  explicit PoissonImpact(const Parameters& x) : TwoPhaseImpact(x) {}
  bool isMirrored(const MirrorPlane&) const override { return true; }
  static void declare(Attributes& a);

 protected:
  SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                          const std::vector<double>& factor, Vec Lambda) const override;

 private:
  mutable std::vector<double> kappa_;
};

class EnergeticImpact final : public TwoPhaseImpact {
 public:
  EnergeticImpact() = default;
  explicit EnergeticImpact(const Parameters& x) : TwoPhaseImpact(x) {}
  static void declare(Attributes& a);

 protected:
  SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                          const std::vector<double>& factor, Vec Lambda) const override;

 private:
  struct Search {
    double low = 0.0, high = 0.0;  // κ with too little and with too much energy returned
    double excessLow = 0.0, excessHigh = 0.0;
    double kappa = 0.0;
    bool bracketed = false, done = true;
  };
  void aims(const InclusionProblem& problem, const std::vector<double>& factor,
            ConstVec compression) const;
  bool search(InclusionProblem& problem) const;
  mutable ContactGroups groups_;
  mutable std::vector<double> kappa_, aim_, excess_, gammaE_;
  mutable std::vector<Search> search_;
};

}  // namespace dynamy
