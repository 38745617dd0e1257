#include <fmt/format.h>

#include <algorithm>
#include <dynamy/contact/contact_name.hpp>
#include <dynamy/integrator/contact_probe.hpp>

namespace dynamy {

void ContactProbe::evaluate(const State& x, const ContactRequest& request) {
  kinematics_.evaluate(*parts_->topology, x.t, view(x.q), view(x.u), view(x.memory));
  contacts_.clear();
  ContactSink sink(contacts_, request);
  for (std::size_t i = 0; i < parts_->contacts.size(); ++i) {
    sink.element(static_cast<int>(i));
    parts_->contacts[i]->contacts(kinematics_, sink);
  }
}

void ContactProbe::prepare(const MechanicalSystem& s, const State& x) {
  parts_ = &s.parts();
  announcements_.read(*parts_);
  kinematics_.resize(*parts_->topology);
  list(x);
}

void ContactProbe::list(const State& x) {
  ContactRequest request;
  request.refresh = true;
  evaluate(x, request);
  order_ = contacts_.candidateKey, all_ = order_;
  std::sort(all_.begin(), all_.end());
}

bool ContactProbe::look(const State& x) {
  ContactRequest request;
  request.refresh = true, request.frozen = all_;
  evaluate(x, request);
  if (contacts_.candidateKey != order_) return false;
  gamma_.resize(contacts_.rows());
  contacts_.gamma(view(x.u), view(gamma_));
  announcements_.switching(kinematics_, switching_);
  return true;
}

std::string ContactProbe::unfollowed() const {
  const std::vector<ContactKey>& now = contacts_.candidateKey;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (!std::binary_search(all_.begin(), all_.end(), now[i]))
      return why(now[i], "appears with a gap of " + fmt::format("{:.3g}", contacts_.g[i]) + " m");
  for (const ContactKey key : order_)
    if (std::find(now.begin(), now.end(), key) == now.end())
      return why(key, "is no longer reported");
  return "contacts are reported in another order than at the start";
}

std::string ContactProbe::lost(ContactKey key) const {
  return why(key, "is closed, and no longer reported");
}

std::string ContactProbe::why(ContactKey key, const std::string& what) const {
  const auto number = static_cast<std::size_t>(key.value >> 40);
  const NonSmoothElement& e = *parts_->contacts[number];
  // Contacts of shapes have no type of their own.
  const std::string cause =
      e.type().empty() ? "which features of two bodies could touch (corners over faces, rims over "
                         "edges, faces of "
                         "a mesh that are nearest to a ball) is another list after every motion"
                       : "<" + e.type() + "> reports it at some positions only";
  return "contact " + contactName(e, number, contactNumber(key)) + " " + what + ": " + cause +
         ", and its gap cannot be followed; give a step instead of the tolerance";
}

int ContactProbe::find(ContactKey key) const {
  const auto at = std::find(contacts_.key.begin(), contacts_.key.end(), key);
  return at == contacts_.key.end() ? -1 : static_cast<int>(at - contacts_.key.begin());
}

}  // namespace dynamy
