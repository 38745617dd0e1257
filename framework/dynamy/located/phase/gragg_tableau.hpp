/// Gragg's extrapolated midpoint rule as a Butcher tableau [hairer_norsett_wanner1993, II.9]:
///
///   η₁ = y + h f(y),   η_{k+1} = η_{k−1} + 2h f(η_k),   T_{j,1} = η_{n_j},   h = H/n_j,  n_j = 2j
///   T_{j,l+1} = T_{j,l} + (T_{j,l} − T_{j−1,l}) / ((n_j/n_{j−l})² − 1)
///
/// k columns have order 2k. The error estimate is T_{k,k} − T_{k,k−1}; the harmonic sequence takes
/// 1 + k² stages. Gragg's smoothing step is left out: the order is the same without it, and an
/// explicit rule is not used for its damping.
#pragma once
#include <dynamy/located/phase/butcher_tableau.hpp>

namespace dynamy {

/// Order 2, 4, 6 or 8; throws std::invalid_argument for others.
const ButcherTableau& graggTableau(int order);

}  // namespace dynamy
