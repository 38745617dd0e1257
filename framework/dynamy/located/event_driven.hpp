/// EventDriven: the event-driven scheme of the textbooks (theory 51.7), for comparison.
///
///   phase     index sets fixed: q̇ = Fu + β, M u̇ = h + Wλ, Wᵀu̇ + w̄ = 0 in the rows that hold
///   events    g = 0, λ_N = 0, γ_T = 0, |λ_T| = μ λ_N, each by its root
///   at each   the impact law, then one inclusion on the level of accelerations, at the instant:
///                 −γ̇_N ∈ N(λ_N) where g = γ_N = 0,   −γ̇_T ∈ N(λ_T) where γ_T = 0 too
///
/// Phases, search and impacts are those of LocatedDormandPrince. Its extensions are left out: the
/// look ahead of decisions (here stick ends in slip because its bound was reached), the passage of
/// accumulations, the ends of slip in space, monitors ignored for a while after empty events, and
/// steps in time. Where impacts accumulate the scheme stalls, and reports it.
#pragma once
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {

class EventDriven final : public LocatedDormandPrince {
 public:
  EventDriven();
  explicit EventDriven(const Parameters& x);
  static void declare(Attributes& a);
};

}  // namespace dynamy
