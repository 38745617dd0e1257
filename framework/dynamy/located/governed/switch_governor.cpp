#include <algorithm>
#include <cmath>
#include <dynamy/located/governed/switch_governor.hpp>

namespace dynamy {
namespace {

constexpr double kWindow = 3000;     ///< evaluations in a window, about a hundred switches,
constexpr double kWindowWork = 1e9;  ///< or operations, where many rows make these expensive
constexpr double kDearer = 2.0;      ///< factor by which locating switches may cost more
constexpr double kBearable = 0.5;    ///< of this: work of islands that continue to be located
constexpr double kFast = 100.0;      ///< the same factor for motion that is fast without switches
/// Of T: time that a window has to cover; and the number of windows in turn that may cover less.
constexpr double kLeastWindow = 1e-4, kMostCreeping = 8;
constexpr double kMost = 0.1;          ///< of T: longest step in time
constexpr double kFirstStay = 0.05;    ///< of T: first duration of stepping in time
constexpr double kPatientStay = 0.02;  ///< of the run, where it has no patience left
constexpr double kGovernorSafety = 0.9, kGovernorShrink = 0.2, kGrow = 2.0;

}  // namespace

void SwitchGovernor::archive(NumberArchive& a) {
  a.choice(mode_, 3), a.choice(turnedBy_, 4), a(turnedAt_);
  a(h_), a(began_), a(stay_), a(window_.time), a(window_.work), a(window_.evaluations);
  a(window_.stepWork), a(window_.switchWork), a(creeping_), a(crept_), a(oneSwitch_), a(switches_),
      a(stepWork_), a(patience_);
}

bool SwitchGovernor::located(double t, double dt, long evaluations, double work, double stepWork,
                             bool switched, ContactKey at) {
  turnedAt_ = at;
  window_.time += dt, window_.work += work, window_.evaluations += static_cast<double>(evaluations);
  window_.stepWork = std::max(window_.stepWork, stepWork),
  window_.switchWork += switched ? work : 0.0;
  if (window_.evaluations < kWindow && window_.work < kWindowWork) return false;
  const double instead = window_.time / (tolerance_ * T_) * window_.stepWork;
  const bool dear = window_.switchWork > kDearer * instead, fast = window_.work > kFast * instead;
  creeping_ = window_.time < kLeastWindow * T_ ? creeping_ + 1.0 : 0.0;
  const bool creeps = creeping_ >= kMostCreeping;
  window_ = {};
  if (dear || fast || creeps) turn(t, TurnedBy::density, at);
  crept_ = creeps && !dear && !fast;
  tooFast_ = !dear, bearable_ = kBearable * (dear ? kDearer : kFast) * instead;
  return true;
}

void SwitchGovernor::giveUp(double t, double end, ContactKey at) {
  turn(t, TurnedBy::patience, at);
  stay_ = std::max(stay_, kPatientStay * end);
  tooFast_ = true, bearable_ = 0.0;
}

void SwitchGovernor::turn(double t, TurnedBy why, ContactKey at) {
  const bool soon = stay_ > 0.0 && t - began_ < stay_;
  stay_ = soon ? 2.0 * stay_ : kFirstStay * T_;
  mode_ = Mode::step, turnedBy_ = why, turnedAt_ = at, crept_ = false;
  began_ = t, h_ = least(), switches_ = stepWork_ = creeping_ = 0.0;
}

double SwitchGovernor::factor(double error) const {
  // The error of an impact grows with h, that of smooth motion with h³: the square root of the
  // error is a compromise.
  const double f = kGovernorSafety / std::sqrt(std::max(error, 1e-10));
  return std::isfinite(f) ? f : kGovernorShrink;
}

void SwitchGovernor::shorten(double h, double error) {
  h_ = std::max(least(), h * std::clamp(factor(error), kGovernorShrink, 0.5));
}

void SwitchGovernor::stepped(double t, double h, double error, double work, bool again,
                             double evaluations, double end) {
  patience_.spend(h, evaluations, T_, end);
  const double next = h * std::clamp(factor(error), kGovernorShrink, kGrow);
  // The next step does not become shorter because an outer bound shortened this one.
  h_ = std::clamp(h < h_ ? std::max(h_, next) : next, least(), std::max(kMost * T_, least()));
  switches_ += again || error > 1.0 ? 1.0 : 0.0, stepWork_ += work;
  if (t - began_ < stay_) return;
  // Where no switches but a place made located steps short (a position in which rows vanish), errors
  // of steps in time say nothing: it is passed.
  const bool rare = crept_ || switches_ * oneSwitch_ <= stepWork_;
  if (rare) mode_ = Mode::decideAnew;
  began_ = t, switches_ = stepWork_ = 0.0;
}

}  // namespace dynamy
