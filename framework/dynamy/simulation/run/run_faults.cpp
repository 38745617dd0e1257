#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/run_faults.hpp>
#include <tuple>

namespace dynamy {
namespace {

/// Index of a gap in the last evaluation that is not a number, because it would count as open; −1:
/// none.
int gapWithoutNumber(const MechanicalSystem& system) {
  const std::vector<double>& g = system.slot(0).contacts.g;
  const auto at = std::find_if(g.begin(), g.end(), [](double x) { return std::isnan(x); });
  return at == g.end() ? -1 : static_cast<int>(at - g.begin());
}

}  // namespace

bool isSound(const MechanicalSystem& system, const State& x, const StepReport& step) {
  if (!step.refused.empty() || system.indefiniteMass() >= 0 || gapWithoutNumber(system) >= 0)
    return false;
  const SystemSubset* some = system.parts().subset;
  if (some == nullptr || !some->anyRests()) return x.q.allFinite() && x.u.allFinite();
  return std::all_of(some->systems().begin(), some->systems().end(), [&](int i) {
    const SystemHandle& s = system.parts().topology->system(i);
    return x.q.segment(s.q0, s.nq).allFinite() && x.u.segment(s.u0, s.nu).allFinite();
  });
}

std::string faultOf(const Model& model, const MechanicalSystem& system, const State& x,
                    const StepReport& step) {
  const std::string when = "t = " + numberText(x.t) + " s: ";
  if (!step.refused.empty())
    return when + "<" + model.scheme().type() + "> refuses: " + std::string(step.refused);
  if (system.indefiniteMass() >= 0)
    return when + "the mass matrix of " + systemName(model, system.indefiniteMass()) +
           " is not positive definite";
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const SystemHandle& s = model.topology().system(static_cast<int>(i));
    for (const auto& [letter, v, first, n] :
         {std::tuple{"u", &x.u, s.u0, s.nu}, std::tuple{"q", &x.q, s.q0, s.nq}})
      for (int k = 0; k < n; ++k)
        if (!std::isfinite((*v)[first + k]))
          return when + letter + "[" + std::to_string(k) + "] of " +
                 systemName(model, static_cast<int>(i)) + " is not finite";
  }
  if (const int i = gapWithoutNumber(system); i >= 0)
    return when + "the gap of " +
           contactText(model, system.slot(0).contacts.candidateKey[static_cast<std::size_t>(i)]) +
           " is not a number";
  return {};
}

const ExternalForce* forceWithoutNumber(const Model& model, const State& x, double t) {
  const int nu = model.topology().nu();
  Kinematics k;
  k.resize(model.topology());
  k.evaluate(model.topology(), t, view(x.q), view(x.u), view(x.memory));
  Eigen::VectorXd h(nu), nonPotential(nu);
  for (const auto& force : model.forces()) {
    h.setZero(), nonPotential.setZero();
    ForceSink sink(view(h), view(nonPotential));
    force->addTo(k, sink);
    if (!h.allFinite()) return force.get();
  }
  return nullptr;
}

std::string missedTolerance(const Model& model, const MechanicalSystem& system, double t,
                            const SolveReport& solved) {
  const ContactSet& c = system.slot(0).contacts;
  const Residuals& e = solved.residuals;
  std::string text = "t = " + numberText(t) + " s: the inclusion was not solved (" +
                     std::string(solveStatusText(solved.status)) + " after " +
                     std::to_string(solved.iterations) + " iterations, residual " +
                     numberText(e.largest());
  if (e.worst >= 0 && e.worst < c.size())
    text += ", worst at " + contactText(model, c.key[static_cast<std::size_t>(e.worst)]);
  return text + "); onNonConvergence is stop";
}

std::string divergence(const Model& model, const State& x, const RunTrust& trust) {
  int fastest = 0;
  double most = -1.0;
  for (int i = 0; i < static_cast<int>(model.systems().size()); ++i) {
    const SystemHandle& s = model.topology().system(i);
    if (const double speed = x.u.segment(s.u0, s.nu).norm(); speed > most)
      most = speed, fastest = i;
  }
  return fmt::format(
      "t = {} s: the run has diverged: T + V rose by {:.2g} J, more than {:.0e} times all that it "
      "began with and all works; the fastest is {}; {}",
      numberText(trust.energyRiseTime), trust.energyRise, RunTrust::kDiverged,
      systemName(model, fastest),
      model.scheme().choosesSteps() ? "take a smaller tolerance" : "take a smaller step");
}

std::string lawThatThrows(const MechanicalSystem& system) {
  const InclusionProblem& p = system.problem();
  const auto rows = static_cast<std::size_t>(p.rows());
  if (p.gammaFree.size() != rows || p.gammaA.size() != rows) return {};  // none was set up
  std::vector<double> r, xi, Lambda;
  for (int i = 0; i < p.size(); ++i) {
    const auto n = static_cast<std::size_t>(p.dim(i));
    const auto first = p.gammaFree.begin() + p.row0(i);
    r.assign(n, 1.0), xi.assign(first, first + p.dim(i)), Lambda.assign(n, 0.0);
    try {
      named(p.law(i), [&] { p.law(i).prox(p.input(i), r.data(), xi.data(), Lambda.data()); });
    } catch (const ElementFault& e) {
      return e.what();
    }
  }
  return {};
}

}  // namespace dynamy
