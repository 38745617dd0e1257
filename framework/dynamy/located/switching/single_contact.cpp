#include <dynamy/located/switching/single_contact.hpp>

namespace dynamy {

void SingleContact::prepare(const SystemParts& parts) {
  parts_ = &parts;
  kinematics_.resize(*parts.topology);
}

bool SingleContact::look(const QuinticPath& path, double theta, State& x, ContactRequest request) {
  const ContactKey key = request.frozen.front();
  const NonSmoothElement& element = *parts_->contacts[static_cast<std::size_t>(key.value >> 40)];
  frames_.clear();
  if (!element.framesOf(contactNumber(key), frames_)) return false;
  path.at(theta, *parts_, frames_, x);
  const State& at = x;
  kinematics_.evaluate(*parts_->topology, at.t, view(at.q), view(at.u), view(at.memory),
                       parts_->subset, frames_);
  request.near = nullptr;
  report(*parts_, kinematics_, request);
  return true;
}

void SingleContact::report(const SystemParts& parts, const Kinematics& k,
                           const ContactRequest& request) {
  const int number = static_cast<int>(request.frozen.front().value >> 40);
  only_.assign(parts.contacts.size(), 0);
  only_[static_cast<std::size_t>(number)] = 1;
  found_.contacts.clear();
  ContactSink sink(found_.contacts, request, parts.subset);
  reportContacts(parts, k, sink, only_);
}

bool SingleContact::giveTo(ContactGaps& gaps, int i, const Eigen::VectorXd& u) {
  const int found = found_.find(gaps.key(i));
  if (found < 0) return false;
  found_.evaluateGammas(u);
  return gaps.take(i, found_, found);
}

}  // namespace dynamy
