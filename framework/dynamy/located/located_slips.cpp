// LocatedDormandPrince: ends of slip in space, starts of slip, and checks of the bias that elements
// report.
#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_name.hpp>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

constexpr double kMostTurn = 2.0;     ///< largest turn in a step with open contacts [rad]
constexpr double kMostTurned = 10.0;  ///< k of theory 20.6, in units of the tolerance
constexpr double kStop = 0.1;         ///< of the tolerance: end of a slip that is taken as straight
constexpr double kShareOfStop = 0.75;  ///< steps end before slip does
constexpr double kDifference = 1e-4;   ///< of T: for γ̇ by differences
constexpr double kBias = 1e-3;         ///< of the sum of absolute values in γ̇
constexpr double kBiasNoise = 1e-12;   ///< of L/T² and 1/T²: rates that count as zero

}  // namespace

double LocatedDormandPrince::shortened(double h) const {
  // Turning bodies must not turn past a contact between two samples of the search.
  if (const double turn = norm_.fastestTurn(from_.x.u);
      (search_.gaps() || probe_.comesAndGoes()) && turn * h > kMostTurn)
    h = kMostTurn / turn;
  // A force that is ignored may pass its bound, but no longer than it is to be ignored.
  for (const Held& held : phase_.held)
    if (!held.slips && held.mutedUntil > from_.x.t) h = std::min(h, held.mutedUntil - from_.x.t);
  return h;
}

bool LocatedDormandPrince::findStopping(double most, double& bound, double& last) {
  stopping_.clear();
  last = 0.0, bound = most;
  for (std::size_t i = 0; i < phase_.held.size(); ++i) {
    const Held& h = phase_.held[i];
    const int first = phase_.slip0(i), k = phase_.slipRows(i);
    if (!h.slips || k < 2 || h.starts || h.mutedUntil > from_.x.t) continue;
    double v = 0.0, along = 0.0, rate = 0.0;
    for (int r = 0; r < k; ++r) {
      const double w = phase_.slipWeight(i, r);
      const double g = w * phase_.gamma()[first + r], d = w * phase_.gammaDot(first + r);
      v += g * g, along += g * d, rate += d * d;
    }
    v = std::sqrt(v);
    if (!(along < 0.0)) continue;
    const double T = -v * v / along, path = 0.5 * v * T, tol = kStop * norm_.tolerance();
    const double sine = std::max(0.0, 1.0 - along * along / (v * v * rate));
    // The moment of a disc may turn bodies: the way of its slip may be an angle.
    const double most1 =
        phase_.form(i) == FrozenPhase::Form::disc ? std::min(1.0, norm_.length()) : norm_.length();
    if (path > tol * most1 || T * sine > 10.0 * tol * norm_.time() || T > most) {
      bound = std::min(bound, kShareOfStop * T);
      continue;
    }
    if (plain_)
      return refuse("slip in space ends, and its speed has no sign whose change could be found");
    stopping_.push_back({h.key, h.first});
    lastSwitched_ = h.key;
    last = std::max(last, T);
  }
  return true;
}

bool LocatedDormandPrince::stop(MechanicalSystem& s, InclusionSolver& solver, double& most,
                                StepReport& report, bool& stopped) {
  // Slip in space ends where |γ_T| reaches zero, in a singular way: the end is taken analytically,
  // for all contacts whose slip is that short at once.
  stopped = false;
  double last = 0.0, bound = most;
  if (!findStopping(most, bound, last)) return false;
  if (stopping_.empty()) {
    most = bound;
    return true;
  }
  trial_ = from_, oldPhase_ = phase_;
  delta_ = from_.x.u + 0.5 * last * from_.a;
  s.move(from_.x, delta_, last);
  from_.x.u += last * from_.a;
  if (closesOpen()) {  // an impact comes first: shorter steps locate it
    from_ = trial_;
    most = std::min(bound, kShareOfStop * last);
    return true;
  }
  const std::size_t told = told_.size(), struck = impacts_.size();
  const std::array<double, 5> works = works_;
  if (!event(s, solver, from_, report, stopping_)) return false;
  stopped = std::all_of(stopping_.begin(), stopping_.end(), [&](HeldKey part) {
    const Held* after = phase_.find(part);
    return after == nullptr || !after->slips;
  });
  if (stopped) {
    // Forces are constant until the slip ends, and powers of slips fall linearly to zero.
    stepKeys_.clear();
    impulse_ = last * trial_.lambda;
    for (std::size_t i = 0; i < oldPhase_.held.size(); ++i)
      stepKeys_.push_back(
          {oldPhase_.held[i].key, oldPhase_.held[i].first, oldPhase_.row0(i), oldPhase_.dim(i)});
    for (std::size_t k = 0; k < works_.size(); ++k)
      works_[k] += 0.5 * last * (trial_.power[k] + from_.power[k]);
    return true;
  }
  from_ = trial_, phase_ = oldPhase_;  // contacts continue to slip: this is no stop
  told_.resize(told), impacts_.resize(struck), works_ = works;
  for (Held& h : phase_.held)
    if (std::find(stopping_.begin(), stopping_.end(), HeldKey{h.key, h.first}) != stopping_.end())
      h.mutedUntil = from_.x.t + 2.0 * last;
  phaseKeys_.clear();
  phase_.keys(phaseKeys_);
  return evaluateEnd(s, from_);
}

