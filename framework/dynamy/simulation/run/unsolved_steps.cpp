#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/unsolved_steps.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>

namespace dynamy {
namespace {

constexpr int kMostDiagnoses = 3;      ///< of a run
constexpr int kDiagnosisRows = 200;    ///< above, a diagnosis may take more than a second
constexpr int kDiagnosisPivots = 200;  ///< more of them may take ten seconds

}  // namespace

void UnsolvedSteps::note(long index, double t, const StepReport& report, bool diagnoses) {
  const SolveReport& solved = report.solved;
  const InclusionProblem& p = system_.problem();
  Unsolved& u = worst_;
  const double E = solved.residuals.largest();
  if (u.step > 0 && !(E > 10.0 * u.residual)) return;
  u.step = index, u.t = t, u.residual = E, u.iterations = solved.iterations;
  u.status = std::string(solveStatusText(solved.status));
  u.tried = attemptsText(solved);
  const auto name = [&](int i) {
    return contactText(model_, p.contacts->key[static_cast<std::size_t>(i)]);
  };
  // A scheme may solve several problems in a step; the last one need not be the unsolved one.
  const bool known = p.size() > 0 && report.contacts == p.size();
  u.contact = known && solved.residuals.worst >= 0 ? name(solved.residuals.worst) : "";
  u.findings.clear();
  if (!known || !diagnoses || diagnoses_++ >= kMostDiagnoses) return;
  DiagnosisOptions options;
  options.maxRows = kDiagnosisRows, options.maxPivots = kDiagnosisPivots;
  options.name = name;
  const ConstVec Lambda = system_.problem().Lambda();
  InclusionProblem shortly = p;  // each of its starts may take seconds otherwise
  shortly.effort = Effort::retried;
  const Diagnosis d = diagnose(shortly, Lambda, solved, model_.solver(), options);
  for (const Finding& f : d.findings)
    if (f.kind != FindingKind::unsolved) u.findings += f.text + ' ' + f.advice + '\n';
}

}  // namespace dynamy
