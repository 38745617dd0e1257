#include <fmt/format.h>

#include <algorithm>
#include <dynamy/contact/contact_name.hpp>
#include <dynamy/located/switching/contact_probe.hpp>

namespace dynamy {

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
}

bool ContactProbe::gather(const State& x, std::span<const ContactKey> held) {
  if (!comesAndGoes()) return look(x);
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

std::string ContactProbe::unfollowed() const {
  const std::vector<ContactKey>& now = contacts_.candidateKey;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (!std::binary_search(all_.begin(), all_.end(), now[i]))
      return why(now[i], "appears with a gap of " + fmt::format("{:.3g}", contacts_.g[i]) + " m");
  for (const ContactKey key : all_)
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