bool LocatedDormandPrince::closesOpen() {
  if (!probe_.look(from_.x)) return true;
  for (int i = 0; i < probe_.size(); ++i)
    if (probe_.law(i).unilateral() && probe_.gap(i) < 0.0 && !probe_.comesAndGoes(i) &&
        phase_.find(probe_.key(i)) == nullptr &&
        std::find(borne_.begin(), borne_.end(), probe_.key(i)) == borne_.end())
      return true;
  return sinks(from_.x);
}

double LocatedDormandPrince::turn() {
  // How far the directions of starting slips have turned in the trial, over the allowed turn.
  double past = 0.0;
  const double most = kMostTurned * norm_.tolerance() * norm_.speed();
  for (std::size_t i = 0; i < phase_.held.size(); ++i) {
    Held& h = phase_.held[i];
    if (!h.starts) continue;
    const int first = phase_.slip0(i), k = phase_.slipRows(i);
    const Held& before = startHeld_[i];
    double speed = 0.0, along = 0.0, across = 0.0;
    for (int turn = 0; turn < 2; ++turn)  // unit vectors: first the cosine, then the part across
      for (int r = 0; r < k; ++r) {
        const double w = phase_.slipWeight(i, r), g = w * phase_.gamma()[first + r];
        const double a = w * before.direction[static_cast<std::size_t>(r)],
                     b = w * h.direction[static_cast<std::size_t>(r)];
        if (turn == 0)
          along += a * b, speed += g * g;
        else
          across += (b - along * a) * (b - along * a);
      }
    h.turned = before.turned + std::sqrt(speed * across);
    past = std::max(past, h.turned / most);
  }
  return past;
}

bool LocatedDormandPrince::slipIsClear(std::size_t i, double h) const {
  // γ_T has a clear direction if it points along the slip's direction and forces change it by less
  // than itself within h. The direction of γ̇_T, which has none where it vanishes, is then not
  // needed.
  const Held& held = phase_.held[i];
  const double most = kMostTurned * norm_.tolerance() * norm_.speed();
  double speed = 0.0, rate = 0.0, along = 0.0;
  for (int r = 0; r < phase_.slipRows(i); ++r) {
    const double w = phase_.slipWeight(i, r);
    const int row = phase_.slip0(i) + r;
    const double g = w * phase_.gamma()[row], d = w * phase_.gammaDot(row);
    speed += g * g, rate += d * d;
    along += g * w * held.direction[static_cast<std::size_t>(r)];
  }
  const double across = std::sqrt(std::max(0.0, speed - along * along));
  return speed > rate * h * h && along > 0.0 && across <= most;
}

bool LocatedDormandPrince::endClearStarts(MechanicalSystem& s, double h) {
  if (!evaluateEnd(s, from_)) return false;
  bool any = false;
  for (std::size_t i = 0; i < phase_.held.size(); ++i)
    if (phase_.held[i].starts && slipIsClear(i, h)) phase_.held[i].starts = false, any = true;
  if (!any) return true;
  startHeld_ = phase_.held;
  return evaluateEnd(s, from_);
}

LocatedDormandPrince::Tried LocatedDormandPrince::tryStep(MechanicalSystem& s, double& h,
                                                          StepReport& report, Switch& found) {
  Tried tried = attempt(s, h, false, report, found);
  if (tried == Tried::again) {
    book(s, &StepEffort::switches, report);
    h *= found.theta, tried = attempt(s, h, true, report, found);
  }
  if (tried == Tried::rejected || tried == Tried::turned)
    phase_.held = startHeld_;  // directions as they were
  if (tried == Tried::turned) {
    tried = endClearStarts(s, h) ? Tried::rejected : Tried::failed;
  } else if (tried == Tried::rejected) {
    // The end of slip in space is predicted from speeds at the start, not from those of the trial.
    bool inSpace = false;
    for (std::size_t i = 0; i < phase_.held.size(); ++i)
      if (phase_.held[i].slips && phase_.slipRows(i) > 1) inSpace = true;
    if (inSpace && !evaluateEnd(s, from_)) tried = Tried::failed;
  }
  book(s,
       tried == Tried::rejected ? &StepEffort::rejected
       : found                  ? &StepEffort::switches
                                : &StepEffort::smooth,
       report);
  return tried;
}

