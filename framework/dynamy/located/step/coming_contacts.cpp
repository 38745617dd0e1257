#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <dynamy/located/step/coming_contacts.hpp>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/switching/borne_by_joints.hpp>

namespace dynamy {
namespace {

/// Part of a path before a contact that is noted first at sample j of the path.
double clearBefore(int j) {
  return std::max((static_cast<double>(j) - MeetingConstants::halfWay) / SwitchSearch::kSamples,
                  MeetingConstants::notAtAll);
}

}  // namespace

bool ComingContacts::begin(LocatedStep& step, double time) {
  ContactProbe& probe = parts_.probe;
  const PhaseMotion& motion = parts_.motion;
  narrow(near_.ahead(step.from, time, MeetingConstants::touching * parts_.norm.length()));
  if (!probe.gather(step.from.x, motion.keys())) return false;
  startOverlap_ = probe.gathers() ? std::max(0.0, probe.noted().overlap()) : 0.0;
  inside_ = probe.gathers() ? probe.noted().deepest(parts_.passingOverlap()) : kNoContact;
  return parts_.search.begin(probe, motion.phase, step.from.x) && leaveToJoints(step);
}

bool ComingContacts::hasJoint() const {
  const std::vector<Held>& held = parts_.motion.phase.held;
  const ContactGaps& gaps = parts_.probe.gaps();
  return std::any_of(held.begin(), held.end(), [&](const Held& h) {
    const int i = gaps.find(h.key);
    return i >= 0 && !gaps.law(i).unilateral() && gaps.law(i).rowKind(0) == RowKind::joint;
  });
}

bool ComingContacts::leaveToJoints(LocatedStep& step) {
  ContactProbe& probe = parts_.probe;
  const ContactGaps& gaps = probe.gaps();
  const PhaseMotion& motion = parts_.motion;
  borne_.clear();
  if (!hasJoint()) return true;
  const double drifted =
      std::max(MeetingConstants::drifted * parts_.norm.length(), parts_.leftOverlap());
  asked_ = motion.keys();
  for (int i = 0; i < gaps.size(); ++i)
    if (gaps.law(i).unilateral() && std::abs(gaps.gap(i)) <= drifted &&
        findHeld(motion.phase.held, gaps.key(i)) == nullptr)
      asked_.push_back(gaps.key(i));
  if (asked_.size() == motion.keys().size()) return true;
  std::sort(asked_.begin(), asked_.end());
  step.s.evaluate(step.from.x, motion.phase.request.holding(asked_, 1, true));
  borneByJoints(step.s.slot(1), borne_);
  if (borne_.empty()) return true;
  parts_.search.borne(borne_, parts_.passingOverlap());
  return parts_.search.watch(probe, motion.phase, step.from.x);
}

/// Closed contacts remain, whatever their gaps.
void ComingContacts::narrow(const NearContacts* near) {
  const std::vector<ContactKey>& held = parts_.motion.keys();
  const bool all = near == nullptr || !std::all_of(held.begin(), held.end(),
                                                   [&](ContactKey key) { return near->has(key); });
  parts_.probe.narrow(all ? nullptr : near);
}

bool ComingContacts::widen(const State& from, const QuinticPath& path) {
  ContactProbe& probe = parts_.probe;
  clear_ = 1.0;
  if (!near_.cover(path)) {
    narrow(near_.along());
    if (!probe.gather(from, parts_.motion.keys()) ||
        !parts_.search.watch(probe, parts_.motion.phase, from)) {
      clear_ = MeetingConstants::notAtAll;
      return false;
    }
  }
  return !probe.gathers() || widenAlong(from, path);
}

bool ComingContacts::widenAlong(const State& from, const QuinticPath& path) {
  ContactProbe& probe = parts_.probe;
  const double deep = startOverlap_ + parts_.passingOverlap();
  at_.memory = from.memory;
  // Each sample looks ahead half of the way to the next one.
  const double ahead = MeetingConstants::halfWay * path.length() / SwitchSearch::kSamples;
  constexpr int n = SwitchSearch::kSamples;
  const auto depth = [&](double theta) {
    path.at(theta, at_);
    probe.widen(at_, ahead);
    if (theta > 0.0 && probe.noted().overlap() > deep) passing_ = std::min(passing_, theta);
    return probe.noted().overlap();
  };
  std::array<double, n + 1> depths{};
  int fresh = -1;
  for (int j = 0; j <= n; ++j) {
    depths[static_cast<std::size_t>(j)] = depth(static_cast<double>(j) / n);
    if (fresh < 0 && probe.noted().fresh()) fresh = j;
    if (probe.noted().unreported() == kNoContact && !probe.noted().unseen()) continue;
    clear_ = clearBefore(j);
    return false;
  }
  // Bodies may come near between two samples and part again: find the nearest place.
  for (std::size_t j = 0; j < n; ++j) {
    // Bodies that touch at the start part from there on.
    if (j == 0 && !(depths[0] < -parts_.leftOverlap())) continue;
    const std::size_t before = j > 0 ? j - 1 : 0;
    const double here = depths[j], after = depths[j + 1];
    // Before the start nothing is known: the change that follows tells of the one before.
    const double left = j > 0 ? here - depths[before] : after - depths[2];
    const double fall = std::max(left, here - after);
    if (here < depths[before] || here <= after || here > deep || here + fall < 0.0) continue;
    std::uintmax_t looks = MeetingConstants::looks;
    boost::math::tools::brent_find_minima(
        [&](double theta) { return -depth(theta); }, static_cast<double>(before) / n,
        static_cast<double>(j + 1) / n, MeetingConstants::nearestBits, looks);
  }
  if (probe.settle(from) && parts_.search.watch(probe, parts_.motion.phase, from)) return true;
  clear_ = clearBefore(std::max(fresh, 0));  // a contact on the path is not reported at its start
  return false;
}

bool ComingContacts::sinks(const State& x) {
  ContactProbe& probe = parts_.probe;
  if (!probe.gaps().comeAndGo()) return false;
  probe.widen(x, 0.0);
  return probe.noted().overlap() > startOverlap_ + parts_.leftOverlap();
}

ContactKey ComingContacts::sunk(double h) const {
  const NotedContacts& noted = parts_.probe.noted();
  const double depth = startOverlap_ + parts_.leftOverlap();
  const double T = parts_.norm.time();
  // A gap that begins far below zero is no switch until it has been positive.
  const ContactKey deepest = noted.deepest(depth);
  if (deepest != kNoContact && deepest == inside_ && h < MeetingConstants::inside * T)
    return deepest;
  if (h < MeetingConstants::creeping * T) return deepest;
  return h < MeetingConstants::atMeeting * T ? noted.jumping(depth) : kNoContact;
}

bool ComingContacts::closesOpen(const State& x) {
  ContactProbe& probe = parts_.probe;
  if (!probe.look(x)) return true;
  const ContactGaps& gaps = probe.gaps();
  // A contact that has just opened, or that grazes, has a gap of rounding, as in the search.
  const double touching = -TrialConstants::gapNoise * parts_.norm.length();
  for (int i = 0; i < gaps.size(); ++i)
    if (gaps.law(i).unilateral() && gaps.gap(i) < touching && !gaps.comesAndGoes(i) &&
        findHeld(parts_.motion.phase.held, gaps.key(i)) == nullptr &&
        std::find(borne_.begin(), borne_.end(), gaps.key(i)) == borne_.end())
      return true;
  return sinks(x);
}

}  // namespace dynamy
