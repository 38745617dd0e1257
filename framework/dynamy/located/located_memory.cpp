// LocatedDormandPrince: the data kept from step to step, and the report of a step.
#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

/// Layout of State::scheme. First H, T, the part of H that decisions look ahead, time of the last
/// event, number of empty events there, whether steps are implicit, SmoothStep::Counted, number of
/// held contacts. Then the governor's numbers; T of each system, and its work. Then for each held
/// contact: element, number, slip, sign, time until which it is ignored, whether the slip starts,
/// how far it has turned, weight, first row and number of rows, direction, λ. At the end the
/// elements without a bias, the place where the Jacobian of implicit steps was taken, and its size.
constexpr int kDirection = kMostRows - 1;
constexpr int kFixed = 10, kPerHeld = kFixed + kDirection + kMostRows;
constexpr int kSteppedHead = 4;   ///< numbers at the front of the data of steps in time
constexpr double kAround = 1e-2;  ///< of L: search distance for a contact that cannot be followed
constexpr double kHalfKey = 4294967296.0, kMostNumber = 1099511627776.0;  ///< 2³², 2⁴⁰

/// True: x is a whole number in [0, most).
bool isCount(double x, double most) { return x >= 0.0 && x < most && x == std::floor(x); }

}  // namespace

void LocatedDormandPrince::store(State& x) {
  const std::size_t n = phase_.held.size();
  const auto governed = governor_.numbers();
  if (governor_.mode() == SwitchGovernor::Mode::step) {
    beginStepping(x);
    x.scheme.resize(0);
    storeStepping(x);
    x.impulses = {};
    stored_.resize(0);
    return;
  }
  const auto first = static_cast<std::size_t>(behindTimes());
  const Eigen::VectorXd place = smooth_.kept();
  x.scheme.resize(static_cast<Eigen::Index>(first + kPerHeld * n + untold_.size() + 1) +
                  place.size());
  x.scheme.segment(x.scheme.size() - 1 - place.size(), place.size()) = place;
  x.scheme[x.scheme.size() - 1] = static_cast<double>(place.size());
  const SmoothStep::Counted counted = smooth_.counted();
  x.scheme.head<kHead>() << H_, norm_.time(), lookAhead_, lastEvent_, nulls_,
      smooth_.implicit() ? 1.0 : 0.0, counted[0], counted[1], counted[2], counted[3], counted[4],
      counted[5], counted[6], static_cast<double>(n);
  std::copy(governed.begin(), governed.end(), x.scheme.data() + kHead);
  x.scheme.segment(kBehind, norm_.times().size()) = norm_.times();
  x.scheme.segment(kBehind + norm_.times().size(), owed_.size()) = owed_.reshaped();
  for (std::size_t i = 0; i < n; ++i) {
    const Held& h = phase_.held[i];
    double* out = x.scheme.data() + first + kPerHeld * i;
    out[0] = static_cast<double>(h.key.value >> 40);
    out[1] = static_cast<double>(contactNumber(h.key));
    out[2] = h.slips ? 1.0 : 0.0, out[3] = h.sign, out[4] = h.mutedUntil;
    out[5] = h.starts ? 1.0 : 0.0, out[6] = h.turned;
    out[7] = h.weight;
    out[8] = h.first, out[9] = h.rows;
    std::copy(h.direction.begin(), h.direction.end(), out + kFixed);
    std::copy(h.lambda.begin(), h.lambda.end(), out + kFixed + kDirection);
  }
  std::copy(untold_.begin(), untold_.end(), x.scheme.data() + first + kPerHeld * n);
  stored_ = x.scheme;
}

void LocatedDormandPrince::resumeNorm(const MechanicalSystem& s, const State& x) {
  const auto systems = static_cast<Eigen::Index>(s.parts().topology->systems().size());
  const ConstVec times(x.scheme.data() + kBehind, systems);
  if (norm_.time() != x.scheme[1] || norm_.times().size() != systems || norm_.times() != times)
    norm_.resume(s, accuracy_.tolerance, accuracy_.length, x.scheme[1], times);
}

bool LocatedDormandPrince::goesOn(const State& x) const {
  return x.t == to_.x.t && x.scheme.size() == stored_.size() && x.scheme == stored_ &&
         x.q == to_.x.q && x.u == to_.x.u && x.memory == to_.x.memory;
}

