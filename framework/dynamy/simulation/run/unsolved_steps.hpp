/// UnsolvedSteps: keeps the unsolved step with the largest residual and diagnoses its inclusion, for
/// a few steps of a run and for inclusions of moderate size, because a diagnosis takes long.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

class UnsolvedSteps {
 public:
  /// The arguments outlive the object; the result goes to `worst`.
  UnsolvedSteps(Model& model, MechanicalSystem& system, Unsolved& worst)
      : model_(model), system_(system), worst_(worst) {}
  /// Notes the step `report`, number `index` from 1, which ends at t [s] and was not solved, if its
  /// residual is ten times as large as the one kept. `diagnoses`: there is time for a diagnosis.
  void note(long index, double t, const StepReport& report, bool diagnoses);

 private:
  Model& model_;
  MechanicalSystem& system_;
  Unsolved& worst_;
  int diagnoses_ = 0;
};

}  // namespace dynamy
