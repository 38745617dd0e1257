#include "import/contact_rules.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace dynamy::app {
namespace {

/// Skins of one link that behave alike. Link −1: the world.
struct Group {
  int link = -1;
  unsigned category = 1, collidesWith = 1;
  double mu = 0.0;
  auto key() const { return std::tuple(link, category, collidesWith, mu); }
};

class RuleMaker {
 public:
  explicit RuleMaker(const Machine& machine) : m_(machine) {
    for (const auto& [a, b] : machine.apart) apart_.insert(std::minmax(a, b));
  }
  ContactRules make();

 private:
  int groupOf(const Skin& skin, int link);
  std::vector<int> groupsOf(const std::vector<Skin>& skins, int link);
  /// First ancestor that moves, or −1: links that stand still belong to the world.
  int mover(int link) const;
  bool related(int a, int b) const;
  bool touch(const Group& a, const Group& b) const;
  void findClasses();
  bool fits(std::size_t group, int c) const;

  const Machine& m_;
  std::set<std::pair<int, int>> apart_;
  std::vector<Group> groups_;
  std::map<std::tuple<int, unsigned, unsigned, double>, int> known_;
  std::vector<std::vector<char>> touch_;
  std::vector<std::vector<std::size_t>> classes_;
  std::vector<int> classOf_;
};

int RuleMaker::groupOf(const Skin& skin, int link) {
  if (!skin.touches) return -1;
  const Group group{link, skin.category, skin.collidesWith, skin.mu};
  const auto [found, made] = known_.try_emplace(group.key(), static_cast<int>(groups_.size()));
  if (made) groups_.push_back(group);
  return found->second;
}

std::vector<int> RuleMaker::groupsOf(const std::vector<Skin>& skins, int link) {
  std::vector<int> out;
  for (const Skin& skin : skins) out.push_back(groupOf(skin, link));
  return out;
}

int RuleMaker::mover(int link) const {
  while (link >= 0) {
    const Link& l = m_.links[at(link)];
    if (l.free || !l.joints.empty()) return link;
    link = l.parent;
  }
  return -1;
}

/// Links of one rigid piece, and a piece and the piece that carries it.
bool RuleMaker::related(int a, int b) const {
  const int A = mover(a), B = mover(b);
  if (A == B) return true;
  const auto carrier = [this](int i) {
    while (i >= 0) {
      i = mover(m_.links[at(i)].parent);
      if (i < 0 || !m_.links[at(i)].between) return i;
    }
    return -2;
  };
  if (m_.staticContact && (A < 0 || B < 0)) return false;
  return (B >= 0 && carrier(A) == B) || (A >= 0 && carrier(B) == A);
}

bool RuleMaker::touch(const Group& a, const Group& b) const {
  const bool masks = (a.category & b.collidesWith) != 0 || (b.category & a.collidesWith) != 0;
  if (!masks || apart_.contains(std::minmax(a.link, b.link))) return false;
  if (a.link < 0 || b.link < 0) return true;
  return m_.selfContact && (m_.parentContact || !related(a.link, b.link));
}

/// Does the group behave like all of class c, towards all other groups and among themselves?
bool RuleMaker::fits(std::size_t group, int c) const {
  const auto& members = classes_[static_cast<std::size_t>(c)];
  const std::size_t first = members.front();
  if (groups_[first].mu != groups_[group].mu) return false;
  if ((groups_[first].link < 0) != (groups_[group].link < 0)) return false;
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    const bool inside = k == group || std::find(members.begin(), members.end(), k) != members.end();
    if (!inside && touch_[k][group] != touch_[k][first]) return false;
  }
  const char among = members.size() > 1 ? touch_[first][members[1]] : touch_[first][group];
  return std::all_of(members.begin(), members.end(),
                     [&](std::size_t k) { return touch_[k][group] == among; });
}

void RuleMaker::findClasses() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    int found = -1;
    for (int c = 0; c < static_cast<int>(classes_.size()) && found < 0; ++c)
      if (fits(g, c)) found = c;
    if (found < 0) found = static_cast<int>(classes_.size()), classes_.emplace_back();
    classes_[static_cast<std::size_t>(found)].push_back(g);
    classOf_.push_back(found);
  }
}

ContactRules RuleMaker::make() {
  ContactRules out;
  for (std::size_t i = 0; i < m_.links.size(); ++i)
    out.ofSkin.push_back(groupsOf(m_.links[i].skins, static_cast<int>(i)));
  out.ofGround = groupsOf(m_.ground, -1);
  for (const Group& a : groups_) {
    touch_.emplace_back();
    for (const Group& b : groups_) touch_.back().push_back(touch(a, b) ? 1 : 0);
  }
  findClasses();
  for (auto& skins : out.ofSkin)
    for (int& g : skins) g = g < 0 ? -1 : classOf_[static_cast<std::size_t>(g)];
  for (int& g : out.ofGround) g = g < 0 ? -1 : classOf_[static_cast<std::size_t>(g)];
  std::set<std::string> names;
  for (const auto& members : classes_) {
    const Group& first = groups_[members.front()];
    std::string name = first.link < 0       ? "ground"
                       : members.size() > 1 ? "machine"
                                            : m_.links[at(first.link)].name;
    const std::string plain = name;
    for (int k = 2; !names.insert(name).second; ++k) name = plain + std::to_string(k);
    out.materials.push_back({name, first.mu});
  }
  const auto count = static_cast<int>(classes_.size());
  for (int i = 0; i < count; ++i)
    for (int j = i; j < count; ++j) {
      const auto &a = classes_[static_cast<std::size_t>(i)],
                 &b = classes_[static_cast<std::size_t>(j)];
      if (i == j && a.size() < 2) continue;  // shapes of one body never touch
      if (touch_[a.front()][i == j ? a[1] : b.front()] == 0) out.apart.emplace_back(i, j);
    }
  return out;
}

}  // namespace

ContactRules contactRules(const Machine& machine) { return RuleMaker(machine).make(); }

}  // namespace dynamy::app