bool LocatedDormandPrince::knows(const MechanicalSystem& s, const State& x) const {
  // Data that this object has just stored need no check: the check is for states from files.
  const bool own = x.scheme.size() == stored_.size() && x.scheme == stored_;
  return x.scheme.size() == 0 || (system_ == &s && own) || knows(s, x.scheme, false);
}

bool LocatedDormandPrince::knows(const MechanicalSystem& s, const Eigen::VectorXd& kept,
                                 bool quiet) const {
  const Topology& topology = *s.parts().topology;
  const auto systems = static_cast<Eigen::Index>(topology.systems().size());
  const Eigen::Index nq = topology.nq(), nu = topology.nu(), front = kBehind + 3 * systems;
  const auto elements = static_cast<double>(s.parts().contacts.size());
  if (kept.size() < front) return false;
  using Mode = SwitchGovernor::Mode;
  const double mode = kept[kHead], most = static_cast<double>(kept.size());
  bool good = isCount(mode, 3.0) && isCount(kept[kHead + 1], 3.0) && isCount(kept[4], 1e9);
  good = good && isCount(kept[kHead + 2], kHalfKey) && isCount(kept[kHead + 3], kHalfKey);
  if (!good || !(kept[1] > 0.0)) return false;
  if (mode == static_cast<double>(Mode::decideAnew)) return true;  // the rest is not read
  if (mode == static_cast<double>(Mode::step)) {
    if (quiet || kept.size() < front + kSteppedHead || !isCount(kept[front], most) ||
        !isCount(kept[front + 2], most))
      return false;
    const auto rates = static_cast<Eigen::Index>(kept[front]);
    const auto apart = static_cast<Eigen::Index>(kept[front + 2]);
    if (kept.size() < front + kSteppedHead + rates + apart || (rates != 0 && rates != nu))
      return false;
    if (apart == 0) return true;
    return apart >= 2 + nq + nu &&
           knows(s, kept.segment(front + kSteppedHead + rates + 2 + nq + nu, apart - 2 - nq - nu),
                 true);
  }
  // Held contacts, elements without a bias, place of the Jacobian, size of that place.
  if (!isCount(kept[kHead - 1], most) || !isCount(kept[kept.size() - 1], most)) return false;
  const auto n = static_cast<Eigen::Index>(kept[kHead - 1]);
  const auto placed = static_cast<Eigen::Index>(kept[kept.size() - 1]);
  const Eigen::Index untold = front + kPerHeld * n, place = kept.size() - 1 - placed;
  if (place < untold || (placed != 0 && placed != 1 + 2 * (nq + nu))) return false;
  for (Eigen::Index i = front; i < untold; i += kPerHeld)
    if (!isCount(kept[i], elements) || !isCount(kept[i + 1], kMostNumber) ||
        !isCount(kept[i + 8], kMostRows) || !isCount(kept[i + 9], kMostRows + 1))
      return false;
  for (Eigen::Index i = untold; i < place; ++i)
    if (!isCount(kept[i], elements)) return false;
  return true;
}

