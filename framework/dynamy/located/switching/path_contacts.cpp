#include <dynamy/located/switching/path_contacts.hpp>

namespace dynamy {
namespace {

/// Factors on noted speeds: of a prediction, and of a path that is known at three places.
constexpr double kAhead = 1.5, kBetweenPlaces = 1.2;

}  // namespace

void PathContacts::prepare(const SystemParts& parts) {
  parts_ = &parts, narrowed_ = false;
  start_.resize(*parts.topology), later_.resize(*parts.topology);
}

const Kinematics& PathContacts::at(const State& x, Kinematics& k) const {
  k.evaluate(*parts_->topology, x.t, view(x.q), view(x.u), view(x.memory), parts_->subset);
  return k;
}

const NearContacts* PathContacts::find() {
  near_.clear();
  parts_->forContacts([&](std::size_t i) {
    const int element = static_cast<int>(i);
    if (parts_->contacts[i]->nearOnPath(start_, reach_, element, near_))
      narrowed_ = true;
    else
      near_.addAll(element);
  });
  near_.order();
  return narrowed_ ? &near_ : nullptr;
}

const NearContacts* PathContacts::ahead(const PhasePoint& p, double time, double margin) {
  margin_ = margin, narrowed_ = false;
  at_ = p.x;
  at_.u += time * p.a;
  if (!at_.q.allFinite() || !at_.u.allFinite()) return nullptr;
  reach_.begin(at(p.x, start_), time, margin);
  reach_.pass(at(at_, later_));
  reach_.widen(kAhead);
  return find();
}

bool PathContacts::cover(const QuinticPath& path) {
  if (!narrowed_) return true;
  path.at(0.5, at_);
  passed_.begin(at(at_, later_), path.length(), margin_);
  path.at(1.0, at_);
  passed_.pass(at(at_, later_));
  passed_.widen(kBetweenPlaces);
  return at_.q.allFinite() && at_.u.allFinite() && passed_.within(reach_);
}

const NearContacts* PathContacts::along(const State& from, const QuinticPath& path) {
  narrowed_ = false;
  reach_ = passed_;
  reach_.pass(at(from, start_));
  reach_.widen(kAhead / kBetweenPlaces);
  path.at(1.0, at_);
  return at_.q.allFinite() && at_.u.allFinite() ? find() : nullptr;
}

}  // namespace dynamy
