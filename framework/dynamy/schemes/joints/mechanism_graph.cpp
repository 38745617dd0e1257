#include <algorithm>
#include <dynamy/schemes/joints/mechanism_graph.hpp>

namespace dynamy {

bool MechanismGraph::isOf(const ContactSet& c, const std::vector<int>& joints) const {
  if (nu_.empty() || keys_.size() != joints.size()) return false;
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (keys_[k] != c.key[joints[k]]) return false;
  return true;
}

void MechanismGraph::build(const MassMatrix& mass, const ContactSet& c,
                           const std::vector<int>& joints,
                           const std::vector<std::pair<int, int>>& coupled) {
  const int blocks = mass.blocks(), count = static_cast<int>(joints.size());
  keys_.clear(), row0_.assign(1, 0), u0_.clear(), nu_.clear(), mostNu_ = 0;
  for (int b = 0; b < blocks; ++b) {
    u0_.push_back(mass.u0(b)), nu_.push_back(mass.nu(b));
    mostNu_ = std::max(mostNu_, mass.nu(b));
  }
  // Nodes are blocks, then joints; a joint makes its blocks neighbours of each other.
  std::vector<int> jointRows;
  std::vector<std::vector<int>> near(static_cast<std::size_t>(blocks + count));
  nearBlocks_.assign(static_cast<std::size_t>(blocks), {});
  nearJoints_.assign(static_cast<std::size_t>(blocks), {});
  for (int b = 0; b < blocks; ++b) nearBlocks_[b].push_back(b);
  for (int k = 0; k < count; ++k) {
    const int i = joints[k];
    keys_.push_back(c.key[i]);
    jointRows.push_back(c.dim(i)), row0_.push_back(row0_.back() + c.dim(i));
    std::vector<int> of;
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) of.push_back(c.segment[m].block);
    for (const int b : of) {
      near[b].push_back(blocks + k), near[blocks + k].push_back(b);
      nearJoints_[b].push_back(k);
      for (const int other : of)
        if (other != b) near[b].push_back(other), nearBlocks_[b].push_back(other);
    }
  }
  for (const auto& [a, b] : coupled) near[a].push_back(b), nearBlocks_[a].push_back(b);
  for (std::vector<int>& list : nearBlocks_) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  walk_.order(near, nu_, jointRows), colourBlocks();
}

void MechanismGraph::colourBlocks() {
  const int blocks = this->blocks();
  colour_.assign(static_cast<std::size_t>(blocks), -1), colours_ = 0;
  for (int b = 0; b < blocks; ++b) {
    std::vector<bool> used(static_cast<std::size_t>(blocks) + 1, false);
    for (const int a : nearBlocks_[b])
      for (const int o : nearBlocks_[a])
        if (colour_[o] >= 0) used[colour_[o]] = true;
    int c = 0;
    while (used[c]) ++c;
    colour_[b] = c;
    colours_ = std::max(colours_, c + 1);
  }
}

}  // namespace dynamy
