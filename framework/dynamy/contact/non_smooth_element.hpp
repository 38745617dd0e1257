/// NonSmoothElement: emits all of its contacts (gaps, W and χ) in one call. −ξ_i ∈ N_{C_i}(Λ_i) for
/// each of them.
#pragma once
#include <dynamy/contact/contact_sink.hpp>

namespace dynamy {

class NonSmoothElement : public Element {
 public:
  static constexpr Kind kKind = Kind::contact;
  using Element::Element;
  /// Names → handles, once.
  virtual void connect(Topology& topology) = 0;
  /// Reports every gap that can close, and W and χ rows of the closed ones.
  virtual void contacts(const Kinematics& k, ContactSink& sink) const = 0;
  /// Changes the numbers the element reserved by Topology::memory, from the end of an accepted
  /// step. Called once per step, in no other place; a rejected step is rolled back with its State.
  virtual void remember(const Kinematics&, Vec /*memory*/) const {}
  /// Name of one of its contacts in reports, the element's own left out; "": its number is shown.
  virtual std::string contactName(std::uint64_t /*id*/) const { return {}; }
};

}  // namespace dynamy
