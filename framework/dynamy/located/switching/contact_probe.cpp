#include <fmt/format.h>

#include <algorithm>
#include <dynamy/contact/contact_name.hpp>
#include <dynamy/located/switching/contact_probe.hpp>

namespace dynamy {
namespace {

/// Used as g_tol where contacts are requested by key: elements may leave out all others.
constexpr double kOnly = -1.0;

}  // namespace

void ContactProbe::evaluate(const State& x, const ContactRequest& request) {
  kinematics_.evaluate(*parts_->topology, x.t, view(x.q), view(x.u), view(x.memory));
  contacts_.clear();
  ContactSink sink(contacts_, request);
  reportContacts(*parts_, kinematics_, sink);
}

void ContactProbe::prepare(const MechanicalSystem& s, const State& x) {
  parts_ = &s.parts();
  announcements_.read(*parts_);
  kinematics_.resize(*parts_->topology);
  list(x);
}

void ContactProbe::list(const State& x) {
  ContactRequest request;
  request.refresh = request.follow = true;
  evaluate(x, request);
  order_ = contacts_.candidateKey, all_ = order_;
  std::sort(all_.begin(), all_.end());
  fixed_ = all_;
  notes_ = !contacts_.noted.empty();
}

bool ContactProbe::gather(const State& x, std::span<const ContactKey> held) {
  if (!gathers()) return look(x);
  wide_ = fixed_;
  wide_.insert(wide_.end(), held.begin(), held.end());
  widen(x, 0.0);
  return settle(x);
}

void ContactProbe::widen(const State& x, double ahead) {
  ContactRequest request;
  request.refresh = request.follow = true, request.ahead = ahead;
  evaluate(x, request);
  wide_.insert(wide_.end(), contacts_.noted.begin(), contacts_.noted.end());
  overlap_ = contacts_.overlap;
  noted_ = contacts_.noted;
  notesFresh_ = std::any_of(noted_.begin(), noted_.end(), [&](ContactKey key) {
    return !std::binary_search(all_.begin(), all_.end(), key);
  });
  learn(x);
}

/// Finds which of the noted contacts are reported when requested by key, and which are not.
void ContactProbe::learn(const State& x) {
  const auto has = [](const std::vector<ContactKey>& keys, ContactKey key) {
    return std::binary_search(keys.begin(), keys.end(), key);
  };
  fresh_.clear();
  for (const ContactKey key : noted_)
    if (!has(followed_, key) && !has(neverFollowed_, key)) fresh_.push_back(key);
  if (!fresh_.empty()) {
    std::sort(fresh_.begin(), fresh_.end());
    ContactRequest request;
    request.refresh = request.follow = true, request.frozen = fresh_;
    evaluate(x, request);
    for (const ContactKey key : fresh_) {
      std::vector<ContactKey>& known =
          std::find(contacts_.key.begin(), contacts_.key.end(), key) != contacts_.key.end()
              ? followed_
              : neverFollowed_;
      known.insert(std::upper_bound(known.begin(), known.end(), key), key);
    }
  }
  const auto first = std::find_if(noted_.begin(), noted_.end(),
                                  [&](ContactKey key) { return has(neverFollowed_, key); });
  meets_ = first == noted_.end() ? kNone : *first;
}

ContactKey ContactProbe::lookAround(const State& x, double within, ContactKey key) {
  ContactRequest request;
  request.gTol = within;
  evaluate(x, request);
  ContactKey found = kNone;  // the noted key is the least of the contacts of its two bodies
  for (const ContactKey other : contacts_.key)
    if (other >= key && other < found) found = other;
  return found.value >> 40 == key.value >> 40 ? found : kNone;
}

bool ContactProbe::settle(const State& x) {
  std::sort(wide_.begin(), wide_.end());
  wide_.erase(std::unique(wide_.begin(), wide_.end()), wide_.end());
  if (wide_ == all_) return look(x);
  all_ = wide_;
  ContactRequest request;
  request.refresh = request.follow = true, request.frozen = all_;
  evaluate(x, request);
  order_ = contacts_.candidateKey;
  std::vector<ContactKey>& found = wide_;
  found = order_;
  std::sort(found.begin(), found.end());
  return found == all_ && look(x);
}

bool ContactProbe::coincide(int i, int j, double distance) const {
  constexpr double kTurned = 1e-5;
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const ContactSet& c = contacts_;
  if ((c.point[a] - c.point[b]).squaredNorm() > distance * distance ||
      (c.normal[a] - c.normal[b]).squaredNorm() > kTurned * kTurned)
    return false;
  const int segments = c.segment0[a + 1] - c.segment0[a];
  if (c.segment0[b + 1] - c.segment0[b] != segments) return false;
  for (int k = 0; k < segments; ++k)
    if (c.segment[static_cast<std::size_t>(c.segment0[a] + k)].block !=
        c.segment[static_cast<std::size_t>(c.segment0[b] + k)].block)
      return false;
  return true;
}

bool ContactProbe::look(const State& x) {
  ContactRequest request;
  request.refresh = request.follow = true, request.frozen = all_;
  evaluate(x, request);
  if (contacts_.candidateKey != order_) return false;
  gamma_.resize(contacts_.rows());
  contacts_.gamma(view(x.u), view(gamma_));
  announcements_.switching(kinematics_, switching_);
  return true;
}

bool ContactProbe::lookAt(const State& x, int i) {
  const ContactKey wanted = key(i);
  kinematics_.evaluate(*parts_->topology, x.t, view(x.q), view(x.u), view(x.memory));
  one_.clear();
  ContactRequest request;
  request.refresh = request.follow = true, request.frozen = {&wanted, 1}, request.gTol = kOnly;
  ContactSink sink(one_, request);
  reportContacts(*parts_, kinematics_, sink);
  const auto at = std::find(one_.key.begin(), one_.key.end(), wanted);
  if (at == one_.key.end()) return false;
  const int found = static_cast<int>(at - one_.key.begin()), dim = contacts_.dim(i);
  if (one_.dim(found) != dim) return false;
  gammaOne_.resize(one_.rows());
  one_.gamma(view(x.u), view(gammaOne_));
  const int from = one_.row0[static_cast<std::size_t>(found)];
  gamma_.segment(row0(i), dim) = gammaOne_.segment(from, dim);
  std::copy_n(one_.position.begin() + from, dim, contacts_.position.begin() + row0(i));
  contacts_.presence[static_cast<std::size_t>(i)] = one_.presence[static_cast<std::size_t>(found)];
  return true;
}

ContactKey ContactProbe::unfollowed() const {
  const std::vector<ContactKey>& now = contacts_.candidateKey;
  for (const ContactKey key : now)
    if (!std::binary_search(all_.begin(), all_.end(), key)) return key;
  for (const ContactKey key : all_)
    if (std::find(now.begin(), now.end(), key) == now.end()) return key;
  return now.empty() ? kNone : now.front();  // contacts came in another order than at the start
}

std::string ContactProbe::why(ContactKey key) const {
  if (key == kNone) return std::string(kUnfollowed);
  const auto number = static_cast<std::size_t>(key.value >> 40);
  const NonSmoothElement& e = *parts_->contacts[number];
  // Contacts of shapes have no type of their own.
  const std::string cause =
      e.type().empty() ? "which features of two bodies could touch (corners over faces, rims over "
                         "edges, faces of "
                         "a mesh that are nearest to a ball) is another list after every motion"
                       : "<" + e.type() + "> reports it at some positions only";
  return "contact " + contactName(e, number, contactNumber(key)) + " comes and goes: " + cause +
         ", and its gap cannot be followed; give a step instead of the tolerance";
}

int ContactProbe::find(ContactKey key) const {
  const auto at = std::find(contacts_.key.begin(), contacts_.key.end(), key);
  return at == contacts_.key.end() ? -1 : static_cast<int>(at - contacts_.key.begin());
}

}  // namespace dynamy
