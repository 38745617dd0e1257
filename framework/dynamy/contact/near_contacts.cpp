#include <algorithm>
#include <dynamy/contact/near_contacts.hpp>

namespace dynamy {

void PathReach::begin(const Kinematics& k, double time, double margin) {
  time_ = time, margin_ = margin;
  speeds_.assign(static_cast<std::size_t>(k.frames()), {});
  pass(k);
}

void PathReach::pass(const Kinematics& k) {
  for (std::size_t i = 0; i < speeds_.size(); ++i) {
    const Frame& f = k.frame({static_cast<int>(i)});
    if (f.absent) continue;
    speeds_[i].v = std::max(speeds_[i].v, f.v_S_I.norm());
    speeds_[i].Omega = std::max(speeds_[i].Omega, f.Omega_I.norm());
  }
}

void PathReach::widen(double factor) {
  for (Speeds& s : speeds_) s.v *= factor, s.Omega *= factor;
}

bool PathReach::within(const PathReach& other) const {
  if (!(time_ <= other.time_) || speeds_.size() != other.speeds_.size()) return false;
  for (std::size_t i = 0; i < speeds_.size(); ++i)
    if (!(speeds_[i].v <= other.speeds_[i].v && speeds_[i].Omega <= other.speeds_[i].Omega))
      return false;
  return true;
}

void NearContacts::order() {
  std::sort(ranges_.begin(), ranges_.end(),
            [](const Range& a, const Range& b) { return a.first < b.first; });
}

bool NearContacts::has(ContactKey key) const {
  const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), key,
                                      [](ContactKey k, const Range& r) { return k < r.first; });
  return after != ranges_.begin() && key < std::prev(after)->end;
}

void NearContacts::select(std::span<const ContactKey> keys, std::vector<ContactKey>& out) const {
  out.clear();
  auto key = keys.begin();
  for (const Range& r : ranges_) {
    key = std::lower_bound(key, keys.end(), r.first);
    for (; key != keys.end() && *key < r.end; ++key) out.push_back(*key);
  }
}

std::vector<NearContacts::Range>::const_iterator NearContacts::startOf(int element) const {
  return std::lower_bound(ranges_.begin(), ranges_.end(), contactKey(element, 0),
                          [](const Range& r, ContactKey k) { return r.first < k; });
}

}  // namespace dynamy
