/// StoppingRule: another measure than E_f and E_u by which a solver judges Λ, and the wish to stop.
#pragma once

namespace dynamy {

struct InclusionProblem;

class StoppingRule {
 public:
  virtual ~StoppingRule() = default;
  /// What is compared with the solver's tolerance; `xi` = GΛ + c, rows() entries.
  virtual double measure(const InclusionProblem& problem, const double* Lambda,
                         const double* xi) const = 0;
  /// True: no more work is wanted. Asked now and then; the solver then returns its best Λ so far
  /// with status maxIterations.
  virtual bool enough() const { return false; }
};

/// The measure of FCLIB [acary_bremond_huber2018]: natural map of the exact law with ρ = 1,
///
///   √( Σ_i |Λ_i − P_K(Λ_i − ξ^_i)|² ) / |c|
///
/// It mixes the units of Λ and ξ, so that it depends on the scale of the data; it is here because
/// others publish it.
class FclibRule : public StoppingRule {
 public:
  double measure(const InclusionProblem& problem, const double* Lambda,
                 const double* xi) const override;
};

}  // namespace dynamy
