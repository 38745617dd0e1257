// SwitchEvent: sets on a displacement x. Beside x = 0 the force is known. Where x passes 0 with a
// speed the force jumps. Rest at x = 0 is decided like stick.                     (theory 50.4)
#include <algorithm>
#include <cmath>
#include <dynamy/located/switching/switch_event.hpp>

namespace dynamy {
namespace {

constexpr double kMiddle = 1e-12;  ///< displacements below this part of L count as zero
constexpr double kZeno = 0.1;      ///< z: heights below z tol L count as zero
constexpr double kZenoFloor = 1e-12;

bool notched(const ContactSet& c, std::size_t i) {
  NotchedForce unused;
  return c.law[i]->notched({.dim = c.dim(static_cast<int>(i)), .dt = 1.0}, unused);
}

}  // namespace

double SwitchEvent::zenoHeight() const { return std::max(kZeno * norm_->tolerance(), kZenoFloor); }

double SwitchEvent::side(const ContactSet& c, std::size_t i, const double* gamma) const {
  if (!notched(c, i)) return 0.0;
  const double x = c.position[static_cast<std::size_t>(c.row0[i])];
  if (std::abs(x) > kMiddle * norm_->length()) return x > 0.0 ? 1.0 : -1.0;
  return std::abs(gamma[0]) > kSlip * norm_->speed() ? (gamma[0] > 0.0 ? 1.0 : -1.0) : 0.0;
}

void SwitchEvent::holdNotches(ContactSet& c) {
  // Where x is zero the decision gets exactly x = 0, not the rounding that is left after h_s.
  const double middle = kMiddle * norm_->length();
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < c.key.size(); row += c.dim(static_cast<int>(i)), ++i)
    if (double& x = c.position[static_cast<std::size_t>(c.row0[i])];
        notched(c, i) && std::abs(gammaBefore_[row]) <= kSlip * norm_->speed() &&
        std::abs(x) <= 2.0 * middle)
      x = 0.0;
}

bool SwitchEvent::staysInNotch(const MechanicalSystem& s, const FrozenPhase& old,
                               const FrozenPhase& phase, const PhasePoint& p, Result& r) {
  // A displacement that forces drive back from both sides, within the tolerance, has come to rest.
  const ContactSet& c = s.slot(0).contacts;
  gamma_.resize(c.rows());
  c.gamma(view(p.x.u), view(gamma_));
  const double height = zenoHeight() * std::min(norm_->length(), 1.0);  // x may be an angle
  bool any = false;
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    if (!notched(c, i)) continue;
    const Held *before = old.find(c.key[i]), *now = phase.find(c.key[i]);
    if (before == nullptr || now == nullptr || !before->slips || !now->slips) continue;
    const auto row = static_cast<std::size_t>(c.row0[i]);
    const double v = now->sign * gamma_[c.row0[i]];
    if (before->sign == now->sign || !(v > 0.0) ||
        std::abs(c.position[row]) > kMiddle * norm_->length())
      continue;
    const double back = now->sign * closing(c, i, p.a);
    const double drawn = -now->sign * closing(c, i, aBefore_);
    if (!(back > 0.0 && drawn > 0.0 && v * v <= 2.0 * back * height)) continue;
    if (std::find(shut_.begin(), shut_.end(), c.key[i]) != shut_.end()) continue;
    shut_.push_back(c.key[i]);
    r.accumulationEnd = p.x.t + 2.0 * v / back;
    any = true, ++r.accumulations;
  }
  return any;
}

}  // namespace dynamy