bool LocatedDormandPrince::restore(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                                   StepReport& report) {
  H_ = x.scheme[0], lookAhead_ = x.scheme[2], lastEvent_ = x.scheme[3];
  nulls_ = static_cast<int>(x.scheme[4]);
  resumeNorm(s, x);
  islands_.start(s.parts());
  owed_ = x.scheme.segment(kBehind + norm_.times().size(), 2 * norm_.times().size())
              .reshaped(norm_.times().size(), 2);
  const bool implicit = x.scheme[5] != 0.0;
  smooth_.implicit(implicit, s, norm_), smoothOwn_.implicit(implicit, s, norm_);
  SmoothStep::Counted counted;
  std::copy_n(x.scheme.data() + 6, counted.size(), counted.begin());
  smooth_.counted(counted);
  phase_.held.resize(static_cast<std::size_t>(x.scheme[kHead - 1]));
  for (std::size_t i = 0; i < phase_.held.size(); ++i) {
    Held& h = phase_.held[i];
    const double* in = x.scheme.data() + behindTimes() + kPerHeld * i;
    h.key = contactKey(static_cast<int>(in[0]), static_cast<std::uint64_t>(in[1]));
    h.slips = in[2] != 0.0, h.sign = in[3], h.mutedUntil = in[4];
    h.starts = in[5] != 0.0, h.turned = in[6], h.weight = in[7];
    h.first = static_cast<int>(in[8]), h.rows = static_cast<int>(in[9]);
    std::copy(in + kFixed, in + kFixed + kDirection, h.direction.begin());
    std::copy(in + kFixed + kDirection, in + kPerHeld, h.lambda.begin());
  }
  const Eigen::Index known =
      behindTimes() + kPerHeld * static_cast<Eigen::Index>(phase_.held.size());
  const auto placed = static_cast<Eigen::Index>(x.scheme[x.scheme.size() - 1]);
  const Eigen::Index place = x.scheme.size() - 1 - placed;
  untold_.assign(x.scheme.data() + known, x.scheme.data() + place);
  useDifferences(s);
  phaseKeys_.clear();
  phase_.keys(phaseKeys_);
  from_.x.t = x.t, from_.x.q = x.q, from_.x.u = x.u, from_.x.memory = x.memory;
  // Between two steps populations may remove bodies and add others.
  const bool renewed = x.q.size() != to_.x.q.size() || x.q != to_.x.q;
  if (renewed && relist(x)) {
    from_.a.setZero(x.u.size());
    return event(s, solver, from_, report, {});
  }
  s.hold(phaseKeys_);
  smooth_.keep(s, phase_, x, x.scheme.segment(place, placed));
  return evaluateEnd(s, from_);
}

bool LocatedDormandPrince::refuse(std::string_view why) {
  why_ = why;
  if (why == ContactProbe::kUnfollowed) return lose(probe_.unfollowed());
  return false;
}

bool LocatedDormandPrince::lose(ContactKey at) {
  // The features that touch are known only after a search of contacts as in steps in time.
  if (const ContactKey found = probe_.lookAround(from_.x, kAround * norm_.length(), at);
      found != ContactProbe::kNone)
    at = found;
  whyOwn_ = probe_.why(at);
  lastSwitched_ = at;
  stalled_ = lost_ = true;
  why_ = whyOwn_;
  return false;
}

bool LocatedDormandPrince::refuse(const FrozenPhase& phase) {
  if (phase.fault() == FrozenPhase::kOtherSet) return stall(phase.lost());
  if (phase.fault() != FrozenPhase::kLost) return refuse(phase.fault());
  return lose(phase.lost());
}

bool LocatedDormandPrince::stall() {
  stalled_ = true;
  return refuse(plain_ ? "events follow each other without end (an accumulation of impacts, or "
                         "slip in space that ends): this scheme has no way past"
                       : "the steps have become too short: no status of the contacts lasts");
}

bool LocatedDormandPrince::stall(ContactKey at) {
  lastSwitched_ = at;
  stalled_ = otherSet_ = true;
  return refuse(FrozenPhase::kOtherSet);
}

void LocatedDormandPrince::keepImpulses() {
  stepKeys_.clear();
  for (std::size_t i = 0; i < phase_.held.size(); ++i)
    stepKeys_.push_back({phase_.held[i].key, phase_.held[i].first, phase_.row0(i), phase_.dim(i)});
  for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += smooth_.works()[k];
}

Status LocatedDormandPrince::status(std::size_t i) const {
  const FrozenPhase::Form form = phase_.form(i);
  if (form == FrozenPhase::Form::joint) return Status::locked;
  if (form == FrozenPhase::Form::notch)
    return !phase_.held[i].slips ? Status::locked
                                 : (phase_.held[i].sign > 0.0 ? Status::lower : Status::upper);
  bool slips = phase_.held[i].slips || form == FrozenPhase::Form::normal;
  for (std::size_t k = i + 1; k < phase_.held.size() && phase_.held[k].first > 0; ++k)
    slips = slips || phase_.held[k].slips;
  return slips ? Status::slip : Status::stick;
}

