#include <algorithm>
#include <cstddef>
#include <dynamy/schemes/joints/mechanism_walk.hpp>
#include <numeric>

namespace dynamy {

void MechanismWalk::order(const std::vector<std::vector<int>>& near,
                          const std::vector<int>& blockRows, const std::vector<int>& jointRows) {
  const std::size_t blocks = blockRows.size(), n = near.size();
  std::vector<int> position(n, -1);
  nodes_.clear(), parts_.clear(), ends_.clear(), unknowns_ = 0, band_ = 0;
  blockPart_.assign(blocks, 0);
  const auto rows = [&](std::size_t i) {
    return i < blocks ? blockRows[i] : jointRows[i - blocks];
  };
  const auto number = [&](const Node& node) {
    return static_cast<std::size_t>(node.index) + (node.joint ? blocks : 0);
  };
  const auto visit = [&](std::size_t i) {
    if (position[i] >= 0) return;
    position[i] = static_cast<int>(nodes_.size());
    nodes_.push_back({i >= blocks, static_cast<int>(i < blocks ? i : i - blocks), unknowns_});
    unknowns_ += rows(i);
    if (i < blocks) blockPart_[i] = static_cast<int>(parts_.size());
  };
  std::vector<std::size_t> starts(n);
  std::iota(starts.begin(), starts.end(), std::size_t{0});
  std::stable_sort(starts.begin(), starts.end(),
                   [&](std::size_t i, std::size_t j) { return near[i].size() < near[j].size(); });
  for (const std::size_t start : starts) {
    if (position[start] >= 0) continue;
    Part part{.firstNode = static_cast<int>(nodes_.size()), .first = unknowns_};
    visit(start);
    for (std::size_t next = nodes_.size() - 1; next < nodes_.size(); ++next)
      for (const int other : near[number(nodes_[next])]) visit(static_cast<std::size_t>(other));
    part.lastNode = static_cast<int>(nodes_.size()), part.last = unknowns_;
    parts_.push_back(part), ends_.push_back(unknowns_);
  }
  block_.assign(blocks, 0), joint_.assign(n - blocks, 0);
  for (const Node& node : nodes_) {
    (node.joint ? joint_ : block_)[static_cast<std::size_t>(node.index)] = node.first;
    const std::size_t i = number(node);
    band_ = std::max(band_, rows(i) - 1);
    for (const int o : near[i]) {
      const auto other = static_cast<std::size_t>(o);
      const int first = nodes_[static_cast<std::size_t>(position[other])].first;
      band_ =
          std::max({band_, node.first + rows(i) - 1 - first, first + rows(other) - 1 - node.first});
    }
  }
}

}  // namespace dynamy
