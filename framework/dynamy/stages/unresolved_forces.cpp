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
/// Number of forces up to which a neutral rule takes resolved ones wherever others are damped. M̂ of a large net
/// would couple all its contacts.
constexpr std::size_t kFew = 50;

}  // namespace

/// Shares of the entries from `first` on that belong to the same mass block; moves `first` behind them.
UnresolvedForces::Share UnresolvedForces::shareOfBlock(std::size_t& first, std::size_t end,
                                                       const MassMatrix& mass, double dt) const {
  Share out{.block = block(all_[first].i)};
  const int u0 = mass.u0(out.block), nu = mass.nu(out.block);
  const auto inverse = mass.inverse(out.block);
  for (; first < end; ++first) {
    const StiffEntry& e = all_[first];
    const int i = e.i - u0, j = e.j - u0;
    if (i < 0 || i >= nu) break;
    if (j < 0 || j >= nu) continue;  // the entry is not in the trace
    out.K += -inverse(j, i) * 0.25 * dt * dt * e.K, out.D += -inverse(j, i) * 0.5 * dt * e.D;
  }
  return out;
}

bool UnresolvedForces::find(const std::vector<const ExternalForce*>& forces, const Kinematics& k,
                            const MassMatrix& mass, double dt, Keeping keeping) {
  if (blockOf_.empty())
    for (int b = 0; b < mass.blocks(); ++b)
      blockOf_.insert(blockOf_.end(), static_cast<std::size_t>(mass.nu(b)), b);
  all_.clear(), entries_.clear(), ends_.clear(), own_.clear();
  StiffnessSink sink(all_);
  for (const ExternalForce* f : forces) {
    if (!f->stiff()) f->addStiffness(k, sink);
    ends_.push_back({.entries = all_.size()});
  }
  damped_.assign(forces.size(), 0), dampedEntries_ = 0, share_ = swing_ = 0.0;
  if (all_.empty()) return false;
  shares_.assign(static_cast<std::size_t>(mass.blocks()), 0.0), swings_ = shares_;
  std::size_t first = 0;
  for (Ends& end : ends_) {
    while (first < end.entries) {
      const Share own = shareOfBlock(first, end.entries, mass, dt);
      const auto b = static_cast<std::size_t>(own.block);
      shares_[b] += own.sum();
      if (!(own.D > 0.0 && own.D * own.D >= 4.0 * own.K)) swings_[b] += own.K;
      own_.push_back(own);
    }
    end.shares = own_.size();
  }
  share_ = *std::max_element(shares_.begin(), shares_.end());
  swing_ = *std::max_element(swings_.begin(), swings_.end());
  // Damped forces first.
  for (const bool damping : {true, false}) {
    if (damping ? share_ <= kUnresolved : !keeps(keeping, forces.size())) continue;
    Ends from;
    for (std::size_t f = 0; f < forces.size(); from = ends_[f++]) {
      if (damped_[f] != 0 ||
          !isAbove(damping ? kUnresolved : kNeutral, from.shares, ends_[f].shares))
        continue;
      damped_[f] = damping ? 1 : 0;
      entries_.insert(entries_.end(), all_.begin() + static_cast<std::ptrdiff_t>(from.entries),
                      all_.begin() + static_cast<std::ptrdiff_t>(ends_[f].entries));
    }
    if (damping) dampedEntries_ = entries_.size();
  }
  return !entries_.empty();
}

bool UnresolvedForces::keeps(Keeping keeping, std::size_t forces) const {
  return keeping == Keeping::all ||
         (keeping == Keeping::besideDamped && dampedEntries_ > 0 && forces <= kFew);
}

/// The force with these shares has more than a share `most` of a block, and not as a soft one.
bool UnresolvedForces::isAbove(double most, std::size_t first, std::size_t end) const {
  for (; first < end; ++first)
    if (shares_[static_cast<std::size_t>(own_[first].block)] > most &&
        own_[first].sum() > kOwnShare * most)
      return true;
  return false;
}

}  // namespace dynamy
