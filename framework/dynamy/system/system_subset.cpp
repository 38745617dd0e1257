#include <algorithm>
#include <atomic>
#include <dynamy/system/system_subset.hpp>
#include <stdexcept>

namespace dynamy {

void SystemSubset::choose(const Topology& topology, std::vector<char> without) {
  if (without.size() != topology.systems().size())
    throw std::logic_error("SystemSubset: one entry for each system");
  static std::atomic<std::uint64_t> stamps{0};
  stamp_ = ++stamps, without_ = std::move(without);
  systems_.clear(), frames_.clear(), idle_.clear(), beside_.clear();
  for (int i = 0; i < static_cast<int>(without_.size()); ++i)
    if (!leavesOut(i)) systems_.push_back(i);
  const auto& requested = topology.requestedFrames();
  for (std::size_t k = 0; k < requested.size(); ++k)
    if (!leavesOut(requested[k].first)) frames_.push_back(static_cast<int>(k));
  rests_ = false;
  for (int i = 0; i < static_cast<int>(without_.size()); ++i)
    rests_ = rests_ || (outsideRests() && leavesOut(i) && topology.system(i).nu > 0);
  const auto rests = [&](int i) { return leavesOut(i) || topology.system(i).nu == 0; };
  for (const Connection& c : topology.connections())
    if (!c.systems.empty() && std::all_of(c.systems.begin(), c.systems.end(), rests))
      idle_.push_back(c.element);
  std::sort(idle_.begin(), idle_.end());
  if (own() != nullptr) own_.assign(topology, systems_, frames_);
}

void SystemSubset::addBeside(const Topology& topology, const Element* force) {
  const auto& all = topology.connections();
  const auto own = std::find_if(all.begin(), all.end(),
                                [force](const Connection& c) { return c.element == force; });
  const bool known = own != all.end() && !own->systems.empty();
  for (int i = 0; i < static_cast<int>(without_.size()); ++i)
    if (leavesOut(i) && (!known || std::binary_search(own->systems.begin(), own->systems.end(), i)))
      beside_.push_back(i);
  std::sort(beside_.begin(), beside_.end());
  beside_.erase(std::unique(beside_.begin(), beside_.end()), beside_.end());
}

}  // namespace dynamy
