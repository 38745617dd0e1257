#include <algorithm>
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
  kinematics_.resize(*parts_->topology);
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
  return true;
}

int ContactProbe::find(ContactKey key) const {
  const auto at = std::find(contacts_.key.begin(), contacts_.key.end(), key);
  return at == contacts_.key.end() ? -1 : static_cast<int>(at - contacts_.key.begin());
}

}  // namespace dynamy