bool LocatedDormandPrince::endStarts() {
  bool any = false;
  const double most = kMostTurned * norm_.tolerance() * norm_.speed();
  for (std::size_t i = 0; i < phase_.held.size(); ++i) {
    Held& h = phase_.held[i];
    if (!h.starts) continue;
    double along = 0.0;
    for (int r = 0; r < phase_.slipRows(i); ++r) {
      const double w = phase_.slipWeight(i, r);
      const int row = phase_.slip0(i) + r;
      along += w * w * phase_.gamma()[row] * phase_.gammaDot(row);
    }
    if (h.turned > most || !(along > 0.0) || slipIsClear(i, H_)) h.starts = false, any = true;
  }
  return any;
}

bool LocatedDormandPrince::checkBias(MechanicalSystem& s, const PhasePoint& p) {
  foundUntold_ = findUntold(s, p.x, true);
  if (foundUntold_) return false;
  // Compares γ̇ = Wᵀu̇ + w̄ with the difference of γ along the motion, which is accurate up to
  // (δ/T)² = 1e-8. T is that of the motion here: mechanisms beside a singular position are a
  // hundred times as fast as at the start. Where γ has a kink close by (a formula with clamp, an
  // edge that a ball rolls over), the difference is taken on one side of the kink.
  double faster = 1.0;
  for (Eigen::Index i = 0; i < p.a.size(); ++i) {
    const double u = norm_.velocity(i, p.x.u[i], 0.0), a = norm_.velocity(i, p.a[i], 0.0);
    faster =
        std::max({faster, norm_.tolerance() * u, std::sqrt(norm_.tolerance() * a * norm_.time())});
  }
  const double d = kDifference * norm_.time() / faster;
  const auto gammaAt = [&](double tau) {
    trial_.x = p.x;
    rates_ = p.x.u + 0.5 * tau * p.a;
    s.move(trial_.x, rates_, tau);
    trial_.x.u += tau * p.a;
    s.evaluate(trial_.x, 1);
    Eigen::VectorXd gamma(s.slot(1).contacts.rows());
    s.slot(1).contacts.gamma(view(std::as_const(trial_.x.u)), view(gamma));
    return gamma;
  };
  s.hold(phaseKeys_);
  const Eigen::VectorXd before = gammaAt(-d), after = gammaAt(d);
  gammaDot_ = (after - before) / (2.0 * d);
  if (firstWrongBias(s, p, gammaDot_) < 0) return true;
  const Eigen::VectorXd now = gammaAt(0.0);
  int wrong = 0;
  for (const double side : {1.0, -1.0}) {
    gammaDot_ = (4.0 * (side > 0.0 ? after : before) - 3.0 * now - gammaAt(2.0 * side * d)) /
                (2.0 * side * d);
    wrong = firstWrongBias(s, p, gammaDot_);
    if (wrong < 0) return true;
  }
  return refuseBias(s, wrong, toldDot_[wrong], gammaDot_[wrong]);
}

int LocatedDormandPrince::firstWrongBias(const MechanicalSystem& s, const PhasePoint& p,
                                         const Eigen::VectorXd& found) {
  const double T = norm_.time(), noise = kBiasNoise * std::max(1.0, norm_.length()) / (T * T);
  const ContactSet& c = s.slot(0).contacts;
  toldDot_.resize(c.rows());
  c.gamma(view(p.a), view(toldDot_));
  rates_ = p.a.cwiseAbs();
  sums_.assign(static_cast<std::size_t>(c.rows()), 0.0);
  c.addAbsolute(view(std::as_const(rates_)), sums_.data());
  for (int r = 0; r < c.rows(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    toldDot_[r] += c.bias[row] - c.chi[row];
    if (std::abs(found[r] - toldDot_[r]) > kBias * (sums_[row] + std::abs(found[r])) + noise)
      return r;
  }
  return -1;
}

bool LocatedDormandPrince::refuseBias(const MechanicalSystem& s, int row, double told,
                                      double found) {
  const ContactSet& c = s.slot(0).contacts;
  std::size_t i = 0;
  while (c.row0[i + 1] <= row) ++i;
  const NonSmoothElement& e = *s.parts().contacts[static_cast<std::size_t>(c.element[i])];
  const std::string name = e.name().empty() ? "" : " name=\"" + e.name() + "\"";
  const std::string who = e.type().empty()
                              ? "contact " + contactName(e, static_cast<std::size_t>(c.element[i]),
                                                         contactNumber(c.key[i]))
                              : "<" + e.type() + name + ">";
  whyOwn_ = who + " tells a wrong bias of its row " + std::to_string(row - c.row0[i]) +
            ": with it γ changes by " + numberText(told) + " a second, along the motion by " +
            numberText(found) + "; let contacts() tell γ̇ − Wᵀu̇, or run with a step";
  return refuse(whyOwn_);
}

}  // namespace dynamy
