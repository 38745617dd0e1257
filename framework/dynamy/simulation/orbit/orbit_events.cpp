#include <fmt/format.h>

#include <algorithm>
#include <dynamy/simulation/orbit/orbit_events.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <tuple>

namespace dynamy {
namespace {

constexpr double kSameInstant = 1e-6;  ///< of the period: two events in one

bool sameStatuses(const std::vector<HeldStatus>& a, const std::vector<HeldStatus>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.key == y.key && x.status == y.status;
  });
}

bool same(const OrbitEvent& a, const OrbitEvent& b) {
  return a.impacts == b.impacts && a.switches == b.switches && sameStatuses(a.statuses, b.statuses);
}

Status statusIn(const std::vector<HeldStatus>& all, ContactKey key) {
  for (const HeldStatus& s : all)
    if (s.key == key) return s.status;
  return Status::open;
}

/// A contact whose status differs.
ContactKey differing(const std::vector<HeldStatus>& a, const std::vector<HeldStatus>& b) {
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const HeldStatus& s : *one)
      if (statusIn(*other, s.key) != s.status) return s.key;
  return kNoContact;
}

/// The contact that switches in an event, as far as that shows.
ContactKey contactOf(const std::vector<OrbitEvent>& events, std::size_t i) {
  if (!events[i].impacts.empty()) return events[i].impacts.front();
  const std::vector<HeldStatus> before = i > 0 ? events[i - 1].statuses : std::vector<HeldStatus>();
  const ContactKey changed = differing(before, events[i].statuses);
  if (changed != kNoContact || events[i].statuses.empty()) return changed;
  return events[i].statuses.front().key;
}

/// The contact is closed before and after this event: it begins to stick or to slip.
bool slides(const std::vector<OrbitEvent>& events, std::size_t i, ContactKey key) {
  if (!events[i].impacts.empty()) return false;
  const std::vector<HeldStatus> none;
  const Status before = statusIn(i > 0 ? events[i - 1].statuses : none, key);
  const Status after = statusIn(events[i].statuses, key);
  const auto closed = [](Status s) { return s == Status::stick || s == Status::slip; };
  return closed(after) && (i == 0 || closed(before));
}

long countOf(const std::vector<OrbitEvent>& events, ContactKey key) {
  long out = 0;
  for (const OrbitEvent& e : events) out += std::count(e.impacts.begin(), e.impacts.end(), key);
  return out;
}

}  // namespace

std::vector<OrbitEvent> eventsOf(const MotionSequence& sequence) {
  std::vector<OrbitEvent> out;
  std::vector<HeldStatus> held;
  for (const MotionSequence::Step& s : sequence.steps) {
    if (s.step.end != PlannedStep::End::ofMotion) continue;
    if (s.impacts.empty() && s.switches == 0 && sameStatuses(s.statuses, held)) continue;
    out.push_back({s.t, s.switches, s.statuses, s.impacts});
    held = s.statuses;
  }
  return out;
}

bool sameEvents(const std::vector<OrbitEvent>& a, const std::vector<OrbitEvent>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

EventChange changeOf(const Model& model, const std::vector<OrbitEvent>& a,
                     const std::vector<OrbitEvent>& b) {
  std::size_t i = 0;
  while (i < std::min(a.size(), b.size()) && same(a[i], b[i])) ++i;
  double t = i < b.size() ? b[i].t : i < a.size() ? a[i].t : 0.0;
  const auto text = [&](ContactKey key, const std::string& what) {
    return fmt::format("{} {} {:.9g} s after the section", contactText(model, key), what, t);
  };
  // Two contacts that switch at one instant: which of them comes first decides what follows.
  for (std::size_t k = i > 0 ? i - 1 : 0; k + 1 < a.size() && k <= i; ++k) {
    const ContactKey one = contactOf(a, k), other = contactOf(a, k + 1);
    if (one == other || !(a[k + 1].t - a[k].t < kSameInstant * a.back().t)) continue;
    return {"coincidence",
            fmt::format("{} and {} switch at the same instant, {:.9g} s after the section: which "
                        "of them comes first decides what follows",
                        contactText(model, one), contactText(model, other), a[k].t)};
  }
  // A contact with more impacts in one of them, and its first impact from the difference on.
  for (const auto& [more, less, what] : {std::tuple(&b, &a, "more"), std::tuple(&a, &b, "less")})
    for (std::size_t k = i; k < more->size(); ++k)
      for (const ContactKey& key : (*more)[k].impacts)
        if (countOf(*more, key) > countOf(*less, key)) {
          t = (*more)[k].t;
          const bool only = countOf(*less, key) == 0;
          const std::string once = more == &b ? "is touched" : "is no longer touched";
          return {"grazing", text(key, only ? once : fmt::format("has one impact {},", what))};
        }
  // A switch more or less of a contact that keeps its status: the direction of its slip.
  if (a.size() != b.size()) {
    const auto& longer = a.size() > b.size() ? a : b;
    const ContactKey key = i < longer.size() ? contactOf(longer, i) : kNoContact;
    t = i < longer.size() ? longer[i].t : t;
    if (key != kNoContact)
      return {slides(longer, i, key) ? "sliding" : "switch",
              text(key, a.size() > b.size() ? "switches once less," : "switches once more,")};
  }
  const std::vector<HeldStatus> none;
  const auto& heldA = i < a.size() ? a[i].statuses : none;
  const auto& heldB = i < b.size() ? b[i].statuses : none;
  const ContactKey other = differing(heldA, heldB);
  if (other != kNoContact)
    return {"switch",
            text(other, fmt::format("is {} in place of {}", statusText(statusIn(heldB, other)),
                                    statusText(statusIn(heldA, other))))};
  return {"switch", fmt::format("the motion switches otherwise {:.9g} s after the section", t)};
}

}  // namespace dynamy
