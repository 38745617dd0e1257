#include <algorithm>
#include <dynamy/located/switching/borne_by_joints.hpp>
#include <dynamy/located/switching/event_contacts.hpp>

namespace dynamy {
namespace {

constexpr double kTouch = 1e-10;  ///< gaps up to this part of L take part in an impact
constexpr double kDeep = 10.0;    ///< overlaps of features touch up to this multiple of tol L

}  // namespace

bool EventContacts::find(ContactProbe& probe, const std::vector<Held>& held, ContactKey left,
                         const OngoingEvent& at) {
  left_ = left;
  held_.clear();
  heldKeys(held, held_);
  if (!probe.gather(at.p.x, held_)) return false;
  const ContactGaps& gaps = probe.gaps();
  const double length = at.norm.length();
  taking_.clear();
  for (int i = 0; i < gaps.size(); ++i)
    if (!gaps.law(i).unilateral() || touches(gaps, i, at) ||
        (findHeld(held, gaps.key(i)) != nullptr && !leaves(gaps, i, length)))
      taking_.push_back(i);
  if (probe.gaps().comeAndGo()) leaveOneOfEach(gaps, held, length);
  keys_.clear();
  for (const int i : taking_) keys_.push_back(gaps.key(i));
  overlap_ = std::any_of(taking_.begin(), taking_.end(), [&](int i) {
    return gaps.law(i).unilateral() && gaps.gap(i) < -kTouch * length;
  });
  std::sort(keys_.begin(), keys_.end());
  return true;
}

bool EventContacts::leaves(const ContactGaps& gaps, int i, double length) const {
  return gaps.comesAndGoes(i) && (gaps.key(i) == left_ || gaps.presence(i) <= kGone * length);
}

bool EventContacts::touches(const ContactGaps& gaps, int i, const OngoingEvent& at) const {
  const double gap = gaps.gap(i), deep = kDeep * at.norm.tolerance(), length = at.norm.length();
  if (!gaps.law(i).unilateral() || gap > kTouch * length) return false;
  const bool closes = gaps.key(i) == at.closes && gap >= -kTouch * length;
  if (gaps.gamma(i) > at.restSpeed() && !closes && !at.starts) return false;
  // Features with a deeper overlap are on the far side of a body.
  return !gaps.comesAndGoes(i) || (!leaves(gaps, i, length) && gap >= -deep * length);
}

void EventContacts::leaveOneOfEach(const ContactGaps& gaps, const std::vector<Held>& held,
                                   double length) {
  // Corners on corners and flush faces have many pairs of features at one place. Only one of them
  // counts, preferably one that is held.
  alike_.clear();
  const auto isHeld = [&](int i) { return findHeld(held, gaps.key(i)) != nullptr; };
  std::stable_sort(taking_.begin(), taking_.end(),
                   [&](int a, int b) { return isHeld(a) && !isHeld(b); });
  for (const int i : taking_) {
    const bool again =
        gaps.comesAndGoes(i) && std::any_of(alike_.begin(), alike_.end(), [&](int j) {
          return gaps.comesAndGoes(j) && gaps.coincide(i, j, kSame * length);
        });
    if (!again) alike_.push_back(i);
  }
  taking_ = alike_;
}

void EventContacts::leaveToJoints(OngoingEvent& at) {
  borneByJoints(at.s.slot(0), borne_);
  if (borne_.empty()) return;
  std::erase_if(keys_, [&](ContactKey key) {
    return std::find(borne_.begin(), borne_.end(), key) != borne_.end();
  });
  at.evaluate(at.p.x, keys_, 0, true);
}

}  // namespace dynamy
