#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/located/switching/borne_by_joints.hpp>
#include <dynamy/located/switching/switch_event.hpp>
#include <dynamy/stages/projection.hpp>

namespace dynamy {
namespace {

constexpr double kTouch = 1e-10;  ///< gaps up to this part of L take part in an impact
constexpr double kRest = 1e-10;   ///< speeds below this part of U count as rest
constexpr double kGone = 1e-12;   ///< features that lie over one another by less of L leave
constexpr double kDeep = 10.0;    ///< overlaps of features touch up to this multiple of tol L
constexpr int kMostDecisions = 12;
constexpr int kMostOffered = 16;  ///< most rows of a contact, also of laws that are refused

bool has(const std::vector<ContactKey>& keys, ContactKey key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

void SwitchEvent::prepare(const MechanicalSystem&, const ErrorNorm& norm) { norm_ = &norm; }

bool SwitchEvent::takePart(ContactProbe& probe, const FrozenPhase& phase, const State& x) {
  closing_.clear();
  phase.keys(closing_);
  if (!probe.gather(x, closing_)) return false;
  taking_.clear();
  for (int i = 0; i < probe.size(); ++i)
    if (!probe.law(i).unilateral() || touches(probe, i) ||
        (phase.find(probe.key(i)) != nullptr && !leaves(probe, i)))
      taking_.push_back(i);
  if (probe.comesAndGoes()) leaveOneOfEach(probe, phase);
  keys_.clear();
  for (const int i : taking_) keys_.push_back(probe.key(i));
  std::sort(keys_.begin(), keys_.end());
  return true;
}

bool SwitchEvent::leaves(const ContactProbe& probe, int i) const {
  return probe.comesAndGoes(i) &&
         (probe.key(i) == left_ || probe.presence(i) <= kGone * norm_->length());
}

bool SwitchEvent::touches(const ContactProbe& probe, int i) const {
  const double gap = probe.gap(i), deep = kDeep * norm_->tolerance();
  if (!probe.law(i).unilateral() || gap > kTouch * norm_->length() ||
      probe.gamma(i) > kRest * norm_->speed())
    return false;
  // Features with a deeper overlap are on the far side of a body.
  return !probe.comesAndGoes(i) || (!leaves(probe, i) && gap >= -deep * norm_->length());
}

void SwitchEvent::leaveOneOfEach(const ContactProbe& probe, const FrozenPhase& phase) {
  // Corners on corners and flush faces have many pairs of features at one place. Only one of them
  // counts, preferably one that is held.
  alike_.clear();
  const auto held = [&](int i) { return phase.find(probe.key(i)) != nullptr; };
  std::stable_sort(taking_.begin(), taking_.end(),
                   [&](int a, int b) { return held(a) && !held(b); });
  for (const int i : taking_) {
    const bool again =
        probe.comesAndGoes(i) && std::any_of(alike_.begin(), alike_.end(), [&](int j) {
          return probe.comesAndGoes(j) && probe.coincide(i, j, kSame * norm_->length());
        });
    if (!again) alike_.push_back(i);
  }
  taking_ = alike_;
}

void SwitchEvent::projectPositions(MechanicalSystem& s, const FrozenPhase& phase, State& x) {
  // Held and touching contacts are projected together. With held ones alone, the correction of
  // their drift would move touching contacts into their partners.
  shutPhase_.held.clear();
  for (const ContactKey key : s.slot(0).contacts.key) {
    shutPhase_.held.push_back({});
    shutPhase_.held.back().key = key;
    const Held* held = phase.find(key);  // sets on displacements count only if they rest at x = 0
    shutPhase_.held.back().slips = held == nullptr || held->slips;
  }
  const double t = x.t;
  for (int i = 0; i < 4 && shutPhase_.positionCorrection(s.slot(0), delta_); ++i) {
    const double size = delta_.lpNorm<Eigen::Infinity>();
    if (!(size > 0.0)) break;
    delta_ /= kDisplacementTime;
    s.move(x, delta_, kDisplacementTime);
    x.t = t;
    s.evaluate(x, 0);
    if (size < 1e-12 * norm_->length()) break;
  }
}

void SwitchEvent::projectHeld(MechanicalSystem& s, const FrozenPhase& phase, State& x) {
  // Faces that lie on each other touch with all their features, up to the drift of those features
  // that are held: this drift is removed first.
  keys_.clear();
  phase.keys(keys_);
  if (keys_.empty()) return;
  s.hold(keys_);
  s.evaluate(x, 0);
  projectPositions(s, phase, x);
  next_ = phase;
  projectVelocities(s, next_, x);
}

/// Contacts that joints bear take no part.
void SwitchEvent::leaveToJoints(MechanicalSystem& s, const State& x) {
  borneByJoints(s.slot(0), borne_);
  if (borne_.empty()) return;
  std::erase_if(keys_, [&](ContactKey key) { return has(borne_, key); });
  s.hold(keys_);
  s.evaluate(x, 0);
}

void SwitchEvent::projectVelocities(MechanicalSystem& s, FrozenPhase& phase, State& x) {
  if (phase.velocityCorrection(s.slot(0), x.u, delta_)) x.u += delta_;
}

SwitchEvent::Result SwitchEvent::process(MechanicalSystem& s, InclusionSolver& solver,
                                         ContactProbe& probe, FrozenPhase& phase, PhasePoint& p,
                                         const SmoothStep& smooth, double lookAhead,
                                         const std::vector<HeldKey>& stopped) {
  Result r;
  percussions_.clear(), plastic_.clear(), shut_.clear(), works_ = {};
  State& x = p.x;
  if (probe.comesAndGoes()) projectHeld(s, phase, x);
  const bool known = takePart(probe, phase, x);
  left_ = kNone;
  if (!known) {
    r.fault = ContactProbe::kUnfollowed;
    return r;
  }
  s.hold(keys_);
  s.evaluate(x, 0);
  leaveToJoints(s, x);
  projectPositions(s, phase, x);
  projectVelocities(s, phase, x);
  uBefore_ = x.u, aBefore_ = p.a;
  for (int turn = 0;; ++turn) {
    x.u = uBefore_;
    percussions_.clear(), works_ = {};
    r.impact = impact(s, solver, x, r);
    decide(s, solver, x, lookAhead, phase, stopped, next_, r);
    s.hold(keys_);
    s.evaluate(x, 0);
    projectVelocities(s, next_, x);
    if (!next_.share(s.slot(0), x.u, p.a)) {
      r.fault = next_.fault(), r.lost = next_.lost();
      return r;
    }
    if (plain_ || turn == kMostDecisions) break;
    const bool closed = staysClosed(s, next_, p, r), rests = staysInNotch(s, phase, next_, p, r);
    if (!closed && !rests) break;
  }
  if (!accelerateAlone(s, p)) {
    r.fault = next_.fault(), r.lost = next_.lost();
    return r;
  }
  p.lambda = next_.lambda(), p.power = next_.power();
  smooth.rates(s, p);
  // Note whether any status has changed.
  r.changed = next_.held.size() != phase.held.size();
  for (std::size_t i = 0; i < next_.held.size() && !r.changed; ++i) {
    const Held &a = next_.held[i], &b = phase.held[i];
    r.changed = a.key != b.key || a.first != b.first || a.slips != b.slips || a.sign != b.sign;
  }
  phase = next_;
  return r;
}

bool SwitchEvent::accelerateAlone(MechanicalSystem& s, PhasePoint& p) {
  // Elements may place a contact according to others that are closed, too. Those that have left no
  // longer count, and the phase has to begin with the same accelerations with which it continues.
  closing_.clear();
  next_.keys(closing_);
  if (closing_.size() == keys_.size()) return true;
  s.hold(closing_);
  s.evaluate(p.x, 1);
  return next_.accelerate(s.slot(1), p.x.u, p.a);
}

bool SwitchEvent::impact(MechanicalSystem& s, InclusionSolver& solver, State& x, Result& r) {
  ContactSet& c = s.contactsOf(0);
  gamma_.resize(c.rows());
  c.gamma(view(std::as_const(x.u)), view(gamma_));
  double fastest = 0.0;
  for (int i = 0; i < c.size(); ++i)
    if (c.law[static_cast<std::size_t>(i)]->unilateral())
      fastest = std::max(fastest, -gamma_[c.row0[static_cast<std::size_t>(i)]]);
  leaves_ = std::max(kRest * norm_->speed(), 1e-9 * fastest);
  if (fastest > kRest * norm_->speed()) {
    wrappers_.clear();
    for (std::size_t i = 0; i < c.law.size(); ++i)
      if (has(plastic_, c.key[i])) {
        wrappers_.push_back(std::make_unique<WithoutRebound>(c.law[i]));
        c.law[i] = wrappers_.back().get();
      }
    x.impulses = {};
    gammaBefore_ = gamma_;
    auto& problem = s.impactProblem(x, 0.0, 0);
    const SolveReport solved = s.impactLaw().solve(problem, solver, s.Lambda());
    if (!solved.ok()) r.solved = solved;
    r.solved.repaired += solved.repaired;
    r.solved.energyGain = std::max(r.solved.energyGain, solved.energyGain);
    s.velocityFromImpulses(x);
    x.impulses = {};
    c.gamma(view(std::as_const(x.u)), view(gamma_));
    notePercussions(s);
  }
  if (!shut_.empty()) shut(s, x);
  return !percussions_.empty();
}

void SwitchEvent::notePercussions(const MechanicalSystem& s) {
  const ContactSet& c = s.slot(0).contacts;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    Percussion p{
        c.key[at], std::min(c.dim(i), kMostRows), {}, {}, c.law[at]->rowKind(0) == RowKind::normal};
    for (int k = 0; k < p.dim; ++k) {
      const int row = c.row0[at] + k;
      const double Lambda = s.Lambda(row);
      p.Lambda[static_cast<std::size_t>(k)] = Lambda;
      p.gammaMinus[static_cast<std::size_t>(k)] = gammaBefore_[row];
      bookWork(works_, c.law[at]->rowKind(k), Lambda, 0.5 * (gammaBefore_[row] + gamma_[row]),
               c.chi[row]);
    }
    percussions_.push_back(p);
  }
}

void SwitchEvent::shut(MechanicalSystem& s, State& x) {
  // Projects velocities in the metric of the mass, without a percussion of friction; closed
  // contacts stay closed.
  const ContactSet& c = s.slot(0).contacts;
  shutPhase_.held.clear();
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    const bool unilateral = c.law[i]->unilateral();
    if (unilateral && !has(shut_, c.key[i]) && gamma_[c.row0[i]] > leaves_) continue;
    // Parts that stick continue to stick.
    const int dim = c.dim(static_cast<int>(i));
    FrozenPhase::parts(*c.law[i], dim, parts_);
    for (const auto& [first, rows] : parts_) {
      double slip = 0.0;
      for (int k = unilateral && first == 0 ? 1 : first; k < first + rows; ++k)
        slip = std::max(slip, std::abs(gamma_[c.row0[i] + k]));
      Held h;
      h.key = c.key[i], h.first = first, h.rows = rows;
      h.slips = !holds(c.law[i]->rowKind(0)) && slip > kSlip * norm_->speed();
      if (side(c, i, gamma_.data() + c.row0[i]) != 0.0) h.slips = !has(shut_, c.key[i]);
      shutPhase_.held.push_back(h);
    }
  }
  projectVelocities(s, shutPhase_, x);
}

double SwitchEvent::closing(const ContactSet& c, std::size_t i, const Eigen::VectorXd& a) const {
  double back = -c.bias[static_cast<std::size_t>(c.row0[i])];
  for (int k = c.segment0[i]; k < c.segment0[i + 1]; ++k) {
    const Segment& segment = c.segment[static_cast<std::size_t>(k)];
    for (int j = 0; j < segment.nu; ++j)
      back -= c.W[static_cast<std::size_t>(segment.w + j)] * a[segment.u0 + j];
  }
  return back;
}

bool SwitchEvent::staysClosed(const MechanicalSystem& s, const FrozenPhase& phase,
                              const PhasePoint& p, Result& r) {
  const ContactSet& c = s.slot(0).contacts;
  gamma_.resize(c.rows());
  c.gamma(view(p.x.u), view(gamma_));
  const double height = zenoHeight() * norm_->length();
  bool any = false;
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    if (!c.law[i]->unilateral() || phase.find(c.key[i]) != nullptr) continue;
    const int row = c.row0[i];
    const double v = gamma_[row];
    if (!(v > leaves_)) continue;
    const double back = closing(c, i, p.a);
    if (!(back > 0.0 && v * v <= 2.0 * back * height)) continue;
    // A contact that rebounds takes the impact once more without rebound; others are projected.
    const auto hit = std::find_if(percussions_.begin(), percussions_.end(),
                                  [&](const Percussion& q) { return q.key == c.key[i]; });
    const bool struck = hit != percussions_.end() && hit->gammaMinus[0] < -leaves_;
    double epsilon[kMostOffered] = {};
    c.law[i]->epsilon(c.dim(static_cast<int>(i)), epsilon);
    if (struck && epsilon[0] > 0.0 && !has(plastic_, c.key[i]))
      plastic_.push_back(c.key[i]);
    else if (!has(shut_, c.key[i]))
      shut_.push_back(c.key[i]);
    else
      continue;
    // The rest of the sequence of impacts takes 2v/(a(1 − ε)).
    const double rebound = struck ? std::min(epsilon[0], 0.999999) : 0.0;
    r.accumulationEnd = p.x.t + 2.0 * v / (back * (1.0 - rebound));
    any = true, ++r.accumulations;
  }
  return any;
}

}  // namespace dynamy
