/// StoppingRule: replaces E_f and E_u as the measure of Λ, and may request a solver to stop.
#pragma once

namespace dynamy {

struct InclusionProblem;

class StoppingRule {
 public:
  virtual ~StoppingRule() = default;
  /// The value that is compared with the solver's tolerance; `xi` = GΛ + c, rows() entries.
  virtual double measure(const InclusionProblem& problem, const double* Lambda,
                         const double* xi) const = 0;
  /// True if no more work is wanted. Solvers check it at intervals and return their best Λ so far
  /// with status maxIterations.
  virtual bool enough() const { return false; }
};

/// The measure of FCLIB [acary_bremond_huber2018]: natural map of the exact law with ρ = 1,
///
///   √( Σ_i |Λ_i − P_K(Λ_i − ξ^_i)|² ) / |c|
///
/// It mixes the units of Λ and ξ, so that it depends on the scale of the data; it is offered
/// because others publish it.
class FclibRule : public StoppingRule {
 public:
  double measure(const InclusionProblem& problem, const double* Lambda,
                 const double* xi) const override;
};

}  // namespace dynamy
