#include <dynamy/located/switching/event_projection.hpp>
#include <dynamy/stages/projection.hpp>

namespace dynamy {

void EventProjection::positions(OngoingEvent& at, std::span<const ContactKey> keys,
                                const std::vector<Held>& held) {
  const MechanicalSystem& s = at.s;
  State& x = at.p.x;
  // Held and touching contacts are projected together. With held ones alone, the correction of
  // their drift would move touching contacts into their partners.
  together_.clear();
  for (const ContactKey key : s.slot(0).contacts.key) {
    together_.push_back({});
    together_.back().key = key;
    const Held* own = findHeld(held, key);
    together_.back().slips = own == nullptr || own->slips;
  }
  const double t = x.t;
  for (int i = 0; i < 4 && rows_.read(together_, s.slot(0), x.u, unused_) &&
                  projection_.positions(together_, rows_, s.slot(0), delta_);
       ++i) {
    const double size = delta_.lpNorm<Eigen::Infinity>();
    if (!(size > 0.0)) break;
    delta_ /= kDisplacementTime;
    s.move(x, delta_, kDisplacementTime);
    x.t = t;
    at.evaluate(x, keys);
    if (size < 1e-12 * at.norm.length()) break;
  }
}

void EventProjection::velocities(const MechanicalSystem& s, const std::vector<Held>& held,
                                 State& x) {
  const Evaluation& e = s.slot(0);
  if (rows_.read(held, e, x.u, unused_) && projection_.velocities(held, rows_, e, delta_))
    x.u += delta_;
}

}  // namespace dynamy
