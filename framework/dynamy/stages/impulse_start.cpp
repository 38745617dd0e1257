#include <dynamy/stages/impulse_start.hpp>

namespace dynamy {

void ImpulseStart::set(const ContactSet& c, const RememberedImpulses& old, double dt,
                       std::vector<double>& Lambda) {
  Lambda.assign(static_cast<std::size_t>(c.rows()), 0.0);
  pressedBefore_.assign(static_cast<std::size_t>(c.size()), 0);
  if (!old.key.empty() && old.dt > 0.0) {
    take(c, old, dt / old.dt, Lambda);
    for (int i = 0; i < c.size(); ++i) {
      const int found = remembered_.find(c.key[static_cast<std::size_t>(i)]);
      if (found < 0) continue;
      const auto at = static_cast<std::size_t>(found);
      const int first = old.first[at];
      pressedBefore_[static_cast<std::size_t>(i)] =
          old.first[at + 1] > first && old.Lambda[static_cast<std::size_t>(first)] > 0.0 ? 1 : 0;
    }
  }
  if (!again_.key.empty()) take(c, again_, 1.0, Lambda);
}

void ImpulseStart::again(const ContactSet& c, const std::vector<double>& Lambda) {
  again_.key = c.key, again_.first = c.row0, again_.Lambda = Lambda;
}

void ImpulseStart::take(const ContactSet& c, const RememberedImpulses& old, double scale,
                        std::vector<double>& Lambda) {
  remembered_.build(old.key);
  for (int i = 0; i < c.size(); ++i) {
    const int found = remembered_.find(c.key[static_cast<std::size_t>(i)]);
    if (found < 0) continue;
    const auto at = static_cast<std::size_t>(found);
    const int first = old.first[at], dim = old.first[at + 1] - first;
    if (dim != c.dim(i)) continue;
    for (int r = 0; r < dim; ++r)
      Lambda[static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)] + r)] =
          scale * old.Lambda[static_cast<std::size_t>(first + r)];
  }
}

}  // namespace dynamy
