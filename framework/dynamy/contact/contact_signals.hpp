/// Signals every contact offers: g, status, and per row γ, Λ, λ.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/system/description.hpp>

namespace dynamy {

/// Number `id` of a contact, and the `count` numbers from `first` on of the contacts reported in
/// its place if pairs of features are followed one by one (ContactRequest::follow). At most one of
/// these contacts presses at a time.
struct ContactNumbers {
  std::uint64_t id = 0, first = 0, count = 0;
};

/// Rows of a contact whose positions are angles: bit r stands for row r.
using AngularRows = unsigned;
inline constexpr AngularRows kAllAngular = ~0U;

/// Adds the signals of contact `numbers` of the element: g [m], status (−), gamma_N, gamma_T…
/// [m/s], Lambda_N, Lambda_T… [N s], lambda_N, lambda_T… [N] (Λ/Δt); of `angular` rows in rad, rad/s,
/// N m s, N m. Their names begin with `prefix` ("", "corner3.").
void describeContact(Description& d, const ContactNumbers& numbers, int geometric,
                     const SetValuedForceLaw& law, const std::string& prefix = {},
                     AngularRows angular = 0);
inline void describeContact(Description& d, std::uint64_t id, int geometric,
                            const SetValuedForceLaw& law, const std::string& prefix = {},
                            AngularRows angular = 0) {
  describeContact(d, ContactNumbers{id, 0, 0}, geometric, law, prefix, angular);
}

}  // namespace dynamy
