#include <algorithm>
#include <dynamy/located/switching/contact_probe.hpp>

namespace dynamy {

namespace {

/// Requests exactly these contacts, wherever they are; `near`: others need not be reported. `flat`:
/// ContactRequest::flat.
ContactRequest following(std::span<const ContactKey> keys, const NearContacts* near, double flat) {
  ContactRequest request;
  request.refresh = request.follow = true, request.frozen = keys, request.near = near;
  request.flat = flat, request.absent = true;
  return request;
}

}  // namespace

void ContactProbe::evaluate(const State& x, const ContactRequest& request) {
  kinematics_.evaluate(*parts_->topology, x.t, view(x.q), view(x.u), view(x.memory),
                       parts_->subset);
  gaps_.contacts.clear();
  ContactSink sink(gaps_.contacts, request, parts_->subset);
  reportContacts(*parts_, kinematics_, sink);
  ++looks.whole, looks.gaps += static_cast<long>(gaps_.contacts.candidateKey.size());
  looks.searched += gaps_.contacts.features.searched;
}

void ContactProbe::prepare(const MechanicalSystem& s, const State& x) {
  parts_ = &s.parts();
  announcements_.read(*parts_);
  kinematics_.resize(*parts_->topology), one_.prepare(*parts_);
  list(x);
}

void ContactProbe::list(const State& x) {
  const auto comeOrNoted = [](const ContactGaps& gaps) {
    return gaps.contacts.features.comeAndGo || !gaps.contacts.features.noted.empty();
  };
  const NearContacts none;
  near_ = &none;
  evaluate(x, following({}, near_, flat_));
  othersGather_ = comeOrNoted(gaps_);
  narrow(nullptr);
  evaluate(x, following({}, near_, flat_));
  gathers_ = comeOrNoted(gaps_);
  order_ = gaps_.contacts.candidateKey, all_ = order_, ordered_ = true;
  std::sort(all_.begin(), all_.end());
  fixed_ = all_;
}

void ContactProbe::narrow(const NearContacts* near) { near_ = near, ordered_ = false; }

bool ContactProbe::gather(const State& x, std::span<const ContactKey> held) {
  if (near_ != nullptr)
    near_->select(fixed_, wide_);
  else
    wide_ = fixed_;
  wide_.insert(wide_.end(), held.begin(), held.end());
  if (gathers()) widen(x, 0.0);
  return settle(x);
}

void ContactProbe::widen(const State& x, double ahead) {
  ContactRequest request = following({}, near_, flat_);
  request.ahead = ahead;
  const ContactSet& c = gaps_.contacts;
  evaluate(x, request);
  wide_.insert(wide_.end(), c.features.noted.begin(), c.features.noted.end());
  if (const std::span<const ContactKey> unknown = noted_.read(c, all_); !unknown.empty()) {
    evaluate(x, following(unknown, near_, flat_));
    noted_.learn(c);
  }
}

ContactKey ContactProbe::lookAround(const State& x, double within, ContactKey key) {
  ContactRequest request;
  request.gTol = within;
  evaluate(x, request);
  ContactKey found = kNoContact;  // the noted key is the least of the contacts of its two bodies
  for (const ContactKey other : gaps_.contacts.key)
    if (other >= key && other < found) found = other;
  return found.value >> 40 == key.value >> 40 ? found : kNoContact;
}

bool ContactProbe::settle(const State& x) {
  std::sort(wide_.begin(), wide_.end());
  wide_.erase(std::unique(wide_.begin(), wide_.end()), wide_.end());
  if (ordered_ && wide_ == all_) return look(x);
  all_ = wide_;
  evaluate(x, following(all_, near_, flat_));
  order_ = gaps_.contacts.candidateKey, ordered_ = true;
  std::vector<ContactKey>& found = wide_;
  found = order_;
  std::sort(found.begin(), found.end());
  if (found != all_) return false;
  finish(x);
  return true;
}

void ContactProbe::finish(const State& x) {
  gaps_.evaluateGammas(x.u);
  announcements_.switching(kinematics_, switching_);
}

bool ContactProbe::look(const State& x) {
  evaluate(x, following(all_, near_, flat_));
  if (gaps_.contacts.candidateKey != order_) return false;
  finish(x);
  return true;
}

bool ContactProbe::lookAt(const QuinticPath& path, double theta, State& x, int i) {
  const ContactKey wanted = gaps_.key(i);
  ContactRequest request = following({&wanted, 1}, near_, flat_);
  request.alone = true;
  ++looks.gaps;
  if (!one_.look(path, theta, x, request)) {
    // The element of the contact cannot tell on which frames it depends.
    path.at(theta, x);
    kinematics_.evaluate(*parts_->topology, x.t, view(std::as_const(x.q)), view(std::as_const(x.u)),
                         view(std::as_const(x.memory)), parts_->subset);
    one_.report(*parts_, kinematics_, request);
  }
  looks.searched += one_.searched();
  return one_.giveTo(gaps_, i, x.u);
}

ContactKey ContactProbe::unfollowed() const {
  const std::vector<ContactKey>& now = gaps_.contacts.candidateKey;
  for (const ContactKey key : now)
    if (!std::binary_search(all_.begin(), all_.end(), key)) return key;
  for (const ContactKey key : all_)
    if (std::find(now.begin(), now.end(), key) == now.end()) return key;
  return now.empty() ? kNoContact
                     : now.front();  // contacts came in another order than at the start
}

}  // namespace dynamy
