#include <algorithm>
#include <cmath>
#include <dynamy/located/governed/stepped_islands.hpp>
#include <dynamy/located/islands/divided_state.hpp>
#include <dynamy/located/islands/island_clock.hpp>

namespace dynamy {
namespace {

constexpr int kSlots = 2;  ///< of a system whose switches are located
/// Parts of a step, for the boxes of its path. Two at least: velocities at its ends do not tell of a
/// swing to and fro within it.
constexpr int kFewestParts = 2, kParts = 8;
/// With the velocities at the ends, shapes move in a part by no more than this part of their bounds,
/// and turn by no more than this [rad], unless there are kParts.
constexpr double kOnePart = 0.1;

}  // namespace

IslandClock::IslandClock(const MechanicalSystem& s, const LocatedSettings& settings,
                         const ClockState& x)
    : systems_(x.systems), whole_(*s.parts().topology), motion_(settings) {
  std::vector<char> without(whole_.systems().size(), 1);
  for (const int i : viewOf(whole_, systems_)) without[static_cast<std::size_t>(i)] = 0;
  subset_.assign(whole_, std::move(without), s.parts().forces, s.parts().contacts);
  topology_ = std::make_unique<Topology>(topologyOf(subset_, whole_));
  SystemParts parts = s.parts();
  parts.topology = topology_.get(), parts.subset = &subset_;
  view_ = std::make_unique<MechanicalSystem>(parts, kSlots);
  view_->gTol(s.gTol());
  now_.to.t = x.t, now_.to.q = x.q, now_.to.u = x.u, now_.to.scheme = x.scheme;
  now_.from = now_.to, now_.end = x.end;
  now_.before = now_.after = x.statuses;
}

void IslandClock::orderContacts() {
  std::vector<ContactKey> keys;
  for (const IslandDivision::Joined& contact : joined(true)) keys.push_back(contact.key);
  if (keys.size() > 1) now_.to.scheme = now_.from.scheme = inOrder(now_.to.scheme, keys);
}

std::vector<IslandDivision::Joined> IslandClock::joined(bool atEnd) {
  auto out = IslandDivision::joinedAt(*view_, atEnd ? now_.to : now_.from);
  for (IslandDivision::Joined& contact : out)
    for (int& i : contact.systems) i = subset_.systems()[static_cast<std::size_t>(i)];
  return out;
}

ClockState IslandClock::state(bool atEnd) const {
  const State& x = atEnd ? now_.to : now_.from;
  return {systems_, x.t, now_.end, x.q, x.u, x.scheme, now_.statuses(x.t)};
}

void IslandClock::keep(ClockState& out) const {
  if (out.systems == systems_ && out.t == now_.from.t && out.end == now_.end &&
      out.scheme.size() == now_.from.scheme.size() && out.scheme == now_.from.scheme)
    return;
  out = state(false);
}

Refusal IslandClock::step(MechanicalSystem& s, InclusionSolver& solver, double end) {
  now_.from = now_.to, now_.end = end;
  now_.before = now_.after, booked = {}, now_.justSet = false;
  return advance(s, solver);
}

Refusal IslandClock::again(MechanicalSystem& s, InclusionSolver& solver, double end) {
  now_.to = now_.from, now_.end = end, now_.justSet = false;
  return advance(s, solver);
}

Refusal IslandClock::advance(MechanicalSystem& s, InclusionSolver& solver) {
  MechanicalSystem& view = *view_;
  view.limits = s.limits;
  now_.report = {}, counted = false, path_.clear();
  now_.energy = std::numeric_limits<double>::quiet_NaN();
  const long evaluations = view.evaluations();
  Refusal refusal;
  if (!motion_.load(view, now_.to))
    refusal = {Refusal::Kind::fault,
               "the checkpoint holds what this scheme does not leave in a state"};
  else
    refusal = motion_.locate(view, solver, now_.to, now_.end - now_.from.t, now_.report);
  s.count(view.evaluations() - evaluations);
  now_.turned = motion_.turned();
  if (refusal || now_.turned) {
    now_.to = now_.from, counted = true;
    return refusal;
  }
  now_.after.assign(now_.report.statuses.begin(), now_.report.statuses.end());
  return refusal;
}

std::vector<int> IslandClock::toStep() const {
  std::vector<int> out;
  const std::vector<char>& chosen = motion_.state().stepped.systems;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (chosen[k] != 0 && topology_->system(static_cast<int>(k)).nu > 0)
      out.push_back(subset_.systems()[k]);
  return out.empty() ? systems_ : out;
}

/// The state at t, into at_; `closed`: with held contacts closed. A step that ends with a slip has no
/// interpolation of its own: its accelerations are constant.
void IslandClock::within(double t, bool closed) {
  const double theta = (t - now_.from.t) / (now_.to.t - now_.from.t);
  if (!motion_.motion().interpolate(*view_, now_.from, now_.to, theta, at_, closed))
    SteppedIslands::linear(*view_, now_.from, now_.to, theta, at_);
}

void IslandClock::giveVelocities(const Eigen::VectorXd& own, Eigen::VectorXd& out) const {
  for (std::size_t k = 0; k < subset_.systems().size(); ++k) {
    const SystemHandle& h = whole_.system(subset_.systems()[k]);
    out.segment(h.u0, h.nu) = own.segment(subset_.own()->handles()[k].u0, h.nu);
  }
}

void IslandClock::place(MechanicalSystem& s, double t, State& out, bool closed) {
  const State* own = t >= now_.to.t ? &now_.to : &now_.from;
  if (t < now_.to.t && t > now_.from.t) {
    const long evaluations = view_->evaluations();
    within(t, closed);
    s.count(view_->evaluations() - evaluations);
    own = &at_;
  }
  for (std::size_t k = 0; k < subset_.systems().size(); ++k) {
    const SystemHandle &h = whole_.system(subset_.systems()[k]),
                       &from = subset_.own()->handles()[k];
    out.q.segment(h.q0, h.nq) = own->q.segment(from.q0, h.nq);
  }
  giveVelocities(own->u, out.u);
}

double IslandClock::gained(MechanicalSystem& s, double t) {
  const long evaluations = view_->evaluations();
  const auto energy = [&](const State& x) {
    const Evaluation& e = view_->evaluate(x, {.slot = 1, .held = HeldContacts{.alone = true}});
    return e.mass.kineticEnergy(view(x.u)) + view_->potentialEnergy(e.kinematics, x);
  };
  if (std::isnan(now_.energy)) now_.energy = energy(std::as_const(now_.from));
  within(t, false);
  const double out = energy(std::as_const(at_)) - now_.energy;
  s.count(view_->evaluations() - evaluations);
  return out;
}

bool IslandClock::contactsAt(const State& at, bool after, ContactInstant& out) {
  asked_.t = at.t;
  asked_.q.resize(topology_->nq()), asked_.u.resize(topology_->nu());
  for (std::size_t k = 0; k < subset_.systems().size(); ++k) {
    const SystemHandle &h = whole_.system(subset_.systems()[k]), &own = subset_.own()->handles()[k];
    asked_.q.segment(own.q0, h.nq) = at.q.segment(h.q0, h.nq);
    asked_.u.segment(own.u0, h.nu) = at.u.segment(h.u0, h.nu);
  }
  return motion_.motion().contactsAt(*view_, asked_, after, out);
}

void IslandClock::findPath(MechanicalSystem& s, std::span<const MovingShape> shapes) {
  shapes_.clear();
  for (const MovingShape& shape : shapes)
    if (std::binary_search(systems_.begin(), systems_.end(), shape.system))
      shapes_.push_back(shape);
  path_.clear();
  if (shapes_.empty()) return;
  Kinematics& k = kinematics_;
  const auto frames = [&](const State& x) {
    k.evaluate(*topology_, x.t, view(x.q), view(x.u), view(x.memory), &subset_);
  };
  const double h = now_.to.t - now_.from.t;
  frames(std::as_const(now_.to));
  double stretch = PathBoxes::stretch(shapes_, k, h);
  frames(std::as_const(now_.from));
  stretch = std::max(stretch, PathBoxes::stretch(shapes_, k, h));
  const int parts = stretch < kOnePart * kParts
                        ? std::max(kFewestParts, 1 + static_cast<int>(stretch / kOnePart))
                        : kParts;
  path_.begin(shapes_, k);
  const long evaluations = view_->evaluations();
  for (int i = 1; i <= parts && h > 0.0; ++i) {
    // At the end of the step these are the velocities before an impact there.
    within(i < parts ? now_.from.t + h * i / parts : now_.to.t, false);
    at_.t = i < parts ? at_.t : now_.to.t;
    frames(std::as_const(at_));
    path_.pass(k);
  }
  s.count(view_->evaluations() - evaluations);
}

}  // namespace dynamy
