#include <algorithm>
#include <cmath>
#include <cstdio>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <dynamy/solver/diagnosis/diagnosis_parts.hpp>

namespace dynamy {

std::string_view findingName(FindingKind kind) {
  switch (kind) {
    case FindingKind::unsolved:
      return "unsolved";
    case FindingKind::rounding:
      return "rounding";
    case FindingKind::contradiction:
      return "contradiction";
    case FindingKind::jam:
      return "jam";
    case FindingKind::painleve:
      return "painleve";
    case FindingKind::severalSolutions:
      return "severalSolutions";
    case FindingKind::redundantJoints:
      return "redundantJoints";
    case FindingKind::forcesNotUnique:
      return "forcesNotUnique";
    case FindingKind::tooLarge:
      return "tooLarge";
  }
  return "unknown";
}

std::string attemptsText(const SolveReport& r) {
  std::string out;
  for (int k = 0; k < r.attempts; ++k) {
    const Attempt& a = r.attempt[static_cast<std::size_t>(k)];
    if (!out.empty()) out += ", then ";
    out += std::string(a.method) + " (" + std::to_string(a.iterations) + " iterations, residual " +
           diagnosis::number(a.residual) + ")";
  }
  if (out.empty())
    out = std::string(r.method.empty() ? "iteration" : r.method) + " (" +
          std::to_string(r.iterations) + " iterations)";
  return out;
}

const Finding* Diagnosis::find(FindingKind kind) const {
  for (const Finding& f : findings)
    if (f.kind == kind) return &f;
  return nullptr;
}

std::string Diagnosis::text(const std::string& indent) const {
  std::string out;
  if (rank >= 0)
    out += indent + std::to_string(closed) + " of " + std::to_string(contacts) +
           " contacts closed, rank " + std::to_string(rank) + " of " + std::to_string(rows) +
           " rows\n";
  for (const Finding& f : findings) {
    out += indent + f.text + '\n';
    if (!f.advice.empty()) out += indent + "  " + f.advice + '\n';
  }
  return out;
}

Diagnosis diagnose(const InclusionProblem& p, ConstVec Lambda, const SolveReport& report,
                   InclusionSolver& solver, const DiagnosisOptions& options) {
  using namespace diagnosis;
  Diagnosis d;
  d.contacts = p.size();
  const Names names{options.name};
  const auto add = [&d](std::optional<Finding> f) {
    if (f) d.findings.push_back(std::move(*f));
  };
  add(unsolved(report, names));
  if (p.rows() == 0) return d;
  if (p.rows() > options.maxRows || !Lambda.allFinite()) {
    d.rank = -1;
    if (Lambda.allFinite()) add(tooLarge(p.rows(), options.maxRows));
    return d;
  }
  const DenseProblem dense(p, Lambda);
  if (!dense.finite()) {  // decompositions that pivot by size read out of bounds
    d.rank = -1;
    return d;
  }
  for (int i = 0; i < p.size(); ++i) d.closed += dense.isClosed(i) ? 1 : 0;
  const std::vector<int> rows = dense.rowsOf([&](int i) { return dense.isClosed(i); });
  const Eigen::MatrixXd Z = dense.kernel(rows);
  d.rows = static_cast<int>(rows.size());
  d.rank = d.rows - static_cast<int>(Z.cols());
  d.freedom = freeDirections(dense, Z);

  add(contradictingJoints(dense, names));
  add(jam(dense, names));
  // Forces that grow without bound have large rounding errors, which are then not the cause.
  if (!d.find(FindingKind::contradiction)) add(rounding(dense, options.tolerance, names));
  add(pivoted(p, report, options));
  for (Finding& f : painleve(dense, names)) d.findings.push_back(std::move(f));
  if (options.otherStarts) add(severalSolutions(dense, report, solver, options.tolerance, names));
  add(redundantJoints(dense, names));
  if (report.ok()) add(forcesNotUnique(d, names));
  return d;
}

}  // namespace dynamy
