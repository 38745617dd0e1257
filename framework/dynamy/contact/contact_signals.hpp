/// Signals every contact offers: g, status, and per row γ, Λ, λ.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

/// Names the signals of contact `id` of the element: g [m], status (−), gamma_N, gamma_T… [m/s],
/// Lambda_N, Lambda_T… [N s], lambda_N, lambda_T… [N] (Λ/Δt). `prefix` stands in front ("",
/// "corner3.").
void describeContact(Description& d, std::uint64_t id, int geometric, const SetValuedForceLaw& law,
                     const std::string& prefix = {});

}  // namespace dynamy