void LocatedDormandPrince::keepPercussions(double t) {
  const double floor = 1e-9 * norm_.length();  // [m/s], as for schemes with fixed steps
  for (const Percussion& q : event_.percussions()) {
    told_.push_back(q);
    if (!q.unilateral || !(-q.gammaMinus[0] > floor && q.Lambda[0] > 0.0)) continue;
    Status after = Status::open;
    for (std::size_t i = 0; i < phase_.held.size(); ++i)
      if (phase_.held[i].key == q.key && phase_.held[i].first == 0) after = status(i);
    impacts_.push_back({q.key, t, after, -q.gammaMinus[0], q.Lambda[0]});
  }
}

void LocatedDormandPrince::tell(MechanicalSystem& s, State& x, StepReport& report) {
  InclusionProblem& p = s.impactProblem(x, report.dt, 0);
  const ContactSet& c = *p.contacts;
  Vec Lambda = s.Lambda();
  Lambda.setZero();
  delta_.resize(c.rows());
  c.gamma(view(std::as_const(x.u)), view(delta_));
  for (int k = 0; k < c.rows(); ++k) p.gammaA[static_cast<std::size_t>(k)] = delta_[k];
  for (int i = 0; i < c.size(); ++i)  // γ_N that the projection leaves is no impact
    if (c.law[static_cast<std::size_t>(i)]->unilateral())
      p.gammaA[static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)])] = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int first = c.row0[at];
    for (const Impulse& m : stepKeys_)
      for (int r = 0; m.key == c.key[at] && r < m.dim; ++r)
        Lambda[first + m.first + r] += impulse_[m.row + r];
    for (const Percussion& q : told_)
      for (int r = 0; q.key == c.key[at] && r < q.dim; ++r) {
        const auto k = static_cast<std::size_t>(r);
        Lambda[first + r] += q.Lambda[k];
        p.gammaA[static_cast<std::size_t>(first + r)] = q.gammaMinus[k];
      }
  }
  p.gammaFree = p.gammaA;
  statuses_.clear();
  for (std::size_t i = 0; i < phase_.held.size(); ++i)
    if (phase_.held[i].first == 0) statuses_.push_back({phase_.held[i].key, status(i)});
  report.ownStatuses = true, report.statuses = statuses_, report.impacts = impacts_;
  x.impulses = {};
  report.contacts = c.size();
  report.works = {true, works_[0], works_[1], works_[2], works_[3], works_[4]};
}

void LocatedDormandPrince::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                       double theta, State& out) const {
  if (stepped_ && system_ == &s) {
    SteppedIslands::between(s, a, b, theta, out);
    showQuiet(a.t + theta * (b.t - a.t), out);
    return;
  }
  const bool known = system_ == &s && stepFrom_.x.t == a.t && enteredAt_ == a.q;
  if (!known) {
    OneStep::interpolate(s, a, b, theta, out);
    return;
  }
  if (!denseReady_) {
    system_->hold(stepPhaseKeys_);
    denseReady_ = smooth_.prepareDense(*system_, stepPhase_, stepFrom_, stepTo_);
    system_->thaw();
  }
  const double t = a.t + theta * (b.t - a.t);
  out.memory = theta < 1.0 ? a.memory : b.memory;
  smooth_.dense(std::clamp((t - stepFrom_.x.t) / smooth_.length(), 0.0, 1.5), out);
  out.t = t;
}

bool LocatedDormandPrince::contactsAt(const MechanicalSystem& s, const State& at, bool after,
                                      ContactInstant& out) const {
  if (stepped_ || system_ != &s) return false;
  if (after) afterPhase_ = phase_;
  FrozenPhase& phase = after ? afterPhase_ : stepPhase_;
  system_->hold(after ? phaseKeys_ : stepPhaseKeys_);
  const Evaluation& e = system_->evaluate(at, 1);
  const bool known = phase.accelerate(e, at.u, shownA_);
  system_->thaw();
  if (!known) return false;
  const ContactSet& c = e.contacts;
  out.contacts = &c;
  out.lambda.setZero(c.rows()), out.gamma.resize(c.rows());
  c.gamma(view(at.u), view(out.gamma));
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const int row0 = c.row0[static_cast<std::size_t>(phase.contact(i))];
    out.lambda.segment(row0 + phase.held[i].first, phase.dim(i)) =
        phase.lambda().segment(phase.row0(i), phase.dim(i));
  }
  return true;
}

}  // namespace dynamy
