#include <dynamy/located/switching/path_contacts.hpp>

namespace dynamy {
namespace {

/// Places at which a path is known, besides its start.
constexpr int kPlaces = 4;

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
  at(p.x, start_), at(at_, later_);
  reach_.expect(start_, later_, time, margin);
  return find();
}

bool PathContacts::cover(const QuinticPath& path) {
  if (!narrowed_) return true;
  passed_.begin(start_, margin_);
  for (int i = 1; i <= kPlaces; ++i) {
    path.at(static_cast<double>(i) / kPlaces, at_);
    finite_ = at_.q.allFinite() && at_.u.allFinite();
    if (!finite_) return false;
    passed_.pass(at(at_, later_), path.length() / kPlaces);
  }
  passed_.finish();
  return passed_.within(reach_);
}

const NearContacts* PathContacts::along() {
  narrowed_ = false, reach_ = passed_;
  return finite_ ? find() : nullptr;
}

}  // namespace dynamy
