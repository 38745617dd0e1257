#include <algorithm>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/schemes/paoli_schatzman.hpp>

namespace dynamy {
namespace {

/// Shortest step that is accepted as equally long, as a part of the step before.
constexpr double kEqual = 1e-4;

}  // namespace

StepReport PaoliSchatzman::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  s.evaluate(x, {.ahead = dt});  // M, h, W, χ and g at q_k
  if (x.impulses.dt == 0.0) {    // start: q_{−1} = q_0 − Δt u_0 + Δt²/2 a_0
    a_.resize(x.u.size());
    s.slot(0).mass.applyInverse(view(s.slot(0).h), view(a_));
    x.u -= 0.5 * dt * a_;
  }
  auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
  problem.linearlyImplicit(x, kImplicitEnd);
  gapsBefore(s, problem, x, dt);
  const bool rebounds =
      std::any_of(offset_.begin(), offset_.end(), [](double o) { return o != 0.0; });
  if (rebounds && dt < kEqual * x.impulses.dt) {
    StepReport report{dt, {}, problem.size()};
    report.refused =
        "a rebound compares two steps of equal length, and a fast body asks for a much shorter one";
    return report;
  }
  // q_{k+1} = q_k + Δt u_{k+1},  g(q_{k+1}) + ε g(q_{k−1}) ≥ 0
  const auto solved = level_.solve(s, problem, solver, x, dt, 1, offset_);
  return {dt, solved, problem.size(), lackingAtImpact(s)};
}

std::string_view PaoliSchatzman::lacks(Asked what) const {
  switch (what) {
    case Asked::frictionAtImpact:
      return "a contact with friction is hit, and this scheme spreads an impact over two steps, "
             "for which no friction is defined";
    case Asked::impactLaw:
      return "restitution is a mean of its positions, it takes no impact law";
    default:
      return {};
  }
}

void PaoliSchatzman::gapsBefore(MechanicalSystem& s, const InclusionProblem& problem,
                                const State& x, double dt) {
  const ContactSet& c = *problem.contacts;
  offset_.assign(static_cast<std::size_t>(problem.rows()), 0.0);
  before_ = x;
  s.move(before_, x.u, -dt);
  keys_.clear();
  addKeys(c, keys_);
  const ContactSet& before = s.evaluate(before_, {.slot = 1, .held = HeldContacts{keys_}}).contacts;
  for (int i = 0; i < c.size(); ++i) {
    if (!problem.law(i).unilateral()) continue;
    double epsilon[kMostRows] = {};
    problem.law(i).epsilon(problem.dim(i), epsilon);
    for (int j = 0; j < before.size() && epsilon[0] > 0.0; ++j)
      if (before.key[static_cast<std::size_t>(j)] == c.key[static_cast<std::size_t>(i)])
        offset_[static_cast<std::size_t>(problem.row0(i))] =
            epsilon[0] *
            before.position[static_cast<std::size_t>(before.row0[static_cast<std::size_t>(j)])] /
            dt;
  }
}

void PaoliSchatzman::declare(Attributes& a) {
  a.about(
      "Paoli and Schatzman's scheme: laws on displacement level, restitution by the mean of the "
      "positions one step before and after, order 1. The velocity of the state is that of the "
      "last step, (q_k - q_(k-1))/dt.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><PaoliSchatzman/></simulation>");
}

}  // namespace dynamy
