#include <algorithm>
#include <dynamy/stages/unresolved_forces.hpp>

namespace dynamy {
namespace {

/// Share of the stability limit of explicit rules above which the forces of a block are unresolved
/// (why one half: see the header), and above which a neutral rule takes resolved ones, ωΔt = 0.13
/// between two equal bodies.
constexpr double kUnresolved = 0.5, kNeutral = 0.002;
/// Share of the limit that a force needs itself, over that of its block: else it is a soft one.
constexpr double kOwnShare = 0.1;

}  // namespace

UnresolvedForces::Share UnresolvedForces::shareOf(const StiffEntry& e, const MassMatrix& mass,
                                                  double dt) const {
  const int b = block(e.i);
  if (b != block(e.j)) return {};  // the entry is not in the trace
  const double inverse = mass.inverse(b)(e.j - mass.u0(b), e.i - mass.u0(b));
  return {-inverse * 0.25 * dt * dt * e.K, -inverse * 0.5 * dt * e.D};
}

UnresolvedForces::Share UnresolvedForces::shareOfBlock(std::size_t& first, std::size_t end,
                                                       const MassMatrix& mass, double dt) const {
  Share out;
  for (const int b = block(all_[first].i); first < end && block(all_[first].i) == b; ++first) {
    const Share one = shareOf(all_[first], mass, dt);
    out.K += one.K, out.D += one.D;
  }
  return out;
}

bool UnresolvedForces::find(const std::vector<const ExternalForce*>& forces, const Kinematics& k,
                            const MassMatrix& mass, double dt, bool neutral) {
  if (blockOf_.empty())
    for (int b = 0; b < mass.blocks(); ++b)
      blockOf_.insert(blockOf_.end(), static_cast<std::size_t>(mass.nu(b)), b);
  all_.clear(), entries_.clear(), ends_.clear();
  StiffnessSink sink(all_);
  for (const ExternalForce* f : forces) {
    if (!f->stiff()) f->addStiffness(k, sink);
    ends_.push_back(all_.size());
  }
  taken_.assign(forces.size(), 0), share_ = swing_ = 0.0, neutral_ = false;
  if (all_.empty()) return false;
  shares_.assign(static_cast<std::size_t>(mass.blocks()), 0.0), swings_ = shares_;
  std::size_t first = 0;
  for (const std::size_t end : ends_)
    while (first < end) {
      const auto b = static_cast<std::size_t>(block(all_[first].i));
      const Share own = shareOfBlock(first, end, mass, dt);
      shares_[b] += own.sum();
      if (!(own.D > 0.0 && own.D * own.D >= 4.0 * own.K)) swings_[b] += own.K;
    }
  share_ = *std::max_element(shares_.begin(), shares_.end());
  swing_ = *std::max_element(swings_.begin(), swings_.end());
  neutral_ = neutral && share_ <= kUnresolved;
  first = 0;
  for (std::size_t f = 0; f < forces.size(); ++f) {
    if (isUnresolved(first, ends_[f], mass, dt)) {
      taken_[f] = 1;
      entries_.insert(entries_.end(), all_.begin() + static_cast<std::ptrdiff_t>(first),
                      all_.begin() + static_cast<std::ptrdiff_t>(ends_[f]));
    }
    first = ends_[f];
  }
  return !entries_.empty();
}

/// True: the force with these entries is unresolved. Entries of one mass block follow each other.
bool UnresolvedForces::isUnresolved(std::size_t first, std::size_t end, const MassMatrix& mass,
                                    double dt) const {
  const double most = neutral_ ? kNeutral : kUnresolved;
  while (first < end) {
    const int b = block(all_[first].i);
    const double own = shareOfBlock(first, end, mass, dt).sum();
    if (shares_[static_cast<std::size_t>(b)] > most && own > kOwnShare * most) return true;
  }
  return false;
}

}  // namespace dynamy
