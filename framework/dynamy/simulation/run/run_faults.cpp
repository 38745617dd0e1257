// Simulation: reports on steps that were not solved or cannot be taken.
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <tuple>

namespace dynamy {
namespace {

constexpr int kMostDiagnoses = 3;    ///< of a run
constexpr int kDiagnosisRows = 400;  ///< above, a diagnosis would take seconds

/// Index of a gap in the last evaluation that is not a number, because it would count as open; −1:
/// none.
int gapWithoutNumber(const MechanicalSystem& system) {
  const std::vector<double>& g = system.slot(0).contacts.g;
  const auto at = std::find_if(g.begin(), g.end(), [](double x) { return std::isnan(x); });
  return at == g.end() ? -1 : static_cast<int>(at - g.begin());
}

}  // namespace

bool Simulation::sound() const {
  return stepReport_.refused.empty() && system_.indefiniteMass() < 0 && x_.q.allFinite() &&
         x_.u.allFinite() && gapWithoutNumber(system_) < 0;
}

bool Simulation::fail(const StepReport& report) {
  const ContactSet& c = system_.slot(0).contacts;
  const Residuals& e = report.solved.residuals;
  std::string text = "t = " + numberText(x_.t) + " s: the inclusion was not solved (" +
                     std::string(solveStatusText(report.solved.status)) + " after " +
                     std::to_string(report.solved.iterations) + " iterations, residual " +
                     numberText(e.largest());
  if (e.worst >= 0 && e.worst < c.size())
    text += ", worst at " + contactText(model_, c.key[static_cast<std::size_t>(e.worst)]);
  stepReport_ = {};
  return endBecause(text + "); onNonConvergence is stop");
}

void Simulation::noteUnsolved() {
  const SolveReport& solved = stepReport_.solved;
  const InclusionProblem& p = system_.problem();
  Unsolved& u = report_.unsolved;
  const double E = solved.residuals.largest();
  if (u.step > 0 && !(E > 10.0 * u.residual)) return;
  u.step = report_.steps + 1, u.t = x_.t, u.residual = E, u.iterations = solved.iterations;
  u.status = std::string(solveStatusText(solved.status));
  u.tried = attemptsText(solved);
  const auto name = [&](int i) {
    return contactText(model_, p.contacts->key[static_cast<std::size_t>(i)]);
  };
  // A scheme may solve several problems in a step; the last one need not be the unsolved one.
  const bool known = p.size() > 0 && stepReport_.contacts == p.size();
  u.contact = known && solved.residuals.worst >= 0 ? name(solved.residuals.worst) : "";
  u.findings.clear();
  if (!known || stopped() || diagnoses_++ >= kMostDiagnoses) return;
  DiagnosisOptions options;
  options.maxRows = kDiagnosisRows, options.name = name;
  const Vec Lambda = system_.Lambda();
  const Diagnosis d = diagnose(p, dynamy::view(Lambda), solved, model_.solver(), options);
  for (const Finding& f : d.findings)
    if (f.kind != FindingKind::unsolved) u.findings += f.text + ' ' + f.advice + '\n';
}

std::string Simulation::fault() const {
  const std::string when = "t = " + numberText(x_.t) + " s: ";
  if (!stepReport_.refused.empty())
    return when + "<" + model_.scheme().type() + "> refuses: " + std::string(stepReport_.refused);
  if (system_.indefiniteMass() >= 0)
    return when + "the mass matrix of " + systemName(model_, system_.indefiniteMass()) +
           " is not positive definite";
  for (std::size_t i = 0; i < model_.systems().size(); ++i) {
    const SystemHandle& s = model_.topology().system(static_cast<int>(i));
    for (const auto& [letter, v, first, n] :
         {std::tuple{"u", &x_.u, s.u0, s.nu}, std::tuple{"q", &x_.q, s.q0, s.nq}})
      for (int k = 0; k < n; ++k)
        if (!std::isfinite((*v)[first + k]))
          return when + letter + "[" + std::to_string(k) + "] of " +
                 systemName(model_, static_cast<int>(i)) + " is not finite";
  }
  if (const int i = gapWithoutNumber(system_); i >= 0)
    return when + "the gap of " +
           contactText(model_, system_.slot(0).contacts.candidateKey[static_cast<std::size_t>(i)]) +
           " is not a number";
  return {};
}

}  // namespace dynamy
